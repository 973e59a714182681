// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/recursions/regressor.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "benchmarks/model_counts/models.hpp"
#include "torsor/generator/base/linear_algebra/real_rows.hpp"
#include "torsor/generator/dynamics/recursions/base_parameters.hpp"
#include "torsor/generator/import/exact_direction.hpp"
#include "torsor/generator/kernels/kernel.hpp"
#include "torsor/generator/verification/random_state.hpp"
#include "tests/dynamics/random_mechanism.hpp"
#include "tests/kernels/compressed_tables.hpp"
#include "tests/scenes/bodies.hpp"

namespace torsor::regressor_test {
namespace {

using testing_headers::constant;
using testing_headers::numbers;
using testing_mechanisms::kilograms;
using testing_mechanisms::metres;
using testing_mechanisms::moment;
using testing_mechanisms::random_mechanism;
using Indices = std::vector<std::size_t>;

/// A body without any symmetry.
Inertia crooked_body() {
  return Inertia::general({.mass = kilograms("1.2"), .xx = moment("0.3"), .yy = moment("0.5"), .zz = moment("0.7"),
                           .xy = moment("0.02"), .xz = moment("-0.03"), .yz = moment("0.05")})
      .at({metres("0.1"), metres("-0.4"), metres("0.2")});
}

/// Two links that turn about z, the second at (l_x, l_y, 0) of the first, gravity along −y.
Scene planar_pendulum(const Expression& x, const Expression& y, Scene scene = Scene("planar_pendulum")) {
  const FrameHandle first = scene.revolute("first", scene.ground(), axis::z, scene.coordinate("a", "rad"));
  const FrameHandle second =
      scene.revolute("second", first, axis::z, scene.coordinate("b", "rad"), {.origin = {x, y, 0}});
  scene.body("first", first, crooked_body());
  scene.body("second", second, crooked_body());
  scene.gravity({0, Expression::quantity("-9.81", "m/s^2"), 0});
  return scene;
}

struct Found {
  explicit Found(const Scene& scene) : equations(scene) {}
  Equations equations;
  ValueMatrix y = regressor(equations.model());
  BaseParameters base = base_parameters(equations.model(), y);

