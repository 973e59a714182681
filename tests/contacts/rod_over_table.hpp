// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <cmath>
#include <cstddef>

#include "torsor/runtime/contacts/integrate_contacts.hpp"

// A closed loop with contacts in space.
namespace rod_over_table {

using namespace torsor::runtime;

/// Two particles of mass 1, joined by a rod without mass, over a table at A sin(w t). A force that turns pushes the first.
struct Rod {
  static constexpr std::size_t nq = 6, nv = 6, contacts = 2;
  static constexpr int constraints = 1;
  using State = std::array<double, nq + nv>;
  static constexpr double g = 9.81, length = 0.1, w = 30;

  double A = 0.01;  ///< below g/w²: it does not throw the rod up

  [[nodiscard]] static ContactRule rule(int) { return {.tangents = 2, .friction = 0.4, .restitution = 0.3}; }
  [[nodiscard]] Evaluation read(double t, const State& y, ContactReading& r) const {
    r.M.setIdentity();
    r.F << 4 * std::cos(3 * t), 3 * std::sin(3 * t), -g, 0, 0, -g;
    r.J.setZero();
    for (int k = 0; k < 2; ++k) {
      const int first = 3 * k;
      const auto x = static_cast<std::size_t>(first);
      r.gap[static_cast<std::size_t>(k)] = y[x + 2] - A * std::sin(w * t);
      r.J(first, first + 2) = r.J(first + 1, first) = r.J(first + 2, first + 1) = 1;
      r.w.segment(first, 3) << y[nq + x + 2] - A * w * std::cos(w * t), y[nq + x], y[nq + x + 1];
      r.drift.segment(first, 3) << A * w * w * std::sin(w * t), 0, 0;
    }
    const Eigen::Map<const Eigen::Vector3d> a(y.data()), b(y.data() + 3), va(y.data() + nq), vb(y.data() + nq + 3);
    const Eigen::Vector3d d = b - a, v = vb - va;
    r.A.row(0) << -d.transpose(), d.transpose();
    r.value(0) = (d.squaredNorm() - length * length) / 2;
    r.rate(0) = d.dot(v);
    r.gamma(0) = v.squaredNorm();
    return Evaluation::ok;
  }
  static void coordinate_rates(double, const State& y, std::array<double, nq>& rates) {
    for (std::size_t i = 0; i < nq; ++i) rates[i] = y[nq + i];
  }

  /// Level at a height above the table, without a velocity against it.
  [[nodiscard]] State above(double height) const {
    return {0, 0, height, length, 0, height, 0, 0, height > 0 ? 0 : A * w, 0, 0, height > 0 ? 0 : A * w};
  }
};

}  // namespace rod_over_table
