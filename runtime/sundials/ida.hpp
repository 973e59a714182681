// SPDX-License-Identifier: MIT
#pragma once
#include <ida/ida.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "torsor/runtime/mechanism.hpp"
#include "torsor/runtime/sundials/run.hpp"

namespace torsor::runtime {

/// A motion (see `equations_of_motion`) without inputs of a mechanism that has the kernels `inverse_dynamics` and, with
/// multipliers, `constraints`.
template <class S>
concept HasResidual = requires {
  typename S::Mechanism;
  requires S::Mechanism::input_count == 0;
  requires S::Mechanism::multiplier_count == 0 || HasConstraints<typename S::Mechanism>;
  requires requires(const typename S::Mechanism::Precomputed& precomputed, const typename S::Mechanism::State& state,
                    const typename S::Mechanism::Accelerations& a, const typename S::Mechanism::Multipliers& lambda,
                    typename S::Mechanism::GeneralizedForces& r) {
    S::Mechanism::inverse_dynamics(precomputed, state, a, lambda, r);
  };
};

/// The kernel `residual_jacobian` of a mechanism with q' = v: where the entries that do not vanish stand, and their values.
template <class M>
concept HasResidualJacobian = velocities_of<M> == coordinates_of<M> &&
    requires(const typename M::Precomputed& precomputed, const typename M::State& state, const typename M::Accelerations& a,
             const typename M::Multipliers& lambda, const typename M::Inputs& u, typename M::ResidualJacobian& result) {
      M::residual_jacobian(precomputed, state, a, lambda, u, result);
      M::residual_jacobian_row_start[0];
      M::residual_jacobian_column[0];
    };

/// SUNDIALS' IDA: backward differentiation (orders 1 to 5) of the implicit form with the multipliers among the unknowns
/// (index 1), so that M is never solved with:
///   q' = N(q) v,   M v' + h - Aᵀλ = 0,   A v' + γ = 0   (λ_j = 0 where constraint j repeats others).
/// Newton's method takes its Jacobian from the kernel `residual_jacobian` where the mechanism has it, else from
/// differences. The multipliers stay out of the error test. Constraints drift as with the kernel `forward_dynamics`. The start's v'
/// and λ are those of the motion. y holds q and v as everywhere; the system must be what `equations_of_motion` makes.
/// Source: Hindmarsh et al., SUNDIALS, ACM TOMS 31 (2005).
struct Ida : SundialsMethod<Ida> {
  template <class S, std::size_t size>
  class Solver;
};

inline constexpr SundialsFunctions ida_functions{
    IDAFree,           IDASetErrFile,         IDASetUserData,     IDASStolerances,       IDASetInitStep,
    IDASetMaxStep,     IDASetStopTime,        IDASetLinearSolver, IDAGetNumErrTestFails, IDAGetNumStepSolveFails,
    IDAGetNumJacEvals, IDAGetNumLinSolvSetups};

template <class S, std::size_t size>
class Ida::Solver : public SundialsSolver<S, size> {
  static_assert(HasResidual<std::remove_cv_t<S>>,
                "IDA needs equations_of_motion of a mechanism without inputs that has the kernels inverse_dynamics "
                "and, with multipliers, constraints");
  using Base = SundialsSolver<S, size>;
  using typename Base::Work;

 public:
  Solver(const Ida& method, S& system) : Base(ida_functions, system), method_(method) {}
  ~Solver() {
    if (rates_ != nullptr) N_VDestroy(rates_);
    if (kinds_ != nullptr) N_VDestroy(kinds_);
  }

  [[nodiscard]] bool create(double t, const std::array<double, size>& y) {
    if (!this->prepare(y, size + m, true)) return false;
    rates_ = N_VClone(work.y);
    kinds_ = N_VClone(work.y);
    if (rates_ == nullptr || kinds_ == nullptr || !fill(t, y)) return false;
    this->memory = IDACreate(work.context);
    if (this->memory == nullptr || IDAInit(this->memory, residual, t, work.y, rates_) != 0) return false;
    if (!this->set_options(method_) || IDASetId(this->memory, kinds_) != 0 ||
        IDASetSuppressAlg(this->memory, SUNTRUE) != 0) {
      return false;
    }
    if constexpr (HasResidualJacobian<M>) return IDASetJacFn(this->memory, jacobian) == 0;
    return true;
  }

  int step(double end, double& t) { return IDASolve(this->memory, end, &t, work.y, rates_, IDA_ONE_STEP); }

  using Base::work;

 private:
  using M = typename std::remove_cv_t<S>::Mechanism;
  static constexpr std::size_t nq = coordinates_of<M>, nv = velocities_of<M>;
  static constexpr std::size_t m = static_cast<std::size_t>(M::multiplier_count);

