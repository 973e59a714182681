// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/equations/equations.hpp"

#include <gtest/gtest.h>

#include "torsor/generator/dynamics/derivatives/linearisation.hpp"
#include "torsor/generator/verification/random_state.hpp"
#include "tests/dynamics/random_mechanism.hpp"
#include "tests/program/test_symbols.hpp"
#include "tests/scenes/rolling.hpp"

namespace torsor::equations_test {
namespace {

using namespace testing_symbols;
using namespace testing_mechanisms;

class RandomEquations : public ::testing::TestWithParam<unsigned> {
 protected:
  const WorkingDigits precision{60};
};

/// ‖x − y‖ / ‖y‖ over all entries.
double distance(const std::vector<Real>& x, const std::vector<Real>& y) {
  Real difference(0);
  Real size(0);
  for (std::size_t i = 0; i < y.size(); ++i) difference += abs(x[i] - y[i]), size += abs(y[i]);
  return difference.is_zero() ? 0 : (difference / size).to_double();
}

std::vector<Value> recursion_less_passive(const Equations& equations, std::vector<Value> recursion) {
  for (std::size_t i = 0; i < recursion.size(); ++i) recursion[i] -= equations.actions().passive[i];
  return recursion;
}

TEST_P(RandomEquations, AreTheSameWithAndWithoutRegroupedInertia) {
  const Scene scene = random_mechanism(GetParam());
  const Equations regrouped(scene);
  const Equations plain(scene, as_given({}));
  const RandomState state(scene, 5);
  Evaluator<Real> first(regrouped.program(), state.in_real());
  Evaluator<Real> second(plain.program(), state.in_real());
  EXPECT_LT(distance(first(regrouped.inverse_dynamics()), second(plain.inverse_dynamics())), 1e-45);
  EXPECT_LT(distance(first(regrouped.bias()), second(plain.bias())), 1e-45);
  for (std::size_t i = 0; i < plain.mass().size(); ++i) {
    EXPECT_LT(distance(first(regrouped.mass()[i]), second(plain.mass()[i])), 1e-45);
  }
}

TEST_P(RandomEquations, GiveBackTheAccelerationsWhoseForcesTheMotorsSupply) {
  const Scene scene = random_mechanism(GetParam(), {.motors = true, .constraints = false});
  const Equations equations(scene);
  const Model& model = equations.model();
  const RandomState state(scene, 6);
  const auto n = static_cast<std::size_t>(model.unknown_count());
  const std::vector<SymbolPointer> inputs = model.inputs();
  ASSERT_EQ(inputs.size(), n);  // motor k works with the unknown k
  Evaluator<Real> evaluate(equations.program(), state.in_real());
  std::vector<Real> forces = evaluate(equations.inverse_dynamics());
  Evaluator<Real> driven(equations.program(), [&](const SymbolPointer& symbol) {
    for (std::size_t k = 0; k < n; ++k) {
      if (symbol == inputs[k]) return forces[k];
    }
    return state.in_real()(symbol);
  });
  std::vector<Real> wanted;
  for (std::size_t i = 0; i < n; ++i) wanted.push_back(evaluate(model.a(static_cast<int>(i))));
  // Rounding of 60 digits times the condition of M, which stays below 1e8 for these.
  EXPECT_LT(distance(driven(equations.forward().accelerations), wanted), 1e-48);
}

TEST_P(RandomEquations, AreLinearInAccelerationsWithTheMassMatrixAndTheBias) {
  const Scene scene = random_mechanism(GetParam(), {.constraints = false});
  const Equations equations(scene);
  const Model& model = equations.model();
  const RandomState state(scene, 8);
  Evaluator<Real> evaluate(equations.program(), state.in_real());
  const auto n = static_cast<std::size_t>(model.unknown_count());
  std::vector<Real> sums, whole;
  for (std::size_t i = 0; i < n; ++i) {
    Real sum = evaluate(equations.bias()[i]);
    for (std::size_t j = 0; j < n; ++j)
      sum += evaluate(equations.mass()[i][j]) * evaluate(model.a(static_cast<int>(j)));
    sums.push_back(sum);
  }
  // By one recursion, which inverse_dynamics() need not be.
  const std::vector<Value> recursion = recursion_less_passive(
      equations, inertia_forces(model, AccelerationInput::symbols, equations.actions().wrenches));
  std::vector<Real> chosen;
  for (std::size_t i = 0; i < n; ++i) {
    whole.push_back(evaluate(recursion[i]));
    chosen.push_back(evaluate(equations.inverse_dynamics()[i]));
  }
  EXPECT_LT(distance(sums, whole), 1e-45);
  EXPECT_LT(distance(chosen, whole), 1e-45);
}

/// A body welded to a frame that is welded to a turned one stands where the product of both placements puts it.
TEST(Equations, PlaceWeldsInsideWelds) {
  const auto arm_with = [](bool in_two_steps) {
    Scene scene("arm");
    const FrameHandle arm = scene.revolute("arm", scene.ground(), {1, 2, 2}, scene.coordinate("q", "rad"));
    const Rotation quarter = Rotation::about(2, 6), tilt = Rotation::about(0, 4);  // x to y; y towards z
    FrameHandle flange = arm;
    if (in_two_steps) {
      const FrameHandle plate = scene.weld("plate", arm, {.origin = {metres("1"), 0, 0}, .rotation = quarter});
      flange = scene.weld("flange", plate, {.origin = {metres("2"), 0, metres("3")}, .rotation = tilt});
    } else {
      flange =
          scene.weld("flange", arm, {.origin = {metres("1"), metres("2"), metres("3")}, .rotation = quarter * tilt});
    }
    scene.body("tool", flange,
               Inertia::box(Expression::quantity("2", "kg"), metres("1"), metres("0.5"), metres("0.2"))
                   .at({metres("0.1"), metres("0.4"), 0}));
    scene.gravity({0, 0, Expression::quantity("-10", "m/s^2")});
    return scene;
  };
  const WorkingDigits precision(50);
  const Equations one(arm_with(true)), other(arm_with(false));
  const auto at = [](const SymbolPointer& symbol) { return symbol->name == "q" ? rational(2, 7) : rational(3, 5); };
  Evaluator<Real> first(one.program(), at), second(other.program(), at);
  EXPECT_LT(relative_difference(first(one.mass()[0][0]), second(other.mass()[0][0])), 1e-45);
  EXPECT_LT(relative_difference(first(one.bias()[0]), second(other.bias()[0])), 1e-45);
}

/// s = t³ m/s³ moves the hand; a force of 2 kg s'' + 3 N s/m s' on a mass of 2 kg.
TEST(Equations, KnowTheRatesOfADrivenCoordinate) {
  Scene scene("hand");
  const Expression x = scene.coordinate("x", "m"), s = scene.coordinate("s", "m");
  scene.drive(s, Expression::quantity("1", "m/s^3") * pow(scene.time(), 3));
  const FrameHandle block = scene.prismatic("block", scene.ground(), axis::x, x);
  scene.body("block", block, Inertia::point(Expression::quantity("2", "kg")));
  scene.generalised_force(
      "pull", x, Expression::quantity("2", "kg") * rate(rate(s)) + Expression::quantity("3", "N s/m") * rate(s));
  const Equations equations(scene);
  const WorkingDigits precision(50);
  const Real t = rational(3, 4);
  Evaluator<Real> here(equations.program(),
                       [&](const SymbolPointer& symbol) { return symbol->kind == SymbolKind::time ? t : Real(0); });
  EXPECT_LT(relative_difference(here(equations.forward().accelerations[0]), Real(6) * t + rational(9, 2) * t * t),
            1e-45);
}

/// A ball of mass m that rolls without slip is pushed as if it had the mass 7 m/5, along x as along y.
TEST(Equations, OfARollingBallHoldItsSpinInBothDirections) {
  Scene scene("ball");
  add_rolling_ball(scene, scene.ground(), Inertia::solid_sphere(kilograms("2"), metres("0.5")));
  scene.motor("along", Expression(scene.content().coordinates[0].q));
  scene.motor("across", Expression(scene.content().coordinates[1].q));
  const Equations equations(scene);
  const WorkingDigits precision(50);
  Evaluator<Real> here(equations.program(), [](const SymbolPointer& symbol) {
    if (symbol->name == "along") return Real(14);
    if (symbol->name == "across") return Real(28);
    return Real(symbol->name == "e_w" ? 1 : 0);
  });
  EXPECT_LT(relative_difference(here(equations.forward().accelerations[0]), Real(5)), 1e-45);
  EXPECT_LT(relative_difference(here(equations.forward().accelerations[1]), Real(10)), 1e-45);
}

// About the pivot the moments across the axis are equal, and the centre of mass is off the axis all the same: such a
// tip does not look the same turned. (1 + m d²) θ'' = −m g d sin θ with m = 2 kg, d = ½ m, g = 10 m/s².
TEST(Equations, OfAPendulumWithEqualMomentsAcrossItsAxisHaveItsWeight) {
  Scene scene("pendulum");
  const Expression theta = scene.coordinate("theta", "rad");
  const Inertia bob = Inertia::general({.mass = Expression::quantity("2", "kg"), .xx = moment("1"), .yy = moment("1.5"),
                                        .zz = moment("1")});
  scene.body("bob", scene.revolute("arm", scene.ground(), axis::z, theta),
             bob.at({0, Expression::quantity("-0.5", "m"), 0}));
  scene.gravity({0, Expression::quantity("-10", "m/s^2"), 0});
  const Equations equations(scene);
  const WorkingDigits precision(50);
  const Real angle = rational(2, 7);
  Evaluator<Real> here(equations.program(),
                       [&](const SymbolPointer& symbol) { return symbol->name == "theta" ? angle : Real(0); });
  EXPECT_LT(relative_difference(here(equations.forward().accelerations[0]), -Real(20) / Real(3) * sin(angle)), 1e-45);
}

/// A mass of 3 kg and one of 1 kg about their centre, which they leave at r/4 and 3 r/4.
TEST(Equations, ShowThatTheCentreOfMassUncouples) {
  using namespace literals;
  Scene scene("pair");
  const Expression X = scene.coordinate("X", "m"), r = scene.coordinate("r", "m");
  const FrameHandle centre = scene.prismatic("centre", scene.ground(), axis::x, X);
  const FrameHandle first = scene.prismatic("first", centre, axis::x, r / 4);
  const FrameHandle second = scene.prismatic("second", centre, axis::x, -3 * r / 4);
  scene.body("first", first, Inertia::point(Expression::quantity("3", "kg")));
  scene.body("second", second, Inertia::point(Expression::quantity("1", "kg")));
  const Equations equations(scene);
  EXPECT_TRUE(equations.mass()[0][1].is_zero());
  EXPECT_TRUE(equations.mass()[1][0].is_zero());
  // 4 X'' and 3/4 r''; joint by joint both forces depend on both accelerations.
  EXPECT_EQ(count(equations.program(), equations.inverse_dynamics()).total(), 2);
  const std::vector<Value> recursion =
      inertia_forces(equations.model(), AccelerationInput::symbols, equations.actions().wrenches);
  EXPECT_GT(count(equations.program(), recursion).total(), 2);
  const RandomState state(scene, 3);
  const WorkingDigits precision(60);
  Evaluator<Real> evaluate(equations.program(), state.in_real());
  EXPECT_LT(distance(evaluate(equations.inverse_dynamics()), evaluate(recursion)), 1e-55);
}

/// A chain costs less by one recursion.
TEST(Equations, TakeTheRecursionWhereItCostsLess) {
  Scene scene("chain");
  FrameHandle link = scene.ground();
  for (int k = 1; k <= 5; ++k) {
    const std::string name = "q" + std::to_string(k);
    const Expression angle = scene.coordinate(name, "rad");
    link = scene.revolute("link" + std::to_string(k), link, k % 2 == 0 ? axis::z : axis::y, angle);
    scene.body("link" + std::to_string(k), link,
               Inertia::point(Expression::quantity("1", "kg")).at({Expression::quantity("1", "m"), 0, 0}));
  }
  const Equations equations(scene);
  const std::vector<Value> recursion =
      inertia_forces(equations.model(), AccelerationInput::symbols, equations.actions().wrenches);
  EXPECT_EQ(count(equations.program(), equations.inverse_dynamics()).total(),
            count(equations.program(), recursion_less_passive(equations, recursion)).total());
}

/// A force that is next to nothing but near 2 m is a force.
TEST(Equations, KeepAForceThatActsInOneRegionOnly) {
  Scene scene("cart");
  const Expression x = scene.coordinate("x", "m");
  const FrameHandle cart = scene.prismatic("cart", scene.ground(), axis::x, x);
  scene.body("cart", cart, Inertia::point(Expression::quantity("1", "kg")));
  scene.generalised_force(
      "wall", x,
      Expression::quantity("-1", "N") * exp((x - Expression::quantity("2", "m")) / Expression::quantity("0.001", "m")));
  const Equations equations(scene);
  EXPECT_FALSE(equations.bias()[0].is_zero());
  EXPECT_FALSE(equations.forward().accelerations[0].is_zero());
}

/// Central differences of the residual r = M q̈ + h − Aᵀλ − E u, step 1e-20: truncation and rounding leave 1e-38.
TEST_P(RandomEquations, HaveTheLinearisationOfTheirFiniteDifferences) {
  const Scene scene = random_mechanism(GetParam());
  const Equations equations(scene);
  const Model& model = equations.model();
  const Linearisation linear = linearisation(equations);
  const auto n = static_cast<std::size_t>(model.unknown_count());
  const RandomState state(scene, 9);
  const Real h = power_of_ten(-20);
  const std::vector<SymbolPointer> inputs = model.inputs();
  const auto residual = [&](const SymbolPointer& moved, const Real& by) {
    Evaluator<Real> evaluate(equations.program(), [&](const SymbolPointer& symbol) {
      const Real value = state.in_real()(symbol);
      return symbol == moved ? value + by : value;
    });
    std::vector<Real> r;
    for (std::size_t i = 0; i < n; ++i) {
      Real sum = evaluate(equations.inverse_dynamics()[i]);
      for (std::size_t k = 0; k < inputs.size(); ++k) {
        sum -= evaluate(equations.actions().inputs[k][i]) * evaluate(equations.program().symbol(inputs[k]));
      }
      r.push_back(sum);
    }
    return r;
  };
  Evaluator<Real> here(equations.program(), state.in_real());
  const std::vector<Real> r0 = residual(nullptr, Real(0));
  const auto column = [&](const SymbolPointer& symbol) {
    std::vector<Real> differences = residual(symbol, h);
    const std::vector<Real> below = residual(symbol, -h);
    for (std::size_t i = 0; i < n; ++i) differences[i] = (differences[i] - below[i]) / (h + h);
    return differences;
  };
  const auto expect_column = [&](const ValueMatrix& matrix, std::size_t j, const std::vector<Real>& differences,
                                 int sign) {
    for (std::size_t i = 0; i < n; ++i) {
      const Real slope = Real(sign) * here(matrix[i][j]);
      EXPECT_LT(relative_difference(differences[i], slope), 1e-30) << i << ", " << j;
    }
  };
  for (std::size_t j = 0; j < n; ++j) {
    const CoordinateContent& c = model.coordinates()[j];
    expect_column(linear.M, j, column(c.a), 1);
    expect_column(linear.C, j, column(c.v), 1);
    expect_column(linear.K, j, column(c.q), 1);
  }
  for (std::size_t k = 0; k < inputs.size(); ++k) expect_column(linear.E, k, column(inputs[k]), -1);
  for (std::size_t i = 0; i < n; ++i) EXPECT_LT(relative_difference(here(linear.F[i]), -r0[i]), 1e-45);
}

TEST_P(RandomEquations, HaveASymmetricMassMatrixEvenAsFormulas) {
  const Equations equations(random_mechanism(GetParam()));
  const ValueMatrix& mass = equations.mass();
  for (std::size_t i = 0; i < mass.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) EXPECT_EQ(mass[i][j].polynomial(), mass[j][i].polynomial());
  }
}

TEST(ForwardDynamics, IsTheSameByFactorisationAndByTheArticulatedBodyRecursion) {
  const WorkingDigits precision(60);
  int trees = 0;
  for (unsigned seed = 300; seed < 340; ++seed) {
    const Scene scene = random_mechanism(seed, {.constraints = false});
    ModelOptions options;
    options.forward = ForwardMethod::articulated_body;
    const Equations recursive(scene, options);
    options.forward = ForwardMethod::factorisation;
    const Equations factored(scene, options);
    try {
      recursive.forward();
    } catch (const UsageError&) {
      continue;  // a joint of several coordinates
    }
    ++trees;
    const RandomState state(scene, 4);
    Evaluator<Real> first(recursive.program(), state.in_real());
    Evaluator<Real> second(factored.program(), state.in_real());
    EXPECT_LT(distance(first(recursive.forward().accelerations), second(factored.forward().accelerations)), 1e-48)
        << seed;
  }
  EXPECT_GT(trees, 10);
}

TEST(ForwardDynamics, KeepsTheRecursionForScenesThatItFits) {
  Scene scene("swung");
  const Expression q = scene.coordinate("q", "rad");
  const Expression swing = sin(Expression::quantity("2", "rad/s") * scene.time());
  const FrameHandle arm = scene.revolute("arm", scene.ground(), axis::z, q + swing);
  scene.body("arm", arm, Inertia::disk(Expression::quantity("1", "kg"), Expression::quantity("1", "m"), 2));
  ModelOptions options;
  options.forward = ForwardMethod::articulated_body;
  EXPECT_EQ(
      error_of<UsageError>([&] { Equations(scene, options).forward(); }),
      "the articulated-body recursion does not fit the scene 'swung': it needs a tree without constraints in which "
      "each coordinate is the displacement of one joint");
  // Free of forces the disk keeps its speed: q'' = −d²(sin 2t)/dt² = 4 sin 2t.
  const Equations equations(scene);
  Evaluator<double> evaluate(equations.program(),
                             [](const SymbolPointer& symbol) { return symbol->kind == SymbolKind::time ? 0.7 : 0.0; });
  EXPECT_NEAR(evaluate(equations.forward().accelerations[0]), 4 * std::sin(1.4), 1e-14);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomEquations, ::testing::Range(200U, 230U));

}  // namespace
}  // namespace torsor::equations_test
