// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <cmath>
#include <type_traits>

// Mechanisms written by hand to the contract of generated headers, small enough to be read at a glance.
namespace mechanisms {

enum class Status : int { ok = 0, singular = 1, not_finite = 2 };

template <class Scalar, int count>
struct Values {
  static constexpr int size = count;
  std::array<Scalar, static_cast<std::size_t>(count)> values{};
  Scalar& operator[](int i) noexcept { return values[static_cast<std::size_t>(i)]; }
  const Scalar& operator[](int i) const noexcept { return values[static_cast<std::size_t>(i)]; }
};
struct Nothing {
  static constexpr int size = 0;
};

/// Sizes and structures of mechanisms without inputs and parameters: n velocities, m multipliers, nq coordinates. What a
/// mechanism has besides takes the place of what is here.
template <class Scalar, int n, int m, int nq = n>
struct ContractOf {
  static constexpr int coordinate_count = nq, velocity_count = n, multiplier_count = m, input_count = 0, parameter_count = 0;
  using Coordinates = Values<Scalar, nq>;
  using Velocities = Values<Scalar, n>;
  using Accelerations = Values<Scalar, n>;
  using GeneralizedForces = Values<Scalar, n>;
  using Inputs = Nothing;
  using Multipliers = std::conditional_t<m == 0, Nothing, Values<Scalar, m>>;
  using Parameters = Nothing;
  struct Precomputed {
    Parameters parameters;
  };
  struct State {
    Scalar time;
    Coordinates q;
    Velocities v;
  };
  struct Constraints {
    std::array<Scalar, static_cast<std::size_t>(m)> value, rate;
    std::array<Scalar, static_cast<std::size_t>(m* n)> jacobian;
    std::array<Scalar, static_cast<std::size_t>(m)> gamma;
  };
  struct Linearisation {
    std::array<Scalar, static_cast<std::size_t>(n*n)> M, C, K;
    std::array<Scalar, static_cast<std::size_t>(n)> F;
  };
  static Parameters default_parameters() noexcept { return {}; }
  static Precomputed precompute(const Parameters& p) noexcept { return {p}; }
  static State initial_state() noexcept { return {}; }
};
template <int n, int m, int nq = n>
using Contract = ContractOf<double, n, m, nq>;

template <class Scalar>
inline constexpr Scalar gravity = Scalar(9.81);

/// m x'' = -k x + F, started at x = 1, x' = 0.
template <class Scalar>
struct Oscillator : ContractOf<Scalar, 1, 0> {
  using Base = ContractOf<Scalar, 1, 0>;
  using typename Base::Accelerations, typename Base::Multipliers, typename Base::State;
  static constexpr int input_count = 1, parameter_count = 2;
  using Inputs = Values<Scalar, 1>;
  struct Parameters {
    static constexpr int size = 2;
    Scalar mass, stiffness;
  };
  struct Precomputed {
    Parameters parameters;
    Scalar inverse_mass;
  };
  static Parameters default_parameters() noexcept { return {Scalar(1), Scalar(1)}; }
  static Precomputed precompute(const Parameters& p) noexcept { return {p, Scalar(1) / p.mass}; }
  static State initial_state() noexcept { return {Scalar(0), {{Scalar(1)}}, {{Scalar(0)}}}; }
  static Status forward_dynamics(const Precomputed& p, const State& s, const Inputs& u, Accelerations& a,
                                 Multipliers&) noexcept {
    a[0] = (u[0] - p.parameters.stiffness * s.q[0]) * p.inverse_mass;
    return Status::ok;
  }
};

/// Simple pendulum of length 1, angle from the downward vertical, released at rest from 2 rad.
template <class Scalar>
struct Pendulum : ContractOf<Scalar, 1, 0> {
  using Base = ContractOf<Scalar, 1, 0>;
  using typename Base::Accelerations, typename Base::Inputs, typename Base::Multipliers, typename Base::Precomputed;
  using typename Base::State, typename Base::GeneralizedForces;
  static State initial_state() noexcept { return {Scalar(0), {{Scalar(2)}}, {{Scalar(0)}}}; }
  static void mass_matrix(const Precomputed&, const State&, std::array<Scalar, 1>& mass) noexcept {
    mass[0] = Scalar(1);
  }
  static void bias(const Precomputed&, const State& s, GeneralizedForces& h) noexcept {
    h[0] = gravity<Scalar> * std::sin(s.q[0]);
  }
  static Status forward_dynamics(const Precomputed&, const State& s, const Inputs&, Accelerations& a,
                                 Multipliers&) noexcept {
    a[0] = -gravity<Scalar> * std::sin(s.q[0]);
    return Status::ok;
  }
};

/// The same pendulum (m = 1) in Cartesian coordinates, y upwards, with the constraint (x² + y² - 1)/2 = 0; benchmark
/// A01's start: horizontal to the left, at rest. Singular at the origin, where the constraint has no gradient.
template <class Scalar>
struct CartesianPendulum : ContractOf<Scalar, 2, 1> {
  using Base = ContractOf<Scalar, 2, 1>;
  using typename Base::Accelerations, typename Base::Inputs, typename Base::Multipliers, typename Base::Precomputed;
  using typename Base::State, typename Base::GeneralizedForces, typename Base::Constraints;
  static State initial_state() noexcept { return {Scalar(0), {{Scalar(-1), Scalar(0)}}, {{Scalar(0), Scalar(0)}}}; }
  static void mass_matrix(const Precomputed&, const State&, std::array<Scalar, 4>& mass) noexcept {
    mass = {Scalar(1), Scalar(0), Scalar(0), Scalar(1)};
  }
  static void bias(const Precomputed&, const State&, GeneralizedForces& h) noexcept {
    h[0] = Scalar(0);
    h[1] = gravity<Scalar>;
  }
  static void constraints(const Precomputed&, const State& s, Constraints& c) noexcept {
    c.value[0] = (s.q[0] * s.q[0] + s.q[1] * s.q[1] - Scalar(1)) / Scalar(2);
    c.rate[0] = s.q[0] * s.v[0] + s.q[1] * s.v[1];
    c.jacobian = {s.q[0], s.q[1]};
    c.gamma[0] = s.v[0] * s.v[0] + s.v[1] * s.v[1];
  }
  // x'' = λ x, y'' = λ y - g and x x'' + y y'' = -v² give λ (x² + y²) = g y - v².
  static Status forward_dynamics(const Precomputed&, const State& s, const Inputs&, Accelerations& a,
                                 Multipliers& lambda) noexcept {
    const Scalar r2 = s.q[0] * s.q[0] + s.q[1] * s.q[1];
    if (!(r2 > Scalar(0))) return Status::singular;
    lambda[0] = (gravity<Scalar> * s.q[1] - s.v[0] * s.v[0] - s.v[1] * s.v[1]) / r2;
    a[0] = lambda[0] * s.q[0];
    a[1] = lambda[0] * s.q[1] - gravity<Scalar>;
    return Status::ok;
  }
};

/// A free turn told by (cos, sin) of its angle: two coordinates, one velocity, dq/dt is not v.
template <class Scalar>
struct TurnByCosineAndSine : ContractOf<Scalar, 1, 0, 2> {
  using Base = ContractOf<Scalar, 1, 0, 2>;
  using typename Base::Accelerations, typename Base::Inputs, typename Base::Multipliers, typename Base::Precomputed;
  using typename Base::State;
  static State initial_state() noexcept { return {Scalar(0), {{Scalar(1), Scalar(0)}}, {{Scalar(2)}}}; }
  static void coordinate_rates(const Precomputed&, const State& s, std::array<Scalar, 2>& rates) noexcept {
    rates = {-s.q[1] * s.v[0], s.q[0] * s.v[0]};
  }
  static Status forward_dynamics(const Precomputed&, const State&, const Inputs&, Accelerations& a,
                                 Multipliers&) noexcept {
    a[0] = Scalar(0);
    return Status::ok;
  }
};

}  // namespace mechanisms