  bool fill(double t, const std::array<double, size>& y) {
    typename M::Accelerations a{};
    typename M::Multipliers lambda{};
    std::array<double, size> slope;
    if (!work.f(t, y, slope) || work.f.system().accelerations(unpack<M>(t, y), a, lambda) != Evaluation::ok) {
      return false;
    }
    [[maybe_unused]] double* const unknowns = N_VGetArrayPointer(work.y);
    std::copy(slope.begin(), slope.end(), N_VGetArrayPointer(rates_));
    std::fill_n(N_VGetArrayPointer(kinds_), size, 1.0);
    if constexpr (m > 0) {
      for (std::size_t j = 0; j < m; ++j) {
        unknowns[size + j] = lambda[static_cast<int>(j)];
        N_VGetArrayPointer(rates_)[size + j] = 0.0;
        N_VGetArrayPointer(kinds_)[size + j] = 0.0;
      }
    }
    return true;
  }

  /// v' and λ among the unknowns.
  static std::pair<typename M::Accelerations, typename M::Multipliers> answer(const double* x, const double* dx) {
    std::pair<typename M::Accelerations, typename M::Multipliers> all{};
    for (std::size_t i = 0; i < nv; ++i) all.first[static_cast<int>(i)] = dx[nq + i];
    if constexpr (m > 0) {
      for (std::size_t j = 0; j < m; ++j) all.second[static_cast<int>(j)] = x[size + j];
    }
    return all;
  }

  static int residual(realtype t, N_Vector unknowns, N_Vector rates, N_Vector result, void* user) {
    auto& here = *static_cast<Work*>(user);
    ++here.f.calls;
    const double* const x = N_VGetArrayPointer(unknowns);
    const double* const dx = N_VGetArrayPointer(rates);
    double* const r = N_VGetArrayPointer(result);
    const auto& precomputed = here.f.system().precomputed();
    const typename M::State state = unpack<M>(t, here.read(unknowns));
    StateVector<M> turning{};
    write_coordinate_rates<M>(precomputed, state, turning);
    for (std::size_t i = 0; i < nq; ++i) r[i] = dx[i] - turning[i];
    const auto [a, lambda] = answer(x, dx);
    typename M::GeneralizedForces forces{};
    M::inverse_dynamics(precomputed, state, a, lambda, forces);
    for (std::size_t i = 0; i < nv; ++i) r[nq + i] = forces[static_cast<int>(i)];
    if constexpr (m > 0) {
      typename M::Constraints constraints{};
      M::constraints(precomputed, state, constraints);
      for (std::size_t j = 0; j < m; ++j) {
        r[size + j] = constraints.gamma[j];
        for (std::size_t i = 0; i < nv; ++i) r[size + j] += constraints.jacobian[i * m + j] * dx[nq + i];
      }
      if constexpr (HasRedundantConstraints<M>) {
        for (const int j : M::redundant_multipliers) {
          r[size + static_cast<std::size_t>(j)] = x[size + static_cast<std::size_t>(j)];
        }
      }
    }
    bool finite = true;
    for (std::size_t i = 0; i < size + m; ++i) finite = finite && std::isfinite(r[i]);
    if (finite) return 0;
    here.f.evaluation = Evaluation::not_finite;
    return here.refuse();
  }

  /// ∂F/∂x + c ∂F/∂x' of F = (q' - v, r(q, v, v', λ)), x = (q, v, λ): each entry of ∂r/∂(q, v, a, λ) goes to its column
  /// of x, those by accelerations with the factor c to the column of v.
  static int jacobian(realtype t, realtype c, N_Vector unknowns, N_Vector rates, N_Vector, SUNMatrix result, void* user,
                      N_Vector, N_Vector, N_Vector) {
    auto& here = *static_cast<Work*>(user);
    const auto [a, lambda] = answer(N_VGetArrayPointer(unknowns), N_VGetArrayPointer(rates));
    typename M::ResidualJacobian slopes;
    M::residual_jacobian(here.f.system().precomputed(), unpack<M>(t, here.read(unknowns)), a, lambda, {}, slopes);
    const auto entry = [result](std::size_t i, std::size_t j) -> double& {
      return SM_ELEMENT_D(result, static_cast<sunindextype>(i), static_cast<sunindextype>(j));
    };
    SUNMatZero(result);
    for (std::size_t i = 0; i < nq; ++i) {
      entry(i, i) = c;
      entry(i, nq + i) = -1;
    }
    bool finite = true;
    for (std::size_t i = 0; i < nv + m; ++i) {
      for (int k = M::residual_jacobian_row_start[i]; k < M::residual_jacobian_row_start[i + 1]; ++k) {
        const auto column = static_cast<std::size_t>(M::residual_jacobian_column[k]);
        const double value = slopes.values[static_cast<std::size_t>(k)];
        const bool by_acceleration = column >= 2 * nv && column < 3 * nv;
        entry(nq + i, column < 2 * nv ? column : column - nv) += by_acceleration ? c * value : value;
        finite = finite && std::isfinite(value);
      }
    }
    if (finite) return 0;
    here.f.evaluation = Evaluation::not_finite;
    return here.refuse();
  }

  Ida method_;
  N_Vector rates_ = nullptr, kinds_ = nullptr;
};

}  // namespace torsor::runtime
