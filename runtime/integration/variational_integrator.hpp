// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "torsor/runtime/integration/even_forces.hpp"
#include "torsor/runtime/integration/fixed_step.hpp"
#include "torsor/runtime/integration/integrate.hpp"
#include "torsor/runtime/integration/lagrangian_forces.hpp"
#include "torsor/runtime/numerics/lu.hpp"
#include "torsor/runtime/steps/compensated_state.hpp"
#include "torsor/runtime/steps/gauss_coefficients.hpp"
#include "torsor/runtime/steps/spot_checks.hpp"
#include "torsor/runtime/steps/stage_convergence.hpp"

namespace torsor::runtime {

/// The variational integrator of order 2 stages with a fixed step: the action over a step, with q a polynomial of
/// degree `stages` and the integral taken by Gauss' formula, is a discrete Lagrangian
///   L_d(q_0, q_1) = ext Σ_i h b_i L(Q_i, V_i),   Q_i = q_0 + h Σ_j a_ij V_j,
/// and the motion is that of its discrete Euler-Lagrange equations, here in the momenta p = ∂L/∂v = M v:
///   M(Q_i) V_i = p + h Σ_j a_ij F_j,   F_j = ∂L/∂q + actions without a force function, at (Q_j, V_j),
///   q⁺ = q + h Σ_j b_j V_j,   p⁺ = p + h Σ_j b_j F_j.
/// One stage is the midpoint rule, L_d = h L((q_0 + q_1)/2, (q_1 - q_0)/h).
///
/// Symplectic however the mass matrix varies, so that the energy does not drift; the momenta of cyclic coordinates are
/// kept to rounding (discrete Noether theorem). Dampers act as discrete forces (Lagrange-d'Alembert). The stages are
/// solved by substitution down to rounding, `no_convergence` after `iteration_limit` sweeps.
/// A mass matrix that changes with time by itself (a driven joint that moves mass along) is refused, `unsuitable_model`:
/// seen at the start and at two later times. So are actions that are even in the velocities, as a drag -c v² without the
/// sign of v: they would pass for part of ∂T/∂q and turn round. That is tried at the start, at places about it, and along
/// the motion after 1, 2, 4, ... steps and after every 64.
/// For the motions of mechanisms with q' = v, without inputs and multipliers, with the kernels `mass_matrix` and `bias`
/// (and faster with `inverse_dynamics_derivatives`). A call counted is one F.
/// Source: Marsden-West, Discrete mechanics and variational integrators, Acta Numerica 10 (2001), 2.6.2 and 3.2;
/// Hairer-Lubich-Wanner, Geometric Numerical Integration, VI.6.2, theorem 6.4.
template <int stages = 1>
struct VariationalIntegrator {
  static constexpr int stage_count = stages;
  static constexpr int order = 2 * stages;

  double step = 0.0;  ///< in units of time, positive in both directions of time
  int iteration_limit = 50;
  std::int64_t step_limit = usual_fixed_step_limit;

  template <class S, class Scalar, std::size_t size>
  class Formula;

  template <class S, class Scalar, std::size_t size>
  [[nodiscard]] auto start(S& system, std::array<Scalar, size>& y, Scalar t) const noexcept {
    static_assert(HasLagrangian<std::remove_cv_t<S>>,
                  "the variational integrator needs equations_of_motion of a mechanism with q' = v, without inputs and "
                  "multipliers, that has the kernels mass_matrix and bias");
    using Stages = Formula<S, Scalar, size>;
    return FixedStepRun<Stages, S, Scalar, size>(system, y, t, step, Stages(iteration_limit), step_limit);
  }
};

template <int stages>
template <class S, class Scalar, std::size_t size>
class VariationalIntegrator<stages>::Formula {
 public:
  using Vector = std::array<Scalar, size>;

  explicit Formula(int iteration_limit = 50) noexcept : iteration_limit_(iteration_limit) {}

  template <class F>
  [[nodiscard]] IntegrationStatus prepare(F& f, Scalar t, const Vector& y) noexcept {
    const Matrix mass = mass_at(f, t, y);
    for (const Scalar later : {Scalar(0.37), Scalar(1.91)}) {
      if (mass_at(f, t + later, y) != mass) return IntegrationStatus::unsuitable_model;  // F lacks (∂M/∂t) v
    }
    for (int place = -1; place < 3; ++place) {
      if (place_has_even_forces(f, t, y, place)) return IntegrationStatus::unsuitable_model;
    }
    for (std::size_t i = 0; i < n; ++i) {
      momenta_[i] = Scalar(0);
      for (std::size_t j = 0; j < n; ++j) momenta_[i] += mass[j * n + i] * y[n + j];
    }
    if (!force(f, t, y, forces_[0])) return IntegrationStatus::model_failure;
    for (std::size_t i = 0; i < s; ++i) {
      forces_[i] = forces_[0];
      for (std::size_t k = 0; k < n; ++k) velocities_[i][k] = y[n + k];
    }
    return IntegrationStatus::reached_end;
  }

