// SPDX-License-Identifier: GPL-3.0-or-later
// Second derivatives, sensitivities and the sparse Jacobian as generated headers have them, against what the headers'
// other kernels give.
#include <gtest/gtest.h>

#include <Eigen/Sparse>
#include <cmath>

#include "generated/andrews_squeezer.hpp"
#include "generated/double_pendulum.hpp"
#include "generated/rolling_hoop.hpp"

namespace torsor::derivative_kernels_test {
namespace {

using Pendulum = double_pendulum::Mechanism<double>;
using Hoop = rolling_hoop::Mechanism<double>;

// Central differences with h = 1e-5 are off by h²/6 times a third derivative and by 1e-16/h times the value: below 1e-8
// for values and derivatives below some hundred.
constexpr double step = 1e-5;
constexpr double bound = 1e-8;

template <class Array>
Array slope(const Array& above, const Array& below) {
  Array result{};
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = (above[i] - below[i]) / (2 * step);
  return result;
}

/// Page k of `pages` is `matrix`.
template <class Pages, class Matrix>
void expect_page(const Pages& pages, std::size_t k, const Matrix& matrix, const char* name) {
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    EXPECT_NEAR(pages[k * matrix.size() + i], matrix[i], bound * (1 + std::abs(matrix[i]))) << name << " " << k << " " << i;
  }
}

Pendulum::State pendulum_state() {
  Pendulum::State state{};
  state.q[0] = 0.7;
  state.q[1] = -1.1;
  state.v[0] = 1.3;
  state.v[1] = -0.4;
  return state;
}

TEST(SecondDerivativeKernels, HavePagesThatAreSlopesOfTheFirstDerivatives) {
  const auto precomputed = Pendulum::precompute(Pendulum::Parameters{});
  const Pendulum::State state = pendulum_state();
  const Pendulum::Accelerations a{2.0, -3.0};
  Pendulum::InverseDynamicsSecondDerivatives inverse;
  Pendulum::ForwardDynamicsSecondDerivatives forward;
  Pendulum::inverse_dynamics_second_derivatives(precomputed, state, a, {}, inverse);
  ASSERT_EQ(Pendulum::forward_dynamics_second_derivatives(precomputed, state, {}, forward), torsor::Status::ok);
  const auto first = [&](const Pendulum::State& at) {
    struct {
      Pendulum::InverseDynamicsDerivatives inverse;
      Pendulum::ForwardDynamicsDerivatives forward;
      std::array<double, 4> mass;
    } all;
    Pendulum::inverse_dynamics_derivatives(precomputed, at, a, {}, all.inverse);
    EXPECT_EQ(Pendulum::forward_dynamics_derivatives(precomputed, at, {}, all.forward), torsor::Status::ok);
    Pendulum::mass_matrix(precomputed, at, all.mass);
    return all;
  };
  for (int k = 0; k < Pendulum::velocity_count; ++k) {
    Pendulum::State above = state, below = state, faster = state, slower = state;
    above.q[k] += step, below.q[k] -= step, faster.v[k] += step, slower.v[k] -= step;
    const auto up = first(above), down = first(below), fast = first(faster), slow = first(slower);
    const auto page = static_cast<std::size_t>(k);
    const auto turned = slope(up.inverse.by_position, down.inverse.by_position);
    expect_page(inverse.by_position_position, page, turned, "d2f/dq dq");
    const auto mixed = slope(fast.inverse.by_position, slow.inverse.by_position);
    expect_page(inverse.by_position_velocity, page, mixed, "d2f/dq dv");
    const auto twice = slope(fast.inverse.by_velocity, slow.inverse.by_velocity);
    expect_page(inverse.by_velocity_velocity, page, twice, "d2f/dv dv");
    expect_page(inverse.by_acceleration_position, page, slope(up.mass, down.mass), "dM/dq");
    const auto of_motion = slope(up.forward.by_position, down.forward.by_position);
    expect_page(forward.by_position_position, page, of_motion, "d2a/dq dq");
    const auto mixed_motion = slope(fast.forward.by_position, slow.forward.by_position);
    expect_page(forward.by_position_velocity, page, mixed_motion, "d2a/dq dv");
    const auto fast_motion = slope(fast.forward.by_velocity, slow.forward.by_velocity);
    expect_page(forward.by_velocity_velocity, page, fast_motion, "d2a/dv dv");
  }
}

Hoop::State hoop_state() {
  Hoop::State state{};
  state.q.psi = 0.4;
  state.q.theta = 1.1;
  state.v.psi = 0.5;
  state.v.theta = -0.3;
  state.v.phi = -4;
  state.v.x = 0.2;
  return state;
}

TEST(SensitivityKernels, AreSlopesAlongTheRunTimeParameters) {
  const Hoop::State state = hoop_state();
  const Hoop::Accelerations a{0.1, 0.2, 0.3, 0.4, 0.5};
  const Hoop::Multipliers lambda{1.0, -2.0};
  const Hoop::Parameters parameters = Hoop::default_parameters();
  Hoop::InverseDynamicsSensitivities inverse;
  Hoop::ForwardDynamicsSensitivities forward;
  Hoop::inverse_dynamics_sensitivities(Hoop::precompute(parameters), state, a, lambda, inverse);
  ASSERT_EQ(Hoop::forward_dynamics_sensitivities(Hoop::precompute(parameters), state, {}, forward), torsor::Status::ok);
  struct Results {
    std::array<double, 5> forces{}, accelerations{};
    std::array<double, 2> multipliers{};
  };
  for (int k = 0; k < Hoop::parameter_count; ++k) {
    const auto at = [&](double change) {
      Hoop::Parameters changed = parameters;
      changed[k] += change;
      const auto precomputed = Hoop::precompute(changed);
      Hoop::GeneralizedForces f{};
      Hoop::Accelerations motion{};
      Hoop::Multipliers of_motion{};
      Hoop::inverse_dynamics(precomputed, state, a, lambda, f);
      EXPECT_EQ(Hoop::forward_dynamics(precomputed, state, {}, motion, of_motion), torsor::Status::ok);
      Results results;
      for (int i = 0; i < 5; ++i) results.forces[static_cast<std::size_t>(i)] = f[i];
      for (int i = 0; i < 5; ++i) results.accelerations[static_cast<std::size_t>(i)] = motion[i];
      for (int i = 0; i < 2; ++i) results.multipliers[static_cast<std::size_t>(i)] = of_motion[i];
      return results;
    };
    const Results above = at(step), below = at(-step);
    const auto column = static_cast<std::size_t>(k);
    expect_page(inverse.by_parameter, column, slope(above.forces, below.forces), "df/dp");
    expect_page(forward.by_parameter, column, slope(above.accelerations, below.accelerations), "da/dp");
    const auto multipliers = slope(above.multipliers, below.multipliers);
    expect_page(forward.multipliers_by_parameter, column, multipliers, "dlambda/dp");
  }
}

TEST(SparseJacobianKernel, IsReadByEigenAsTheJacobian) {
  const auto precomputed = Hoop::precompute(Hoop::default_parameters());
  const Hoop::State state = hoop_state();
  Hoop::SparseConstraintJacobian sparse;
  Hoop::sparse_constraint_jacobian(precomputed, state, sparse);
  const Eigen::Map<const Eigen::SparseMatrix<double, Eigen::RowMajor>> a(
      Hoop::multiplier_count, Hoop::velocity_count, Hoop::constraint_jacobian_nonzeros,
      Hoop::constraint_jacobian_row_start, Hoop::constraint_jacobian_column, sparse.values.data());
  Hoop::Constraints constraints;
  Hoop::constraints(precomputed, state, constraints);
  const Eigen::Map<const Eigen::Matrix<double, Hoop::multiplier_count, Hoop::velocity_count>> dense(
      constraints.jacobian.data());
  EXPECT_EQ(Eigen::MatrixXd(a), dense);
  EXPECT_LT(a.nonZeros(), dense.size());
}

TEST(ResidualJacobianKernel, IsReadByEigenAndHoldsMassAndConstraints) {
  using Squeezer = andrews_squeezer::Mechanism<double>;
  constexpr int n = Squeezer::velocity_count, m = Squeezer::multiplier_count;
  const auto precomputed = Squeezer::precompute(Squeezer::default_parameters());
  const Squeezer::State state = Squeezer::initial_state();
  Squeezer::ResidualJacobian sparse;
  Squeezer::residual_jacobian(precomputed, state, {}, {}, {}, sparse);
  const Eigen::MatrixXd all = Eigen::Map<const Eigen::SparseMatrix<double, Eigen::RowMajor>>(
      n + m, 3 * n + m, Squeezer::residual_jacobian_nonzeros, Squeezer::residual_jacobian_row_start,
      Squeezer::residual_jacobian_column, sparse.values.data());
  std::array<double, n * n> mass{};
  Squeezer::mass_matrix(precomputed, state, mass);
  Squeezer::Constraints constraints;
  Squeezer::constraints(precomputed, state, constraints);
  const Eigen::Map<const Eigen::Matrix<double, m, n>> a(constraints.jacobian.data());
  EXPECT_EQ(all.block(0, 2 * n, n, n), (Eigen::Map<const Eigen::Matrix<double, n, n>>(mass.data())));
  EXPECT_EQ(all.block(n, 2 * n, m, n), a);
  EXPECT_EQ(all.rightCols(m).topRows(n), -a.transpose());
  EXPECT_TRUE(all.bottomRightCorner(m, m).isZero(0));
  EXPECT_LT(2 * Squeezer::residual_jacobian_nonzeros, all.size());
}

}  // namespace
}  // namespace torsor::derivative_kernels_test
