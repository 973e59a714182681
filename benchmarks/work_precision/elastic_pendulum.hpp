// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <cmath>

namespace work_precision {

/// A unit mass on a spring from the origin (k = frequency² N/m, rest length 1 m) in the plane under gravity along -y, by
/// hand to the contract of generated headers: stiff without damping, so that its fast mode lives on.
template <class Scalar, int frequency>
struct ElasticPendulum {
  static constexpr int coordinate_count = 2, velocity_count = 2, input_count = 0, multiplier_count = 0;
  enum class Status : int { ok = 0, singular = 1 };
  struct Values {
    std::array<Scalar, 2> values{};
    Scalar& operator[](int i) noexcept { return values[static_cast<std::size_t>(i)]; }
    const Scalar& operator[](int i) const noexcept { return values[static_cast<std::size_t>(i)]; }
  };
  struct Nothing {
    static constexpr int size = 0;
  };
  using Coordinates = Values;
  using Velocities = Values;
  using Accelerations = Values;
  using GeneralizedForces = Values;
  using Inputs = Nothing;
  using Multipliers = Nothing;
  using Parameters = Nothing;
  struct State {
    Scalar time;
    Values q, v;
  };
  struct Precomputed {
    Parameters parameters;
  };
  struct Energy {
    Scalar kinetic, force_function;
  };
  static constexpr Scalar stiffness = Scalar(frequency) * Scalar(frequency), gravity = Scalar(9.81);

  static Parameters default_parameters() noexcept { return {}; }
  static Precomputed precompute(const Parameters& p) noexcept { return {p}; }
  static State initial_state() noexcept { return {Scalar(0), {{Scalar(1), Scalar(0)}}, {}}; }
  static Status forward_dynamics(const Precomputed&, const State& s, const Inputs&, Accelerations& a,
                                 Multipliers&) noexcept {
    const Scalar r = std::sqrt(s.q[0] * s.q[0] + s.q[1] * s.q[1]), pull = -stiffness * (r - Scalar(1)) / r;
    a[0] = pull * s.q[0];
    a[1] = pull * s.q[1] - gravity;
    return r > Scalar(0) ? Status::ok : Status::singular;
  }
  static void inverse_dynamics(const Precomputed& p, const State& s, const Accelerations& a, const Multipliers&,
                               GeneralizedForces& forces) noexcept {
    Accelerations free{};
    Multipliers none{};
    forward_dynamics(p, s, {}, free, none);
    for (int i = 0; i < 2; ++i) forces[i] = a[i] - free[i];
  }
  static void energy(const Precomputed&, const State& s, const Inputs&, Energy& e) noexcept {
    const Scalar r = std::sqrt(s.q[0] * s.q[0] + s.q[1] * s.q[1]);
    e.kinetic = (s.v[0] * s.v[0] + s.v[1] * s.v[1]) / Scalar(2);
    e.force_function = -stiffness * (r - Scalar(1)) * (r - Scalar(1)) / Scalar(2) - gravity * s.q[1];
  }
};

}  // namespace work_precision
