// SPDX-License-Identifier: GPL-3.0-or-later
// Articulated bodies as sums of squares against the factorised mass matrix: two derivations to the same accelerations.
#include "torsor/generator/dynamics/recursions/factored_bodies.hpp"

#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <string>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/dynamics/derivatives/forward_derivatives.hpp"
#include "torsor/generator/dynamics/equations/equations.hpp"
#include "torsor/generator/dynamics/equations/forward_choice.hpp"
#include "torsor/generator/kernels/kernel.hpp"
#include "torsor/generator/program/evaluation.hpp"
#include "torsor/generator/verification/random_state.hpp"
#include "tests/dynamics/central_differences.hpp"
#include "tests/dynamics/random_mechanism.hpp"
#include "tests/long_tests.hpp"
#include "tests/scenes/bodies.hpp"

namespace torsor::factored_bodies_test {
namespace {

using namespace testing_mechanisms;

ModelOptions by(ForwardMethod method) { return {.forward = method}; }

/// The largest difference of the accelerations by the two methods, relative to one and them; all lengths that move are
/// `lengths` where this is given.
double difference(const Scene& scene, std::uint64_t seed, const std::optional<Number>& lengths = {}) {
  const WorkingDigits precision(60);
  const Equations squares(scene, by(ForwardMethod::sums_of_squares)), factored(scene, by(ForwardMethod::factorisation));
  const RandomState state(scene, seed);
  const auto values = [&, drawn = state.in_real()](const SymbolPointer& symbol) {
    return lengths && symbol->kind == SymbolKind::coordinate && symbol->unit == units::metre ? Real(*lengths, 60) : drawn(symbol);
  };
  Evaluator<Real> first(squares.program(), values), second(factored.program(), values);
  const std::vector<Real> x = first(squares.forward().accelerations), y = second(factored.forward().accelerations);
  EXPECT_EQ(x.size(), y.size());
  double worst = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double off = abs(x[i] - y[i]).to_double() / (1 + abs(y[i]).to_double());
    if (!(off <= worst)) worst = off;
  }
  return worst;
}

/// 60 digits less what a condition of M below 1e5 and a few hundred operations cost.
constexpr double rounding = 1e-48;

TEST(FactoredBodies, GiveTheAccelerationsOfTheFactorisedMassMatrix) {
  int trees = 0;
  const unsigned seeds = wanted(20U, 40U);
  for (unsigned seed = 300; seed < 300 + seeds; ++seed) {
    const Scene scene = random_mechanism(seed, {.constraints = false});
    if (!joint_coordinates(Equations(scene).model())) continue;  // a displacement that is a formula
    ++trees;
    EXPECT_LT(difference(scene, 4), rounding) << seed;
  }
  EXPECT_GE(trees, static_cast<int>(seeds) / 4);
}

// Several bodies on a link, masses at run time, a link without matter, absolute angles, a slider, wrenches, a branch.
Scene tree() {
  Scene s("tree");
  const Expression a = s.coordinate("a", "rad"), b = s.coordinate("b", "rad"), c = s.coordinate("c", "rad");
  const Expression x = s.coordinate("x", "m"), d = s.coordinate("d", "rad");
  const Expression m = s.run_time_parameter("m", "kg", quantity("0.7", "kg"));
  const FrameHandle first = s.revolute("first", s.ground(), axis::z, a, {.origin = {quantity("0.1", "m"), 0, 0}});
  const FrameHandle second = s.revolute("second", first, axis::z, b - a, {.origin = {0, quantity("-0.5", "m"), 0}});
  const FrameHandle third =
      s.revolute("third", second, axis::z, c - b + 2 * a, {.origin = {0, quantity("-0.4", "m"), 0}});
  const FrameHandle slide = s.prismatic("slide", first, {0, 1, 1}, x, {.rotation = Rotation::about(0, 2)});
  const FrameHandle tip = s.revolute("tip", slide, {1, 2, 2}, d, {.origin = {0, 0, quantity("0.3", "m")}});
  s.body("one", first, Inertia::point(m).at({0, quantity("-0.5", "m"), 0}));
  s.body("other", first, generic_body("1.5"));
  s.body("end", third, Inertia::rod(m, quantity("0.6", "m"), 1).at({0, quantity("-0.3", "m"), 0}));
  s.body("flange", s.weld("flange", third, {.origin = {0, 0, quantity("0.1", "m")}, .rotation = Rotation::about(1, 5)}),
         generic_body("0.6"));
  s.body("block", tip, generic_body("2"));
  s.body("weight", tip, generic_body("0.5"));
  s.gravity({0, quantity("-9.81", "m/s^2"), 0});
  const PointHandle p = s.point("P", tip, {quantity("0.3", "m"), 0, 0});
  s.force("force", {.body = tip, .point = p, .components = {0, quantity("3", "N"), 0}, .axes = s.ground()});
  s.spring("spring", {.a = p,
                      .b = s.point("Q", s.ground(), {0, quantity("1", "m"), 0}),
                      .stiffness = quantity("40", "N/m"),
                      .rest = quantity("0.2", "m")});
  s.motor("u", c);
  return s;
}

TEST(FactoredBodies, KnowAbsoluteAnglesSeveralBodiesAndLinksWithoutMatter) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) EXPECT_LT(difference(tree(), seed), rounding) << seed;
}

