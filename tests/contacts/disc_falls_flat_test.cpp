// SPDX-License-Identifier: GPL-3.0-or-later
// A thin disc that leans on its rim and falls flat: its lowest point jumps to the other side there.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstddef>

#include "tests/contacts/simple_systems.hpp"

namespace disc_falls_flat_test {
namespace {

using namespace simple_systems;

constexpr double R = 0.1, I = R * R / 4;

// Energy says how fast it turns when it is flat: (I + R^2 cos^2 β) β'^2/2 = g R (sin β0 - sin β). It went on flat without
// an end, as if the impact of the other side were a part of a step.
TEST(DiscFallsFlat, HasNoPointThere) {
  for (const double tolerance : {1e-1, 1e-3, 1e-6, 1e-10, 1e-13}) {
    for (const double start : {0.02, 0.3, 0.8}) {
      std::array<double, 4> y{R * std::sin(start), start, 0, 0};
      const DormandPrince853 method{.relative_tolerance = tolerance, .absolute_tolerance = tolerance};
      ContactOptions options;
      const auto steps = [n = 0](const double&, const auto&) mutable { return ++n < 10000; };
      const ContactResult result = integrate_contacts(leaning_disc(R), y, 0, 1, method, options, steps);
      EXPECT_EQ(result.status, ContactStatus::no_point) << tolerance << " " << start << ": " << describe(result.status);
      EXPECT_EQ(result.contact, 0);
      EXPECT_NEAR(y[1], 0, 100 * tolerance);
      EXPECT_NEAR(y[3], -std::sqrt(2 * g * R * std::sin(start) / (I + R * R)), 1000 * tolerance + 1e-10);
    }
  }
}

/// A thin disc of mass 1 in space on a table that resists its rolling by h N: q = place of its centre, quaternion; v =
/// (V, W) in ground axes. No difference of numbers near 1 is taken, however flat it lies.
struct Coin {
  static constexpr std::size_t nq = 7, nv = 6, contacts = 2;
  using State = std::array<double, nq + nv>;
  using Vector = Eigen::Vector3d;

  double friction, h;

  [[nodiscard]] ContactRule rule(int i) const {
    if (i == 0) return {.tangents = 2, .friction = friction};
    return {.tangents = 2, .normal = false, .pressed_by = 0, .friction = h};
  }
  void normalise(State& y) const {
    const double length = std::hypot(std::hypot(y[3], y[4]), std::hypot(y[5], y[6]));
    for (std::size_t i = 3; i < 7; ++i) y[i] /= length;
  }
  void coordinate_rates(double, const State& y, std::array<double, nq>& rates) const {
    for (std::size_t i = 0; i < 3; ++i) rates[i] = y[7 + i];
    const double a = y[10], b = y[11], c = y[12];
    rates[3] = (-a * y[4] - b * y[5] - c * y[6]) / 2;
    rates[4] = (a * y[3] + b * y[6] - c * y[5]) / 2;
    rates[5] = (b * y[3] + c * y[4] - a * y[6]) / 2;
    rates[6] = (c * y[3] + a * y[5] - b * y[4]) / 2;
  }
  /// The part along the ground of the axis: sin of the lean, in the direction in which the lowest point lies.
  [[nodiscard]] static Vector leans(const State& y) {
    return {2 * (y[4] * y[6] + y[3] * y[5]), 2 * (y[5] * y[6] - y[3] * y[4]), 0};
  }
  [[nodiscard]] Evaluation read(double, const State& y, ContactReading& r) const {
    const Vector up = Vector::UnitZ(), level = leans(y), V(y[7], y[8], y[9]), W(y[10], y[11], y[12]);
    const double s = level.norm(), c = y[3] * y[3] - y[4] * y[4] - y[5] * y[5] + y[6] * y[6];
    const Vector axis = level + c * up, axis_rate = W.cross(axis), to = level / s;
    const Eigen::Matrix3d inertia = I * (Eigen::Matrix3d::Identity() + axis * axis.transpose());
    r.M.setIdentity();
    r.M.block<3, 3>(3, 3) = inertia;
    const Vector gyroscopic = W.cross(Vector(inertia * W));
    r.F << 0, 0, -g, -gyroscopic;
    const double s_rate = to.dot(axis_rate);
    const Vector level_rate(axis_rate.x(), axis_rate.y(), 0), to_rate = (level_rate - s_rate * to) / s;
    const Vector p = R * (c * to - s * up), p_rate = R * (axis_rate.z() * to + c * to_rate - s_rate * up);
    r.gap[0] = y[2] - R * s;
    r.J.setZero();
    r.drift.setZero();
    for (int row = 0; row < 3; ++row) {
      const Vector along = Vector::Unit((row + 2) % 3);
      r.J.block<1, 3>(row, 0) = along.transpose();
      r.J.block<1, 3>(row, 3) = p.cross(along).transpose();
      r.w(row) = along.dot(V + W.cross(p));
      r.drift(row) = along.dot(W.cross(p_rate));
    }
    r.J(3, 3) = r.J(4, 4) = 1;
    r.w.tail(2) << W.x(), W.y();
    return Evaluation::ok;
  }
};

// A coin that rolls on its rim about its centre (Euler's disc) turns by Ω² = 4 g/(R sin α) and has the energy 3/2 g R
// sin α. Its moment h g takes h g Ω sin α of it, so that sqrt α falls to zero evenly, in 3 R/h sqrt(α R/(4 g)), to
// first order in α and h/R. There Ω is endless: the motion ended with `integration_failed`.
TEST(DiscFallsFlat, HasNoPointWhereACoinHasSpunUntilItLiesFlat) {
  constexpr double start = 0.01;
  const double omega = std::sqrt(4 * g / (R * std::sin(start)));
  Coin::State y{0,
                0,
                R * std::sin(start),
                std::cos(start / 2),
                0,
                std::sin(start / 2),
                0,
                0,
                0,
                0,
                omega * std::sin(start) * std::cos(start),
                0,
                -omega * std::sin(start) * std::sin(start)};
  const DormandPrince853 method{.relative_tolerance = 1e-6, .absolute_tolerance = 1e-6};
  const ContactResult result = integrate_contacts(Coin{.friction = 1000, .h = 0.1 * R}, y, 0, 1, method);
  EXPECT_EQ(result.status, ContactStatus::no_point) << describe(result.status);
  EXPECT_EQ(result.contact, 0);
  const double ends = 30 * std::sqrt(start * R / (4 * g));
  EXPECT_NEAR(result.time, ends, 0.01 * ends);
  EXPECT_LT(Coin::leans(y).norm(), 1e-5);
}

}  // namespace
}  // namespace disc_falls_flat_test