  template <class F>
  [[nodiscard]] IntegrationStatus step(F& f, Scalar t, Scalar h, const Vector& y, Vector& next) noexcept {
    if (checks_.due() && (place_has_even_forces(f, t, y, -1) || place_has_even_forces(f, t, y, 0))) {
      return IntegrationStatus::unsuitable_model;
    }
    if (last_step_ == h) extrapolate();
    const IntegrationStatus status = solve(f, t, h, y);
    if (status != IntegrationStatus::reached_end) return status;
    for (std::size_t k = 0; k < n; ++k) {
      Scalar turn = Scalar(0), turn_rest = Scalar(0), push = Scalar(0), push_rest = Scalar(0);
      for (std::size_t j = 0; j < s; ++j) {
        turn += gauss.b[j] * velocities_[j][k];
        turn_rest += gauss.b_rest[j] * velocities_[j][k];
        push += gauss.b[j] * forces_[j][k];
        push_rest += gauss.b_rest[j] * forces_[j][k];
      }
      next[k] = state_.add(k, y[k], h * (turn + turn_rest));
      momenta_[k] = state_.add(n + k, momenta_[k], h * (push + push_rest));
      next[n + k] = Scalar(0);
    }
    last_step_ = h;
    std::array<Scalar, n> v;
    if (!velocity(f, t + h, next, momenta_, v)) return IntegrationStatus::model_failure;
    for (std::size_t k = 0; k < n; ++k) next[n + k] = v[k];
    return IntegrationStatus::reached_end;
  }

 private:
  using M = typename std::remove_cv_t<S>::Mechanism;
  static constexpr std::size_t s = static_cast<std::size_t>(stages), n = size / 2;
  static constexpr const GaussCoefficients<Scalar, s>& gauss = gauss_coefficients<Scalar, s>;
  using Half = std::array<Scalar, n>;

  using Matrix = std::array<Scalar, n * n>;

  template <class F>
  static Matrix mass_at(F& f, Scalar t, const Vector& y) noexcept {
    Matrix mass;
    M::mass_matrix(f.system().precomputed(), unpack<M>(t, y), mass);
    return mass;
  }

  // At y itself for -1, else at a place about q with velocities no smaller than the largest given one and 1, no two
  // shifts the same: what is below rounding at rest may count later.
  template <class F>
  static bool place_has_even_forces(F& f, Scalar t, Vector y, int place) noexcept {
    Scalar fastest = Scalar(1);
    for (std::size_t i = 0; i < n; ++i) fastest = std::max(fastest, std::abs(y[n + i]));
    for (std::size_t i = 0; i < n && place >= 0; ++i) {
      const Scalar shift = Scalar(0.37) + Scalar(0.61) * spread<Scalar>(i);
      y[i] += static_cast<Scalar>(place) * shift * (Scalar(0.1) + std::abs(y[i]));
      y[n + i] = fastest * (Scalar(1.3) + Scalar(0.7) * spread<Scalar>(3 * i + 1));
    }
    return has_forces_even_in_velocities<M>(f.system().precomputed(), unpack<M>(t, y));
  }

  template <class F>
  static bool force(F& f, Scalar t, const Vector& y, Half& forces) noexcept {
    ++f.calls;
    lagrangian_forces<M>(f.system().precomputed(), unpack<M>(t, y), forces);
    f.evaluation = all_finite(forces) ? Evaluation::ok : Evaluation::not_finite;
    return f.evaluation == Evaluation::ok;
  }

