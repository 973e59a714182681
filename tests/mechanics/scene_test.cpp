// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/mechanics/scene.hpp"

#include <gtest/gtest.h>

#include "tests/program/test_symbols.hpp"

namespace torsor::scene_test {
namespace {

using namespace testing_symbols;
using namespace literals;

class SceneTest : public ::testing::Test {
 protected:
  Scene scene{"machine"};
};

using SceneNames = SceneTest;

TEST_F(SceneNames, AreUniqueAmongWhatBecomesASymbol) {
  scene.coordinate("theta", "rad");
  const std::string expected =
      "duplicate name 'theta': the scene 'machine' already has a coordinate of that name; choose another name for the "
      "new parameter";
  EXPECT_EQ(error_of<SceneError>([&] { scene.parameter("theta", "kg", 1); }), expected);
  EXPECT_NE(error_of<SceneError>([&] { scene.coordinate("theta", "rad"); }), "no error");
  EXPECT_NE(error_of<SceneError>([&] { scene.motor("theta", scene.coordinate("x", "m")); }), "no error");
  // On a page there would be two meanings of t.
  EXPECT_EQ(error_of<SceneError>([&] { scene.coordinate("t", "m"); }),
            "duplicate name 't': the scene 'machine' already has a time of that name; choose another name for the new "
            "coordinate");
}

TEST_F(SceneNames, AreUniqueAmongFramesBodiesPointsActionsAndConstraints) {
  const Expression x = scene.coordinate("x", "m");
  const FrameHandle slide = scene.prismatic("slide", scene.ground(), axis::x, x);
  scene.body("slide", slide, Inertia::point(1));  // a frame and its body are often namesakes
  scene.point("end", slide, {0, 0, 0});
  scene.spring("end", x, 1);
  scene.holonomic("end", x);
  const auto refused = [](const auto& action) { return error_of<SceneError>(action).starts_with("duplicate name"); };
  EXPECT_TRUE(refused([&] { scene.weld("slide", "ground", {}); }));
  EXPECT_TRUE(refused([&] { scene.weld("ground", "slide", {}); }));
  EXPECT_TRUE(refused([&] { scene.body("slide", slide, Inertia::point(1)); }));
  EXPECT_TRUE(refused([&] { scene.point("end", slide, {0, 0, 0}); }));
  EXPECT_TRUE(refused([&] { scene.damper("end", x, 1); }));
  EXPECT_TRUE(refused([&] { scene.holonomic("end", x); }));
}

TEST_F(SceneNames, AreNamesInGeneratedCode) {
  for (const char* bad : {"", "1st", "a b", "double", "_x", "x_", "a__b", "mass-1", "size"}) {
    const std::string text = error_of<SceneError>([&] { scene.coordinate(bad, "m"); });
    EXPECT_TRUE(text.starts_with("the name '" + std::string(bad) + "' of a coordinate cannot be a name")) << text;
  }
  EXPECT_THROW(Scene("class"), SceneError);
}

TEST_F(SceneNames, HaveTheArticleOfWhatIsNamed) {
  const Expression x = scene.coordinate("x", "m");
  EXPECT_TRUE(error_of<SceneError>([&] { scene.attitude("1st"); }).starts_with("the name '1st' of an attitude cannot be"));
  scene.parameter("p", "1", 1);
  const std::string text = error_of<SceneError>([&] { scene.coordinate("p", "m"); });
  EXPECT_NE(text.find("already has a parameter of that name"), std::string::npos) << text;
  scene.motor("u", x);
  const std::string taken = error_of<SceneError>([&] { scene.coordinate("u", "m"); });
  EXPECT_NE(taken.find("already has an input of that name"), std::string::npos) << taken;
}

using SceneCoordinates = SceneTest;

TEST_F(SceneCoordinates, BringTheirVelocityAndAccelerationAlong) {
  const SymbolPointer q = scene.coordinate("x", "m").as_symbol();
  ASSERT_TRUE(q && q->rate && q->rate->rate);
  EXPECT_EQ(q->kind, SymbolKind::coordinate);
  EXPECT_EQ(q->rate->name, "x'");
  EXPECT_EQ(q->rate->unit, units::metre_per_second);
  EXPECT_EQ(q->rate->rate->unit, units::metre_per_second_squared);
  EXPECT_EQ(q->rate->rate->kind, SymbolKind::acceleration);
}

TEST_F(SceneCoordinates, FollowOneLawOfTimeInTheirOwnUnit) {
  const Expression x = scene.coordinate("x", "m");
  EXPECT_EQ(error_of<UnitError>([&] { scene.drive(x, scene.time()); }),
            "coordinate 'x' [m] cannot follow the law t [s]: the units differ");
  scene.drive(x, scene.time() * Expression::quantity("2", "m/s"));
  EXPECT_EQ(error_of<SceneError>([&] { scene.drive(x, 0); }), "coordinate 'x' is driven twice: keep one law of time");
  EXPECT_EQ(error_of<SceneError>([&] { scene.drive(2 * x, 0); }),
            "drive needs a coordinate of the scene 'machine' and got 2*x: pass what coordinate(...) returned");
}

TEST_F(SceneCoordinates, StartInTheirOwnUnit) {
  const Expression x = scene.coordinate("x", "m");
  scene.initial(x, 1);
  scene.initial(x, Expression::quantity("1", "m"), Expression::quantity("1", "m/s"));
  EXPECT_EQ(error_of<UnitError>([&] { scene.initial(x, Expression::quantity("1", "kg")); }),
            "initial value of 'x' is given in kg and must be in m");
  EXPECT_EQ(error_of<UnitError>([&] { scene.initial(x, 0, Expression::quantity("1", "m")); }),
            "initial rate of 'x' is given in m and must be in m/s");
}

TEST_F(SceneCoordinates, OfAnAttitudeStartWithTheirOwnRates) {
  const AttitudeHandle first = scene.attitude("first"), second = scene.attitude("second");
  scene.initial(second, {1, 0, 0, 0}, {1, 2, 3});
  scene.initial(first, {1, 0, 0, 0}, {4, 5, 6});
  std::vector<std::string> rates;
  for (const CoordinateContent& c : scene.content().coordinates) rates.push_back(c.initial_rate->to_string());
  EXPECT_EQ(rates, (std::vector<std::string>{"4", "5", "6", "1", "2", "3"}));
}

using SceneUnits = SceneTest;

TEST_F(SceneUnits, OfJointsAreAnglesAndLengths) {
  const Expression x = scene.coordinate("x", "m");
  const Expression theta = scene.coordinate("theta", "rad");
  EXPECT_EQ(error_of<UnitError>([&] { scene.revolute("arm", scene.ground(), axis::z, x); }),
            "the angle x of the joint 'arm' has the unit m and must be in rad");
  EXPECT_EQ(error_of<UnitError>([&] { scene.prismatic("slide", scene.ground(), axis::z, theta); }),
            "the displacement theta of the joint 'slide' has the unit 1 and must be in m");
}

TEST_F(SceneUnits, OfAParametersValueAreItsOwnOrNone) {
  scene.parameter("plain", "kg", 3);
  scene.parameter("same", "kg", Expression::quantity("3", "kg"));
  EXPECT_EQ(error_of<UnitError>([&] { scene.run_time_parameter("d", "m", Expression::quantity("3", "kg")); }),
            "parameter 'd' [m] is given the value 3 [kg]: the units differ; give a plain number or one in m");
  EXPECT_THROW(scene.parameter("e", "m", scene.time()), UnitError);
}

TEST_F(SceneUnits, OfMotorsMakeTheirPowerAPower) {
  EXPECT_EQ(scene.motor("pull", scene.coordinate("x", "m")).unit(), units::newton);
  EXPECT_EQ(scene.motor("turn", scene.coordinate("theta", "rad")).unit(), units::newton_metre);
}

TEST_F(SceneUnits, OfMultipliersMakeTheirForcesGeneralisedForces) {
  const Expression x = scene.coordinate("x", "m");
  const Expression theta = scene.coordinate("theta", "rad");
  scene.holonomic("length", x);
  scene.holonomic("angle", theta);
  scene.nonholonomic("speed", rate(theta));
  const auto& constraints = scene.content().constraints;
  EXPECT_EQ(constraints[0].multiplier->unit, units::newton);
  EXPECT_EQ(constraints[1].multiplier->unit, units::newton_metre);
  EXPECT_EQ(constraints[2].multiplier->unit, units::newton_metre);
}

TEST(SceneFree, MovesInThreeDirectionsThenTurnsAboutThreeAxesOfItsSequence) {
  Scene scene("floating");
  Triple position, angles;
  for (std::size_t i = 0; i < 3; ++i) {
    position[i] = scene.coordinate(std::string("p") + "xyz"[i], "m");
    angles[i] = scene.coordinate(std::string("a") + "123"[i], "rad");
  }
  scene.free("euler", scene.ground(), position, {.sequence = AngleSequence::euler, .angles = angles});
  scene.free("cardan", scene.ground(), position, {.sequence = AngleSequence::cardan, .angles = angles});
  const auto& frames = scene.content().frames;
  ASSERT_EQ(frames.size(), 13U);
  const auto axis_of = [&](std::size_t frame) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (!frames[frame].axis[i].is_zero()) return static_cast<int>(i);
    }
    return -1;
  };
  const std::vector<int> axes{0, 1, 2, 2, 0, 2, 0, 1, 2, 0, 1, 2};
  for (std::size_t k = 0; k < axes.size(); ++k) EXPECT_EQ(axis_of(k + 1), axes[k]) << frames[k + 1].name;
  EXPECT_EQ(frames[5].name, "euler.2");
  EXPECT_EQ(frames[6].name, "euler");
}

