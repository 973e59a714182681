// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <cmath>

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

/// Sizes and structures of mechanisms in double without inputs: n velocities, m multipliers, nq coordinates.
template <int n, int m, int nq = n>
struct Contract {
  static constexpr int coordinate_count = nq, velocity_count = n, multiplier_count = m, input_count = 0;
  using Coordinates = Values<double, nq>;
  using Velocities = Values<double, n>;
  using Accelerations = Values<double, n>;
  using GeneralizedForces = Values<double, n>;
  using Inputs = Nothing;
  using Multipliers = Values<double, m>;
  struct State {
    double time;
    Coordinates q;
    Velocities v;
  };
  struct Constraints {
    std::array<double, static_cast<std::size_t>(m)> value, rate;
    std::array<double, static_cast<std::size_t>(m* n)> jacobian;
    std::array<double, static_cast<std::size_t>(m)> gamma;
  };
  struct Linearisation {
    std::array<double, static_cast<std::size_t>(n*n)> M, C, K;
    std::array<double, static_cast<std::size_t>(n)> F;
  };
  static State initial_state() noexcept { return {}; }
};

template <class Scalar>
inline constexpr Scalar gravity = Scalar(9.81);

/// m x'' = -k x + F, started at x = 1, x' = 0.
template <class Scalar>
struct Oscillator {
  static constexpr int coordinate_count = 1, velocity_count = 1, input_count = 1, parameter_count = 2,
                       multiplier_count = 0;
  struct Parameters {
    static constexpr int size = 2;
    Scalar mass, stiffness;
  };
  using Coordinates = Values<Scalar, 1>;
  using Velocities = Values<Scalar, 1>;
  using Accelerations = Values<Scalar, 1>;
  using GeneralizedForces = Values<Scalar, 1>;
  using Inputs = Values<Scalar, 1>;
  using Multipliers = Nothing;
  struct State {
    Scalar time;
    Coordinates q;
    Velocities v;
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
struct Pendulum {
  static constexpr int coordinate_count = 1, velocity_count = 1, input_count = 0, parameter_count = 0,
                       multiplier_count = 0;
  using Parameters = Nothing;
  using Coordinates = Values<Scalar, 1>;
  using Velocities = Values<Scalar, 1>;
  using Accelerations = Values<Scalar, 1>;
  using GeneralizedForces = Values<Scalar, 1>;
  using Inputs = Nothing;
  using Multipliers = Nothing;
  struct State {
    Scalar time;
    Coordinates q;
    Velocities v;
  };
  struct Precomputed {
    Parameters parameters;
  };
  static Parameters default_parameters() noexcept { return {}; }
  static Precomputed precompute(const Parameters& p) noexcept { return {p}; }
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
struct CartesianPendulum {
  static constexpr int coordinate_count = 2, velocity_count = 2, input_count = 0, parameter_count = 0,
                       multiplier_count = 1;
  using Parameters = Nothing;
  using Coordinates = Values<Scalar, 2>;
  using Velocities = Values<Scalar, 2>;
  using Accelerations = Values<Scalar, 2>;
  using GeneralizedForces = Values<Scalar, 2>;
  using Inputs = Nothing;
  using Multipliers = Values<Scalar, 1>;
  struct State {
    Scalar time;
    Coordinates q;
    Velocities v;
  };
  struct Precomputed {
    Parameters parameters;
  };
  struct Constraints {
    std::array<Scalar, 1> value, rate;
    std::array<Scalar, 2> jacobian;
    std::array<Scalar, 1> gamma;
  };
  static Parameters default_parameters() noexcept { return {}; }
  static Precomputed precompute(const Parameters& p) noexcept { return {p}; }
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
struct TurnByCosineAndSine {
  static constexpr int coordinate_count = 2, velocity_count = 1, input_count = 0, parameter_count = 0,
                       multiplier_count = 0;
  using Parameters = Nothing;
  using Coordinates = Values<Scalar, 2>;
  using Velocities = Values<Scalar, 1>;
  using Accelerations = Values<Scalar, 1>;
  using GeneralizedForces = Values<Scalar, 1>;
  using Inputs = Nothing;
  using Multipliers = Nothing;
  struct State {
    Scalar time;
    Coordinates q;
    Velocities v;
  };
  struct Precomputed {
    Parameters parameters;
  };
  static Parameters default_parameters() noexcept { return {}; }
  static Precomputed precompute(const Parameters& p) noexcept { return {p}; }
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