  Real k(std::size_t independent, std::size_t dependent) const {
    const auto place = [](const Indices& all, std::size_t index) {
      const auto found = std::find(all.begin(), all.end(), index);
      EXPECT_NE(found, all.end()) << index;
      return static_cast<std::size_t>(found - all.begin());
    };
    return base.combination[place(base.independent, independent)][place(base.dependent, dependent)];
  }
};

class RandomRegressor : public ::testing::TestWithParam<unsigned> {
 protected:
  /// The forces of inertia and gravity are all there is.
  static Scene scene() {
    const unsigned seed = GetParam();
    return random_mechanism(seed, {.actions = false, .released = false, .constraints = false, .joints = seed % 2 == 0});
  }
};

// With 50 digits, sums of some hundred terms, errors of a few units each: 1e-35 of the largest term is far above that
// and far below any term that would be forgotten.
TEST_P(RandomRegressor, TimesTheInertialParametersIsInverseDynamics) {
  const Scene scene = RandomRegressor::scene();
  const Equations equations(scene);
  const ValueMatrix y = regressor(equations.model());
  const RandomState state(scene, GetParam());
  Evaluator<Real> evaluate(equations.program(), state.in_real());
  const std::vector<Real> pi = evaluate(inertial_parameters(equations.model()));
  for (std::size_t i = 0; i < y.size(); ++i) {
    Real rest = evaluate(equations.inverse_dynamics()[i]);
    Real size = abs(rest);
    for (std::size_t c = 0; c < pi.size(); ++c) {
      const Real term = evaluate(y[i][c]) * pi[c];
      rest -= term;
      size = std::max(size, abs(term));
    }
    EXPECT_LE((abs(rest) / size).to_double(), 1e-35) << "row " << i;
  }
}

TEST_P(RandomRegressor, HasIndependentBaseColumnsThatGiveAllForces) {
  const Scene scene = RandomRegressor::scene();
  const Found found(scene);
  const BaseParameters& base = found.base;
  ASSERT_EQ(base.independent.size() + base.dependent.size(), found.y.empty() ? 0 : found.y[0].size());
  Evaluator<Real> evaluate(found.equations.program(), {});
  RealRows rows;
  for (unsigned k = 0; k < 60; ++k) {  // more rows than columns even with one unknown
    const RandomState state(scene, 1000 + k);
    evaluate.move_to(state.in_real());
    const std::vector<Real> pi = evaluate(inertial_parameters(found.equations.model()));
    for (const std::vector<Value>& row : found.y) {
      const std::vector<Real> y = evaluate(row);
      RealRow kept;
      Real whole(0), by_base(0), size(0);
      for (std::size_t c = 0; c < y.size(); ++c) {
        whole += y[c] * pi[c];
        size = std::max(size, abs(y[c] * pi[c]));
      }
      for (std::size_t b = 0; b < base.independent.size(); ++b) {
        Real parameter = pi[base.independent[b]];
        for (std::size_t d = 0; d < base.dependent.size(); ++d)
          parameter += base.combination[b][d] * pi[base.dependent[d]];
        kept.push_back(y[base.independent[b]]);
        by_base += kept.back() * parameter;
        size = std::max(size, abs(kept.back() * parameter));
      }
      if (k < 3 && !size.is_zero()) {
        EXPECT_LE((abs(whole - by_base) / size).to_double(), 1e-35);
      }
      rows.push_back(std::move(kept));
    }
  }
  const std::size_t count = base.independent.size();
  EXPECT_EQ(rank(rows, count, power_of_ten(-25)), count);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomRegressor, ::testing::Range(1U, 101U));

TEST(Regressor, OfABodyAboutAFixedPointIsThatOfEulersEquations) {
  Scene scene("top");
  const AttitudeHandle e = scene.attitude("e");
  const FrameHandle frame = scene.spherical("body", scene.ground(), e);
  scene.body("body", frame, Inertia::point(kilograms("1")));  // its own inertia must not matter
  scene.gravity({0, 0, Expression::quantity("-10", "m/s^2")});
  const Equations equations(scene);
  const Model& model = equations.model();
  const ValueMatrix y = regressor(model);
  ASSERT_EQ(y.size(), 3U);
  ASSERT_EQ(y[0].size(), 10U);
  const RandomState state(scene, 5);
  Evaluator<Real> evaluate(equations.program(), state.in_real());
  // m, h, then J_xx, J_xy, J_xz, J_yy, J_yz, J_zz: any numbers.
  const std::array<int, 10> pi{3, 1, -2, 5, 7, 2, -3, 11, 4, 13};
  const std::array<std::array<int, 3>, 3> j{{{7, 2, -3}, {2, 11, 4}, {-3, 4, 13}}};
  std::array<Real, 3> w, alpha, momentum, rate, up;
  for (int i = 0; i < 3; ++i) {
    w[static_cast<std::size_t>(i)] = evaluate(model.v(i));
    alpha[static_cast<std::size_t>(i)] = evaluate(model.a(i));
  }
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      momentum[i] += Real(j[i][k]) * w[k];
      rate[i] += Real(j[i][k]) * alpha[k];
    }
  }
  // The vertical in the body's axes: third row of the rotation of the unit quaternion (q0, q1, q2, q3).
  std::vector<Real> q;
  for (const SymbolPointer& component : model.positions()) q.push_back(evaluate(equations.program().symbol(component)));
  const Real two(2);
  up = {two * (q[1] * q[3] - q[0] * q[2]), two * (q[2] * q[3] + q[0] * q[1]),
        Real(1) - two * (q[1] * q[1] + q[2] * q[2])};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t k = (i + 1) % 3, l = (i + 2) % 3;
    // J alpha + w x J w + h x 10 m/s^2 up
    const Real gyroscopic = w[k] * momentum[l] - w[l] * momentum[k];
    const Real weight = Real(10) * (Real(pi[1 + k]) * up[l] - Real(pi[1 + l]) * up[k]);
    const Real expected = rate[i] + gyroscopic + weight;
    Real got(0);
    for (std::size_t c = 0; c < 10; ++c) got += evaluate(y[i][c]) * Real(pi[c]);
    EXPECT_LE(abs(got - expected).to_double(), 1e-40) << i;
    EXPECT_TRUE(y[i][0].is_zero());  // the mass alone, at the fixed point, does nothing
  }
}

