// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "tests/contacts/simple_systems.hpp"

// Slips that begin from sticking in space, and those that end or turn round there.
namespace slip_onset_test {
namespace {

using namespace simple_systems;

constexpr DormandPrince853 precise{.relative_tolerance = 1e-13, .absolute_tolerance = 1e-13};

struct Told {
  ContactEventKind kind;
  double time;
};

struct Log {
  std::vector<Told>& events;
  bool operator()(const ContactEvent& e) const {
    events.push_back({e.kind, e.time});
    return true;
  }
};

template <class S, std::size_t size>
std::vector<Told> move(const S& system, std::array<double, size>& y, double from, double to) {
  std::vector<Told> events;
  const auto result = integrate_contacts(system, y, from, to, precise, {}, Log{events});
  EXPECT_TRUE(result) << describe(result.status) << " at " << result.time << ": " << describe(result.integration_event)
                      << ", " << describe(result.integration.status);
  EXPECT_LE(result.worst_residual, 1e-13);
  return events;
}

/// The same motion by other means: the contact slides from a small slip on, whose direction is w_T/|w_T| at all times.
/// These equations are the stiffer the smaller the slip.
template <class S, std::size_t size>
std::array<double, size> slide_from(const S& system, std::array<double, size> y, const std::array<double, 3>& slip,
                                    double from, double to) {
  ContactReading r({static_cast<int>(S::nq), static_cast<int>(S::nv), 1, 0}, 3);
  const auto slides = [&](double t, const std::array<double, size>& at, std::array<double, size>& dydt) {
    const Evaluation evaluation = system.read(t, at, r);
    const Eigen::Vector3d pull(1, -system.rule(0).friction * r.w(1) / std::hypot(r.w(1), r.w(2)),
                               -system.rule(0).friction * r.w(2) / std::hypot(r.w(1), r.w(2)));
    // The masses of all systems here are diagonal.
    const Eigen::Matrix<double, static_cast<int>(S::nv), 1> free = r.F.cwiseQuotient(r.M.diagonal()),
                                                            pulled =
                                                                (r.J.transpose() * pull).cwiseQuotient(r.M.diagonal());
    const double N = -(r.J.row(0).dot(free) + r.drift(0)) / r.J.row(0).dot(pulled);
    std::array<double, S::nq> rates{};
    system.coordinate_rates(t, at, rates);
    for (std::size_t i = 0; i < S::nq; ++i) dydt[i] = rates[i];
    for (std::size_t i = 0; i < S::nv; ++i) {
      dydt[S::nq + i] = free(static_cast<Eigen::Index>(i)) + N * pulled(static_cast<Eigen::Index>(i));
    }
    return evaluation;
  };
  for (std::size_t i = 0; i < 3; ++i) y[S::nq + i] += slip[i];
  EXPECT_TRUE(integrate(slides, y, from, to, precise));
  return y;
}

/// From a slip that tends to zero: the velocity that is added counts to first order.
template <class S, std::size_t size>
std::array<double, size> slide_on(const S& system, const std::array<double, size>& y, const std::array<double, 3>& d,
                                  double from, double to) {
  const auto once = [&](double s) { return slide_from(system, y, {s * d[0], s * d[1], s * d[2]}, from, to); };
  auto limit = once(1e-7);
  const auto twice = once(2e-7);
  for (std::size_t i = 0; i < size; ++i) limit[i] += limit[i] - twice[i];
  return limit;
}

// It sticks until r sqrt(α² + Ω⁴) = f g; the slip then begins along -T, without acceleration.
TEST(SlipOnset, OfAParticleOnATurntableTurnsWithItsAcceleration) {
  constexpr double alpha = 0.5, f = 0.3;
  const double onset = std::pow((f * f * g * g - alpha * alpha) / std::pow(alpha, 4), 0.25);
  const auto system = particle_on_turntable(alpha, f, f);
  std::array<double, 6> y{1, 0, 0, 0, 0, 0};
  const auto events = move(system, y, 0, 4);
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].kind, ContactEventKind::slips);
  EXPECT_NEAR(events[0].time, onset, 1e-12);
  const double angle = alpha * onset * onset / 2, turns = alpha * onset;
  const double c = std::cos(angle), s = std::sin(angle), out = turns * turns / (f * g), back = alpha / (f * g);
  const std::array<double, 3> slip{(out * c + back * s), (out * s - back * c), 0};
  const auto other = slide_on(system, std::array<double, 6>{c, s, 0, -turns * s, turns * c, 0}, slip, onset, 4);
  // What is of second order in 1e-7 m/s, over a slip that counts, some 1e-3 m/s.
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(y[i], other[i], 2e-10) << i;
}