using SceneReactions = SceneTest;

TEST_F(SceneReactions, EnforceOneConstraintEach) {
  const Expression x = scene.coordinate("x", "m");
  const FrameHandle slide = scene.prismatic("slide", scene.ground(), axis::x, x);
  const PointHandle point = scene.point("P", slide, {0, 0, 0});
  const ConstraintHandle stop = scene.holonomic("stop", x);
  scene.reaction(stop, "N", {.body = slide, .contact = point, .direction = axis::x, .axes = "ground"});
  EXPECT_EQ(scene.content().constraints[0].multiplier->name, "N");
  EXPECT_EQ(error_of<SceneError>([&] {
              scene.reaction(stop, "R", {.body = slide, .contact = point, .direction = axis::x, .axes = "ground"});
            }),
            "constraint 'stop' already has the reaction 'N': one multiplier enforces one constraint");
}

TEST(Scene, KeepsLimitsOfCoordinatesAndRefusesThoseTheWrongWayRound) {
  Scene scene("limited");
  const Expression q = scene.coordinate("q", "rad");
  CoordinateLimits limits;
  limits.lower = Number(-1);
  limits.effort = Number(5);
  scene.limits(q, limits);
  ASSERT_TRUE(scene.content().coordinates[0].limits);
  EXPECT_EQ(scene.content().coordinates[0].limits->effort, Number(5));
  limits.upper = Number(-2);
  EXPECT_THROW(scene.limits(q, limits), SceneError);
  EXPECT_THROW(scene.limits(2 * q, {}), SceneError);
  // What a second call does not name stays.
  scene.limits(q, {.lower = {}, .upper = {}, .velocity = Number(3), .effort = {}});
  EXPECT_EQ(scene.content().coordinates[0].limits->lower, Number(-1));
  EXPECT_EQ(scene.content().coordinates[0].limits->velocity, Number(3));
  EXPECT_THROW(scene.limits(q, {.lower = {}, .upper = Number(-2), .velocity = {}, .effort = {}}), SceneError);
}

