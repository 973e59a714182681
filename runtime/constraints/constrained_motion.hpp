// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "torsor/runtime/constraints/change_point.hpp"
#include "torsor/runtime/constraints/independent_constraints.hpp"
#include "torsor/runtime/mechanism.hpp"
#include "torsor/runtime/status.hpp"

namespace torsor::runtime {

/// The generalised forces of a mechanism that nothing drives.
template <MechanismModel M>
struct NoForces {
  [[nodiscard]] typename M::GeneralizedForces operator()(const typename M::State&) const noexcept {
    typename M::GeneralizedForces forces{};
    for (int i = 0; i < M::velocity_count; ++i) forces[i] = ScalarOf<M>(0);
    return forces;
  }
};

/// Baumgarte's stabilisation: A a + γ = -2 α (A v - b) - β² f, so that violations die out like a damped oscillator of
/// eigenvalues near -α (critical for α = β). In 1/s; a few over a step's length at most. 0, 0: none.
/// Source: Baumgarte, Computer Methods in Applied Mechanics and Engineering 1 (1972) 1-16.
template <class Scalar>
struct Baumgarte {
  Scalar alpha = Scalar(0), beta = Scalar(0);
};

/// y' = f(t, y) of a mechanism with constraints of any rank, from its kernels `mass_matrix`, `bias` and `constraints`:
///   M a - Aᵀ λ = Q - h,   A a = -γ - 2 α (A v - b) - β² f,
/// solved through the independent constraints (see IndependentConstraints): redundant ones carry no multiplier. Change
/// points are passed (see ChangePoints), unless Baumgarte's stabilisation or a rank tolerance is given: with these the
/// equations are solved at every state as it is, constraints of which the others leave less than the tolerance let go.
/// Generalised forces Q come from a law `law(state) -> GeneralizedForces`.
template <HasDynamicsMatrices M, class ForceLaw = NoForces<M>>
requires HasConstraints<M>
class ConstrainedMotion {
 public:
  using Mechanism = M;
  using Scalar = ScalarOf<M>;
  using Vector = StateVector<M>;
  static constexpr bool second_order = !HasCoordinateRates<M>;

  explicit ConstrainedMotion(const typename M::Parameters& parameters = M::default_parameters(),
                             Baumgarte<Scalar> stabilisation = {},
                             Scalar rank_tolerance = Scalar(0), ForceLaw law = ForceLaw{}) noexcept
      : precomputed_(M::precompute(parameters)),
        stabilisation_(stabilisation),
        rank_tolerance_(rank_tolerance),
        law_(std::move(law)),
        change_points_(precomputed_) {}

  [[nodiscard]] Evaluation operator()(const Scalar& t, const Vector& y, Vector& dydt) const noexcept {
    const auto equations = [this](Scalar time, const Vector& at, Vector& slope) noexcept {
      const typename M::State state = unpack<M>(time, at);
      typename M::Accelerations a{};
      typename M::Multipliers lambda{};
      const Evaluation evaluation = solve(state, a, lambda, false);
      write_coordinate_rates<M>(precomputed_, state, slope);
      for (std::size_t i = 0; i < nv; ++i) slope[coordinates_of<M> + i] = a[static_cast<int>(i)];
      return evaluation;
    };
    if (!passes_change_points()) return equations(t, y, dydt);
    return change_points_.evaluate({precomputed_, t, y}, equations, dydt);
  }

  /// Accelerations and multipliers at a state; those of constraints that repeat others are 0. `singular` at a change
  /// point, where the state alone does not determine them, unless a rank tolerance lets its constraints go.
  [[nodiscard]] Evaluation accelerations(const typename M::State& state, typename M::Accelerations& a,
                                         typename M::Multipliers& lambda) const noexcept {
    return solve(state, a, lambda, !(rank_tolerance_ > Scalar(0)));
  }

  /// Gives the unit quaternions among the coordinates their norm back.
  void project(Vector& y) const noexcept requires HasQuaternions<M> { normalise_quaternions<M>(y); }

  [[nodiscard]] Evaluation settle_start(Vector& y) const noexcept requires HasQuaternions<M> {
    return start_with_unit_quaternions<M>(y) ? Evaluation::ok : Evaluation::not_finite;
  }