// By hand: of what turns about a fixed axis z across gravity only J_zz, h_x, h_y count; of the second link too, since a
// mass at its origin is one fixed in the first at (l_x, l_y): it adds m l to the first moment and m l² to J_zz.
TEST(BaseParameters, OfAPlanarDoublePendulumAreSix) {
  const Found found(planar_pendulum(metres("3"), metres("-2")));
  EXPECT_EQ(found.base.independent, (Indices{1, 2, 9, 11, 12, 19}));
  EXPECT_TRUE(found.base.at_any_parameters);
  EXPECT_NEAR(found.k(1, 10).to_double(), 3, 1e-30);
  EXPECT_NEAR(found.k(2, 10).to_double(), -2, 1e-30);
  EXPECT_NEAR(found.k(9, 10).to_double(), 13, 1e-30);
  for (const std::size_t d : {0U, 3U, 4U, 5U, 6U, 7U, 8U, 13U, 14U, 15U, 16U, 17U, 18U}) {
    for (const std::size_t b : found.base.independent) EXPECT_TRUE(found.k(b, d).is_zero()) << b << ", " << d;
  }
}

// By hand: a slide feels the mass of all it carries; the link that turns on it adds J_zz, h_x, h_y.
TEST(BaseParameters, OfAPendulumOnACartAreFour) {
  Scene scene("cart");
  const FrameHandle cart = scene.prismatic("cart", scene.ground(), axis::x, scene.coordinate("x", "m"));
  const FrameHandle arm = scene.revolute("arm", cart, axis::z, scene.coordinate("a", "rad"));
  scene.body("cart", cart, crooked_body());
  scene.body("arm", arm, crooked_body());
  scene.gravity({0, Expression::quantity("-9.81", "m/s^2"), 0});
  const Found found(scene);
  EXPECT_EQ(found.base.independent, (Indices{0, 11, 12, 19}));
  EXPECT_NEAR(found.k(0, 10).to_double(), 1, 1e-30);
}

// A link that turns about its z axis anywhere beyond a joint across it: Gautier & Khalil (1990), eqs. 20-24: m, h_z and
// J_yy go to the link before, with J_xx − J_yy left of the own; the first link, about a vertical axis, has J_zz only.
TEST(BaseParameters, OfTwoLinksWithCrossedAxesAreRegroupedByTheRulesOfGautierAndKhalil) {
  Scene scene("crossed");
  const FrameHandle first = scene.revolute("first", scene.ground(), axis::x, scene.coordinate("a", "rad"));
  const FrameHandle second = scene.revolute("second", first, axis::z, scene.coordinate("b", "rad"),
                                            {.origin = {0, metres("0.5"), metres("0.25")}});
  scene.body("first", first, crooked_body());
  scene.body("second", second, crooked_body());
  scene.gravity({Expression::quantity("-9.81", "m/s^2"), 0, 0});
  const Found found(scene);
  // Of the first link J_xx; of the second h_x, h_y, J_xx (with −J_yy), J_xy, J_xz, J_yz, J_zz.
  EXPECT_EQ(found.base.independent, (Indices{4, 11, 12, 14, 15, 16, 18, 19}));
  EXPECT_NEAR(found.k(14, 17).to_double(), -1, 1e-30);
  EXPECT_NEAR(found.k(4, 17).to_double(), 1, 1e-30);              // J_yy about the crossed axis
  EXPECT_NEAR(found.k(4, 10).to_double(), 0.25 + 0.0625, 1e-30);  // m (y² + z²)
  EXPECT_NEAR(found.k(4, 13).to_double(), 0.5, 1e-30);            // 2 z h_z
}

// 10 parameters less the three that go to the link before for each revolute joint; the first link of an arm on the
// floor has J_zz if its axis is vertical, and two first moments if it is level.
TEST(BaseParameters, OfArmsAreAsManyAsTheoryCounts) {
  for (const Scene& scene : read_models(TORSOR_SOURCE_DIR "/tests/reference/models.json")) {
    std::size_t expected = 0;
    if (scene.name() == "pend2") expected = 6;
    if (scene.name() == "ur5") expected = 1 + 5 * 7;
    if (scene.name() == "panda") expected = 1 + 6 * 7;
    if (scene.name() == "chain4") expected = 3 + 3 * 7;
    if (scene.name() == "chain8") expected = 3 + 7 * 7;
    if (expected == 0) continue;
    EXPECT_EQ(Found(scene).base.independent.size(), expected) << scene.name();
  }
}