/// A cart, a rod that turns on it, and a slider along the rod with a tool that turns.
Scene telescope(bool driven) {
  Scene s("telescope");
  const Expression u = s.coordinate("u", "m");
  const FrameHandle cart = s.prismatic("cart", s.ground(), axis::x, s.coordinate("x", "m"));
  const FrameHandle rod = s.revolute("rod", cart, axis::z, s.coordinate("theta", "rad"));
  const FrameHandle slider = s.prismatic("slider", rod, axis::x, u);
  const FrameHandle tool = s.revolute("tool", slider, axis::z, s.coordinate("phi", "rad"));
  int number = 0;
  for (const FrameHandle& frame : {cart, rod, slider, tool}) {
    const std::string name = "m" + std::to_string(++number);
    s.body(name, frame, Inertia::box(s.run_time_parameter(name, "kg", quantity("1", "kg")), quantity("1", "m"), quantity("0.5", "m"),
                                     quantity("0.2", "m")));
  }
  if (driven) s.drive(u, quantity("1", "m/s") * s.time() - quantity("0.5", "m"));
  s.gravity({0, quantity("-9.81", "m/s^2"), 0});
  return s;
}

// The point that a turn is told by lies on its axis there: no length between them may be divided by.
TEST(FactoredBodies, PassPlacesWhereASliderIsOnTheAxisOfItsTurn) {
  for (const Number& u : {Number(0), Number::rational(1, 1'000'000'000), Number(10).pow(-100)})
    EXPECT_LT(difference(telescope(false), 1, u), rounding) << u.to_double();
  const Scene driven = telescope(true);
  const WorkingDigits precision(60);
  const Equations equations(driven, by(ForwardMethod::sums_of_squares));
  const RandomState state(driven, 2);
  Evaluator<Real> there(equations.program(), [&](const SymbolPointer& symbol) {
    return symbol->kind == SymbolKind::time ? Real(Number::rational(1, 2), 60) : state.in_real()(symbol);
  });
  for (const Real& acceleration : there(equations.forward().accelerations)) EXPECT_FALSE(acceleration.is_nan());
}

Scene satellite() {
  Scene s("satellite");
  std::vector<Expression> place;
  for (const char* name : {"x", "y", "z"}) place.push_back(s.coordinate(name, "m"));
  FrameHandle frame = s.ground();
  int i = 0;
  for (const Triple& axis : {axis::x, axis::y, axis::z}) {
    frame = s.prismatic("slide" + std::to_string(i), frame, axis, place[static_cast<std::size_t>(i)]);
    ++i;
  }
  frame = s.spherical("hull", frame, s.attitude("e"));
  s.body("hull", frame, generic_body("3"));
  const FrameHandle arm = s.revolute("arm", frame, axis::x, s.coordinate("q", "rad"), {.origin = {quantity("0.4", "m"), 0, 0}});
  s.body("arm", arm, generic_body("0.8"));
  s.gravity({0, 0, quantity("-9.81", "m/s^2")});
  return s;
}

TEST(FactoredBodies, CarryAFreeBodyWithAnArm) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) EXPECT_LT(difference(satellite(), seed), rounding) << seed;
}

// Definition by definition against the equations, differentiated and solved.
TEST(FactoredBodies, HaveTheDerivativesOfTheFactorisedMassMatrix) {
  const WorkingDigits precision(60);
  for (const Scene& scene : {tree(), satellite(), random_mechanism(302, {.motors = true, .constraints = false})}) {
    const Equations squares(scene, by(ForwardMethod::sums_of_squares)), factored(scene, by(ForwardMethod::factorisation));
    const ForwardDerivatives one = forward_derivatives(squares), other = forward_derivatives(factored);
    EXPECT_EQ(one.method, "differentiating articulated bodies as sums of squares");
    const RandomState state(scene, 3);
    Evaluator<Real> first(squares.program(), state.in_real()), second(factored.program(), state.in_real());
    using Of = ForwardDerivatives::Of;
    for (const auto matrix : {&Of::by_position, &Of::by_velocity, &Of::by_force, &Of::by_input}) {
      EXPECT_LT(largest_difference(first(flattened(one.accelerations.*matrix)),
                                   second(flattened(other.accelerations.*matrix))),
                rounding * 1e5)  // the condition once more
          << scene.name();
    }
  }
}

TEST(FactoredBodies, HaveTheStateMatricesOfTheFactorisedMassMatrix) {
  const WorkingDigits precision(60);
  for (const Scene& scene : {tree(), satellite()}) {
    const Equations squares(scene, by(ForwardMethod::sums_of_squares)), factored(scene, by(ForwardMethod::factorisation));
    const RandomState state(scene, 6);
    std::map<std::string, Real> first, second;
    const auto fill = [&state](const Equations& equations, std::map<std::string, Real>& results) {
      const Kernel kernel = derive_kernel("linearisation", equations);
      Evaluator<Real> at(equations.program(), state.in_real());
      for (const Assignment& each : kernel.assignments) results.emplace(each.target.to_string(), at(each.value));
    };
    fill(squares, first);
    fill(factored, second);
    ASSERT_EQ(first.size(), second.size());
    int differ = 0;
    for (const auto& [target, value] : first) {
      const Real& other = second.at(target);
      if (!(abs(value - other).to_double() <= rounding * 1e5 * (1 + abs(other).to_double()))) ++differ;
    }
    EXPECT_EQ(differ, 0) << scene.name();
  }
}

// Taylor coefficients solve for accelerations with L D Lᵀ of M where that costs less, and loses no digits.
TEST(FactoredBodies, ExpandWhatTheyAreMadeOf) {
  const Scene scene = tree();
  const Equations squares(scene, by(ForwardMethod::sums_of_squares)), factored(scene, by(ForwardMethod::factorisation));
  EXPECT_FALSE(derive_kernel("jets", squares).series->solve);
  EXPECT_TRUE(derive_kernel("jets", factored).series->solve);
}

void expect_refused(const Scene& scene) {
  try {
    Equations(scene, by(ForwardMethod::sums_of_squares)).forward();
    FAIL() << scene.name() << " is taken";
  } catch (const UsageError& error) {
    EXPECT_EQ(std::string(error.what()),
              "articulated bodies as sums of squares do not fit the scene '" + scene.name() +
                  "': they need a tree without constraints, with as many joints as coordinates, their displacements "
                  "linear in these");
  }
}

TEST(FactoredBodies, AreRefusedWhereTheyDoNotFit) {
  Scene s("coupled");
  const Expression a = s.coordinate("a", "rad");
  const FrameHandle first = s.revolute("first", s.ground(), axis::z, a);
  const FrameHandle second = s.revolute("second", first, axis::z, 2 * a);
  s.body("one", first, generic_body("1"));
  s.body("other", second, generic_body("1"));
  expect_refused(s);
  // The acceleration of the joint has a part of time alone.
  Scene shaken("shaken");
  const Expression b = shaken.coordinate("b", "rad");
  const Expression law = Expression(Number::rational(1, 5)) * sin(quantity("3", "rad/s") * shaken.time());
  shaken.body("one", shaken.revolute("first", shaken.ground(), axis::z, b + law), generic_body("1"));
  expect_refused(shaken);
}

}  // namespace
}  // namespace torsor::factored_bodies_test
