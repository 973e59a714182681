// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "runtime/constraints/independent_constraints.hpp"
#include "runtime/mechanism.hpp"
#include "runtime/numerics/linear_solve.hpp"
#include "runtime/status.hpp"

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
/// solved through the independent constraints (see IndependentConstraints): redundant ones, and those lost at a change
/// point, carry no multiplier. Generalised forces Q come from a law `law(state) -> GeneralizedForces`.
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
                             Scalar rank_tolerance = usual_rank_tolerance<Scalar>(), ForceLaw law = ForceLaw{}) noexcept
      : precomputed_(M::precompute(parameters)),
        stabilisation_(stabilisation),
        rank_tolerance_(rank_tolerance),
        law_(std::move(law)) {}

  [[nodiscard]] Evaluation operator()(const Scalar& t, const Vector& y, Vector& dydt) const noexcept {
    const typename M::State state = unpack<M>(t, y);
    typename M::Accelerations a{};
    typename M::Multipliers lambda{};
    const Evaluation evaluation = accelerations(state, a, lambda);
    write_coordinate_rates<M>(precomputed_, state, dydt);
    for (std::size_t i = 0; i < nv; ++i) dydt[coordinates_of<M> + i] = a[static_cast<int>(i)];
    return evaluation;
  }

  /// Accelerations and multipliers at a state; those of constraints that repeat others are 0.
  [[nodiscard]] Evaluation accelerations(const typename M::State& state, typename M::Accelerations& a,
                                         typename M::Multipliers& lambda) const noexcept {
    std::array<Scalar, nv * nv> mass;
    typename M::GeneralizedForces h{};
    typename M::Constraints constraints{};
    M::mass_matrix(precomputed_, state, mass);
    M::bias(precomputed_, state, h);
    M::constraints(precomputed_, state, constraints);
    static_assert(
        !requires { constraints.columns; }, "friction needs the mechanism's own forward_dynamics");
    IndependentConstraints<Scalar, nv, m> factor;
    if (const Evaluation e = factor.factorise(mass, constraints.jacobian, rank_tolerance_); e != Evaluation::ok)
      return e;
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
    if (!acceleration.allFinite() || !multipliers.allFinite()) return Evaluation::not_finite;
    for (int i = 0; i < static_cast<int>(nv); ++i) a[i] = acceleration(i);
    for (int j = 0; j < static_cast<int>(m); ++j) lambda[j] = multipliers(j);
    return Evaluation::ok;
  }

  /// Gives the unit quaternions among the coordinates their norm back.
  void project(Vector& y) const noexcept requires HasQuaternions<M> { normalise_quaternions<M>(y); }

  [[nodiscard]] Vector initial() const noexcept { return pack<M>(initial_state_of<M>(precomputed_)); }
  [[nodiscard]] Scalar initial_time() const noexcept { return initial_state_of<M>(precomputed_).time; }
  [[nodiscard]] const typename M::Precomputed& precomputed() const noexcept { return precomputed_; }

 private:
  static constexpr std::size_t nv = velocities_of<M>, m = static_cast<std::size_t>(M::multiplier_count);
  typename M::Precomputed precomputed_;
  Baumgarte<Scalar> stabilisation_;
  Scalar rank_tolerance_;
  ForceLaw law_;
};

/// `auto motion = constrained_motion<Mechanism<double>>();`, or with parameters, stabilisation and rank tolerance.
template <HasDynamicsMatrices M>
[[nodiscard]] ConstrainedMotion<M> constrained_motion(
    const typename M::Parameters& parameters = M::default_parameters(), Baumgarte<ScalarOf<M>> stabilisation = {},
    ScalarOf<M> rank_tolerance = usual_rank_tolerance<ScalarOf<M>>()) noexcept {
  return ConstrainedMotion<M>(parameters, stabilisation, rank_tolerance);
}

}  // namespace torsor::runtime
