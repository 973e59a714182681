// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "torsor/runtime/integration/fixed_step.hpp"
#include "torsor/runtime/integration/integrate.hpp"
#include "torsor/runtime/numerics/jacobian.hpp"
#include "torsor/runtime/numerics/lu.hpp"
#include "torsor/runtime/steps/compensated_state.hpp"
#include "torsor/runtime/steps/gauss_coefficients.hpp"
#include "torsor/runtime/steps/gauss_step.hpp"
#include "torsor/runtime/steps/second_order.hpp"
#include "torsor/runtime/steps/stage_convergence.hpp"

namespace torsor::runtime {

/// How the equations of the stages are solved: by substitution, whose steps must resolve the fastest motion of the
/// mechanism, or by Newton's method with a Jacobian that is kept as long as it serves, for stiff ones.
enum class StageSolver { fixed_point, newton };

/// Gauss collocation of order 2 stages, 2 to 12, with a fixed step:
///   K_i = f(t + c_i h, y + h Σ_j a_ij K_j),   y(t + h) = y + h Σ_j b_j K_j.
/// Symmetric, A-stable, and symplectic where y are canonical variables; it keeps every quadratic first integral. Of a
/// mechanism in (q, v) whose mass matrix varies it is symmetric only, which bounds the energy of reversible motions;
/// the variational integrator is symplectic there too.
///
/// The first guess continues the last step's polynomial. The iteration goes on until rounding alone moves the stages,
/// and increments are summed with compensation and with weights of twice the length: otherwise the energy drifts by
/// rounding. Where q' = v (`second_order`) the velocities of the stages follow from the accelerations in the same
/// sweep, which squares the rate of convergence.
/// `no_convergence` after `iteration_limit` sweeps.
/// Observers may take the steps themselves (GaussStep, for one evaluation more), which are less accurate inside than at
/// their ends: events are located on steps of the method.
/// Source: Hairer-Lubich-Wanner, Geometric Numerical Integration, II.1.3, VIII.5 (rounding), VIII.6 (iteration);
/// Hairer-McLachlan-Razakarivony, Achieving Brouwer's law with implicit Runge-Kutta methods, BIT 48 (2008).
template <int stages = 3, StageSolver solver = StageSolver::fixed_point>
struct GaussCollocation {
  static constexpr int stage_count = stages;
  static constexpr int order = 2 * stages;
  static constexpr bool coarse_inside = true;

  double step = 0.0;  ///< in units of time, positive in both directions of time
  int iteration_limit = 50;
  std::int64_t step_limit = usual_fixed_step_limit;

  template <class S, class Scalar, std::size_t size>
  class Formula;

  template <class S, class Scalar, std::size_t size>
  [[nodiscard]] auto start(S& system, std::array<Scalar, size>& y, Scalar t) const noexcept {
    using Stages = Formula<S, Scalar, size>;
    return FixedStepRun<Stages, S, Scalar, size>(system, y, t, step, Stages(iteration_limit), step_limit);
  }
};

template <int stages, StageSolver solver>
template <class S, class Scalar, std::size_t size>
class GaussCollocation<stages, solver>::Formula {
 public:
  using Vector = std::array<Scalar, size>;
  using Step = GaussStep<Scalar, size, static_cast<std::size_t>(stages)>;

  explicit Formula(int iteration_limit = 50) noexcept : iteration_limit_(iteration_limit) {}

  template <class F>
  [[nodiscard]] IntegrationStatus step(F& f, Scalar t, Scalar h, const Vector& y, Vector& next) {
    if (!guess(f, t, h, y)) return IntegrationStatus::model_failure;
    IntegrationStatus status = IntegrationStatus::no_convergence;
    if constexpr (solver == StageSolver::newton) {
      const bool old_matrix = matrix_step_ == h && sweeps_ <= slow;
      if (!old_matrix && !prepare_matrix(f, t, h, y)) return IntegrationStatus::model_failure;
      status = solve(f, t, h, y);
      if (status == IntegrationStatus::no_convergence && old_matrix) {
        known_ = false;
        if (!guess(f, t, h, y) || !prepare_matrix(f, t, h, y)) return IntegrationStatus::model_failure;
        status = solve(f, t, h, y);
      }
    } else {
      status = solve(f, t, h, y);
    }
    if (status != IntegrationStatus::reached_end) return status;
    for (std::size_t k = 0; k < size; ++k) {
      Scalar rest = Scalar(0), sum = Scalar(0);
      for (std::size_t j = 0; j < s; ++j) {
        rest += gauss.b_rest[j] * slopes_[j][k];
        sum += gauss.b[j] * slopes_[j][k];
      }
      next[k] = state_.add(k, y[k], h * (sum + rest));
    }
    known_ = true;
    last_step_ = h;
    return IntegrationStatus::reached_end;
  }

  /// The slopes at both ends, for the interpolant.
  template <class F>
  [[nodiscard]] bool refine(F& f, Scalar t, Scalar t_next, const Vector& y, const Vector& next) {
    if (ends_known_) {
      first_slope_ = last_slope_;
    } else if (!f(t, y, first_slope_)) {
      return false;
    }
    ends_known_ = f(t_next, next, last_slope_);
    return ends_known_;
  }

  [[nodiscard]] Step interpolant(Scalar t, Scalar t_next, const Vector& y, const Vector& next) const noexcept {
    return Step(t, t_next, y, next, first_slope_, slopes_, last_slope_);
  }