// With f_s > f it goes with a jump of the acceleration, against T: the particle has no other mass.
TEST(SlipOnset, WithLessFrictionThanBeforeBeginsAtOnce) {
  constexpr double alpha = 0.5, f = 0.3;
  for (const double f_static : {0.301, 0.45}) {
    const auto system = particle_on_turntable(alpha, f, f_static);
    const double onset = std::pow((f_static * f_static * g * g - alpha * alpha) / std::pow(alpha, 4), 0.25);
    std::array<double, 6> y{1, 0, 0, 0, 0, 0};
    const auto events = move(system, y, 0, onset + 0.3);
    ASSERT_EQ(events.size(), 1U);
    EXPECT_NEAR(events[0].time, onset, 1e-12);
    const double angle = alpha * onset * onset / 2, turns = alpha * onset;
    const double c = std::cos(angle), s = std::sin(angle);
    const double out = turns * turns / (f_static * g), back = alpha / (f_static * g);
    const std::array<double, 3> slip{(out * c + back * s), (out * s - back * c), 0};
    const auto other =
        slide_on(system, std::array<double, 6>{c, s, 0, -turns * s, turns * c, 0}, slip, onset, onset + 0.3);
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(y[i], other[i], 2e-10) << f_static << ' ' << i;
  }
}

/// A thin disk on a level plane: q = (x, y, z, ψ, θ, φ), Euler's angles about z, x1, z2; v = (V, ω along x1, y2, z2).
struct Disk {
  static constexpr std::size_t nq = 6, nv = 6, contacts = 1;
  using State = std::array<double, 12>;
  double rho, f, f_static;

  [[nodiscard]] ContactRule rule(int) const { return {.tangents = 2, .friction = f, .static_friction = f_static}; }
  void coordinate_rates(double, const State& y, std::array<double, 6>& rates) const {
    const double turning = y[10] / std::sin(y[4]);
    rates = {y[6], y[7], y[8], turning, y[9], y[11] - turning * std::cos(y[4])};
  }
  [[nodiscard]] Evaluation read(double, const State& y, ContactReading& r) const {
    const double A = rho * rho / 4, C = rho * rho / 2;
    const double c = std::cos(y[3]), s = std::sin(y[3]), ct = std::cos(y[4]), st = std::sin(y[4]);
    const double w1 = y[9], w2 = y[10], w3 = y[11], turning = w2 / st, W3 = turning * ct;
    r.M.setIdentity();
    r.M(3, 3) = r.M(4, 4) = A;
    r.M(5, 5) = C;
    r.F << 0, 0, -g, W3 * A * w2 - w2 * C * w3, w1 * C * w3 - W3 * A * w1, 0;
    r.gap[0] = y[2] - rho * st;
    const double along = y[6] * c + y[7] * s, across = -y[6] * s + y[7] * c;
    r.J << 0, 0, 1, -rho * ct, 0, 0, c, s, 0, 0, 0, rho, -s, c, 0, rho * st, 0, 0;
    r.w << y[8] - rho * ct * w1, along + rho * w3, across + rho * st * w1;
    r.drift << rho * st * w1 * w1, across * turning, -along * turning + rho * ct * w1 * w1;
    return Evaluation::ok;
  }
  [[nodiscard]] double energy(const State& y) const {
    const double A = rho * rho / 4, C = rho * rho / 2;
    return (y[6] * y[6] + y[7] * y[7] + y[8] * y[8] + A * (y[9] * y[9] + y[10] * y[10]) + C * y[11] * y[11]) / 2 +
           g * y[2];
  }
  /// It rolls while its centre goes round a circle of radius R at the height h (Pommier, 8.3.2 exercise 2).
  [[nodiscard]] State rolling(double R, double h) const {
    const double d = std::sqrt(rho * rho - h * h), turning = std::sqrt(4 * g * d / (h * (6 * R + d)));
    const double spin = -turning * (R + d) / rho;
    return {0, -R, h, 0, std::asin(h / rho), 0, R * turning, 0, 0, 0, turning * h / rho, spin + turning * d / rho};
  }
};

// f* = R ψ'²/g: with more the disk rolls on for ever, with any less it slips from the first instant on.
TEST(SlipOnset, OfADiskInACircleComesWithTooLittleFriction) {
  for (const double share : {1.001, 0.999, 0.4}) {
    Disk disk{2, 0, 0};
    const auto start = disk.rolling(10, 1);
    const double turning = start[10] * 2;
    disk.f = disk.f_static = share * 10 * turning * turning / g;
    auto y = start;
    EXPECT_EQ(move(disk, y, 0, 0.7).size(), 0U);
    if (share > 1) {
      EXPECT_NEAR(disk.energy(y), disk.energy(start), 1e-11);
      continue;
    }
    // At first it slips outwards, against the friction that would hold it on its circle.
    const auto other = slide_on(disk, start, std::array<double, 3>{0, -1, 0}, 0, 0.7);
    for (std::size_t i = 0; i < 12; ++i) EXPECT_NEAR(y[i], other[i], 1e-9) << share << ' ' << i;
  }
}