  // v of M(q) v = p, with M scaled to a unit diagonal so that units do not matter (as SymmetricSolver does, whose
  // library takes longer than everything else here).
  template <class F>
  static bool velocity(F& f, Scalar t, const Vector& place, const Half& p, Half& v) noexcept {
    const Matrix mass = mass_at(f, t, place);
    Half scale;
    for (std::size_t i = 0; i < n; ++i) {
      const Scalar diagonal = mass[i * n + i];
      f.evaluation = !std::isfinite(diagonal)  ? Evaluation::not_finite
                     : !(diagonal > Scalar(0)) ? Evaluation::singular
                                               : Evaluation::ok;
      if (f.evaluation != Evaluation::ok) return false;
      scale[i] = Scalar(1) / std::sqrt(diagonal);
      v[i] = scale[i] * p[i];
    }
    Lu<Scalar, n> lu;
    for (std::size_t j = 0; j < n; ++j) {
      for (std::size_t i = 0; i < n; ++i) lu.matrix()[j * n + i] = scale[i] * mass[j * n + i] * scale[j];
    }
    f.evaluation = lu.factorise();
    if (f.evaluation != Evaluation::ok) return false;
    const Scalar least = static_cast<Scalar>(n) * std::numeric_limits<Scalar>::epsilon();
    if (!(lu.smallest_pivot() > least)) f.evaluation = Evaluation::singular;
    lu.solve(v);
    for (std::size_t i = 0; i < n; ++i) v[i] *= scale[i];
    if (!all_finite(v)) f.evaluation = Evaluation::not_finite;
    return f.evaluation == Evaluation::ok;
  }

  void extrapolate() noexcept {
    const auto velocities = velocities_, forces = forces_;
    for (std::size_t i = 0; i < s; ++i) {
      for (std::size_t k = 0; k < n; ++k) {
        Scalar v = Scalar(0), force = Scalar(0);
        for (std::size_t j = 0; j < s; ++j) {
          v += gauss.ahead[i][j] * velocities[j][k];
          force += gauss.ahead[i][j] * forces[j][k];
        }
        velocities_[i][k] = v;
        forces_[i][k] = force;
      }
    }
  }

  // Q_i, with nothing for the velocities.
  Vector place_of(std::size_t i, Scalar h, const Vector& y, const std::array<Half, s>& velocities) const noexcept {
    Vector place{};
    for (std::size_t k = 0; k < n; ++k) {
      Scalar turn = Scalar(0);
      for (std::size_t j = 0; j < s; ++j) turn += gauss.a[i][j] * velocities[j][k];
      place[k] = y[k] + (state_.rest[k] + h * turn);
    }
    return place;
  }

  static IntegrationStatus failure(const StageConvergence<Scalar>& convergence) noexcept {
    return convergence.diverges() ? IntegrationStatus::no_convergence : IntegrationStatus::model_failure;
  }

  template <class F>
  [[nodiscard]] IntegrationStatus solve(F& f, Scalar t, Scalar h, const Vector& y) noexcept {
    StageConvergence<Scalar> convergence;
    for (int sweep = 1; sweep <= iteration_limit_; ++sweep) {
      StageChange<Scalar> turns, pushes;
      std::array<Half, s> velocities, forces;
      for (std::size_t i = 0; i < s; ++i) {
        const Vector place = place_of(i, h, y, velocities_);
        Half p;
        for (std::size_t k = 0; k < n; ++k) {
          Scalar push = Scalar(0);
          for (std::size_t j = 0; j < s; ++j) push += gauss.a[i][j] * forces_[j][k];
          p[k] = momenta_[k] + (state_.rest[n + k] + h * push);
        }
        if (!velocity(f, t + gauss.c[i] * h, place, p, velocities[i])) return failure(convergence);
      }
      for (std::size_t i = 0; i < s; ++i) {  // with the places that the new velocities lead to
        Vector place = place_of(i, h, y, velocities);
        for (std::size_t k = 0; k < n; ++k) place[n + k] = velocities[i][k];
        if (!force(f, t + gauss.c[i] * h, place, forces[i])) return failure(convergence);
      }
      for (std::size_t k = 0; k < n; ++k) {
        Scalar turned = Scalar(0), turn = Scalar(0), pushed = Scalar(0), push = Scalar(0);
        for (std::size_t i = 0; i < s; ++i) {
          turned = std::max(turned, std::abs(velocities[i][k] - velocities_[i][k]));
          turn = std::max(turn, std::abs(velocities[i][k]));
          pushed = std::max(pushed, std::abs(forces[i][k] - forces_[i][k]));
          push = std::max(push, std::abs(forces[i][k]));
        }
        const Scalar length = std::abs(h);
        turns.add(length * turned, std::abs(y[k]) + length * turn);
        pushes.add(length * pushed, std::abs(momenta_[k]) + length * push);
      }
      velocities_ = velocities;
      forces_ = forces;
      if (convergence.reached(turns.by_component > pushes.by_component ? turns : pushes))
        return IntegrationStatus::reached_end;
    }
    return IntegrationStatus::no_convergence;
  }

  int iteration_limit_;
  SpotChecks checks_;
  Scalar last_step_ = Scalar(0);
  CompensatedState<Scalar, size> state_;  // of q, then of p
  Half momenta_{};
  std::array<Half, s> velocities_{}, forces_{};
};

}  // namespace torsor::runtime
