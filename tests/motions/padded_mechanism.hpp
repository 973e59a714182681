// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <cstddef>

#include "tests/motions/evaluated_scene.hpp"

namespace torsor::testing_motions {

template <int count>
struct Numbers {
  std::array<double, static_cast<std::size_t>(count)> values{};
  double& operator[](int i) { return values[static_cast<std::size_t>(i)]; }
  const double& operator[](int i) const { return values[static_cast<std::size_t>(i)]; }
};
struct Nothing {
  double operator[](int) const { return 0.0; }
};

/// Any scene as a mechanism of one size, by the contract of generated headers, so that each method is compiled once:
/// coordinates and constraints that the scene lacks stand still and hold nothing. The last velocity is the work of all that
/// has no force function (its acceleration is the power), with a mass of its own.
/// `holding` idle coordinates can be constrained to zero, so that every motion has as many freedoms.
template <int quaternion_slots, int other_slots, int velocity_slots, int constraint_slots>
struct PaddedMechanism {
  static constexpr int quaternion_count = quaternion_slots, nv = velocity_slots, m = constraint_slots;
  static constexpr int coordinate_count = 4 * quaternion_slots + other_slots, velocity_count = nv, input_count = 0,
                       parameter_count = 0, multiplier_count = m;
  static constexpr std::array<int, 2> quaternions{0, 4};

  enum class Status { ok = 0, singular = 1, not_finite = 2 };
  using Parameters = EvaluatedScene*;
  using Coordinates = Numbers<coordinate_count>;
  using Velocities = Numbers<nv>;
  using Accelerations = Numbers<nv>;
  using GeneralizedForces = Numbers<nv>;
  using Inputs = Nothing;
  using Multipliers = Numbers<m>;
  struct State {
    double time = 0.0;
    Coordinates q;
    Velocities v;
  };
  struct Precomputed {
    EvaluatedScene* scene = nullptr;
  };
  struct Constraints {
    std::array<double, static_cast<std::size_t>(m)> value{}, rate{};
    std::array<double, static_cast<std::size_t>(m* nv)> jacobian{};
    std::array<double, static_cast<std::size_t>(m)> gamma{};
  };

  /// The scene that all functions move from now on.
  static inline EvaluatedScene* current = nullptr;
  /// The last constraints are on this many idle coordinates; those between them and the scene's hold nothing.
  static inline int holding = 0;

  [[nodiscard]] static bool holds(const EvaluatedScene::Sizes& sizes) {
    return sizes.quaternions <= quaternion_slots && sizes.others <= other_slots && sizes.velocities < nv &&
           sizes.constraints <= m;
  }

  static Parameters default_parameters() noexcept { return current; }
  static Precomputed precompute(const Parameters& scene) noexcept { return {scene}; }
  static State initial_state(const Parameters& scene = current) noexcept {
    State state;
    for (int k = 0; k < quaternion_slots; ++k) state.q[4 * k] = 1.0;
    const auto& initial = scene->initial_positions();
    for (std::size_t i = 0; i < initial.size(); ++i) state.q[slot(*scene, i)] = initial[i];
    return state;
  }

  /// Where position i of the scene is.
  static int slot(const EvaluatedScene& scene, std::size_t i) {
    const int own = 4 * scene.sizes().quaternions, place = static_cast<int>(i);
    return place < own ? place : 4 * quaternion_slots + place - own;
  }

  static void move(const Precomputed& p, const State& s) {
    std::array<double, static_cast<std::size_t>(coordinate_count)> q{};
    std::array<double, static_cast<std::size_t>(nv)> v{};
    const auto& scene = *p.scene;
    for (std::size_t i = 0; i < scene.positions().size(); ++i) q[i] = s.q[slot(scene, i)];
    for (int i = 0; i < scene.sizes().velocities; ++i) v[static_cast<std::size_t>(i)] = s.v[i];
    p.scene->move_to(s.time, q, v);
  }

