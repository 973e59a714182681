// SPDX-License-Identifier: GPL-3.0-or-later
// The text of one generated header, and what it computes: the committed text is compiled into this test.
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include "torsor/generator/base/output_file.hpp"
#include "torsor/generator/program/evaluation.hpp"
#include "tests/emission/golden/pendulum.hpp.txt"
#include "tests/emission/golden_scene.hpp"
#include "tests/verification/right_to_rounding.hpp"

#include "torsor/generator/verification/real_scalar_traits.hpp"

template struct golden_pendulum::Mechanism<double>;
template struct golden_pendulum::Mechanism<float>;
template struct golden_pendulum::Mechanism<torsor::Real>;

namespace torsor::golden_header_test {
namespace {

const char* const golden_path = TORSOR_SOURCE_DIR "/tests/emission/golden/pendulum.hpp.txt";
const char* const golden_kernels = "mass_matrix,bias,inverse_dynamics,forward_dynamics,constraints";

TEST(GoldenHeader, IsWhatTheSceneGives) {
  const std::string header = emit_header(testing_scenes::golden_pendulum(), parse_kernel_list(golden_kernels));
  if (std::getenv("TORSOR_UPDATE_GOLDEN") != nullptr) write_file_if_changed(golden_path, header);
  std::ifstream file(golden_path, std::ios::binary);
  const std::string golden((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  EXPECT_EQ(header, golden)
      << "when this change is meant: TORSOR_UPDATE_GOLDEN=1 ctest -R GoldenHeader, read git diff, "
         "build again";
}

/// The scalar nearest to a number.
template <class Scalar>
Scalar rounded(const Number& number) {
  return scalar_traits<Scalar>::constant(number.to_double(), number.to_float(), number.to_exact().c_str());
}

const Number theta = Number::rational(7, 8);
const Number rate = Number::rational(-5, 4);
const Number time_now = Number::rational(3, 8);
const Number torque = Number::rational(9, 16);
const Number acceleration = Number::rational(11, 4);
const Number friction = Number::rational(1, 4);
const Number length = Number::rational(3, 4);  // all of these are doubles and floats: no rounding on the way in

/// Every result of the kernels in the order of their assignments: M, h, inverse dynamics, forward dynamics.
template <class Scalar>
std::vector<Scalar> computed() {
  using M = golden_pendulum::Mechanism<Scalar>;
  typename M::Parameters parameters = M::default_parameters();
  parameters.length = rounded<Scalar>(length);
  parameters.friction = rounded<Scalar>(friction);
  const typename M::Precomputed precomputed = M::precompute(parameters);
  typename M::State state{};
  state.time = rounded<Scalar>(time_now);
  state.q.theta = rounded<Scalar>(theta);
  state.v.theta = rounded<Scalar>(rate);
  typename M::Inputs inputs{};
  inputs.torque = rounded<Scalar>(torque);
  typename M::Accelerations a{};
  a.theta = rounded<Scalar>(acceleration);
  typename M::Multipliers multipliers{};

  std::array<Scalar, 1> mass;
  typename M::GeneralizedForces bias{};
  typename M::GeneralizedForces inverse{};
  typename M::Accelerations forward{};
  M::mass_matrix(precomputed, state, mass);
  M::bias(precomputed, state, bias);
  M::inverse_dynamics(precomputed, state, a, multipliers, inverse);
  EXPECT_EQ(M::forward_dynamics(precomputed, state, inputs, forward, multipliers), Status::ok);
  return {mass[0], bias[0], inverse[0], forward[0]};
}

/// The same from the closed form, with Real: the pivot moves by x = 0.1 sin(0.3) sin(3 t), and along the bob's tangent
/// m l² θ'' + m l x'' cos θ + m g l sin θ = τ − c θ'.
std::vector<Real> closed_form() {
  const int digits = Real::working_digits();
  const auto real = [digits](const Number& number) { return Real(number, digits); };
  const Real m = real(Number(2));
  const Real g = real(Number::rational(981, 100));
  const Real l = real(length);
  const Real pivot_acceleration =
      -real(Number::rational(9, 10)) * sin(real(Number::rational(3, 10))) * sin(real(Number(3) * time_now));
  const Real inertia = m * l * l;
  const Real h = m * l * pivot_acceleration * cos(real(theta)) + m * g * l * sin(real(theta)) + real(friction * rate);
  return {inertia, h, inertia * real(acceleration) + h, (real(torque) - h) / inertia};
}

/// About 40 operations, the largest term some 10 times the smallest result: 40 · 10 roundings, in any precision.
template <class Scalar>
void expect_closed_form(double unit) {
  const std::vector<Scalar> found = computed<Scalar>();
  const std::vector<Real> truth = closed_form();
  testing_rounding::RightToRounding check(unit);
  for (std::size_t i = 0; i < truth.size(); ++i) check.entry("result " + std::to_string(i), found[i], truth[i], 400);
  EXPECT_TRUE(check) << check;
}

TEST(GoldenHeader, ComputesTheEquationsOfThePendulumInHighPrecision) { expect_closed_form<Real>(1e-50); }

TEST(GoldenHeader, ComputesTheEquationsOfThePendulumInDoubleAndFloat) {
  expect_closed_form<double>(testing_rounding::unit_of<double>);
  expect_closed_form<float>(testing_rounding::unit_of<float>);
}

TEST(GoldenHeader, StartsFromTheScenesStateForItsParameters) {
  using M = golden_pendulum::Mechanism<double>;
  EXPECT_EQ(M::initial_state().q.theta, 0.25);
  M::Parameters parameters = M::default_parameters();
  EXPECT_EQ(parameters.length, 0.5);
  EXPECT_TRUE(std::isnan(parameters.friction)) << "nothing may compute with a parameter that was never given";
  parameters.length = 3;
  EXPECT_EQ(M::initial_state(parameters).q.theta, 1.5);
  EXPECT_EQ(M::initial_state(parameters).v.theta, 0);
  EXPECT_EQ(M::initial_state().time, 0);
}

TEST(GoldenHeader, ReportsWhatItCannotCompute) {
  using M = golden_pendulum::Mechanism<double>;
  M::Parameters parameters = M::default_parameters();
  M::Accelerations a{};
  M::Multipliers multipliers{};
  // A parameter without a value.
  EXPECT_EQ(M::forward_dynamics(M::precompute(parameters), M::initial_state(), {}, a, multipliers), Status::not_finite);
  // No inertia.
  parameters.friction = 0;
  parameters.length = 0;
  EXPECT_EQ(M::forward_dynamics(M::precompute(parameters), M::initial_state(), {}, a, multipliers), Status::singular);
  parameters.length = 1;
  EXPECT_EQ(M::forward_dynamics(M::precompute(parameters), M::initial_state(), {}, a, multipliers), Status::ok);
}

TEST(GoldenHeader, IndexesItsStructuresInTheOrderOfTheirMembers) {
  using M = golden_pendulum::Mechanism<double>;
  M::Parameters parameters = M::default_parameters();
  ASSERT_EQ(M::Parameters::size, 2);
  parameters[0] = 4;
  parameters[1] = 5;
  EXPECT_EQ(parameters.length, 4);
  EXPECT_EQ(parameters.friction, 5);
  EXPECT_EQ(std::as_const(parameters)[1], 5);
  EXPECT_EQ(M::Multipliers::size, 0);
  EXPECT_STREQ(M::name, "golden_pendulum");
}

}  // namespace
}  // namespace torsor::golden_header_test
