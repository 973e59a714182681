// SPDX-License-Identifier: GPL-3.0-or-later
// Laws and displacements that jump or have a kink, where a motion would need an impulse, are refused.
#include "torsor/generator/dynamics/equations/law_checks.hpp"

#include <functional>

#include <gtest/gtest.h>

#include "torsor/generator/dynamics/equations/validation.hpp"
#include "torsor/generator/expression/piecewise.hpp"
#include "tests/program/test_symbols.hpp"
#include "tests/scenes/pendulums.hpp"

namespace torsor::law_checks_test {
namespace {

using namespace testing_symbols;
using namespace testing_mechanisms;

std::string refusal(const Scene& scene) {
  return error_of([&] { validate(scene); });
}

/// A pendulum whose pivot a law of time moves, by a coordinate or as the displacement itself.
std::string refusal_of_law(const std::function<Expression(Scene&, const Expression& t)>& law, bool driven = true) {
  Scene scene("carried");
  const Expression formula = law(scene, scene.time()), x = scene.coordinate("x", "m");
  if (driven) scene.drive(x, formula);
  const FrameHandle pivot = scene.prismatic("pivot", scene.ground(), axis::x, driven ? x : formula + 2 * x);
  if (!driven) scene.body("cart", pivot, Inertia::point(kilograms("1")));
  const FrameHandle arm = scene.revolute("arm", pivot, axis::y, scene.coordinate("theta", "rad"));
  scene.body("bob", arm, Inertia::point(kilograms("1")).at({0, 0, metres("-1")}));
  return refusal(scene);
}

TEST(LawOfTime, IsRefusedWhereItsRateJumps) {
  const Expression half = quantity("0.5", "s"), speed = quantity("1", "m/s");
  EXPECT_EQ(refusal_of_law([&](Scene&, const Expression& t) { return max(speed * (t - half), 0); }),
            "coordinate 'x' is driven by the law max(t - 1/2, 0): its rate jumps at t = 0.5 s, and the motion has no impulse for "
            "it; give a law whose rate is continuous, as a spline is, or leave it an unknown with the condition holonomic(...) and "
            "start a motion anew there");
  const auto jumps = [&](const std::string& error, const char* what) {
    return error.find("coordinate 'x' is driven by the law ") == 0 && error.find(what) != std::string::npos;
  };
  const auto value = [&](const Expression& t) { return piecewise({{t < half, metres("0")}}, metres("0.3")); };
  const auto kink = [&](const Expression& t) { return piecewise({{t < half, metres("0")}}, speed * (t - half)); };
  const std::vector<std::function<Expression(Scene&, const Expression&)>> bent{
      [&](Scene&, const Expression& t) { return speed * abs(t - half); },
      [&](Scene&, const Expression& t) { return kink(t); },
      [&](Scene&, const Expression& t) { return metres("1") * abs(sin(t / half)); },
  };
  for (const auto& law : bent) EXPECT_TRUE(jumps(refusal_of_law(law), ": its rate jumps")) << refusal_of_law(law);
  EXPECT_TRUE(jumps(refusal_of_law([&](Scene&, const Expression& t) { return value(t); }), ": that jumps"));
  // Through another coordinate, whose law it is that bends.
  const auto chain = [&](int power) {
    return refusal_of_law([&, power](Scene& s, const Expression& t) {
      const Expression other = s.coordinate("u", "m");
      s.drive(other, kink(t));
      return metres("1") * pow(other / metres("1"), power);
    });
  };
  EXPECT_EQ(chain(1).find("coordinate 'u' is driven by the law "), 0U) << chain(1);
  EXPECT_EQ(chain(2), "no error");  // whose rate 2 u u' is continuous
  const std::string of_joint = refusal_of_law([&](Scene&, const Expression& t) { return kink(t); }, false);
  EXPECT_EQ(of_joint.find("the displacement of joint 'pivot' is "), 0U) << of_joint;
}

// Kinks and jumps that stand in no abs and no piecewise: where a root touches zero, and where an angle goes through its cut.
TEST(LawOfTime, IsRefusedWhereItsKinkIsHidden) {
  const Expression half = quantity("0.5", "s"), m = metres("1"), second = quantity("1", "s");
  const auto kink = [&](const std::function<Expression(const Expression& u)>& law, const char* where) {
    const std::string refused = refusal_of_law([&](Scene&, const Expression& t) { return m * law((t - half) / second); });
    EXPECT_NE(refused.find(where), std::string::npos) << refused;
  };
  const Expression tenth = quantity("0.1", "1");
  kink([](const Expression& u) { return sqrt(u * u); }, "law sqrt((t - 1/2)*(t - 1/2)): its rate jumps at t = 0.5 s, and");
  kink([](const Expression& u) { return sqrt(u * u + 2 * pow(u, 4)); }, ": its rate jumps at t = 0.5 s, and");
  kink([](const Expression& u) { return sqrt(u * u - u * u * u + pow(u, 4)); }, ": its rate jumps at t = 0.5 s, and");
  kink([](const Expression& u) { return sqrt(pow(u, 2) + pow(sin(u), 2)); }, ": its rate jumps at t = 0.5 s, and");
  kink([](const Expression& u) { return sqrt(1 - cos(u)); }, ": its rate jumps at t = 0.5 s, and");
  kink([](const Expression& u) { return sqrt(1 - cos(10 * u + 1)); }, ": its rate jumps at t = ");
  kink([](const Expression& u) { return atan2(sin(u), sqrt(1 - pow(sin(u), 2))); }, ": its rate jumps at t = ");  // asin(sin(u))
  kink([](const Expression& u) { return atan2(sqrt(1 - pow(cos(u), 2)), cos(u)); }, ": its rate jumps at t = ");  // acos(cos(u))
  kink([](const Expression& u) { return atan2(sin(10 * u), cos(10 * u)); }, ": that jumps at t = ");
  kink([](const Expression& u) { return atan2(u, u * u); }, ": that jumps at t = 0.5 s, and");
  kink([&](const Expression& u) { return atan2(u * tenth, -1); }, ": that jumps at t = 0.5 s, and");
}

TEST(LawOfTime, MayHoldRootsAndAnglesThatTurnSmoothly) {
  const Expression half = quantity("0.5", "s"), m = metres("1"), second = quantity("1", "s");
  const std::vector<std::function<Expression(const Expression& u)>> smooth{
      [](const Expression& u) { return sqrt(pow(u, 4)); },
      [](const Expression& u) { return sqrt(pow(u, 4) + pow(u, 6)); },
      [](const Expression& u) { return sqrt(u * u + quantity("1e-12", "1")); },
      [](const Expression& u) { return sqrt(2 - cos(u)); },
      [](const Expression& u) { return sqrt(exp(2 * u)); },
      [](const Expression& u) { return atan2(u, 1); },
      [](const Expression& u) { return atan2(sin(3 * u), 2 + cos(3 * u)); },
      [](const Expression& u) { return pow(atan2(sin(10 * u), cos(10 * u)), 2) * pow(1 + cos(10 * u), 2); },
  };
  for (const auto& law : smooth) {
    EXPECT_EQ(refusal_of_law([&](Scene&, const Expression& t) { return m * law((t - half) / second); }), "no error");
  }
}

/// A crank that a law of time turns, by a share of its angle.
std::string refusal_of_turn(const Expression& share) {
  Scene scene("turned");
  const Expression phi = scene.coordinate("phi", "rad"), u = 10 * scene.time() / quantity("1", "s");
  scene.drive(phi, atan2(sin(u), cos(u)));
  const FrameHandle crank = scene.revolute("crank", scene.ground(), axis::z, share * phi);
  const FrameHandle arm = scene.revolute("arm", crank, axis::y, scene.coordinate("theta", "rad"));
  scene.body("bob", arm, Inertia::point(kilograms("1")).at({0, 0, metres("-1")}));
  return refusal(scene);
}

// A full turn changes nothing, half of one does.
TEST(LawOfTime, MayGoThroughTheCutOfAnAngleByWholeTurns) {
  EXPECT_EQ(refusal_of_turn(1), "no error");
  EXPECT_EQ(refusal_of_turn(2), "no error");
  const std::string half = refusal_of_turn(Expression(1) / 2);
  EXPECT_NE(half.find(": that jumps at t = "), std::string::npos) << half;
}

TEST(LawOfTime, MayBendWhereItsRateIsContinuous) {
  const Expression half = quantity("0.5", "s"), third = quantity("1", "m/s^2");
  const auto from_rest = [&](const Expression& t) { return third * pow(max(t - half, 0), 2); };
  EXPECT_EQ(refusal_of_law([&](Scene&, const Expression& t) { return from_rest(t); }), "no error");
  EXPECT_EQ(refusal_of_law([&](Scene&, const Expression& t) { return from_rest(t); }, false), "no error");
  const auto curve = [&](const Expression& t) { return spline(t, {{0, 0}, {1, 0.5}, {2, 0.25}}, "m"); };
  EXPECT_EQ(refusal_of_law([&](Scene&, const Expression& t) { return curve(t); }), "no error");
  // Two straight lines with slopes that are equal for the values that the parameters have.
  const auto lines = [&](int slope) {
    return refusal_of_law([&, slope](Scene& s, const Expression& t) {
      const Expression a = s.run_time_parameter("a", "m/s", 2), b = s.run_time_parameter("b", "m/s", slope);
      return piecewise({{t < half, a * (t - half)}}, b * (t - half));
    });
  };
  EXPECT_EQ(lines(2), "no error");
  EXPECT_NE(lines(3), "no error");
}

/// A pendulum whose pivot a formula of its own angle moves, by a driven coordinate or as the displacement itself.
std::string refusal_of_slope(const std::function<Expression(const Expression& theta)>& formula, bool driven, bool heavy = true) {
  Scene scene("pushed");
  const Expression theta = scene.coordinate("theta", "rad"), x = scene.coordinate("x", "m");
  if (driven) scene.drive(x, formula(theta));
  const FrameHandle pivot = scene.prismatic("pivot", scene.ground(), axis::x, driven ? x : formula(theta) + 2 * x);
  const FrameHandle arm = scene.revolute("arm", heavy ? pivot : scene.ground(), axis::y, theta);
  scene.body("bob", arm, Inertia::point(kilograms("1")).at({0, 0, metres("-1")}));
  if (!driven) scene.body("cart", scene.prismatic("cart", scene.ground(), axis::x, x), Inertia::point(kilograms("1")));
  return refusal(scene);
}

TEST(LawOfACoordinate, IsRefusedWhereItsSlopeJumps) {
  const auto bent = [](const Expression& theta) { return metres("0.3") * abs(theta); };
  const std::string remedy = ", and the motion has no impulse for it; give a formula whose slope is continuous, as a spline is, "
                             "or round the corner off, as sqrt(a^2 + b^2) does abs(a)";
  EXPECT_EQ(refusal_of_slope(bent, true),
            "coordinate 'x' is driven by the law 3/10*abs(theta): its slope along 'theta' jumps" + remedy);
  EXPECT_EQ(refusal_of_slope(bent, false),
            "the displacement of joint 'pivot' is (3/10*abs(theta) + 2*x): its slope along 'theta' jumps" + remedy);
  const auto root = [](const Expression& theta) { return metres("0.3") * sqrt(1 - cos(theta)); };
  EXPECT_NE(refusal_of_slope(root, true).find(": its slope along 'theta' jumps, and"), std::string::npos);
  EXPECT_NE(refusal_of_slope(root, false).find(": its slope along 'theta' jumps, and"), std::string::npos);
  const auto step = [](const Expression& theta) { return piecewise({{theta < 0, metres("0")}}, metres("0.3")); };
  EXPECT_NE(refusal_of_slope(step, true).find(": that jumps along 'theta', and"), std::string::npos);
  EXPECT_EQ(refusal_of_slope(bent, false, false), "no error");  // a frame that carries nothing
}

TEST(LawOfACoordinate, MayBendWhereItsSlopeIsContinuous) {
  const std::vector<std::function<Expression(const Expression&)>> smooth{
      [](const Expression& theta) { return metres("0.3") * theta * abs(theta); },
      [](const Expression& theta) { return metres("0.3") * pow(max(theta, 1) - 1, 2); },
      [](const Expression& theta) { return metres("0.3") * tanh(3 * theta); },
      [](const Expression& theta) { return metres("0.3") * sqrt(2 + sin(theta)); },
      [](const Expression& theta) { return spline(theta, {{0, 0}, {1, 0.5}, {2, 0.25}}, "m"); },
      // (cos + |cos|)^2: where it is zero all that is left beside it are roundings.
      [](const Expression& theta) { return metres("1") * pow(cos(theta) + sqrt(1 - pow(sin(theta), 2)), 2); },
  };
  for (const auto& formula : smooth) {
    for (const bool driven : {true, false}) EXPECT_EQ(refusal_of_slope(formula, driven), "no error");
  }
}

}  // namespace
}  // namespace torsor::law_checks_test
