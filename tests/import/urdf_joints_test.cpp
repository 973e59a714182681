// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/import/urdf_motion.hpp"

namespace torsor::urdf_joints_test {
namespace {

using namespace testing_urdf;

/// Turns about x, y, z by constant angles, each a joint of its own: the derivation that rpy is compared with.
FrameHandle tilted(Scene& scene, const std::string& name, const FrameHandle& parent, const Triple& origin,
                   const Expression& roll, const Expression& pitch, const Expression& yaw) {
  const FrameHandle z = scene.revolute(name + "_yaw", parent, axis::z, yaw, {origin, {}});
  const FrameHandle y = scene.revolute(name + "_pitch", z, axis::y, pitch);
  return scene.revolute(name + "_roll", y, axis::x, roll);
}

const Triple hinge{number("0.1", "m"), number("0.2", "m"), number("-0.3", "m")};
const char* const at_hinge = "<origin xyz=\"0.1 0.2 -0.3\"/>";

TEST(UrdfJoint, RevoluteAndContinuousTurnAboutTheirAxes) {
  const Scene imported =
      read("<link name=\"base\"/>" + link("upper") + link("lower") +
           joint("shoulder", "revolute", "base", "upper", std::string(at_hinge) + "<axis xyz=\"0 0 2\"/>") +
           joint("elbow", "continuous", "upper", "lower", std::string(at_hinge) + "<axis xyz=\"0 -1 0\"/>"));
  Scene made("made");
  const Expression shoulder = made.coordinate("shoulder", "rad");
  const Expression elbow = made.coordinate("elbow", "rad");
  const FrameHandle upper = made.revolute("upper", made.ground(), axis::z, shoulder, {hinge, {}});
  const FrameHandle lower = made.revolute("lower", upper, axis::y, -elbow, {hinge, {}});
  made.body("upper", upper, lump());
  made.body("lower", lower, lump());
  made.motor("shoulder_torque", shoulder);
  made.motor("elbow_torque", elbow);
  made = with_weight(made);
  const Values q{{"shoulder", "0.7"}, {"elbow", "-1.1"}}, v{{"shoulder", "2"}, {"elbow", "-3"}};
  const Values u{{"shoulder_torque", "0.4"}, {"elbow_torque", "-0.3"}};
  expect_same(accelerations(imported, q, v, u), accelerations(made, q, v, u), fifty_digits);
}

TEST(UrdfJoint, PrismaticSlidesAlongItsAxisAndXIsTheDefault) {
  const Scene imported =
      read("<link name=\"base\"/>" + link("cart") + link("arm") + joint("slide", "prismatic", "base", "cart", "") +
           joint("lift", "prismatic", "cart", "arm", "<axis xyz=\"0.6 0 0.8\"/>"));
  Scene made("made");
  const Expression slide = made.coordinate("slide", "m");
  const Expression lift = made.coordinate("lift", "m");
  const FrameHandle cart = made.prismatic("cart", made.ground(), axis::x, slide);
  const FrameHandle arm = made.prismatic("arm", cart, {number("3"), 0, number("4")}, lift);
  made.body("cart", cart, lump());
  made.body("arm", arm, lump());
  made.motor("slide_force", slide);
  made.motor("lift_force", lift);
  made = with_weight(made);
  const Values q{{"slide", "0.7"}, {"lift", "-1.1"}}, v{{"slide", "2"}, {"lift", "-3"}};
  const Values u{{"slide_force", "4"}, {"lift_force", "-3"}};
  expect_same(accelerations(imported, q, v, u), accelerations(made, q, v, u), fifty_digits);
}

TEST(UrdfJoint, OriginTurnsByRollThenPitchThenYawAboutFixedAxes) {
  const Scene imported =
      read("<link name=\"base\"/>" + link("upper") + link("lower") +
           joint("shoulder", "revolute", "base", "upper", "<origin xyz=\"0.1 0.2 -0.3\" rpy=\"0.3 -0.2 0.7\"/>") +
           joint("elbow", "revolute", "upper", "lower",
                 "<origin xyz=\"0.1 0.2 -0.3\" rpy=\"-2.5 1.5707 4\"/><axis xyz=\"1 2 3\"/>"));
  Scene made("made");
  const Expression shoulder = made.coordinate("shoulder", "rad");
  const Expression elbow = made.coordinate("elbow", "rad");
  const FrameHandle first = tilted(made, "first", made.ground(), hinge, number("0.3"), number("-0.2"), number("0.7"));
  const FrameHandle upper = made.revolute("upper", first, axis::x, shoulder);
  const FrameHandle second = tilted(made, "second", upper, hinge, number("-2.5"), number("1.5707"), number("4"));
  const FrameHandle lower = made.revolute("lower", second, {number("1"), number("2"), number("3")}, elbow);
  made.body("upper", upper, lump());
  made.body("lower", lower, lump());
  made = with_weight(made);
  const Values q{{"shoulder", "0.7"}, {"elbow", "-1.1"}}, v{{"shoulder", "2"}, {"elbow", "-3"}};
  expect_same(accelerations(imported, q, v), accelerations(made, q, v), rational_angles);
}

TEST(UrdfJoint, OriginAtMultiplesOfFifteenDegreesIsExact) {
  const Scene imported =
      read("<link name=\"base\"/>" + link("upper") + link("lower") +
           joint("shoulder", "revolute", "base", "upper",
                 "<origin xyz=\"0.1 0.2 -0.3\" rpy=\"1.5707963267948966 -0.2617993878 2.35619449019\"/>") +
           joint("elbow", "revolute", "upper", "lower", "<axis xyz=\"0.707106781187 0.707106781186 0\"/>"));
  Scene made("made");
  const Expression shoulder = made.coordinate("shoulder", "rad");
  const Expression elbow = made.coordinate("elbow", "rad");
  const FrameHandle first =
      tilted(made, "first", made.ground(), hinge, pi() / 2, -pi() / 12, Expression(Number::rational(3, 4)) * pi());
  const FrameHandle upper = made.revolute("upper", first, axis::x, shoulder);
  const FrameHandle lower = made.revolute("lower", upper, {number("1"), number("1"), 0}, elbow);
  made.body("upper", upper, lump());
  made.body("lower", lower, lump());
  made = with_weight(made);
  const Values q{{"shoulder", "0.7"}, {"elbow", "-1.1"}}, v{{"shoulder", "2"}, {"elbow", "-3"}};
  expect_same(accelerations(imported, q, v), accelerations(made, q, v), fifty_digits);
}

TEST(UrdfJoint, FixedWeldsItsLinkAndInertialOriginsTurnTheOperator) {
  const Scene imported =
      read("<link name=\"base\"/>" + link("arm") +
           "<link name=\"tool\"><inertial><origin xyz=\"0.02 -0.03 0.05\" rpy=\"0.5 0 1.5707963267948966\"/><mass "
           "value=\"1.5\"/><inertia ixx=\"0.011\" ixy=\"0\" ixz=\"0\" iyy=\"0.013\" iyz=\"0\" "
           "izz=\"0.009\"/></inertial></link>" +
           joint("shoulder", "revolute", "base", "arm", at_hinge) +
           joint("mount", "fixed", "arm", "tool", "<origin xyz=\"0.1 0.2 -0.3\" rpy=\"0 3.141592653589793 0.4\"/>"));
  Scene made("made");
  const Expression shoulder = made.coordinate("shoulder", "rad");
  const FrameHandle arm = made.revolute("arm", made.ground(), axis::x, shoulder, {hinge, {}});
  const FrameHandle tool = tilted(made, "tool", arm, hinge, 0, pi(), number("0.4"));
  const FrameHandle principal =
      tilted(made, "principal", tool, {number("0.02", "m"), number("-0.03", "m"), number("0.05", "m")}, number("0.5"),
             0, pi() / 2);
  made.body("arm", arm, lump());
  made.body("tool", principal,
            Inertia::general({.mass = number("1.5", "kg"), .xx = number("0.011", "kg m^2"),
                              .yy = number("0.013", "kg m^2"), .zz = number("0.009", "kg m^2")}));
  made = with_weight(made);
  const Values q{{"shoulder", "0.7"}}, v{{"shoulder", "2"}};
  expect_same(accelerations(imported, q, v), accelerations(made, q, v), rational_angles);
}

const Values pose{{"drone_x", "0.3"},
                  {"drone_y", "-0.2"},
                  {"drone_z", "1.1"},
                  {"drone_attitude_w", "1/11"},
                  {"drone_attitude_x", "2/11"},
                  {"drone_attitude_y", "-4/11"},
                  {"drone_attitude_z", "10/11"},
                  {"arm", "0.6"}};
const Values motion{{"drone_x", "0.5"},
                    {"drone_y", "0.25"},
                    {"drone_z", "-1"},
                    {"drone_attitude_omega_x", "3"},
                    {"drone_attitude_omega_y", "-2"},
                    {"drone_attitude_omega_z", "1.5"},
                    {"arm", "-4"}};

/// A free body with an arm, from a placement that is turned as an origin would turn it.
Scene drone(bool placed) {
  Scene made("made");
  const Triple position{made.coordinate("drone_x", "m"), made.coordinate("drone_y", "m"),
                        made.coordinate("drone_z", "m")};
  const AttitudeHandle attitude = made.attitude("drone_attitude");
  const Expression q = made.coordinate("arm", "rad");
  const FrameHandle from = placed ? tilted(made, "pad", made.ground(), hinge, 0, 0, pi() / 2) : made.ground();
  const FrameHandle body = made.free("drone", from, position, attitude);
  const FrameHandle arm = made.revolute("rod", body, axis::x, q, {hinge, {}});
  made.body("drone", body, lump());
  made.body("rod", arm, lump());
  return with_weight(made);
}

TEST(UrdfJoint, FloatingIsAFreeJointByAUnitQuaternion) {
  const Scene imported = read(
      "<link name=\"world\"/>" + link("body") + link("rod") +
      joint("drone", "floating", "world", "body", "<origin xyz=\"0.1 0.2 -0.3\" rpy=\"0 0 1.5707963267948966\"/>") +
      joint("arm", "revolute", "body", "rod", at_hinge));
  expect_same(accelerations(imported, pose, motion), accelerations(drone(true), pose, motion), fifty_digits);
}

TEST(UrdfJoint, OfTheBaseFloatsOnRequest) {
  UrdfOptions options;
  options.base = UrdfBase::floating;
  const Scene imported =
      read(link("drone") + link("rod") + joint("arm", "revolute", "drone", "rod", at_hinge), options);
  expect_same(accelerations(imported, pose, motion), accelerations(drone(false), pose, motion), fifty_digits);
  EXPECT_EQ(imported.content().coordinates.front().q->name, "drone_x");
}

/// Slides along two directions and turns about the third, child axes along the parent's when all are zero.
void expect_planar(const std::string& given, const Triple& along_x, const Triple& along_y, const Triple& normal,
                   double tolerance) {
  SCOPED_TRACE(given);
  const Scene imported =
      read("<link name=\"table\"/>" + link("puck") + link("rod") +
           joint("slip", "planar", "table", "puck", std::string(at_hinge) + "<axis xyz=\"" + given + "\"/>") +
           joint("arm", "revolute", "puck", "rod", at_hinge));
  Scene made("made");
  const Expression x = made.coordinate("slip_x", "m");
  const Expression y = made.coordinate("slip_y", "m");
  const Expression angle = made.coordinate("slip_angle", "rad");
  const Expression arm = made.coordinate("arm", "rad");
  const FrameHandle first = made.prismatic("first", made.ground(), along_x, x, {hinge, {}});
  const FrameHandle second = made.prismatic("second", first, along_y, y);
  const FrameHandle puck = made.revolute("puck", second, normal, angle);
  const FrameHandle rod = made.revolute("rod", puck, axis::x, arm, {hinge, {}});
  made.body("puck", puck, lump());
  made.body("rod", rod, lump());
  made = with_weight(made);
  const Values q{{"slip_x", "0.3"}, {"slip_y", "-0.2"}, {"slip_angle", "0.4"}, {"arm", "0.6"}};
  const Values v{{"slip_x", "1.3"}, {"slip_y", "-2"}, {"slip_angle", "3"}, {"arm", "-4"}};
  expect_same(accelerations(imported, q, v), accelerations(made, q, v), tolerance);
}

TEST(UrdfJoint, PlanarSlidesAcrossItsAxisAndTurnsAboutIt) {
  expect_planar("0 0 1", axis::x, axis::y, axis::z, fifty_digits);
}

TEST(UrdfJoint, PlanarLiesAcrossAnyAxis) {
  expect_planar("1 0 0", axis::y, axis::z, axis::x, fifty_digits);
  expect_planar("0 1 0", axis::z, axis::x, axis::y, fifty_digits);
  expect_planar("0 0 -1", axis::x, -axis::y, -axis::z, fifty_digits);
  // The smallest turn from z to (2, −1, 2)/3 is about (1, 2, 0): 1 + [z∧n] + [z∧n]²/(1 + n_z) by hand.
  expect_planar("2 -1 2", {number("11/15"), number("2/15"), number("-2/3")},
                {number("2/15"), number("14/15"), number("1/3")}, {number("2/3"), number("-1/3"), number("2/3")},
                fifty_digits);
}

TEST(UrdfJoint, MimicMovesAsItsConstraintWouldMakeIt) {
  const std::string links = "<link name=\"base\"/>" + link("upper") + link("lower") + link("rack");
  const auto joints = [](const std::string& lower, const std::string& rack) {
    return joint("shoulder", "revolute", "base", "upper", at_hinge) +
           joint("elbow", "revolute", "upper", "lower", std::string(at_hinge) + "<axis xyz=\"0 1 0\"/>" + lower) +
           joint("feed", "prismatic", "base", "rack", "<axis xyz=\"0 0 1\"/>" + rack);
  };
  UrdfOptions options;
  options.motors = false;
  const Scene imported = read(links + joints("<mimic joint=\"shoulder\" multiplier=\"-2\" offset=\"0.3\"/>",
                                             "<mimic joint=\"elbow\" multiplier=\"0.05\" offset=\"-0.01\"/>"),
                              options);
  Scene constrained = read(links + joints("", ""), options);
  // Symbols by name: the scene was made elsewhere.
  const auto q = [&](const std::string& name) -> Expression {
    for (const CoordinateContent& c : constrained.content().coordinates) {
      if (c.q->name == name) return c.q;
    }
    return 0;
  };
  constrained.holonomic("follows", q("elbow") - (number("-2") * q("shoulder") + number("0.3")));
  constrained.holonomic("feeds", q("feed") - (number("0.05", "m") * q("elbow") - number("0.01", "m")));
  const Values positions{{"shoulder", "0.7"}, {"elbow", "-1.1"}, {"feed", "-0.065"}};
  const Values rates{{"shoulder", "2"}, {"elbow", "-4"}, {"feed", "-0.2"}};
  const auto free = accelerations(constrained, positions, rates);
  ASSERT_EQ(free.size(), 3U);
  expect_same(accelerations(imported, positions, rates), {{"shoulder", free.at("shoulder")}}, fifty_digits);
}

TEST(UrdfJoint, DampingIsAViscousDamperUnlessItIsDataOnly) {
  const std::string body =
      "<link name=\"base\"/>" + link("arm") +
      joint("hinge", "revolute", "base", "arm", "<axis xyz=\"0 0 1\"/><dynamics damping=\"0.75\" friction=\"0.1\"/>");
  UrdfOptions data_only;
  data_only.dampers = false;
  const Values q{{"hinge", "0.7"}}, v{{"hinge", "2"}};
  const Real damped = accelerations(read(body), q, v).at("hinge");
  const Real undamped = accelerations(read(body, data_only), q, v).at("hinge");
  // J = I_zz + m (x² + y²) about the axis, by hand.
  const Real inertia(parse_decimal("0.009") + parse_decimal("1.5") * parse_decimal("0.0013"), 50);
  const Real expected = Real(parse_decimal("-1.5"), 50) / inertia;
  EXPECT_LE(abs(damped - undamped - expected).to_double(), fifty_digits * abs(expected).to_double());
}

}  // namespace
}  // namespace torsor::urdf_joints_test
