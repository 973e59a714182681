// SPDX-License-Identifier: GPL-3.0-or-later
// The same motions with all lengths a thousand times as short and as long: g stays, times grow with the root of lengths.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "torsor/runtime/contacts/integrate_contacts.hpp"
#include "torsor/runtime/contacts/moreau_jean.hpp"
#include "tests/contacts/random_scenes.hpp"
#include "tests/contacts/simple_systems.hpp"

namespace scaled_motions_test {
namespace {

using namespace random_scenes;
using State = RandomScene::State;

Start scaled(const Start& usual, double scale) {
  Start other = usual;
  for (Body& body : other.scene.bodies) {
    body.there *= scale;
    body.here *= scale;
    body.inertia *= scale * scale;
  }
  for (Disc& disc : other.scene.discs) {
    disc.centre *= scale;
    disc.radius *= scale;
  }
  for (Wall& wall : other.scene.walls) wall.at *= scale;
  for (Pin& pin : other.scene.pins) {
    pin.on_a *= scale;
    pin.on_b *= scale;
  }
  std::size_t next = 0;
  const double speeds = std::sqrt(scale);
  for (const Body& body : usual.scene.bodies) {
    for (int k = 0; k < (body.base == Body::Base::free ? 2 : 0); ++k, ++next) {
      other.y[next] *= scale;
      other.y[RandomScene::nq + next] *= speeds;
    }
    other.y[RandomScene::nq + next++] /= speeds;
  }
  return other;
}

struct Happened {
  ContactEventKind kind;
  int contact;
  double time;
  std::string regimes;
};

std::vector<Happened> happens(Start start, double scale, ContactStatus& status) {
  // Lengths, speeds and angular velocities have one absolute tolerance: the least of theirs.
  const DormandPrince853 method{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12 * std::min(scale, 1 / std::sqrt(scale))};
  const double times = std::sqrt(scale);
  std::vector<Happened> all;
  const auto note = [&](const ContactEvent& event) {
    std::string regimes;
    for (const ContactState& state : event.contacts) regimes += std::to_string(static_cast<int>(state.regime));
    all.push_back({event.kind, event.contact, event.time / times, regimes});
    return true;
  };
  status = integrate_contacts(start.scene, start.y, 0, times, method, {.touch = 1e-10 * scale, .at_rest = 1e-10 * times}, note).status;
  return all;
}

// Times agree within what errors of 1e-12 become by some ten impacts.
TEST(ScaledMotions, HaveTheSameEventsAndRegimes) {
  std::size_t compared = 0;
  for (unsigned k = 0; k < 12; ++k) {
    const Start start = random_start(k);
    ContactStatus usual_status{}, status{};
    const std::vector<Happened> usual = happens(start, 1, usual_status);
    for (const double scale : {1e-3, 1e3}) {
      SCOPED_TRACE(testing::Message() << "scene " << k << ", lengths " << scale);
      const std::vector<Happened> other = happens(scaled(start, scale), scale, status);
      EXPECT_EQ(status, usual_status);
      ASSERT_EQ(other.size(), usual.size());
      for (std::size_t i = 0; i < usual.size(); ++i) {
        EXPECT_EQ(other[i].kind, usual[i].kind);
        EXPECT_EQ(other[i].contact, usual[i].contact);
        EXPECT_EQ(other[i].regimes, usual[i].regimes);
        EXPECT_NEAR(other[i].time, usual[i].time, 1e-8);
        ++compared;
      }
    }
  }
  EXPECT_GE(compared, 40U);
}

/// A scene in other units of length and mass. All numbers are multiplied by powers of two, so that nothing is rounded otherwise.
Start in_units(const Start& usual, double length, double mass) {
  Start other = scaled(usual, length);
  other.scene.g *= length;
  for (Body& body : other.scene.bodies) {
    body.mass *= mass;
    body.inertia *= mass;
  }
  std::size_t next = RandomScene::nq;
  for (const Body& body : usual.scene.bodies) {
    for (int k = 0; k < (body.base == Body::Base::free ? 2 : 0); ++k, ++next) other.y[next] = usual.y[next] * length;
    other.y[next] = usual.y[next];
    ++next;
  }
  return other;
}

// To the last bit: no number of the scheme has a unit.
TEST(ScaledMotions, MoveByStepsAlikeInAllUnits) {
  for (unsigned k = 0; k < 12; ++k) {
    const Start start = random_start(k);
    State usual = start.y;
    const ContactStatus status = step_contacts(start.scene, usual, 0, 1, {.count = 500});
    for (const double length : {0x1p-30, 0x1p-10, 0x1p10}) {
      for (const double mass : {0x1p-20, 0x1p20}) {
        SCOPED_TRACE(testing::Message() << "scene " << k << ", lengths " << length << ", masses " << mass);
        Start other = in_units(start, length, mass);
        EXPECT_EQ(step_contacts(other.scene, other.y, 0, 1, {.count = 500}), status);
        EXPECT_EQ(other.y, in_units({start.scene, usual}, length, mass).y);
      }
    }
  }
}

// From event to event times and angles have tolerances, but masses have none.
TEST(ScaledMotions, MoveFromEventToEventAlikeInAllUnitsOfMass) {
  for (unsigned k = 0; k < 12; ++k) {
    const Start start = random_start(k);
    ContactStatus usual_status{}, status{};
    const std::vector<Happened> usual = happens(start, 1, usual_status);
    for (const double mass : {0x1p-20, 0x1p20}) {
      SCOPED_TRACE(testing::Message() << "scene " << k << ", masses " << mass);
      const std::vector<Happened> other = happens(in_units(start, 1, mass), 1, status);
      EXPECT_EQ(status, usual_status);
      ASSERT_EQ(other.size(), usual.size());
      for (std::size_t i = 0; i < usual.size(); ++i) EXPECT_EQ(other[i].time, usual[i].time);
    }
  }
}

// Painlevé's rod, of any half-length L, jams where tan θ = 3 - sqrt 5: what is left of a determinant without a unit decides.
TEST(ScaledMotions, JamAtTheSameAngle) {
  for (const double L : {1e-3, 1.0, 1e3}) {
    SCOPED_TRACE(L);
    const simple_systems::ByHand<3, 3, 1> rod{
        {ContactRule{.tangents = 1, .friction = 2}}, [L](double, const auto& y, auto& r) {
          const double c = L * std::cos(y[2]), s = L * std::sin(y[2]), turning = y[5];
          r.M.setIdentity();
          r.M(2, 2) = L * L / 3;
          r.F << 0, -simple_systems::g, 0;
          r.gap[0] = y[1] - s;
          r.J << 0, 1, -c, 1, 0, s;
          r.w << y[4] - c * turning, y[3] + s * turning;
          r.drift << s * turning * turning, c * turning * turning;
        }};
    const double speed = std::sqrt(L), start = 0.5, turning = 2 / speed, s = L * std::sin(start), c = L * std::cos(start);
    std::array<double, 6> y{0, s, start, -10 * speed - s * turning, c * turning, turning};
    const DormandPrince853 method{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-15};
    const auto result = integrate_contacts(rod, y, 0, 2 * speed, method);
    EXPECT_EQ(result.status, ContactStatus::jams);
    const double left = std::atan(3 - std::sqrt(5.0)) - y[2];
    EXPECT_GT(left, 0);
    EXPECT_LT(left, 1e-8);  // the determinant falls with θ at a rate above 1.5
  }
}

// A particle on a turntable that is spun up, Ω = α t, sticks until r sqrt(α² + Ω⁴) = f g, and slips with f <= f_s from then on: in
// units of length and time from a micrometre and a microsecond to their inverses. Numbers are the same but for powers of two.
TEST(ScaledMotions, BeginToSlipAlikeInAllUnitsOfLengthAndTime) {
  constexpr double f = 0.3;
  for (const double f_static : {0.3, 0.45}) {
    std::array<double, 6> usual{};
    for (const double length : {1.0, 0x1p-20, 0x1p20}) {
      for (const double time : {1.0, 0x1p-20, 0x1p20}) {
        SCOPED_TRACE(testing::Message() << "f_s " << f_static << ", lengths " << length << ", times " << time);
        const double alpha = 0.5 / (time * time), weight = simple_systems::g * length / (time * time);
        const auto particle = simple_systems::particle_on_turntable(alpha, f, f_static, weight);
        const double speed = length / time;
        const DormandPrince853 method{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12 * std::min(length, speed)};
        std::array<double, 6> y{length, 0, 0, 0, 0, 0};
        double slips = 0;
        const auto note = [&slips](const ContactEvent& event) {
          slips = event.time;
          return true;
        };
        const auto result = integrate_contacts(particle, y, 0, 5 * time, method, {.touch = 1e-10 * length, .at_rest = 1e-10 * speed}, note);
        EXPECT_TRUE(result) << describe(result.status);
        EXPECT_EQ(result.events, 1);
        EXPECT_NEAR(slips / time, std::pow((f_static * f_static * simple_systems::g * simple_systems::g - 0.25) / 0.0625, 0.25), 1e-11);
        for (std::size_t i = 0; i < 6; ++i) y[i] /= i < 3 ? length : speed;
        if (length == 1 && time == 1) usual = y;
        for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(y[i], usual[i], 1e-10) << i;
      }
    }
  }
}

}  // namespace
}  // namespace scaled_motions_test
