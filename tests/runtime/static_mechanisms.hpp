// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <cmath>

#include "tests/runtime/mechanisms.hpp"

// Mechanisms for statics, written by hand to the contract of generated headers.
namespace mechanisms {

/// A pendulum (m = L = 1) hinged at the distance a from a vertical axis about which all turns at omega, in its plane,
/// theta from the downward vertical outwards: T0 = ½ ω² (a + sin θ)², U = g cos θ, friction c. a = 0 is a bead on a
/// hoop.
struct ArmPendulum : Contract<1, 0> {
  static constexpr int parameter_count = 3;
  struct Parameters {
    double omega, arm, friction;
  };
  struct Precomputed {
    Parameters parameters;
  };
  static Parameters default_parameters() noexcept { return {0, 0, 0}; }
  static Precomputed precompute(const Parameters& p) noexcept { return {p}; }
  static void inverse_dynamics(const Precomputed& p, const State& s, const Accelerations& a, const Multipliers&,
                               GeneralizedForces& r) noexcept {
    const auto& [omega, arm, friction] = p.parameters;
    r[0] = a[0] + friction * s.v[0] + gravity<double> * std::sin(s.q[0]) -
           omega * omega * (arm + std::sin(s.q[0])) * std::cos(s.q[0]);
  }
  static void linearisation(const Precomputed& p, const State& s, const Accelerations& a, const Multipliers& lambda,
                            const Inputs&, Linearisation& linear) noexcept {
    const auto& [omega, arm, friction] = p.parameters;
    GeneralizedForces r{};
    inverse_dynamics(p, s, a, lambda, r);
    linear.M = {1.0};
    linear.C = {friction};
    linear.K = {gravity<double> * std::cos(s.q[0]) - omega * omega * std::cos(2 * s.q[0]) +
                omega * omega * arm * std::sin(s.q[0])};
    linear.F = {-r[0]};
  }
};

/// A point mass (m = 1) on a curve f(x, y) = 0 under gravity along -y, one multiplier; an input pushes along x.
/// Without the kernel `linearisation`: the search takes central differences.
template <class Curve>
struct PointOnCurve : Contract<2, 1> {
  static void constraints(const Precomputed&, const State& s, Constraints& c) noexcept {
    const auto d = Curve::derivatives(s.q[0], s.q[1]);
    c.value[0] = d.value;
    c.jacobian = {d.x, d.y};
    c.rate[0] = d.x * s.v[0] + d.y * s.v[1];
    c.gamma[0] = d.xx * s.v[0] * s.v[0] + 2 * d.xy * s.v[0] * s.v[1] + d.yy * s.v[1] * s.v[1];
  }
  static void inverse_dynamics(const Precomputed&, const State& s, const Accelerations& a, const Multipliers& lambda,
                               GeneralizedForces& r) noexcept {
    const auto d = Curve::derivatives(s.q[0], s.q[1]);
    r[0] = a[0] - lambda[0] * d.x;
    r[1] = a[1] + gravity<double> - lambda[0] * d.y;
  }
};

/// The same with the kernel `linearisation`.
template <class Curve>
struct LinearisedPointOnCurve : PointOnCurve<Curve> {
  using Base = PointOnCurve<Curve>;
  static void linearisation(const typename Base::Precomputed& p, const typename Base::State& s,
                            const typename Base::Accelerations& a, const typename Base::Multipliers& lambda,
                            const typename Base::Inputs&, typename Base::Linearisation& linear) noexcept {
    const auto d = Curve::derivatives(s.q[0], s.q[1]);
    typename Base::GeneralizedForces r{};
    Base::inverse_dynamics(p, s, a, lambda, r);
    linear.M = {1, 0, 0, 1};
    linear.C = {0, 0, 0, 0};
    linear.K = {-lambda[0] * d.xx, -lambda[0] * d.xy, -lambda[0] * d.xy, -lambda[0] * d.yy};
    linear.F = {-r[0], -r[1]};
  }
};

/// The same held on its curve twice; the second multiplier is taken as zero.
template <class Curve>
struct TwiceOnCurve : Contract<2, 2> {
  static constexpr int redundant_count = 1;
  static constexpr int redundant_multipliers[] = {1};
  using Once = PointOnCurve<Curve>;
  static void constraints(const Precomputed&, const State& s, Constraints& c) noexcept {
    typename Once::Constraints once{};
    Once::constraints({}, {s.time, s.q, s.v}, once);
    c.value.fill(once.value[0]);
    c.rate.fill(once.rate[0]);
    c.gamma.fill(once.gamma[0]);
    c.jacobian = {once.jacobian[0], once.jacobian[0], once.jacobian[1], once.jacobian[1]};
  }
  static void inverse_dynamics(const Precomputed&, const State& s, const Accelerations& a, const Multipliers& lambda,
                               GeneralizedForces& r) noexcept {
    Once::inverse_dynamics({}, {s.time, s.q, s.v}, a, {{lambda[0] + lambda[1]}}, r);
  }
};

struct CurveDerivatives {
  double value, x, y, xx, xy, yy;
};
/// x² + y² = 1, halved.
struct Circle {
  static CurveDerivatives derivatives(double x, double y) noexcept {
    return {0.5 * (x * x + y * y - 1), x, y, 1, 0, 1};
  }
};
/// y = x⁴ − x²: a bump between two valleys.
struct DoubleWell {
  static CurveDerivatives derivatives(double x, double y) noexcept {
    return {y - x * x * x * x + x * x, -4 * x * x * x + 2 * x, 1, -12 * x * x + 2, 0, 0};
  }
};

/// A mass (m = 1) on a spring k = 4 from x = 0 with a motor's force u, and a cyclic turn about the axis x runs away
/// from: T = ½ (x'² + (1 + x²) ψ'²), friction c ψ' on the turn.
struct TurningSlider : Contract<2, 0> {
  static constexpr int input_count = 1, parameter_count = 1;
  using Inputs = Values<double, 1>;
  struct Parameters {
    double friction;
  };
  struct Precomputed {
    Parameters parameters;
  };
  static Parameters default_parameters() noexcept { return {0.5}; }
  static Precomputed precompute(const Parameters& p) noexcept { return {p}; }
  static void linearisation(const Precomputed& p, const State& s, const Accelerations& a, const Multipliers&,
                            const Inputs& u, Linearisation& linear) noexcept {
    const double x = s.q[0], turn = s.v[1], c = p.parameters.friction;
    linear.M = {1, 0, 0, 1 + x * x};
    linear.C = {0, 2 * x * turn, -2 * x * turn, 2 * x * s.v[0] + c};
    linear.K = {4 - turn * turn, 2 * s.v[0] * turn + 2 * x * a[1], 0, 0};
    linear.F = {-(a[0] - x * turn * turn + 4 * x - u[0]), -((1 + x * x) * a[1] + 2 * x * s.v[0] * turn + c * turn)};
  }
};

/// A body about a fixed point, its attitude a unit quaternion (body to ground axes), pulled by two constant fields:
/// the body's z towards the ground's -z with the moment 3, its x towards the ground's x with the moment 1, so that
/// U = x·R x − 3 z·R z. J = 1.
struct HeldBody : Contract<3, 0, 4> {
  static constexpr int quaternion_count = 1;
  static constexpr int quaternions[] = {0};
  static State initial_state() noexcept { return {0, {{1, 0, 0, 0}}, {}}; }
  static void inverse_dynamics(const Precomputed&, const State& s, const Accelerations& a, const Multipliers&,
                               GeneralizedForces& r) noexcept {
    const double w = s.q[0], x = s.q[1], y = s.q[2], z = s.q[3];
    const std::array<double, 3> along_x{w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)};
    const std::array<double, 3> along_z{2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z};
    // Moments x ∧ Rᵀx and −3 z ∧ Rᵀz in body axes.
    r[0] = a[0] - 3 * along_z[1];
    r[1] = a[1] + 3 * along_z[0] + along_x[2];
    r[2] = a[2] - along_x[1];
  }
};

}  // namespace mechanisms
