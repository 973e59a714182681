// SPDX-License-Identifier: GPL-3.0-or-later
// Forward dynamics of chains whose links have masses of ratios from 1e-6 to 1e6: absolute and relative angles, masses as
// numbers and at run time, in the plane and in space, each method evaluated as its header does and compared with CLN.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "torsor/generator/dynamics/equations/equations.hpp"
#include "torsor/generator/verification/verify.hpp"

namespace torsor::mass_ratios_test {
namespace {

enum class Angles { relative, absolute };
enum class Masses { numbers, at_run_time };
enum class Shape { point, box };
enum class Axes { parallel, crossed };

struct Chain {
  std::vector<int> powers;  ///< of ten, of the masses from the ground outwards [kg]
  Angles angles = Angles::relative;
  Masses masses = Masses::numbers;
  Shape shape = Shape::point;
  Axes axes = Axes::parallel;
};

Scene scene_of(const Chain& chain) {
  Scene scene("chain");
  const auto parameter = [&](const std::string& name, const char* unit, const Expression& value) {
    return chain.masses == Masses::numbers ? scene.parameter(name, unit, value)
                                           : scene.run_time_parameter(name, unit, value);
  };
  const Expression l = parameter("l", "m", Expression(1));
  FrameHandle end = scene.ground();
  Triple origin{0, 0, 0};
  Expression before(0);
  for (std::size_t i = 0; i < chain.powers.size(); ++i) {
    const std::string number = std::to_string(i + 1);
    const Expression m = parameter("m" + number, "kg", Expression(Number(10).pow(chain.powers[i])));
    const Expression q = scene.coordinate("q" + number, "rad");
    const bool across = chain.axes == Axes::crossed && i % 2 == 1;
    const bool absolute = chain.angles == Angles::absolute && i > 0;
    end = scene.revolute("link" + number, end, across ? axis::y : axis::z, absolute ? q - before : q, {.origin = origin});
    before = q;
    scene.body("body" + number, end,
               chain.shape == Shape::point ? Inertia::point(m).at({l, 0, 0})
                                           : Inertia::box(m, l, l / 4, l / 8).at({l / 2, 0, 0}));
    origin = {l, 0, 0};
  }
  const Expression g = Expression::quantity("9.81", "m/s^2");
  if (chain.axes == Axes::crossed) {
    scene.gravity({0, 0, -g});
  } else {
    scene.gravity({0, -g, 0});
  }
  return scene;
}

ModelOptions by(ForwardMethod method) { return {.forward = method}; }

/// The worst scaled error of the accelerations, or of another kernel, in double at these many states, with CLN for the
/// truth.
double worst_of(const Scene& scene, ForwardMethod method, int states, const std::string& kernel = "forward_dynamics") {
  VerifyOptions options;
  options.model = by(method);
  options.kernels = {kernel};
  options.precisions = {Precision::in_double};
  options.states = states;
  options.climbs = 0;
  options.range = 6;
  double worst = 0;
  for (const VerifyRow& row : verify_scene(scene, options)) {
    EXPECT_TRUE(row.bounded()) << row.group;
    EXPECT_GE(row.states, states / 2) << row.group;
    worst = std::max(worst, row.worst.scaled);
  }
  return worst;
}

std::string name_of(const Chain& chain) {
  std::string name = chain.angles == Angles::absolute ? "absolute" : "relative";
  name += chain.masses == Masses::numbers ? ", numbers" : ", run time";
  name += chain.shape == Shape::point ? ", points" : ", boxes";
  name += chain.axes == Axes::parallel ? ", plane" : ", space";
  for (const int power : chain.powers) name += " 1e" + std::to_string(power);
  return name;
}

std::vector<Chain> formulations(const std::vector<std::vector<int>>& powers) {
  std::vector<Chain> all;
  for (const std::vector<int>& each : powers) {
    for (const Masses masses : {Masses::numbers, Masses::at_run_time}) {
      for (const Shape shape : {Shape::point, Shape::box}) {
        for (const Angles angles : {Angles::relative, Angles::absolute}) all.push_back({each, angles, masses, shape});
        all.push_back({each, Angles::relative, masses, shape, Axes::crossed});
      }
    }
  }
  return all;
}

// The bar of `verify`: 8 ulp times the condition.
TEST(MassRatios, OfTwoLinksCostNoDigitsByTheMethodThatIsChosen) {
  for (const Chain& chain : formulations({{-6, 0}, {-3, 0}, {0, 0}, {3, 0}, {6, 0}, {0, 6}, {0, -6}})) {
    EXPECT_LE(worst_of(scene_of(chain), ForwardMethod::cheapest, 24), accuracy_bar) << name_of(chain);
  }
}

TEST(MassRatios, OfTwoLinksCostNoDigitsBySumsOfSquares) {
  for (const Chain& chain : formulations({{-6, 0}, {6, 0}})) {
    EXPECT_LE(worst_of(scene_of(chain), ForwardMethod::sums_of_squares, 24), accuracy_bar) << name_of(chain);
  }
}

// Solved with M they hold differences of generalised forces of the heavy body, 1e3 times the bar and more.
TEST(MassRatios, OfTwoLinksCostNoDigitsOfDerivatives) {
  for (const Chain& chain : formulations({{-6, 0}, {-3, 0}, {0, -6}})) {
    const double worst = worst_of(scene_of(chain), ForwardMethod::cheapest, 24, "forward_dynamics_derivatives");
    EXPECT_LE(worst, accuracy_bar) << name_of(chain);
  }
}

// A heavy body next to the first joint, at rest or not, has energies that are differences where they are found from the
// origins of links and from one cosine after the other: 1e5 times the bar.
TEST(MassRatios, OfTwoLinksCostNoDigitsOfEnergiesAndForces) {
  for (const Chain& chain : formulations({{-6, 0}, {-3, 0}, {0, -6}, {6, 0}})) {
    for (const char* kernel : {"energy", "first_integrals", "bias", "inverse_dynamics", "mass_matrix"}) {
      const double worst = worst_of(scene_of(chain), ForwardMethod::cheapest, 48, kernel);
      EXPECT_LE(worst, accuracy_bar) << kernel << " of " << name_of(chain);
    }
  }
}

// Of longer chains the rate of a joint is u − g A, with |g| up to half the root of the ratio of the masses where a light
// link lies nearly in line with what it pulls (g = m s c/(m' + m s²), largest at s² = m'/m): that many times the last bit
// of the parent's acceleration A. Differences of inertias lose the ratio itself, 1e6.
TEST(MassRatios, OfLongerChainsCostTheRootOfTheRatioAtMostBySumsOfSquares) {
  const double allowed = accuracy_bar + 0.5 * std::sqrt(1e6);
  for (const Chain& chain : formulations({{-6, -6, 0}, {0, -6, 0}, {6, 0, 6}, {-6, -6, 0, 0}, {-6, -3, 0, 3}})) {
    const bool boxes_in_space = chain.shape == Shape::box && chain.axes == Axes::crossed;
    if (boxes_in_space && chain.powers.size() > 3) continue;  // a second each
    EXPECT_LE(worst_of(scene_of(chain), ForwardMethod::sums_of_squares, 16), allowed) << name_of(chain);
  }
}

// Of up to eight unknowns the method is chosen by a trial (forward_choice.hpp).
TEST(MassRatios, OfUpToEightLinksCostTheRootOfTheRatioAtMostByTheMethodThatIsChosen) {
  const double allowed = accuracy_bar + 0.5 * std::sqrt(1e6);
  for (const std::vector<int>& powers :
       {std::vector<int>{-6, -6, -6, -6, 0}, {0, -6, 0, -6, 0, 0}, {0, -6, 0, -6, 0, -6, 0, 0}}) {
    for (const Angles angles : {Angles::relative, Angles::absolute}) {
      const Chain chain{powers, angles};
      EXPECT_LE(worst_of(scene_of(chain), ForwardMethod::cheapest, 16), allowed) << name_of(chain);
    }
  }
}

// State matrices, about any accelerations: solved with M they lose 1e4 to 1e6 times the bar.
TEST(MassRatios, OfThreeLinksCostTheRootOfTheRatioAtMostInLinearisations) {
  const double allowed = accuracy_bar + 0.5 * std::sqrt(1e6);
  for (const Chain& chain : formulations({{-6, -6, 0}})) {
    EXPECT_LE(worst_of(scene_of(chain), ForwardMethod::cheapest, 16, "linearisation"), allowed) << name_of(chain);
  }
}

// What is chosen is the most accurate where that matters, and the cheapest where it does not.
TEST(MassRatios, DecideWhichMethodIsTaken) {
  const auto method_of = [](const Chain& chain) { return Equations(scene_of(chain)).forward().method; };
  EXPECT_EQ(method_of({{-6, 0}}), "articulated bodies as sums of squares");
  EXPECT_EQ(method_of({{-6, 0}, Angles::absolute, Masses::at_run_time}), "articulated bodies as sums of squares");
  EXPECT_EQ(method_of({{0, 0}, Angles::relative, Masses::at_run_time}), "articulated bodies as sums of squares");
  EXPECT_NE(method_of({{0, 0}}), "articulated bodies as sums of squares");
  EXPECT_NE(method_of({{6, 0}}), "articulated bodies as sums of squares");
}

}  // namespace
}  // namespace torsor::mass_ratios_test
