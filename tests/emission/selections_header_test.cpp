// SPDX-License-Identifier: GPL-3.0-or-later
// Selections and angles as headers compute them: the committed text is compiled into this test, for every scalar.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "torsor/generator/base/output_file.hpp"
#include "torsor/generator/program/evaluation.hpp"
#include "torsor/generator/verification/emitted_sincos.hpp"
#include "tests/emission/golden/selections.hpp.txt"
#include "tests/emission/golden_scene.hpp"
#include "tests/emission/selections_scene.hpp"
#include "tests/verification/right_to_rounding.hpp"

#include "torsor/generator/verification/real_scalar_traits.hpp"
#include "torsor/runtime/batch/simd.hpp"

using Pack = torsor::runtime::Simd<double, 4>;
using FloatPack = torsor::runtime::Simd<float, 8>;
template struct golden_selections::Mechanism<double>;
template struct golden_selections::Mechanism<float>;
template struct golden_selections::Mechanism<torsor::Real>;
template struct golden_selections::Mechanism<Pack>;
template struct golden_selections::Mechanism<FloatPack>;

namespace torsor::selections_header_test {
namespace {

const char* const golden_path = TORSOR_SOURCE_DIR "/tests/emission/golden/selections.hpp.txt";
const char* const golden_kernels = "bias,forward_dynamics,energy,jets,forward_dynamics_derivatives";

TEST(SelectionsHeader, IsWhatTheSceneGives) {
  const std::string header = emit_header(testing_scenes::golden_selections(), parse_kernel_list(golden_kernels));
  if (std::getenv("TORSOR_UPDATE_GOLDEN") != nullptr) write_file_if_changed(golden_path, header);
  std::ifstream file(golden_path, std::ios::binary);
  const std::string golden((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  EXPECT_EQ(header, golden)
      << "when this change is meant: TORSOR_UPDATE_GOLDEN=1 ctest -R SelectionsHeader, read git diff, build again";
}

using State = std::array<double, 4>;  // x, y and their rates: doubles and floats, in every region of the scene
const std::array<State, 7> states{{{0.25, 0.5, -1.5, 0.25}, {-0.75, -0.5, 2, -4}, {1.25, 0.125, 0.5, 1},
                                   {-2, 0.25, 0, 0}, {0.5, 0, -0.5, 3}, {1, -3, 1, 0.5}, {3, 2.5, -0.25, -0.125}}};

/// Accelerations, energy and the first eight Taylor coefficients.
template <class Scalar>
std::vector<Scalar> computed(const std::function<Scalar(std::size_t)>& component) {
  using M = golden_selections::Mechanism<Scalar>;
  const typename M::Precomputed precomputed = M::precompute(M::default_parameters());
  typename M::State state = M::initial_state();
  state.q.x = component(0), state.q.y = component(1), state.v.x = component(2), state.v.y = component(3);
  typename M::Accelerations a;
  typename M::Multipliers lambda;
  EXPECT_EQ(M::forward_dynamics(precomputed, state, {}, a, lambda), Status::ok);
  typename M::Energy energy;
  M::energy(precomputed, state, {}, energy);
  std::array<std::array<Scalar, 4>, 8> coefficients{};
  EXPECT_EQ(M::jets(precomputed, state, {}, 7, coefficients.data()), Status::ok);
  std::vector<Scalar> all{a.x, a.y, energy.kinetic, energy.force_function};
  for (const auto& order : coefficients) all.insert(all.end(), order.begin(), order.end());
  return all;
}

template <class Scalar>
std::function<Scalar(std::size_t)> at(const State& state) {
  return [&state](std::size_t i) { return static_cast<Scalar>(state[i]); };
}

/// The same text in high precision is the truth: the tests of the expression layer compare that with closed forms.
TEST(SelectionsHeader, ComputesTheSameInEveryScalar) {
  for (const State& state : states) {
    const std::vector<Real> exact = computed<Real>([&](std::size_t i) { return Real::from_double(state[i]); });
    const std::vector<double> in_double = computed<double>(at<double>(state));
    const std::vector<float> in_float = computed<float>(at<float>(state));
    const std::vector<Pack> in_pack = computed<Pack>([&](std::size_t i) {
      Pack pack(states[0][i]);  // another region in the other lanes
      pack.set(2, state[i]);
      return pack;
    });
    const std::vector<double> other = computed<double>(at<double>(states[0]));
    // Some hundred operations with errors of half a unit each, on terms up to a hundred times the result or 1: 10^4
    // roundings of 2^-53 and 2^-24.
    testing_rounding::RightToRounding check(testing_rounding::unit_of<double>);
    testing_rounding::RightToRounding check_float(testing_rounding::unit_of<float>);
    for (std::size_t i = 0; i < exact.size(); ++i) {
      const std::string number = std::to_string(i);
      const double size = std::max(1.0, std::abs(exact[i].to_double()));
      check.entry("double " + number, in_double[i], exact[i], size, 1e4);
      check_float.entry("float " + number, in_float[i], exact[i], size, 1e4);
      check.entry("lane 2 of " + number, in_pack[i][2], exact[i], size, 1e4);
      check.entry("lane 0 of " + number, in_pack[i][0], other[i], std::max(1.0, std::abs(other[i])), 1e4);
    }
    EXPECT_TRUE(check) << check;
    EXPECT_TRUE(check_float) << check_float;
  }
}

/// The program's own values, by the same formulas in another order.
TEST(SelectionsHeader, ComputesWhatTheProgramSays) {
  const Equations equations(testing_scenes::golden_selections());
  for (const State& state : states) {
    Evaluator<Real> evaluate(equations.program(), [&](const SymbolPointer& symbol) {
      const std::array<const char*, 4> names{"x", "y", "x'", "y'"};
      for (std::size_t i = 0; i < 4; ++i) {
        if (symbol->name == names[i]) return Real::from_double(state[i]);
      }
      if (symbol->name == "stop") return Real(Number::rational(1, 4), 50);
      return symbol->name == "most" ? Real(3) : Real::pi();
    });
    const std::vector<Real> exact = computed<Real>([&](std::size_t i) { return Real::from_double(state[i]); });
    for (std::size_t i = 0; i < 2; ++i) {
      const Real wanted = evaluate(equations.forward().accelerations[i]);
      EXPECT_LT((abs(exact[i] - wanted)).to_double(), 1e-40) << i;
    }
  }
}

/// By hand: at (-2, 1/4) at rest the table is a straight line, the stop and the brake are silent, the step is 1 N.
TEST(SelectionsHeader, TakesTheFormsThatCount) {
  const std::vector<double> found = computed<double>(at<double>({-2, 0.25, 0, 0}));
  // U = ½ J atan2(y - 2, x): forces ½ (-(y - 2), x)/r² with r² = 4 + 49/16.
  const double square = 4 + 49.0 / 16;
  EXPECT_NEAR(found[1], (0.5 * -2 / square + 1) / 2, 1e-15);
  const double table = 2 * found[0] - 0.5 * 1.75 / square;  // slope of a straight line: the same further out
  const std::vector<double> further = computed<double>(at<double>({-4, 0.25, 0, 0}));
  EXPECT_NEAR(table, 2 * further[0] - 0.5 * 1.75 / (16 + 49.0 / 16), 1e-14);
}

TEST(SelectionsHeader, IsNotFiniteForAStateThatIsNot) {
  using M = golden_selections::Mechanism<double>;
  M::State state = M::initial_state();
  M::Accelerations a;
  M::Multipliers lambda;
  state.v.y = std::numeric_limits<double>::quiet_NaN();  // it stands in a selection only
  EXPECT_EQ(M::forward_dynamics(M::precompute(M::default_parameters()), state, {}, a, lambda), Status::not_finite);
}

/// The angle that headers compute, against long double: errors in units of the last place.
template <class Float>
double worst_angle() {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1), exponent(-8, 8);
  double worst = 0;
  for (int i = 0; i < 200000; ++i) {
    const auto y = static_cast<Float>(uniform(random)), scale = static_cast<Float>(std::pow(2, exponent(random)));
    const auto x = static_cast<Float>(uniform(random)) * scale;
    const long double exact = std::atan2(static_cast<long double>(y), static_cast<long double>(x));
    const Float rounded = static_cast<Float>(exact);
    const long double ulp = std::abs(static_cast<long double>(std::nextafter(rounded, Float(10))) - rounded);
    worst = std::max(worst, static_cast<double>(std::abs(emitted_arctangent(y, x) - exact) / ulp));
  }
  return worst;
}

TEST(EmittedArctangent, IsWithinTwoUnitsOfTheLastPlace) {
  EXPECT_LT(worst_angle<double>(), 2);
  EXPECT_LT(worst_angle<float>(), 2);
}

TEST(EmittedArctangent, KnowsTheAxesAndWhatIsNoVector) {
  const double pi = std::acos(-1.0), nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(emitted_arctangent(0.0, 0.0), 0);
  EXPECT_EQ(emitted_arctangent(0.0, 2.0), 0);
  EXPECT_EQ(emitted_arctangent(2.0, 0.0), pi / 2);
  EXPECT_EQ(emitted_arctangent(-2.0, 0.0), -pi / 2);
  EXPECT_EQ(emitted_arctangent(0.0, -2.0), pi);
  EXPECT_EQ(emitted_arctangent(3.0, 3.0), pi / 4);
  EXPECT_EQ(emitted_arctangent(-3.0, -3.0), -3 * pi / 4);
  EXPECT_TRUE(std::isnan(emitted_arctangent(nan, 1.0)));
  EXPECT_TRUE(std::isnan(emitted_arctangent(1.0, nan)));
  EXPECT_TRUE(std::isnan(emitted_arctangent(0.0, nan)));
}

}  // namespace
}  // namespace torsor::selections_header_test
