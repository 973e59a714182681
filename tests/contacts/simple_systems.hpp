// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>

#include "torsor/runtime/contacts/integrate_contacts.hpp"

// Mechanisms of a few freedoms whose equations of motion and contacts are written by hand.
namespace simple_systems {

using namespace torsor::runtime;

/// A mechanism given by a function that fills its reading; q' are the first velocities.
template <std::size_t q_count, std::size_t v_count, std::size_t contact_count>
struct ByHand {
  static constexpr std::size_t nq = q_count, nv = v_count, contacts = contact_count;
  using State = std::array<double, nq + nv>;

  std::array<ContactRule, contacts> rules;
  std::function<void(double, const State&, ContactReading&)> fill;

  [[nodiscard]] ContactRule rule(int i) const { return rules[static_cast<std::size_t>(i)]; }
  [[nodiscard]] Evaluation read(double t, const State& y, ContactReading& reading) const {
    fill(t, y, reading);
    return Evaluation::ok;
  }
  void coordinate_rates(double, const State& y, std::array<double, nq>& rates) const {
    for (std::size_t i = 0; i < nq; ++i) rates[i] = y[nq + i];
  }
};

constexpr double g = 9.81;

/// A ball over a floor at z = 0: q = z; drag -c v|v| for each unit of mass.
inline ByHand<1, 1, 1> ball(double e, double c = 0) {
  return {{ContactRule{.tangents = 0, .restitution = e}}, [c](double, const auto& y, auto& r) {
            r.M(0, 0) = 1;
            r.F(0) = -g - c * y[1] * std::abs(y[1]);
            r.gap[0] = y[0];
            r.J(0, 0) = 1;
            r.w(0) = y[1];
            r.drift(0) = 0;
          }};
}

/// A ball over a table at A sin(w t).
inline ByHand<1, 1, 1> ball_on_table(double e, double A, double w) {
  return {{ContactRule{.tangents = 0, .restitution = e}}, [A, w](double t, const auto& y, auto& r) {
            r.M(0, 0) = 1;
            r.F(0) = -g;
            r.gap[0] = y[0] - A * std::sin(w * t);
            r.J(0, 0) = 1;
            r.w(0) = y[1] - A * w * std::cos(w * t);
            r.drift(0) = A * w * w * std::sin(w * t);
          }};
}

/// A solid sphere of mass 1 on a slope, x down it, z normal to it: q = (x, z, φ), φ' > 0 rolls down.
inline ByHand<3, 3, 1> sphere_on_slope(double slope, double f, double e, double R) {
  return {{ContactRule{.tangents = 1, .friction = f, .restitution = e}}, [=](double, const auto& y, auto& r) {
            r.M.setIdentity();
            r.M(2, 2) = 0.4 * R * R;
            r.F << g * std::sin(slope), -g * std::cos(slope), 0;
            r.gap[0] = y[1] - R;
            r.J << 0, 1, 0, 1, 0, -R;
            r.w << y[4], y[3] - R * y[5];
            r.drift.setZero();
          }};
}

/// A particle on a level turntable that is spun up, Ω = α t: q = (x, y, z).
inline ByHand<3, 3, 1> particle_on_turntable(double alpha, double f, double f_static, double weight = g) {
  return {{ContactRule{.tangents = 2, .friction = f, .static_friction = f_static}},
          [=](double t, const auto& y, auto& r) {
            const double turns = alpha * t;
            r.M.setIdentity();
            r.F << 0, 0, -weight;
            r.gap[0] = y[2];
            r.J << 0, 0, 1, 1, 0, 0, 0, 1, 0;
            r.w << y[5], y[3] + turns * y[1], y[4] - turns * y[0];
            r.drift << 0, alpha * y[1] + turns * y[4], -alpha * y[0] - turns * y[3];
          }};
}

/// A ball on a table in space: q = place of its centre, v = (V, W). The contact's three rows come first.
inline void fill_billiard_ball(double m, double R, const std::array<double, 9>& y, ContactReading& r) {
  r.M.setIdentity();
  r.M *= m;
  for (int i = 3; i < 6; ++i) r.M(i, i) = 0.4 * m * R * R;
  r.F << 0, 0, -m * g, 0, 0, 0;
  r.gap[0] = y[2] - R;
  r.J.setZero();
  r.J(0, 2) = r.J(1, 0) = r.J(2, 1) = 1;
  r.J(1, 4) = -R;
  r.J(2, 3) = R;
  r.w.head(3) << y[5], y[3] - R * y[7], y[4] + R * y[6];
  r.drift.setZero();
}
inline ByHand<3, 6, 1> billiard_ball(double m, double R, double f, double e) {
  return {{ContactRule{.tangents = 2, .friction = f, .restitution = e}},
          [=](double, const auto& y, auto& r) { fill_billiard_ball(m, R, y, r); }};
}

/// The same ball, of which the table resists the rolling by h N and the spinning by k N.
inline ByHand<3, 6, 3> ball_on_soft_table(double m, double R, double f, double e, double h, double k) {
  return {{ContactRule{.tangents = 2, .friction = f, .restitution = e},
           ContactRule{.tangents = 2, .normal = false, .pressed_by = 0, .friction = h},
           ContactRule{.tangents = 1, .normal = false, .pressed_by = 0, .friction = k}},
          [=](double, const auto& y, auto& r) {
            fill_billiard_ball(m, R, y, r);
            r.J(3, 3) = r.J(4, 4) = r.J(5, 5) = 1;
            r.w.tail(3) << y[6], y[7], y[8];
          }};
}

/// A disc of mass 1 on a slope, x down it, that resists its rolling by h N: q = (x, z, φ), φ' > 0 rolls down.
inline ByHand<3, 3, 2> disc_on_soft_slope(double slope, double f, double R, double h) {
  return {{ContactRule{.tangents = 1, .friction = f}, ContactRule{.tangents = 1, .normal = false, .pressed_by = 0, .friction = h}},
          [=](double, const auto& y, auto& r) {
            r.M.setIdentity();
            r.M(2, 2) = 0.5 * R * R;
            r.F << g * std::sin(slope), -g * std::cos(slope), 0;
            r.gap[0] = y[1] - R;
            r.J << 0, 1, 0, 1, 0, -R, 0, 0, 1;
            r.w << y[4], y[3] - R * y[5], y[5];
            r.drift.setZero();
          }};
}

/// A pendulum of length and mass 1, q = θ from the downward vertical, with a stop sign (θ - at) >= 0.
inline ByHand<1, 1, 1> pendulum_with_stop(double at, double sign, double e) {
  return {{ContactRule{.tangents = 0, .restitution = e}}, [=](double, const auto& y, auto& r) {
            r.M(0, 0) = 1;
            r.F(0) = -g * std::sin(y[0]);
            r.gap[0] = sign * (y[0] - at);
            r.J(0, 0) = sign;
            r.w(0) = sign * y[1];
            r.drift(0) = 0;
          }};
}

/// The same pendulum without a stop, with a torque of dry friction in its joint.
inline ByHand<1, 1, 1> pendulum_with_friction(double torque) {
  return {{ContactRule{.tangents = 1, .normal = false, .bound = torque}}, [](double, const auto& y, auto& r) {
            r.M(0, 0) = 1;
            r.F(0) = -g * std::sin(y[0]);
            r.J(0, 0) = 1;
            r.w(0) = y[1];
            r.drift(0) = 0;
          }};
}

/// The same pendulum, whose journal rubs by h |R|, R its reaction along the rod and across; a torque A cos(3 t) may drive it.
inline ByHand<1, 1, 1> pendulum_in_a_journal(double h, double A = 0) {
  return {{ContactRule{.tangents = 1, .normal = false, .bearing = 2, .friction = h}}, [A](double t, const auto& y, auto& r) {
            r.M(0, 0) = 1;
            r.F(0) = A * std::cos(3 * t) - g * std::sin(y[0]);
            r.J(0, 0) = 1;
            r.w(0) = y[1];
            r.drift(0) = 0;
            r.B << 0, 1;
            r.C.setZero();
            r.R0 << y[1] * y[1] + g * std::cos(y[0]), g * std::sin(y[0]);
          }};
}

/// A block on a moving belt, held by a spring: q = x; the normal force N presses it.
inline ByHand<1, 1, 1> block_on_belt(double m, double k, double speed, double N, double f_static, double f,
                                     double push = 0) {
  return {{ContactRule{.tangents = 1, .normal = false, .bound = f * N, .static_bound = f_static * N}},
          [=](double, const auto& y, auto& r) {
            r.M(0, 0) = m;
            r.F(0) = push - k * y[0];
            r.J(0, 0) = 1;
            r.w(0) = y[1] - speed;
            r.drift(0) = 0;
          }};
}

/// A disc of mass 1 and radius R on a smooth floor, seen along the diameter that it turns about: q = (z, β). Its lowest point
/// jumps to the other side where it lies flat.
inline ByHand<2, 2, 1> leaning_disc(double R) {
  return {{ContactRule{.tangents = 0}}, [R](double, const auto& y, auto& r) {
            const double s = std::sin(y[1]), c = std::cos(y[1]), side = s < 0 ? -1 : 1;
            r.M << 1, 0, 0, R * R / 4;
            r.F << -g, 0;
            r.gap[0] = y[0] - side * R * s;
            r.J << 1, -side * R * c;
            r.w << y[2] - side * R * c * y[3];
            r.drift << side * R * s * y[3] * y[3];
          }};
}

/// A particle of mass 1 that slides within a smooth circle of radius R, z upward from its centre: q = (x, z).
inline ByHand<2, 2, 1> particle_in_circle(double R) {
  return {{ContactRule{.tangents = 0}}, [R](double, const auto& y, auto& r) {
            const double length = std::hypot(y[0], y[1]), x = y[0] / length, z = y[1] / length;
            const double across = (x * y[3] - z * y[2]);
            r.M.setIdentity();
            r.F << 0, -g;
            r.gap[0] = R - length;
            r.J << -x, -z;
            r.w << -x * y[2] - z * y[3];
            r.drift << -across * across / length;
          }};
}

/// A block that slides on a level plane: q = (x, y), its weight the normal force.
inline ByHand<3, 3, 1> block_on_plane(double f) {
  return {{ContactRule{.tangents = 2, .friction = f}}, [](double, const auto& y, auto& r) {
            r.M.setIdentity();
            r.F << 0, 0, -g;
            r.gap[0] = y[2];
            r.J << 0, 0, 1, 1, 0, 0, 0, 1, 0;
            r.w << y[5], y[3], y[4];
            r.drift.setZero();
          }};
}

/// A rod of 1 kg and 2 m that stands on its rough foot and falls over: q = (x, z, φ), φ from upright.
inline ByHand<3, 3, 1> rod_on_its_foot() {
  return {{ContactRule{.tangents = 1, .friction = 2}}, [](double, const auto& y, auto& r) {
            const double c = std::cos(y[2]), s = std::sin(y[2]);
            r.M.setIdentity();
            r.M(2, 2) = 1.0 / 3;
            r.F << 0, -g, 0;
            r.gap[0] = y[1] - c;
            r.J << 0, 1, s, 1, 0, -c;
            r.w << y[4] + s * y[5], y[3] - c * y[5];
            r.drift << c * y[5] * y[5], s * y[5] * y[5];
          }};
}

}  // namespace simple_systems
