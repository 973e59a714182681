// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <cmath>

#include "tests/runtime/mechanisms.hpp"

// Planar loops written by hand to the contract of generated headers: cranks that hang from pivots on a horizontal base
// and a coupler. Each crank's mass is a point at its end, the coupler's inertia J is about its first joint.
namespace mechanisms {

/// Coordinates: θ_k of each crank from the downward vertical, then ψ of the coupler from the horizontal. The coupler
/// starts at the end of crank 0 and meets that of crank k at the distance L_k: f_k = P_0 + L_k e(ψ) - P_k = 0.
/// `Lengths` has arrays crank[count], base[count], coupler[count] (0 first) and masses; θ_0 and ω_0 start the motion.
template <class Lengths>
struct CrankLoop : Contract<Lengths::cranks + 1, 2 * (Lengths::cranks - 1)> {
  static constexpr int cranks = Lengths::cranks, nv = cranks + 1, m = 2 * (cranks - 1);
  using Base = Contract<nv, m>;
  using typename Base::Constraints, typename Base::GeneralizedForces, typename Base::Precomputed, typename Base::State;
  static State initial_state() noexcept { return {0.0, {Lengths::start()}, {}}; }
  static void mass_matrix(const Precomputed&, const State&,
                          std::array<double, static_cast<std::size_t>(nv* nv)>& mass) noexcept {
    mass.fill(0.0);
    for (int k = 0; k < nv; ++k) {
      const auto i = static_cast<std::size_t>(k);
      mass[i * static_cast<std::size_t>(nv + 1)] =
          k < cranks ? Lengths::mass[i] * Lengths::crank[i] * Lengths::crank[i] : Lengths::inertia;
    }
  }
  static void bias(const Precomputed&, const State& s, GeneralizedForces& h) noexcept {
    for (int k = 0; k < cranks; ++k) {
      const auto i = static_cast<std::size_t>(k);
      h[k] = Lengths::mass[i] * gravity<double> * Lengths::crank[i] * std::sin(s.q[k]);
    }
    h[cranks] = 0.0;
  }
  static void constraints(const Precomputed&, const State& s, Constraints& c) noexcept {
    c.jacobian.fill(0.0);
    const double r0 = Lengths::crank[0], psi = s.q[cranks], psi_rate = s.v[cranks];
    const auto entry = [&](int row, int column) -> double& {
      return c.jacobian[static_cast<std::size_t>(column * m + row)];
    };
    for (int k = 1; k < cranks; ++k) {
      const auto i = static_cast<std::size_t>(k);
      const int row = 2 * (k - 1);
      const auto x = static_cast<std::size_t>(row), y = x + 1;
      const double r = Lengths::crank[i], L = Lengths::coupler[i];
      c.value[x] = r0 * std::sin(s.q[0]) + L * std::cos(psi) - Lengths::base[i] - r * std::sin(s.q[k]);
      c.value[y] = -r0 * std::cos(s.q[0]) + L * std::sin(psi) + r * std::cos(s.q[k]);
      entry(row, 0) = r0 * std::cos(s.q[0]);
      entry(row + 1, 0) = r0 * std::sin(s.q[0]);
      entry(row, k) = -r * std::cos(s.q[k]);
      entry(row + 1, k) = -r * std::sin(s.q[k]);
      entry(row, cranks) = -L * std::sin(psi);
      entry(row + 1, cranks) = L * std::cos(psi);
      const double w0 = s.v[0] * s.v[0], w = s.v[k] * s.v[k], p = psi_rate * psi_rate;
      c.gamma[x] = -r0 * std::sin(s.q[0]) * w0 - L * std::cos(psi) * p + r * std::sin(s.q[k]) * w;
      c.gamma[y] = r0 * std::cos(s.q[0]) * w0 - L * std::sin(psi) * p - r * std::cos(s.q[k]) * w;
      for (const int j : {row, row + 1}) {
        c.rate[static_cast<std::size_t>(j)] = entry(j, 0) * s.v[0] + entry(j, k) * s.v[k] + entry(j, cranks) * psi_rate;
      }
    }
  }
  /// T - U
  static double energy(const State& s) noexcept {
    double sum = 0.5 * Lengths::inertia * s.v[cranks] * s.v[cranks];
    for (int k = 0; k < cranks; ++k) {
      const auto i = static_cast<std::size_t>(k);
      const double r = Lengths::crank[i];
      sum += Lengths::mass[i] * (0.5 * r * r * s.v[k] * s.v[k] - gravity<double> * r * std::cos(s.q[k]));
    }
    return sum;
  }
};

/// Three equal cranks: a parallelogram with an extra bar, which one of the four constraints repeats. It swings like a
/// pendulum of length 1 from 2 rad at rest, over the change points at θ = ±π/2.
struct ThreeEqualCranks {
  static constexpr int cranks = 3;
  static constexpr std::array<double, 3> crank{1, 1, 1}, base{0, 0.75, 2}, coupler{0, 0.75, 2}, mass{1, 2, 0.5};
  static constexpr double inertia = 0.3;
  static std::array<double, 4> start() { return {2, 2, 2, 0}; }
};
/// The same with smaller swings, which stay away from the change points.
struct ThreeEqualCranksSmallSwing : ThreeEqualCranks {
  static std::array<double, 4> start() { return {1.25, 1.25, 1.25, 0}; }
};
/// Two cranks of different lengths: a four-bar of Grashof's kind, released with both to the right.
struct FourBar {
  static constexpr int cranks = 2;
  static constexpr std::array<double, 2> crank{0.3, 0.8}, base{0, 1}, coupler{0, 0.9}, mass{1, 0.7};
  static constexpr double inertia = 0.2;
  static std::array<double, 3> start() {
    // By the cosine rule: from the end of the first crank, turned by 1 rad, to the second pivot is d.
    const double x = 0.3 * std::sin(1.0), y = -0.3 * std::cos(1.0), dx = 1 - x, dy = -y;
    const double d = std::sqrt(dx * dx + dy * dy);
    const double at_joint = std::acos((0.81 + d * d - 0.64) / (2 * 0.9 * d));
    const double psi = std::atan2(dy, dx) - at_joint;
    const double px = x + 0.9 * std::cos(psi) - 1, py = y + 0.9 * std::sin(psi);
    return {1.0, std::atan2(px, -py), psi};
  }
};

}  // namespace mechanisms
