// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/base/error.hpp"
#include "torsor/generator/kernels/kernel.hpp"
#include "tests/import/urdf_motion.hpp"

namespace torsor::urdf_reading_test {
namespace {

using namespace testing_urdf;
using Lines = std::vector<std::string>;

ImportedRobot imported(const std::string& body, const UrdfOptions& options = {}) {
  return read_urdf_text(robot(body), "machine.urdf", options);
}

/// The message with which the robot is refused, empty when it is read.
std::string refusal(const std::string& body, const UrdfOptions& options) {
  try {
    imported(body, options);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

UrdfOptions floating() {
  UrdfOptions options;
  options.base = UrdfBase::floating;
  return options;
}

std::vector<std::string> coordinates(const Scene& scene) {
  std::vector<std::string> names;
  for (const CoordinateContent& c : scene.content().coordinates) names.push_back(c.q->name);
  return names;
}

const std::string base = "<link name=\"base\"/>";
const std::string arm = base + link("arm") + joint("hinge", "revolute", "base", "arm", "<axis xyz=\"0 1 0\"/>");
const Values at{{"hinge", "0.7"}}, moving{{"hinge", "-2"}};

std::string with_inertial(const std::string& name, const std::string& inside) {
  return "<link name=\"" + name + "\"><inertial>" + inside + "</inertial></link>";
}
std::string moments(const std::string& xx, const std::string& yy, const std::string& zz) {
  return "<inertia ixx=\"" + xx + "\" ixy=\"0\" ixz=\"0\" iyy=\"" + yy + "\" iyz=\"0\" izz=\"" + zz + "\"/>";
}

// --- what URDF does not know --------------------------------------------------------------------------------------

TEST(UrdfReading, NotesWhatCannotActOneLineForEachKind) {
  std::string links = base, joints;
  for (int i = 0; i < 7; ++i) {
    const std::string k = std::to_string(i);
    links += link("l" + k);
    joints += joint("j" + k, "revolute", i == 0 ? "base" : "l" + std::to_string(i - 1), "l" + k,
                    "<dynamics D=\"1\" K=\"7000\"/><limit current=\"3\"/><hardware>x</hardware>");
  }
  const ImportedRobot robot = imported(links + joints + "<gazebo reference=\"l1\"/><gazebo/><transmission/>text");
  const Lines expected{"<gazebo> in <robot> is not read",
                       "<transmission> in <robot> is not read",
                       "text inside <robot> is not read",
                       "<hardware> in <joint> is not read: joint j0, joint j1, joint j2, joint j3 and 3 more",
                       "attribute current of <limit> is not read: joint j0, joint j1, joint j2, joint j3 and 3 more",
                       "attribute D of <dynamics> is not read: joint j0, joint j1, joint j2, joint j3 and 3 more",
                       "attribute K of <dynamics> is not read: joint j0, joint j1, joint j2, joint j3 and 3 more"};
  EXPECT_EQ(robot.notes, expected);
  const Lines& head = robot.scene.content().origin.notes;
  ASSERT_GT(head.size(), expected.size());
  EXPECT_EQ(head[0], "Noted while reading (--strict refuses it):");
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(head[i + 1], "  " + expected[i]);
}

// <axis rpy="0 0 0"> of exporters: wherever it belongs, a zero moves nothing. Another number would.
TEST(UrdfReading, NotesZerosThatStandInAnotherPlace) {
  const std::string links = base + link("arm");
  const auto with = [&](const std::string& rpy) {
    return links + joint("hinge", "revolute", "base", "arm", "<axis rpy=\"" + rpy + "\" xyz=\"0 1 0\"/>");
  };
  for (const std::string zeros : {"0 0 0", "0.0 -0 0e3", " 0\t+.0 0. "}) {
    const ImportedRobot robot = imported(with(zeros));
    EXPECT_EQ(robot.notes, Lines{"attribute rpy of <axis> is not read: joint hinge"}) << zeros;
    expect_same(accelerations(robot.scene, at, moving), accelerations(read(arm), at, moving), fifty_digits);
  }
  for (const std::string other : {"0 0 1", "1e-9 0 0", "", "0 x 0"}) {
    EXPECT_NE(refusal(with(other), {}).find("has an attribute rpy, which belongs to <origin>"), std::string::npos) << other;
  }
  const std::string multiplier = "<axis multiplier=\"0\" xyz=\"0 1 0\"/>";
  EXPECT_NE(refusal(links + joint("hinge", "revolute", "base", "arm", multiplier), {}).find("belongs to <mimic>"),
            std::string::npos);
}

TEST(UrdfReading, PassesOverPicturesShapesAndMaterials) {
  const ImportedRobot robot =
      imported(base + "<material name=\"red\"><color rgba=\"1 0 0 1\"/></material><link name=\"arm\">" + inertial +
               "<visual><geometry><mesh filename=\"a.stl\" scale=\"1\"/></geometry></visual><collision/></link>" +
               joint("hinge", "revolute", "base", "arm", ""));
  EXPECT_EQ(robot.notes, Lines());
}

TEST(UrdfReading, StrictlyTakesNotesAsErrors) {
  UrdfOptions strict;
  strict.strict = true;
  EXPECT_EQ(refusal(arm, strict), "");
  EXPECT_EQ(refusal(arm + "\n<gazebo/>", strict),
            "machine.urdf:2: <gazebo> of <robot name=\"machine\">: <gazebo> in <robot> is not read; correct the file, or leave "
            "out --strict");
  EXPECT_NE(refusal(base + with_inertial("arm", "<mass value=\"1\"/>" + moments("1", "1", "3")) +
                        joint("hinge", "revolute", "base", "arm", ""),
                    strict),
            "");
}

TEST(UrdfReading, TakesTheSameElementTwiceOnce) {
  const std::string twice = "<origin rpy=\"0 0 1\" xyz=\"1 2 3\"/><origin xyz=\"1 2 3\" rpy=\"0 0 1\"/>";
  const std::string links = base + link("arm");
  expect_same(accelerations(read(links + joint("hinge", "revolute", "base", "arm", twice)), at, moving),
              accelerations(read(links + joint("hinge", "revolute", "base", "arm", "<origin xyz=\"1 2 3\" rpy=\"0 0 1\"/>")),
                            at, moving),
              fifty_digits);
}

TEST(UrdfReading, TakesTheNameOfTheFileWhereTheRobotHasNone) {
  for (const std::string attribute : {"", " name=\"\"", " name=\" \""}) {
    const ImportedRobot robot = read_urdf_text("<robot" + attribute + ">" + arm + "</robot>", "folder/my arm.v2.urdf");
    EXPECT_EQ(robot.scene.name(), "my_arm");
    EXPECT_EQ(robot.notes, Lines{"<robot> has no name and takes that of the file, 'my arm'"});
  }
}

TEST(UrdfReading, TakesInfiniteLimitsAsNoneAndLeavesOutThoseInTheWrongOrder) {
  const ImportedRobot robot = imported(
      base + link("arm") + link("tool") +
      joint("hinge", "revolute", "base", "arm", "<limit lower=\"-inf\" upper=\"Infinity\" effort=\"1.8e308\" velocity=\"2\"/>") +
      joint("wrist", "revolute", "arm", "tool", "<limit lower=\"1\" upper=\"-1\" effort=\"5\"/>"));
  EXPECT_EQ(robot.joints[0].lower, std::nullopt);
  EXPECT_EQ(robot.joints[0].upper, std::nullopt);
  EXPECT_EQ(robot.joints[0].effort, std::nullopt);
  EXPECT_EQ(robot.joints[0].velocity, Number(2));
  EXPECT_EQ(robot.joints[1].lower, std::nullopt);
  EXPECT_EQ(robot.joints[1].effort, Number(5));
  EXPECT_EQ(robot.notes, Lines{"lower of <limit> is larger than upper, and both are left out: joint wrist"});
}

// By the format a bound that is left out is 0. Without both there is no limit; a leg that was given down to -0.5 would have
// an upper bound of 0.
TEST(UrdfReading, TakesZeroForTheOnlyLimitThatIsNotGiven) {
  const auto bounds = [](const std::string& type, const std::string& limit) {
    const ImportedRobot robot = imported(base + link("arm") + joint("hinge", type, "base", "arm", "<limit " + limit + "/>"));
    return std::tuple(robot.joints[0].lower, robot.joints[0].upper, robot.notes);
  };
  using Bound = std::optional<Number>;
  const Lines no_lower{"<limit> has no lower, which is 0 by the format: joint hinge"};
  const Lines no_upper{"<limit> has no upper, which is 0 by the format: joint hinge"};
  for (const std::string type : {"revolute", "prismatic"}) {
    EXPECT_EQ(bounds(type, "upper=\"1.5\" effort=\"1\""), std::tuple(Bound(Number(0)), Bound(Number::rational(3, 2)), no_lower));
    EXPECT_EQ(bounds(type, "lower=\"-0.5\""), std::tuple(Bound(Number::rational(-1, 2)), Bound(Number(0)), no_upper));
    EXPECT_EQ(bounds(type, "lower=\"-inf\""), std::tuple(Bound(), Bound(Number(0)), no_upper));
    EXPECT_EQ(bounds(type, "effort=\"1\" velocity=\"2\""), std::tuple(Bound(), Bound(), Lines()));
  }
}

// --- places and types ---------------------------------------------------------------------------------------------

// A quarter turn about z and one about x: the quaternion (½, ½, ½, ½) of the third part of a turn about (1, 1, 1).
TEST(UrdfReading, TakesQuaternionsForRollPitchAndYaw) {
  const auto scene = [](const std::string& origin) {
    return read(base + link("arm") + joint("hinge", "revolute", "base", "arm", origin + "<axis xyz=\"1 2 3\"/>"));
  };
  const std::vector<std::pair<const char*, const char*>> same{{"2 2 2 2", "1.5707963267948966 0 1.5707963267948966"},
                                                              {"3 0 0 3", "1.5707963267948966 0 0"},
                                                              {"0 -1 0 1", "0 -1.5707963267948966 0"},
                                                              {"0 0 1 1", "0 0 1.5707963267948966"}};
  for (const auto& [quaternion, angles] : same) {
    SCOPED_TRACE(quaternion);
    expect_same(accelerations(scene("<origin quat_xyzw=\"" + std::string(quaternion) + "\"/>"), at, moving),
                accelerations(scene("<origin rpy=\"" + std::string(angles) + "\"/>"), at, moving), fifty_digits);
  }
}

TEST(UrdfReading, TakesTypesInCapitalsAndWithBlanks) {
  const ImportedRobot robot = imported(base + link("arm") + joint("hinge", " Revolute", "base", "arm", "<axis xyz=\"0 1 0\"/>"));
  EXPECT_EQ(robot.notes, Lines{"type ' Revolute' of <joint> is read as revolute: joint hinge"});
  expect_same(accelerations(robot.scene, at, moving), accelerations(read(arm), at, moving), fifty_digits);
}

// A ball joint turns as the scene's own spherical joint does.
TEST(UrdfReading, BallJointsHaveAnAttitude) {
  const Scene scene = read(base + link("arm") + joint("shoulder", "ball", "base", "arm", "<origin xyz=\"0.1 0 0\"/>"));
  Scene made("made");
  const AttitudeHandle attitude = made.attitude("shoulder_attitude");
  const FrameHandle frame = made.spherical("arm", made.ground(), attitude, {{number("0.1", "m"), 0, 0}, {}});
  made.body("arm", frame, lump());
  made = with_weight(made);
  const Values q{{"shoulder_attitude_w", "0.6"}, {"shoulder_attitude_x", "0.8"}};
  const Values v{{"shoulder_attitude_omega_x", "1"}, {"shoulder_attitude_omega_y", "-2"}};
  expect_same(accelerations(scene, q, v), accelerations(made, q, v), fifty_digits);
}

// --- inertia ------------------------------------------------------------------------------------------------------

TEST(UrdfInertia, NegativeByRoundingIsZero) {
  const ImportedRobot robot =
      imported(base + with_inertial("arm", "<mass value=\"0.526\"/><origin xyz=\"0 0 0.03\"/>" +
                                               moments("-5.42101e-20", "1e-3", "-1e-16")) +
               joint("hinge", "revolute", "base", "arm", "<axis xyz=\"0 1 0\"/>"));
  const Inertia& inertia = robot.scene.content().bodies[0].inertia;
  EXPECT_TRUE(inertia.xx.is_zero() && inertia.zz.is_zero());
  EXPECT_FALSE(inertia.yy.is_zero());
}

TEST(UrdfInertia, ThatNoMatterHasIsTakenAsGivenAndNamed) {
  const ImportedRobot robot = imported(
      base + link("arm") + with_inertial("tool", "<mass value=\"1\"/>" + moments("1", "1", "3")) +
      with_inertial("tip", "<mass value=\"1\"/>" + moments("-0.01", "0.02", "0.03")) +
      joint("hinge", "revolute", "base", "arm", "") + joint("wrist", "revolute", "arm", "tool", "<axis xyz=\"0 0 1\"/>") +
      joint("mount", "fixed", "tool", "tip", ""));
  validate(robot.scene);
  EXPECT_EQ(robot.notes,
            Lines{"moments of inertia that no matter has (one is negative, or larger than the sum of the others) are taken as "
                  "given: link tool, link tip"});
  // About the wrist's axis the moments add up: 3 + 0.03, wherever they come from.
  Scene made("made");
  const Expression hinge = made.coordinate("hinge", "rad"), wrist = made.coordinate("wrist", "rad");
  const FrameHandle upper = made.revolute("arm", made.ground(), axis::x, hinge);
  const FrameHandle tool = made.revolute("tool", upper, axis::z, wrist);
  made.body("arm", upper, lump());
  const auto moment = [](const char* value) { return number(value, "kg m^2"); };
  made.body(
      "tool", tool,
      Inertia::general({.mass = number("2", "kg"), .xx = moment("0.99"), .yy = moment("1.02"), .zz = moment("3.03")}),
      Moments::as_given);
  made = with_weight(made);
  const Values q{{"hinge", "0.3"}, {"wrist", "0.4"}}, v{{"hinge", "1"}, {"wrist", "-2"}}, u{};
  expect_same(accelerations(robot.scene, q, v, u), accelerations(made, q, v, u), fifty_digits);
}

TEST(UrdfInertia, WithoutMassMassWithoutInertiaAndGreatRadiiAreNoted) {
  const auto chain = [](const std::string& inside) {
    return imported(base + link("arm") + with_inertial("tool", inside) + joint("hinge", "revolute", "base", "arm", "") +
                    joint("mount", "fixed", "arm", "tool", ""))
        .notes;
  };
  EXPECT_EQ(chain("<mass value=\"1\"/>"), Lines{"mass without moments of inertia is taken as a point: link tool"});
  EXPECT_EQ(chain("<mass value=\"1\"/>" + moments("0", "0", "0")),
            Lines{"mass without moments of inertia is taken as a point: link tool"});
  EXPECT_EQ(chain(moments("1", "1", "1")), Lines{"moments of inertia without mass are taken as given: link tool"});
  EXPECT_EQ(chain("<mass value=\"0\"/>" + moments("0", "0", "0")), Lines());
  EXPECT_EQ(chain("<mass value=\"1\"/>" + moments("99", "99", "99")), Lines());
  EXPECT_EQ(chain("<mass value=\"1\"/>" + moments("101", "99", "99")),
            Lines{"a radius of gyration is above 10 m, which suggests other units than kg m^2: link tool"});
  const std::string rest = "<mass value=\"1\"/>" + moments("1", "1", "1");
  EXPECT_EQ(chain("<origin xyz=\"0 0 10\"/>" + rest), Lines());
  EXPECT_EQ(chain("<origin xyz=\"0 0 -150\"/>" + rest),
            Lines{"a centre of mass is more than 10 m away, which suggests other units than m: link tool"});
}

TEST(UrdfLimits, ThatLookLikeDegreesAreNoted) {
  const auto notes = [](const std::string& type, const std::string& limit) {
    return imported(base + link("arm") + joint("hinge", type, "base", "arm", "<limit " + limit + "/>")).notes;
  };
  const Lines degrees{"a limit is beyond five turns, which suggests degrees, and is taken in rad: joint hinge"};
  EXPECT_EQ(notes("revolute", "lower=\"-180\" upper=\"180\""), degrees);
  EXPECT_EQ(notes("revolute", "lower=\"0\" upper=\"90\""), degrees);
  EXPECT_EQ(notes("revolute", "lower=\"-6.3\" upper=\"31\""), Lines());
  EXPECT_EQ(notes("revolute", "lower=\"-1e16\" upper=\"1e16\""), Lines());
  EXPECT_EQ(notes("prismatic", "lower=\"0\" upper=\"90\""), Lines());
}

TEST(UrdfOrigins, ThatLookLikeDegreesOrMillimetresAreNoted) {
  const auto notes = [](const std::string& of_joint, const std::string& of_inertia) {
    const std::string inside = "<origin " + of_inertia + "/><mass value=\"1\"/>" + moments("1", "1", "1");
    return imported(base + with_inertial("arm", inside) +
                    joint("hinge", "revolute", "base", "arm", "<origin " + of_joint + "/><axis xyz=\"0 0 1\"/>"))
        .notes;
  };
  const std::string degrees = "an angle of rpy is beyond a turn, which suggests degrees, and is taken in rad: ";
  EXPECT_EQ(notes("rpy=\"90 0 0\"", ""), Lines{degrees + "joint hinge"});
  EXPECT_EQ(notes("rpy=\"0 0 -45\"", "rpy=\"0 180 0\""), Lines{degrees + "link arm, joint hinge"});
  EXPECT_EQ(notes("rpy=\"0 -6.29 6.28318530718\"", ""), Lines());
  const Lines far{"the origin of a joint is 100 m away or more, which suggests other units than m: joint hinge"};
  EXPECT_EQ(notes("xyz=\"0 -300 0\"", ""), far);
  EXPECT_EQ(notes("xyz=\"0 99 0\"", ""), Lines());
}

// --- joints that move no mass -------------------------------------------------------------------------------------

const std::string hand = arm + "<link name=\"finger-1\"/><link name=\"finger-2\"/>" +
                         joint("grip-1", "prismatic", "arm", "finger-1", "<axis xyz=\"1 0 0\"/>") +
                         joint("grip-2", "revolute", "finger-1", "finger-2", "<axis xyz=\"1 0 0\"/>");

TEST(UrdfMassless, JointsAreKeptWhereNothingSolvesWithTheMassMatrix) {
  const Scene scene = read(hand);
  validate(scene);
  const Equations equations(scene);
  EXPECT_EQ(equations.massless(), (std::vector<int>{1, 2}));
  for (const std::string name : {"kinematics", "mass_matrix", "bias", "inverse_dynamics", "energy", "regressor"}) {
    EXPECT_EQ(why_absent(name, equations), "") << name;
  }
  const std::string reason =
      "the mass matrix is singular at every state, because the coordinates 'grip_1', 'grip_2' move no mass; give the links "
      "mass, or fix the joints: --fix grip_1,grip_2, or --fix massless";
  for (const std::string name : {"forward_dynamics", "linearisation", "forward_dynamics_derivatives", "jets"}) {
    EXPECT_EQ(why_absent(name, equations), reason) << name;
  }
  EXPECT_THROW(equations.forward(), SceneError);
}

// A point mass on the axis of the last joint: it is moved, but it does not resist the turn.
TEST(UrdfMassless, JointsAreThoseOfWhichNoMassResistsTheMotion) {
  const std::string body = arm + with_inertial("tool", "<mass value=\"1\"/><origin xyz=\"0.5 0 0\"/>") +
                           joint("roll", "revolute", "arm", "tool", "<axis xyz=\"1 0 0\"/>");
  EXPECT_EQ(Equations(read(body)).massless(), std::vector<int>{1});
  UrdfOptions options;
  options.fix = {"massless"};
  EXPECT_EQ(coordinates(read(body, options)), Lines{"hinge"});
}

TEST(UrdfMassless, JointsCanBeFixedByNameOrAllAtOnce) {
  for (const Lines& names : {Lines{"grip-1", "grip-2"}, Lines{"grip_1", "grip_2"}, Lines{"massless"}}) {
    UrdfOptions options;
    options.fix = names;
    const Scene scene = read(hand, options);
    EXPECT_EQ(coordinates(scene), Lines{"hinge"});
    expect_same(accelerations(scene, at, moving), accelerations(read(arm), at, moving), fifty_digits);
  }
  UrdfOptions unknown;
  unknown.fix = {"grip-3"};
  EXPECT_EQ(refusal(hand, unknown),
            "unknown joint 'grip-3' in --fix: did you mean 'grip-1' or 'grip-2'? name joints of the robot 'machine', or "
            "massless: it has hinge, grip-1, grip-2");
}

// --- mimics -------------------------------------------------------------------------------------------------------

std::string mimic(const std::string& leader, const std::string& more = "") {
  return "<mimic joint=\"" + leader + "\" " + more + "/>";
}

TEST(UrdfMimics, OfNothingAreVoidAndTheJointIsFree) {
  const ImportedRobot robot = imported(arm + link("tool") + joint("wrist", "revolute", "arm", "tool", mimic("elsewhere_q1")));
  EXPECT_EQ(coordinates(robot.scene), (Lines{"hinge", "wrist"}));
  EXPECT_EQ(robot.notes,
            Lines{"<mimic> of the joint 'elsewhere_q1', which is not there, is void, and the joint is free: joint wrist"});
}

TEST(UrdfMimics, OfFixedJointsHoldTheJointAtTheOffset) {
  const std::string links = arm + link("tool") + link("tip") + joint("mount", "fixed", "arm", "tool", "");
  const ImportedRobot held =
      imported(links + joint("wrist", "revolute", "tool", "tip",
                             "<axis xyz=\"0 0 1\"/><dynamics damping=\"2\"/>" + mimic("mount", "multiplier=\"3\" offset=\"0.25\"")));
  EXPECT_EQ(coordinates(held.scene), Lines{"hinge"});
  EXPECT_EQ(held.notes, Lines{"<mimic> of a fixed joint holds the joint at the offset: joint wrist"});
  const Scene placed = read(links + joint("wrist", "fixed", "tool", "tip", "<origin rpy=\"0 0 0.25\"/>"));
  expect_same(accelerations(held.scene, at, moving), accelerations(placed, at, moving), rational_angles);
}

// A joint that is fixed by its name follows nothing any more, and what follows it stays at its offset.
TEST(UrdfMimics, OfJointsThatAreFixedByNameHoldTheJointAtTheOffset) {
  const std::string links = arm + link("tool") + link("tip") +
                            joint("wrist", "revolute", "arm", "tool", "<axis xyz=\"0 0 1\"/>" + mimic("hinge", "multiplier=\"2\""));
  UrdfOptions options;
  options.fix = {"wrist"};
  const std::string finger = "<axis xyz=\"0 0 1\"/>" + mimic("wrist", "multiplier=\"3\" offset=\"0.25\"");
  const Scene held = read(links + joint("finger", "revolute", "tool", "tip", finger), options);
  EXPECT_EQ(coordinates(held), Lines{"hinge"});
  const Scene placed = read(links + joint("finger", "fixed", "tool", "tip", "<origin rpy=\"0 0 0.25\"/>"), options);
  expect_same(accelerations(held, at, moving), accelerations(placed, at, moving), rational_angles);
}

TEST(UrdfMimics, OnFixedJointsAreVoid) {
  const ImportedRobot robot = imported(arm + link("tool") + joint("mount", "fixed", "arm", "tool", mimic("hinge")));
  EXPECT_EQ(robot.notes, Lines{"<mimic> of a fixed joint is void: joint mount"});
  expect_same(accelerations(robot.scene, at, moving),
              accelerations(read(arm + link("tool") + joint("mount", "fixed", "arm", "tool", "")), at, moving), fifty_digits);
}

// Displacements −2 q + π/12, then 3 (−2 q + π/12) + 0.3, then half of that less π/4: an offset is multiplied with what
// it is added to, whether it is a multiple of π/12 or not.
TEST(UrdfMimics, OffsetsThatAreTwelfthsOfPiStayExact) {
  const auto follower = [](const char* name, const char* parent, const char* child, const char* leader, const char* law) {
    return link(child) + joint(name, "revolute", parent, child, "<axis xyz=\"0 0 1\"/>" + mimic(leader, law));
  };
  const Scene scene =
      read(arm + follower("wrist", "arm", "tool", "hinge", "multiplier=\"-2\" offset=\"0.2617993877991494\"") +
           follower("finger", "tool", "tip", "wrist", "multiplier=\"3\" offset=\"0.3\"") +
           follower("nail", "tip", "edge", "finger", "multiplier=\"0.5\" offset=\"-0.7853981633974483\""));
  Scene made("made");
  const Expression q = made.coordinate("hinge", "rad");
  const FrameHandle upper = made.revolute("arm", made.ground(), axis::y, q);
  const FrameHandle tool =
      made.revolute("tool", upper, axis::z, Expression(-2) * q + Expression(Number::rational(1, 12)) * pi());
  const FrameHandle tip = made.revolute("tip", tool, axis::z,
                                        Expression(-6) * q + Expression(Number::rational(1, 4)) * pi() +
                                            Expression(Number::rational(3, 10)));
  const FrameHandle edge = made.revolute("edge", tip, axis::z,
                                         Expression(-3) * q - Expression(Number::rational(1, 8)) * pi() +
                                             Expression(Number::rational(3, 20)));
  made.body("arm", upper, lump());
  made.body("tool", tool, lump());
  made.body("tip", tip, lump());
  made.body("edge", edge, lump());
  made = with_weight(made);
  expect_same(accelerations(scene, at, moving), accelerations(made, at, moving), fifty_digits);
}

TEST(UrdfMimics, HaveNoMotorAndMayAloneMoveMass) {
  const Scene scene = read(base + "<link name=\"drum\"/>" + link("arm") + joint("motor", "revolute", "base", "drum", "") +
                           joint("follower", "revolute", "base", "arm", "<axis xyz=\"0 1 0\"/>" + mimic("motor")));
  EXPECT_EQ(coordinates(scene), Lines{"motor"});
  EXPECT_TRUE(Equations(scene).massless().empty());
  ASSERT_EQ(scene.content().actions.size(), 1U);
  EXPECT_EQ(name_of(scene.content().actions[0]), "motor_torque");
}

// Each joint follows the one before: q_k = ½ q_{k−1} + 1 m, so q_k = q/2^k + 2 − 2^(1−k), however long the chain.
TEST(UrdfMimics, OfMimicsAreFollowedOnceEach) {
  std::string body = base + link("l0") + joint("j0", "prismatic", "base", "l0", "");
  constexpr int count = 2000;
  for (int k = 1; k <= count; ++k) {
    const std::string name = std::to_string(k);
    body += "<link name=\"l" + name + "\"/>" +
            joint("j" + name, "prismatic", "base", "l" + name,
                  mimic("j" + std::to_string(k - 1), k <= 900 ? "multiplier=\"0.5\" offset=\"1\"" : "multiplier=\"-1\""));
  }
  const Scene scene = read(body);
  EXPECT_EQ(coordinates(scene), Lines{"j0"});
  EXPECT_EQ(scene.content().frames.size(), static_cast<std::size_t>(count) + 3);
}

// --- worlds and bases ---------------------------------------------------------------------------------------------

TEST(UrdfBases, AFloatingJointOfTheFileIsTheFloatingBase) {
  const std::string body = "<link name=\"world\"/>" + link("drone") + link("arm") +
                           joint("free", "floating", "world", "drone", "") +
                           joint("hinge", "revolute", "drone", "arm", "");
  const Scene fixed = read(body), both = read(body, floating());
  EXPECT_EQ(coordinates(both), coordinates(fixed));
  EXPECT_EQ(coordinates(both).size(), 7U);
  EXPECT_EQ(both.content().origin.notes[1], "  the joint 'free' of the file is the floating base; 'world' is fixed to the ground");
}

TEST(UrdfBases, OfARootWithMassFloatBesideAFloatingJoint) {
  const std::string body = link("ship") + link("drone") + joint("free", "floating", "ship", "drone", "");
  EXPECT_EQ(coordinates(read(body, floating())).size(), 12U);
  EXPECT_EQ(coordinates(read(body)).size(), 6U);
}

TEST(UrdfBases, AWorldThatHoldsTheRobotIsLeftOutWhenItFloats) {
  const std::string body = "<link name=\"world\"/>" + link("body") + link("arm") +
                           joint("hold", "fixed", "world", "body", "<origin xyz=\"0 0 1\"/>") +
                           joint("hinge", "revolute", "body", "arm", "");
  EXPECT_EQ(coordinates(read(body)), Lines{"hinge"});
  const Lines names = coordinates(read(body, floating()));
  EXPECT_EQ(names.size(), 7U);
  EXPECT_EQ(names[0], "body_x");
}

TEST(UrdfBases, AnUndeclaredWorldIsTheGround) {
  const ImportedRobot robot = imported(link("arm") + joint("hinge", "revolute", "world", "arm", "<axis xyz=\"0 1 0\"/>"));
  EXPECT_EQ(robot.notes, Lines{"the parent link 'world' is not declared and is taken as the ground: joint hinge"});
  expect_same(accelerations(robot.scene, at, moving), accelerations(read(arm), at, moving), fifty_digits);
}

TEST(UrdfBases, LonelyLinksWithoutMassAreLeftOut) {
  const ImportedRobot robot = imported("<link name=\"world\"/>" + arm);
  EXPECT_EQ(robot.notes, Lines{"a link without mass that nothing is joined to is left out: link world"});
  EXPECT_NE(refusal(link("stone") + arm, {}), "");
}

}  // namespace
}  // namespace torsor::urdf_reading_test