 private:
  static constexpr std::size_t s = static_cast<std::size_t>(stages);
  static constexpr const GaussCoefficients<Scalar, s>& gauss = gauss_coefficients<Scalar, s>;
  static constexpr bool second_order = solver == StageSolver::fixed_point && is_second_order<S> && size % 2 == 0;
  static constexpr std::size_t half = second_order ? size / 2 : 0;  // what lies below follows from the rest
  static constexpr int slow = 6;  // more sweeps than these, and a new Jacobian is worth its price
  using Stages = std::array<Vector, s>;

  // The slopes at the nodes: the last step's polynomial continued, or the slope at the start.
  template <class F>
  bool guess(F& f, Scalar t, Scalar h, const Vector& y) {
    if (known_ && last_step_ == h) {
      const Stages last = slopes_;
      for (std::size_t i = 0; i < s; ++i) {
        for (std::size_t k = half; k < size; ++k) {
          Scalar sum = Scalar(0);
          for (std::size_t j = 0; j < s; ++j) sum += gauss.ahead[i][j] * last[j][k];
          slopes_[i][k] = sum;
        }
      }
      return true;
    }
    if (!f(t, y, slopes_[0])) return false;
    for (std::size_t i = 1; i < s; ++i) slopes_[i] = slopes_[0];
    return true;
  }

  // Y_i[k] for all stages, k from `first` to `end`.
  void place(Scalar h, const Vector& y, std::size_t first, std::size_t end) noexcept {
    for (std::size_t i = 0; i < s; ++i) {
      for (std::size_t k = first; k < end; ++k) {
        Scalar sum = Scalar(0);
        for (std::size_t j = 0; j < s; ++j) sum += gauss.a[i][j] * slopes_[j][k];
        places_[i][k] = y[k] + (state_.rest[k] + h * sum);
      }
    }
  }

  template <class F>
  [[nodiscard]] IntegrationStatus solve(F& f, Scalar t, Scalar h, const Vector& y) {
    StageConvergence<Scalar> convergence;
    for (sweeps_ = 1; sweeps_ <= iteration_limit_; ++sweeps_) {
      place(h, y, half, size);
      if constexpr (second_order) {
        for (std::size_t i = 0; i < s; ++i) {
          for (std::size_t k = 0; k < half; ++k) slopes_[i][k] = places_[i][half + k];
        }
        place(h, y, 0, half);
      }
      for (std::size_t i = 0; i < s; ++i) {
        if (!f(t + gauss.c[i] * h, places_[i], new_slopes_[i])) {
          return convergence.diverges() ? IntegrationStatus::no_convergence : IntegrationStatus::model_failure;
        }
      }
      if constexpr (solver == StageSolver::newton) correct();
      if (convergence.reached(change(h, y))) return IntegrationStatus::reached_end;
    }
    return IntegrationStatus::no_convergence;
  }

  // Takes the new slopes over; what the increments moved, each in terms of its own component.
  StageChange<Scalar> change(Scalar h, const Vector& y) noexcept {
    StageChange<Scalar> change;
    for (std::size_t k = half; k < size; ++k) {
      Scalar moved = Scalar(0), slope = Scalar(0);
      for (std::size_t i = 0; i < s; ++i) {
        moved = std::max(moved, std::abs(new_slopes_[i][k] - slopes_[i][k]));
        slope = std::max(slope, std::abs(new_slopes_[i][k]));
        slopes_[i][k] = new_slopes_[i][k];
      }
      change.add(std::abs(h) * moved, std::abs(y[k]) + std::abs(h) * slope);
    }
    return change;
  }

  // Newton's method: (I - h A ⊗ J) ΔK = f(Y) - K, with J of an earlier place.
  template <class F>
  bool prepare_matrix(F& f, Scalar t, Scalar h, const Vector& y) {
    JacobianMatrix<Scalar, size> J;
    if (!f(t, y, new_slopes_[0]) || !evaluate_jacobian(f, t, y, new_slopes_[0], J)) return false;
    auto& matrix = newton_.lu.matrix();
    for (std::size_t i = 0; i < s; ++i) {
      for (std::size_t j = 0; j < s; ++j) {
        for (std::size_t column = 0; column < size; ++column) {
          for (std::size_t row = 0; row < size; ++row) {
            matrix[(j * size + column) * s * size + i * size + row] =
                (i == j && row == column ? Scalar(1) : Scalar(0)) - h * gauss.a[i][j] * J[row + column * size];
          }
        }
      }
    }
    ++f.decompositions;
    f.evaluation = newton_.lu.factorise();
    matrix_step_ = h;
    return f.evaluation == Evaluation::ok;
  }

  void correct() noexcept {
    auto& right = newton_.right;
    for (std::size_t i = 0; i < s; ++i) {
      for (std::size_t k = 0; k < size; ++k) right[i * size + k] = new_slopes_[i][k] - slopes_[i][k];
    }
    newton_.lu.solve(right);
    for (std::size_t i = 0; i < s; ++i) {
      for (std::size_t k = 0; k < size; ++k) new_slopes_[i][k] = slopes_[i][k] + right[i * size + k];
    }
  }

  struct Newton {
    Lu<Scalar, s * size> lu;
    std::array<Scalar, s * size> right;
  };
  struct Nothing {};

  int iteration_limit_;
  int sweeps_ = 0;
  bool known_ = false;  // the slopes are those of the step before
  bool ends_known_ = false;
  Scalar last_step_ = Scalar(0), matrix_step_ = Scalar(0);
  CompensatedState<Scalar, size> state_;
  Stages slopes_{}, new_slopes_{}, places_{};
  Vector first_slope_{}, last_slope_{};
  std::conditional_t<solver == StageSolver::newton, Newton, Nothing> newton_{};
};

}  // namespace torsor::runtime