TEST(Scene, TakesAnotherValueOfAParameter) {
  Scene scene("machine");
  const Expression m = scene.parameter("m", "kg", 1), n = scene.run_time_parameter("n", "kg", 2 * m);
  scene.set_parameter(m, Expression::quantity("3", "kg"));
  EXPECT_EQ(scene.content().parameters[0].value->to_string(), "3");
  EXPECT_FALSE(scene.content().parameters[0].run_time);
  scene.set_parameter(n, 4 * m);
  EXPECT_TRUE(scene.content().parameters[1].run_time);
  EXPECT_EQ(error_of<SceneError>([&] { scene.set_parameter(m, n); }),
            "the value n of the parameter 'm' depends on 'm' itself: give a number or a formula of other parameters");
  EXPECT_THROW(scene.set_parameter(m, Expression::quantity("1", "s")), UnitError);
  EXPECT_THROW(scene.set_parameter(2 * m, 1), SceneError);
}

TEST(Scene, HasOneGravity) {
  Scene scene("stone");
  const Triple down{0, 0, Expression::quantity("-10", "m/s^2")};
  scene.gravity(down);
  EXPECT_EQ(error_of<SceneError>([&] { scene.gravity(down); }),
            "the scene 'stone' has a gravity already: give one sum of both, or a force for what else acts");
}

}  // namespace
}  // namespace torsor::scene_test
