// SPDX-License-Identifier: MIT
#pragma once
#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "torsor/runtime/mechanism.hpp"
#include "torsor/runtime/status.hpp"

namespace torsor::runtime {

/// Factor of a symmetric positive definite matrix, scaled to a unit diagonal so that units do not matter: LDLᵀ of
/// S_ij / sqrt(S_ii S_jj). What remains of a row's 1 after elimination is its share that other rows do not explain;
/// below n roundings the matrix is called singular. Columns run first (column-major).
template <class Scalar, int size>
class SymmetricSolver {
 public:
  using Matrix = Eigen::Matrix<Scalar, size, size>;
  using Vector = Eigen::Matrix<Scalar, size, 1>;

  [[nodiscard]] Evaluation factorise(const Matrix& matrix) noexcept {
    for (int i = 0; i < size; ++i) {
      if (!std::isfinite(matrix(i, i))) return Evaluation::not_finite;
      if (!(matrix(i, i) > Scalar(0))) return Evaluation::singular;
      scale_(i) = Scalar(1) / std::sqrt(matrix(i, i));
    }
    const Matrix scaled = scale_.asDiagonal() * matrix * scale_.asDiagonal();
    if (!scaled.allFinite()) return Evaluation::not_finite;
    if constexpr (size > 1) {  // a single row is scaled to 1: nothing is left to factor
      factor_.compute(scaled);
      const Scalar least = static_cast<Scalar>(size) * std::numeric_limits<Scalar>::epsilon();
      if (!(factor_.vectorD().minCoeff() > least)) return Evaluation::singular;
    }
    return Evaluation::ok;
  }

  /// The solution of S x = b, one column or several; only after `factorise` said `ok`.
  template <int columns>
  [[nodiscard]] Eigen::Matrix<Scalar, size, columns> solve(
      const Eigen::Matrix<Scalar, size, columns>& right_hand_side) const noexcept {
    const Eigen::Matrix<Scalar, size, columns> scaled = scale_.asDiagonal() * right_hand_side;
    if constexpr (size == 1) {
      return scale_.asDiagonal() * scaled;
    } else {
      const Eigen::Matrix<Scalar, size, columns> solution = factor_.solve(scaled);
      return scale_.asDiagonal() * solution;
    }
  }