  /// Puts a state on the constraints, at change points too; what `projected` does after every step.
  [[nodiscard]] Evaluation settle(Scalar t, Vector& y) const noexcept {
    return change_points_.settle(precomputed_, t, y);
  }

  [[nodiscard]] Vector initial() const noexcept { return pack<M>(initial_state_of<M>(precomputed_)); }
  [[nodiscard]] Scalar initial_time() const noexcept { return initial_state_of<M>(precomputed_).time; }
  [[nodiscard]] const typename M::Precomputed& precomputed() const noexcept { return precomputed_; }

 private:
  static constexpr std::size_t nv = velocities_of<M>, m = static_cast<std::size_t>(M::multiplier_count);

  [[nodiscard]] bool passes_change_points() const noexcept {
    return !(rank_tolerance_ > Scalar(0)) && stabilisation_.alpha == Scalar(0) && stabilisation_.beta == Scalar(0);
  }

  [[nodiscard]] Evaluation solve(const typename M::State& state, typename M::Accelerations& a,
                                 typename M::Multipliers& lambda, bool only_regular) const noexcept {
    std::array<Scalar, nv * nv> mass;
    typename M::GeneralizedForces h{};
    typename M::Constraints constraints{};
    M::mass_matrix(precomputed_, state, mass);
    M::bias(precomputed_, state, h);
    M::constraints(precomputed_, state, constraints);
    static_assert(
        !requires { constraints.columns; }, "friction needs the mechanism's own forward_dynamics");
    IndependentConstraints<Scalar, nv, m> factor;
    if (only_regular && !change_points_.regular(constraints)) return Evaluation::singular;
    // Those that the generator left out repeat others on the constraints alone: beside them they look independent.
    if constexpr (HasRedundantConstraints<M>) {
      for (const int j : M::redundant_multipliers) {
        for (std::size_t i = 0; i < nv; ++i) constraints.jacobian[i * m + static_cast<std::size_t>(j)] = Scalar(0);
      }
    }
    const Scalar tolerance = rank_tolerance_ > Scalar(0) ? rank_tolerance_ : usual_rank_tolerance<Scalar>();
    if (const Evaluation e = factor.factorise(mass, constraints.jacobian, tolerance, change_points_.kinds().usual);
        e != Evaluation::ok) {
      return e;
    }
    const auto forces = law_(state);
    typename decltype(factor)::Column r, acceleration;
    typename decltype(factor)::Residual wanted, multipliers;
    for (int i = 0; i < static_cast<int>(nv); ++i) r(i) = forces[i] - h[i];
    const Scalar alpha = stabilisation_.alpha, beta = stabilisation_.beta;
    for (std::size_t j = 0; j < m; ++j) {
      wanted(static_cast<int>(j)) =
          -constraints.gamma[j] - Scalar(2) * alpha * constraints.rate[j] - beta * beta * constraints.value[j];
    }
    factor.solve(r, wanted, acceleration, multipliers);
    if (!all_finite(acceleration.entries) || !all_finite(multipliers.entries)) return Evaluation::not_finite;
    for (int i = 0; i < static_cast<int>(nv); ++i) a[i] = acceleration(i);
    for (int j = 0; j < static_cast<int>(m); ++j) lambda[j] = multipliers(j);
    return Evaluation::ok;
  }

  typename M::Precomputed precomputed_;
  Baumgarte<Scalar> stabilisation_;
  Scalar rank_tolerance_;
  ForceLaw law_;
  ChangePoints<M> change_points_;
};

/// `auto motion = constrained_motion<Mechanism<double>>();`, or with parameters, stabilisation and rank tolerance.
template <HasDynamicsMatrices M>
[[nodiscard]] ConstrainedMotion<M> constrained_motion(
    const typename M::Parameters& parameters = M::default_parameters(), Baumgarte<ScalarOf<M>> stabilisation = {},
    ScalarOf<M> rank_tolerance = {}) noexcept {
  return ConstrainedMotion<M>(parameters, stabilisation, rank_tolerance);
}

}  // namespace torsor::runtime