/// A block on a slope, x down it: q = (x, y, z), z normal to it.
ByHand<3, 3, 1> block_on_slope(double slope, double f) {
  auto system = block_on_plane(f);
  system.fill = [slope, fill = system.fill](double t, const auto& y, auto& r) {
    fill(t, y, r);
    r.F << g * std::sin(slope), 0, -g * std::cos(slope);
  };
  return system;
}

// Thrown up a slope steeper than friction holds, a little off the line of descent: the slip nearly ends, and its
// direction turns round within that time. Exactly along the line it does end, and begins again downwards. With θ
// the angle from the line of descent, ds = (weight cos θ - friction) dt and s dθ = -weight sin θ dt, so that
// s/(k^(friction/weight - 1) (1 + k²)) with k = tan(θ/2) does not change.
TEST(SlipOnset, IsNotSeenWhereASlipPassesZeroAtADistance) {
  constexpr double slope = 0.6, f = 0.3, up = 2;
  const double weight = g * std::sin(slope), friction = f * g * std::cos(slope);
  for (const double aside : {1e-2, 1e-4, 1e-6}) {
    std::array<double, 6> y{0, 0, 0, -up, aside, 0};
    const auto system = block_on_slope(slope, f);
    EXPECT_EQ(move(system, y, 0, 1).size(), 0U) << aside;
    const auto kept = [&](double vy_over, double speed) {
      return speed / (std::pow(vy_over, friction / weight - 1) * (1 + vy_over * vy_over));
    };
    const double s_before = std::hypot(up, aside), s = std::hypot(y[3], y[4]);
    const double before = kept((s_before + up) / aside, s_before), after = kept(y[4] / (s + y[3]), s);
    // Some twenty steps of 1e-13 m/s each, over the least slip of aside^1.44/2.
    EXPECT_NEAR(after / before, 1, 4e-12 / std::pow(aside, 1.44)) << aside;
    // Down it goes as one that was thrown along the line of descent.
    const double turned = up / (weight + friction);
    EXPECT_NEAR(y[3], (weight - friction) * (1 - turned), 10 * aside);
  }
  std::array<double, 6> y{0, 0, 0, -up, 0, 0};
  const auto events = move(block_on_slope(slope, f), y, 0, 1);
  ASSERT_EQ(events.size(), 1U);
  EXPECT_NEAR(events[0].time, up / (weight + friction), 1e-13);
  EXPECT_NEAR(y[3], (weight - friction) * (1 - events[0].time), 1e-12);
}

/// A particle on a level plane, drawn to the origin by a spring of 1 N/m: q = (x, y, z).
ByHand<3, 3, 1> particle_on_spring(double f) {
  return {{ContactRule{.tangents = 2, .friction = f}}, [](double, const auto& y, auto& r) {
            r.M.setIdentity();
            r.F << -y[0], -y[1], -g;
            r.gap[0] = y[2];
            r.J << 0, 0, 1, 1, 0, 0, 0, 1, 0;
            r.w << y[5], y[3], y[4];
            r.drift.setZero();
          }};
}

// On a flat ellipse the slip turns by almost half a turn within one step, and passes zero at the distance b.
TEST(SlipOnset, IsNoneWhereASlipTurnsRoundWithinAStep) {
  for (const double b : {0.5, 1e-2, 1e-4}) {
    std::array<double, 6> y{1, 0, 0, 0, b, 0};
    const auto events = move(particle_on_spring(0), y, 0, 20);
    EXPECT_TRUE(events.empty()) << b;
    EXPECT_NEAR(y[0], std::cos(20.0), 1e-11) << b;
    EXPECT_NEAR(y[1], b * std::sin(20.0), 1e-11) << b;
    for (const double f : {1e-8, 1e-4, 1e-3}) {
      const auto rubbed = particle_on_spring(f);
      std::array<double, 6> start{1, 0, 0, 0, b, 0}, slides = start;
      EXPECT_TRUE(move(rubbed, slides, 0, 3).empty() || b < 0.1) << b << ' ' << f;
      const auto exact = slide_from(rubbed, start, {}, 0, 3);
      for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(slides[i], exact[i], 1e-10) << b << ' ' << f << ' ' << i;
    }
  }
}

// Where the slope holds it, a block thrown in any direction comes to rest on it and stays.
TEST(SlipOnset, DoesNotFollowWhereASlopeHolds) {
  for (const double angle : {0.4, 3.1}) {
    for (const double f : {0.31, 0.6}) {
      std::array<double, 6> y{0, 0, 0, 2 * std::cos(angle), 2 * std::sin(angle), 0};
      const auto events = move(block_on_slope(0.3, f), y, 0, 500);
      ASSERT_EQ(events.size(), 1U) << angle << ' ' << f;
      EXPECT_EQ(events[0].kind, ContactEventKind::slip_ends);
      EXPECT_EQ(std::hypot(y[3], y[4]), 0.0);
    }
  }
}

}  // namespace
}  // namespace slip_onset_test