 private:
  Vector scale_;
  Eigen::LDLT<Matrix> factor_;
};

/// Solves M a = r, with r = Q - h: the accelerations of a mechanism without multipliers.
/// M is symmetric positive definite, column-major. `singular` when it is not within rounding; a is then left alone.
template <class Scalar, std::size_t nv, std::size_t nv_squared>
[[nodiscard]] Evaluation solve_dynamics(const std::array<Scalar, nv_squared>& mass, const std::array<Scalar, nv>& r,
                                        std::array<Scalar, nv>& a) noexcept {
  static_assert(nv_squared == nv * nv, "the mass matrix must have nv x nv entries");
  constexpr int n = static_cast<int>(nv);
  SymmetricSolver<Scalar, n> solver;
  const Eigen::Map<const Eigen::Matrix<Scalar, n, n>> M(mass.data());
  const Eigen::Map<const Eigen::Matrix<Scalar, n, 1>> right(r.data());
  if (const Evaluation evaluation = solver.factorise(M); evaluation != Evaluation::ok) return evaluation;
  const Eigen::Matrix<Scalar, n, 1> solution = solver.template solve<1>(right);
  if (!solution.allFinite()) return Evaluation::not_finite;
  Eigen::Map<Eigen::Matrix<Scalar, n, 1>>(a.data()) = solution;
  return Evaluation::ok;
}

/// M a - Aᵀ λ = r,  A a = -γ  with r = Q - h, of numbers that are kept elsewhere.
template <class Scalar, std::size_t nv, std::size_t m>
struct ConstrainedDynamics {
  static_assert(m > 0 && m <= nv, "independent constraints are at least one and at most as many as velocities");
  const std::array<Scalar, nv * nv>& mass;     ///< M, symmetric positive definite, column by column
  const std::array<Scalar, m * nv>& jacobian;  ///< A, m x nv, column by column
  const std::array<Scalar, nv>& r;             ///< forces
  const std::array<Scalar, m>& gamma;
};

/// Solves for accelerations and multipliers, P_i = Q_i + Σ λ_j a_ji.
/// By the Schur complement: (A M⁻¹ Aᵀ) λ = -γ - A M⁻¹ r, then M a = r + Aᵀ λ. `singular` when M is, or when the
/// constraints are not independent; a and λ are then left alone.
template <class Scalar, std::size_t nv, std::size_t m>
[[nodiscard]] Evaluation solve_constrained_dynamics(const ConstrainedDynamics<Scalar, nv, m>& equations,
                                                    std::array<Scalar, nv>& a, std::array<Scalar, m>& lambda) noexcept {
  constexpr int n = static_cast<int>(nv);
  constexpr int rows = static_cast<int>(m);
  // Eigen refuses a single row stored by columns; its storage is then the same by rows.
  using Jacobian = Eigen::Matrix<Scalar, rows, n, rows == 1 ? Eigen::RowMajor : Eigen::ColMajor>;
  using Column = Eigen::Matrix<Scalar, n, 1>;
  using Multipliers = Eigen::Matrix<Scalar, rows, 1>;
  const Eigen::Map<const Eigen::Matrix<Scalar, n, n>> M(equations.mass.data());
  const Eigen::Map<const Jacobian> A(equations.jacobian.data());
  const Eigen::Map<const Column> right(equations.r.data());
  const Eigen::Map<const Multipliers> g(equations.gamma.data());

  SymmetricSolver<Scalar, n> by_mass;
  if (const Evaluation evaluation = by_mass.factorise(M); evaluation != Evaluation::ok) return evaluation;
  const Eigen::Matrix<Scalar, n, rows> A_transposed = A.transpose();
  const Eigen::Matrix<Scalar, n, rows> response = by_mass.template solve<rows>(A_transposed);  // M⁻¹ Aᵀ
  const Column free = by_mass.template solve<1>(right);                                        // M⁻¹ r
  const Eigen::Matrix<Scalar, rows, rows> complement = A.lazyProduct(response);

  SymmetricSolver<Scalar, rows> by_complement;
  if (const Evaluation evaluation = by_complement.factorise(complement); evaluation != Evaluation::ok) {
    return evaluation;
  }
  const Multipliers wanted = -g - A.lazyProduct(free);
  const Multipliers multipliers = by_complement.template solve<1>(wanted);
  const Column accelerations = free + response.lazyProduct(multipliers);
  if (!accelerations.allFinite() || !multipliers.allFinite()) return Evaluation::not_finite;
  Eigen::Map<Column>(a.data()) = accelerations;
  Eigen::Map<Multipliers>(lambda.data()) = multipliers;
  return Evaluation::ok;
}

/// The same where friction works with the multipliers too: M a - B λ = r, A a = -γ, B nv x m and column-major, by
/// (A M⁻¹ B) λ = -γ - A M⁻¹ r with exchange of rows. `singular` too when that matrix is, to within roundings of its
/// largest entry: a contact jams or leaves more than one motion (Painlevé's paradox lies beyond).
template <class Scalar, std::size_t nv, std::size_t m>
[[nodiscard]] Evaluation solve_constrained_dynamics(const ConstrainedDynamics<Scalar, nv, m>& equations,
                                                    const std::array<Scalar, m * nv>& columns,
                                                    std::array<Scalar, nv>& a, std::array<Scalar, m>& lambda) noexcept {
  constexpr int n = static_cast<int>(nv);
  constexpr int rows = static_cast<int>(m);
  using Jacobian = Eigen::Matrix<Scalar, rows, n, rows == 1 ? Eigen::RowMajor : Eigen::ColMajor>;
  using Columns = Eigen::Matrix<Scalar, n, rows>;
  using Column = Eigen::Matrix<Scalar, n, 1>;
  using Multipliers = Eigen::Matrix<Scalar, rows, 1>;
  const Eigen::Map<const Eigen::Matrix<Scalar, n, n>> M(equations.mass.data());
  const Eigen::Map<const Jacobian> A(equations.jacobian.data());
  const Eigen::Map<const Columns> B(columns.data());
  const Eigen::Map<const Column> right(equations.r.data());
  const Eigen::Map<const Multipliers> g(equations.gamma.data());

  SymmetricSolver<Scalar, n> by_mass;
  if (const Evaluation evaluation = by_mass.factorise(M); evaluation != Evaluation::ok) return evaluation;
  const Eigen::Matrix<Scalar, n, rows> forces = B;
  const Eigen::Matrix<Scalar, n, rows> response = by_mass.template solve<rows>(forces);  // M⁻¹ B
  const Column free = by_mass.template solve<1>(right);                                  // M⁻¹ r
  const Eigen::Matrix<Scalar, rows, rows> complement = A.lazyProduct(response);
  if (!complement.allFinite()) return Evaluation::not_finite;
  const Eigen::FullPivLU<Eigen::Matrix<Scalar, rows, rows>> by_complement(complement);
  if (!by_complement.isInvertible()) return Evaluation::singular;
  const Multipliers wanted = -g - A.lazyProduct(free);
  const Multipliers multipliers = by_complement.solve(wanted);
  const Column accelerations = free + response.lazyProduct(multipliers);
  if (!accelerations.allFinite() || !multipliers.allFinite()) return Evaluation::not_finite;
  Eigen::Map<Column>(a.data()) = accelerations;
  Eigen::Map<Multipliers>(lambda.data()) = multipliers;
  return Evaluation::ok;
}

/// Accelerations and multipliers of a mechanism under given generalised forces Q, from its matrices rather than from
/// the kernel `forward_dynamics`: the same unknowns by another method.
template <HasDynamicsMatrices M>
[[nodiscard]] Evaluation solve_dynamics(const typename M::Precomputed& precomputed, const typename M::State& state,
                                        const typename M::GeneralizedForces& forces, typename M::Accelerations& a,
                                        [[maybe_unused]] typename M::Multipliers& lambda) noexcept {
  using Scalar = ScalarOf<M>;
  constexpr std::size_t nv = velocities_of<M>;
  std::array<Scalar, nv * nv> mass;
  typename M::GeneralizedForces h{};
  M::mass_matrix(precomputed, state, mass);
  M::bias(precomputed, state, h);
  std::array<Scalar, nv> r, solution;
  for (std::size_t i = 0; i < nv; ++i) r[i] = forces[static_cast<int>(i)] - h[static_cast<int>(i)];
  Evaluation evaluation = Evaluation::ok;
  if constexpr (M::multiplier_count > 0) {
    typename M::Constraints constraints{};
    M::constraints(precomputed, state, constraints);
    std::array<Scalar, static_cast<std::size_t>(M::multiplier_count)> multipliers;
    const ConstrainedDynamics<Scalar, nv, std::tuple_size_v<decltype(multipliers)>> equations{
        .mass = mass, .jacobian = constraints.jacobian, .r = r, .gamma = constraints.gamma};
    if constexpr (requires { constraints.columns; }) {  // friction
      evaluation = solve_constrained_dynamics(equations, constraints.columns, solution, multipliers);
    } else {
      evaluation = solve_constrained_dynamics(equations, solution, multipliers);
    }
    if (evaluation == Evaluation::ok) {
      for (int j = 0; j < M::multiplier_count; ++j) lambda[j] = multipliers[static_cast<std::size_t>(j)];
    }
  } else {
    evaluation = solve_dynamics(mass, r, solution);
  }
  if (evaluation == Evaluation::ok) {
    for (std::size_t i = 0; i < nv; ++i) a[static_cast<int>(i)] = solution[i];
  }
  return evaluation;
}

}  // namespace torsor::runtime