  static Status forward_dynamics(const Precomputed& p, const State& s, const Inputs&, Accelerations& a,
                                 Multipliers& lambda) noexcept {
    move(p, s);
    a = {};
    lambda = {};
    const bool regular = p.scene->forward_dynamics(a.values, lambda.values);
    a[nv - 1] = p.scene->energy_rate();
    return regular ? Status::ok : Status::singular;
  }
  static void mass_matrix(const Precomputed& p, const State& s,
                          std::array<double, static_cast<std::size_t>(nv* nv)>& mass) noexcept {
    move(p, s);
    mass.fill(0.0);
    const int n = p.scene->sizes().velocities;
    for (int i = 0; i < nv; ++i) {
      for (int j = 0; j < nv; ++j)
        mass[static_cast<std::size_t>(j * nv + i)] = i < n && j < n ? p.scene->mass(i, j) : i == j ? 1.0 : 0.0;
    }
  }
  static void bias(const Precomputed& p, const State& s, GeneralizedForces& h) noexcept {
    move(p, s);
    h = {};
    for (int i = 0; i < p.scene->sizes().velocities; ++i) h[i] = p.scene->bias(i);
    h[nv - 1] = -p.scene->energy_rate();
  }
  static void constraints(const Precomputed& p, const State& s, Constraints& c) noexcept {
    move(p, s);
    c = {};
    const EvaluatedScene::Sizes& sizes = p.scene->sizes();
    for (int j = 0; j < sizes.constraints; ++j) {
      const auto row = static_cast<std::size_t>(j);
      c.value[row] = p.scene->constraint(j);
      c.rate[row] = p.scene->constraint_rate(j);
      c.gamma[row] = p.scene->constraint_gamma(j);
      for (int i = 0; i < sizes.velocities; ++i)
        c.jacobian[static_cast<std::size_t>(i * m + j)] = p.scene->constraint_jacobian(j, i);
    }
    // Idle coordinates that stay where they are, so that all motions have as many freedoms.
    for (int k = 0; k < holding; ++k) {
      const int row = m - 1 - k, column = nv - 2 - k;
      c.value[static_cast<std::size_t>(row)] = s.q[coordinate_count - 2 - k];
      c.rate[static_cast<std::size_t>(row)] = s.v[column];
      c.jacobian[static_cast<std::size_t>(column * m + row)] = 1.0;
    }
  }
  static void coordinate_rates(const Precomputed& p, const State& s,
                               std::array<double, static_cast<std::size_t>(coordinate_count)>& rates) noexcept
      requires(quaternion_slots > 0) {
    move(p, s);
    rates.fill(0.0);
    std::array<double, static_cast<std::size_t>(coordinate_count)> own{};
    p.scene->rates(own);
    for (std::size_t i = 0; i < p.scene->positions().size(); ++i) rates[static_cast<std::size_t>(slot(*p.scene, i))] = own[i];
  }
  template <class Vector>
  static Status jets(const Precomputed& p, const State& s, const Inputs&, int order, Vector* coefficients) noexcept {
    Accelerations a;
    Multipliers lambda;
    const Status status = forward_dynamics(p, s, {}, a, lambda);
    const auto c = p.scene->jets(order);
    const std::size_t positions = p.scene->positions().size();
    for (std::size_t k = 0; k < c.size(); ++k) {
      coefficients[k] = {};
      for (std::size_t i = 0; i < positions; ++i)
        coefficients[k][static_cast<std::size_t>(slot(*p.scene, i))] = c[k][i];
      for (std::size_t i = positions; i < c[k].size(); ++i)
        coefficients[k][static_cast<std::size_t>(coordinate_count) + i - positions] = c[k][i];
    }
    if constexpr (quaternion_slots > 0) {
      for (int k = p.scene->sizes().quaternions; k < quaternion_slots; ++k)
        coefficients[0][static_cast<std::size_t>(4 * k)] = 1.0;
    }
    return status;
  }
};

}  // namespace torsor::testing_motions