TEST(BaseParameters, HoldForAllValuesUnlessALengthIsSetAtRunTime) {
  Scene length("run_time_length");
  const Expression l = length.run_time_parameter("l", "m", metres("3"));
  const Found found(planar_pendulum(l, metres("-2"), length));
  EXPECT_FALSE(found.base.at_any_parameters);
  EXPECT_NEAR(found.k(1, 10).to_double(), 3, 1e-30);
  Scene mass("run_time_mass");
  const FrameHandle arm = mass.revolute("arm", mass.ground(), axis::z, mass.coordinate("a", "rad"));
  mass.body("arm", arm, Inertia::point(mass.run_time_parameter("m", "kg", kilograms("2"))).at({metres("1"), 0, 0}));
  mass.gravity({0, -mass.run_time_parameter("g", "m/s^2", Expression::quantity("9.81", "m/s^2")), 0});
  EXPECT_TRUE(Found(mass).base.at_any_parameters);
}

TEST(RegressorKernel, HasTheBaseColumnsAndTellsWhichTheyAre) {
  const Equations equations(planar_pendulum(metres("3"), metres("-2")));
  const Kernel kernel = make_kernel("regressor", equations);
  EXPECT_EQ(kernel.assignments.size(), 2U * 6U);
  EXPECT_TRUE(kernel.assignments[1].value.is_zero());  // the second joint does not feel the first link
  const std::vector<ConstantTable>& tables = kernel.structures.at(0).tables;
  const auto number = [&tables](const char* name) { return std::get<std::size_t>(constant(tables, name)); };
  EXPECT_NE(tables.at(0).documentation.find("\n10 to 19: frame second with body second"), std::string::npos);
  EXPECT_EQ(number("inertial_parameter_count"), 20U);
  EXPECT_EQ(number("base_parameter_count"), 6U);
  EXPECT_EQ(numbers(tables, "base_parameters"), (ConstantTable::Indices{1, 2, 9, 11, 12, 19}));
  EXPECT_EQ(number("regrouping_count"), 3U);
  EXPECT_EQ(numbers(tables, "regrouped_from"), (ConstantTable::Indices{10, 10, 10}));
  EXPECT_EQ(numbers(tables, "regrouped_to"), (ConstantTable::Indices{0, 1, 2}));
  EXPECT_EQ(std::get<ConstantTable::Factors>(constant(tables, "regrouping_factors")), (ConstantTable::Factors{3, -2, 13}));
}

TEST(RegressorKernel, LeavesTheCoefficientsOutWhereTheyDependOnRunTimeParameters) {
  Scene scene("run_time_length");
  const Expression l = scene.run_time_parameter("l", "m", metres("3"));
  const Equations equations(planar_pendulum(l, metres("-2"), scene));
  const Kernel kernel = make_kernel("regressor", equations);
  const std::vector<ConstantTable>& tables = kernel.structures.at(0).tables;
  EXPECT_TRUE(std::none_of(tables.begin(), tables.end(),
                           [](const ConstantTable& each) { return each.name.find("regroup") != std::string::npos; }));
  EXPECT_NE(kernel.documentation.find("run-time parameters"), std::string::npos);
}

TEST(RegressorKernel, IsLeftOutWhereNoBodyMoves) {
  Scene scene("massless");
  scene.revolute("arm", scene.ground(), axis::z, scene.coordinate("a", "rad"));
  EXPECT_EQ(make_kernel("regressor", Equations(scene)).skipped, "no body moves");
}

/// Four crooked bodies one behind the other, joints about y and z in turn, each turned by 7/10 about x and offset.
Scene bent_chain(const char* x, const char* y) {
  Scene scene("bent_chain");
  const ExactAngle angle = exact_angle(Number::rational(7, 10), Number());
  FrameHandle frame = scene.ground();
  for (int i = 0; i < 4; ++i) {
    const std::string name = "link_" + std::to_string(i);
    frame = scene.revolute(name, frame, i % 2 == 0 ? axis::y : axis::z, scene.coordinate("q_" + std::to_string(i), "rad"),
                           {{metres(x), metres(y), 0}, rotation_about(0, angle)});
    scene.body(name, frame, crooked_body());
  }
  scene.gravity({0, 0, Expression::quantity("-9.81", "m/s^2")});
  return scene;
}

// Lengths that files hold as rounding: products of 5.55e-17 with 2.28e-12 are beyond 50 digits' 1e-20, and independent all the
// same, as those of ordinary lengths are.
TEST(BaseParameters, AreThoseOfTheMechanismWhereLengthsAreTiny) {
  EXPECT_EQ(Found(bent_chain("5.55e-17", "2.28e-12")).base.independent, Found(bent_chain("0.3", "0.2")).base.independent);
}

}  // namespace
}  // namespace torsor::regressor_test
