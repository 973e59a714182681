// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/runtime/contacts/contact_exchange.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "tests/contacts/simple_systems.hpp"

// Motions that somebody else integrates: by steps of Runge and Kutta, whose events are found by bisection.
namespace contact_exchange_test {
namespace {

using namespace simple_systems;

constexpr double tolerance = 1e-12;

template <class S>
class Importer {
 public:
  using State = typename S::State;

  Importer(const S& system, const State& start, double t = 0, double of_unit = tolerance)
      : mechanism_(system), unit_(mechanism_, {}, of_unit), t_(t), y_(start) {
    began_ = unit_.start(t_, y_);
  }

  /// Whether the motion went on to this time; an event is told to the unit `late` seconds after it has happened. Steps have
  /// four stages or one.
  bool move(double to, double h, double late = 0, int stages = 4) {
    if (!began_) return false;
    stages_ = stages;
    while (t_ < to) {
      const double step = std::min(h, to - t_);
      double after = step;
      const bool event = fallen(stepped(step));
      if (event) {
        double before = 0;
        for (int i = 0; i < 80; ++i) {
          const double middle = 0.5 * (before + after);
          (fallen(stepped(middle)) ? after : before) = middle;
        }
        events_.push_back(t_ + after);
        after += late;
      }
      before_ = y_;
      y_ = stepped(after);
      t_ = after == step ? t_ + step : t_ + after;
      if (unit_.complete(t_, y_) != Evaluation::ok) return false;
      if (event && !unit_.update(t_, y_)) return false;
    }
    return true;
  }

  [[nodiscard]] bool began() const { return began_; }
  [[nodiscard]] double time() const { return t_; }
  [[nodiscard]] State& state() { return y_; }
  /// The state from which the last step went.
  [[nodiscard]] const State& before() const { return before_; }
  [[nodiscard]] ContactExchange& unit() { return unit_; }
  [[nodiscard]] const std::vector<double>& events() const { return events_; }
  [[nodiscard]] std::vector<double> indicators() { return indicators(t_, y_); }
  [[nodiscard]] State slope(double t, const State& y) {
    State result{};
    EXPECT_EQ(unit_.slope(t, y, result), Evaluation::ok);
    return result;
  }

 private:
  std::vector<double> indicators(double t, const State& y) {
    std::vector<double> z(unit_.indicator_count());
    EXPECT_EQ(unit_.indicators(t, y, z), Evaluation::ok);
    return z;
  }
  bool fallen(const State& y) {
    const auto z = indicators(t_, y);
    return std::any_of(z.begin(), z.end(), [](double value) { return value <= 0; });
  }
  // The systems of these tests do not ask for the time.
  State stepped(double h) {
    const auto moved = [&](const State& by, double length) {
      State result = y_;
      for (std::size_t i = 0; i < result.size(); ++i) result[i] += length * by[i];
      return result;
    };
    const State a = slope(t_, y_);
    if (stages_ == 1) return moved(a, h);
    const State b = slope(t_, moved(a, h / 2)), c = slope(t_, moved(b, h / 2)), d = slope(t_, moved(c, h));
    State result = y_;
    for (std::size_t i = 0; i < result.size(); ++i) result[i] += h / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
    return result;
  }

  ContactMechanismOf<S> mechanism_;
  ContactExchange unit_;
  double t_;
  State y_, before_{};
  int stages_ = 4;
  bool began_ = false;
  std::vector<double> events_;
};

template <class S>
typename S::State moved_by_runtime(const S& system, typename S::State y, double to) {
  const DormandPrince853 method{.relative_tolerance = 1e-13, .absolute_tolerance = 1e-13};
  const auto result = integrate_contacts(system, y, 0.0, to, method);
  EXPECT_TRUE(result) << describe(result.status);
  return y;
}

TEST(ContactExchange, BouncesAtTheTimesOfFreeFall) {
  const auto system = ball(0.5);
  Importer importer(system, {0.1, 0.0});
  const double fall = std::sqrt(2 * 0.1 / g);
  ASSERT_TRUE(importer.move(2.9 * fall, 0.01));
  ASSERT_GE(importer.events().size(), 4u);
  // Parabolas are exact in a step of Runge and Kutta; a time is located to its rounding over the velocity of some 1 m/s.
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(importer.events()[k], (3 - std::pow(0.5, double(k)) * 2) * fall, 1e-13) << k;
}

TEST(ContactExchange, BringsBouncesToAnEnd) {
  const auto system = ball(0.5);
  Importer importer(system, {0.1, 0.0});
  ASSERT_TRUE(importer.move(1.0, 0.01));
  EXPECT_NEAR(importer.state()[0], 0, 1e-10);  // of `touch`
  EXPECT_EQ(importer.state()[1], 0);
  EXPECT_EQ(importer.unit().result().accumulations, 1);
  EXPECT_GT(importer.events().size(), 10u);
  EXPECT_LT(importer.events().size(), 60u);  // 0.5^k of 1.4 m/s is below 1e-17 m/s then
  EXPECT_NEAR(importer.indicators()[0], g, 1e-12);  // now the force that presses
}

TEST(ContactExchange, SlidesThenRolls) {
  constexpr double slope = 0.3, f = 0.2, R = 0.1;
  const auto system = sphere_on_slope(slope, f, 0, R);
  const double down = std::sin(slope), across = std::cos(slope);
  Importer importer(system, {0, R, 0, 1.0, 0, 0});
  EXPECT_NEAR(importer.indicators()[1], 1.0, 1e-15);  // its slip
  ASSERT_TRUE(importer.move(1.0, 0.01));
  // Sliding: x'' = g (sin - f cos), R φ'' = 5/2 f g cos; both ends of the slip meet.
  const double end = 1 / (3.5 * f * g * across - g * down);
  ASSERT_FALSE(importer.events().empty());
  EXPECT_NEAR(importer.events().back(), end, 1e-12);
  const double speed = 1 + g * (down - f * across) * end + 5.0 / 7 * g * down * (1 - end);
  EXPECT_NEAR(importer.state()[3], speed, 1e-12);
  EXPECT_NEAR(importer.state()[3], R * importer.state()[5], 1e-14);
  EXPECT_NEAR(importer.slope(importer.time(), importer.state())[3], 5.0 / 7 * g * down, 1e-12);
}

TEST(ContactExchange, ReachesTheStateOfTheRuntime) {
  const auto stopped = pendulum_with_stop(-0.2, 1, 0.7);
  Importer swings(stopped, {1.0, 0.0});
  ASSERT_TRUE(swings.move(3.0, 1e-3));
  const auto swung = moved_by_runtime(stopped, {1.0, 0.0}, 3.0);
  EXPECT_EQ(swings.events().size(), 2u);
  // (1e-3)^4 of a step, 3 s, an impact doubles at most.
  for (std::size_t i = 0; i < swung.size(); ++i) EXPECT_NEAR(swings.state()[i], swung[i], 1e-11) << i;

  const auto table = billiard_ball(0.17, 0.0286, 0.2, 0.9);
  const std::array<double, 9> struck{0, 0, 0.0286, 1.0, 0, 0, 30.0, -20.0, 10.0};
  Importer rolls(table, struck);
  ASSERT_TRUE(rolls.move(1.0, 1e-3));
  const auto rolled = moved_by_runtime(table, struck, 1.0);
  EXPECT_FALSE(rolls.events().empty());
  // Sizes reach 40 rad/s. The direction of this slip stays; its end is located where the slip is zero to 1e-12.
  for (std::size_t i = 0; i < rolled.size(); ++i) EXPECT_NEAR(rolls.state()[i], rolled[i], 1e-9) << i;
}

TEST(ContactExchange, IndicatesNothingAfterAnEvent) {
  const auto system = ball(0.5);
  Importer importer(system, {0.1, 0.0});
  EXPECT_EQ(importer.indicators().size(), 3u);
  double end = 0.05;
  for (int k = 0; k < 6; ++k, end += 0.05) {
    ASSERT_TRUE(importer.move(end, 0.01));
    for (const double z : importer.indicators()) EXPECT_GT(z, 0) << end;
  }
}

TEST(ContactExchange, ChangesNothingWhereNothingHasFallen) {
  const auto system = sphere_on_slope(0.3, 0.2, 0, 0.1);
  Importer importer(system, {0, 0.1, 0, 1.0, 0, 0});
  ASSERT_TRUE(importer.move(0.05, 0.01));
  const auto state = importer.state(), slope = importer.slope(importer.time(), state);
  ASSERT_TRUE(importer.unit().update(importer.time(), importer.state()));
  EXPECT_EQ(importer.state(), state);
  EXPECT_EQ(importer.slope(importer.time(), state), slope);
}

TEST(ContactExchange, PassesAnEventThatIsToldLate) {
  const auto system = ball(0.5);
  Importer importer(system, {0.1, 0.0});
  const double fall = std::sqrt(2 * 0.1 / g), late = 1e-3;
  ASSERT_TRUE(importer.move(1.5 * fall, 0.01, late));
  ASSERT_EQ(importer.events().size(), 1u);  // below the floor on its way up, it has had its impact
  // The velocity that it struck with, and the depth that it left from.
  const double strikes = g * (fall + late), depth = 0.1 - g * (fall + late) * (fall + late) / 2, flight = 0.5 * fall - late;
  EXPECT_NEAR(importer.state()[1], 0.5 * strikes - g * flight, 1e-12);
  EXPECT_NEAR(importer.state()[0], depth + 0.5 * strikes * flight - g * flight * flight / 2, 1e-12);
}

// A parameter is set at an event that was found late: regimes are decided anew, before the ball has struck or after.
TEST(ContactExchange, BeginsAgainBelowTheFloor) {
  const auto system = ball(0.5);
  Importer falls(system, {-1e-3, -2.0}), rises(system, {-1e-3, 2.0});
  EXPECT_FALSE(falls.began());
  EXPECT_FALSE(rises.began());
  ASSERT_TRUE(falls.unit().start(0, falls.state(), true));
  EXPECT_EQ(falls.state()[1], 1.0);  // of e = 0.5
  EXPECT_NEAR(falls.state()[0], 0, 1e-15);  // put on the floor, from a millimetre below
  ASSERT_TRUE(rises.unit().start(0, rises.state(), true));
  EXPECT_EQ(rises.state(), (std::array<double, 2>{-1e-3, 2.0}));
  for (Importer<decltype(ball(0.5))>* importer : {&falls, &rises}) {
    for (const double z : importer->indicators()) EXPECT_GT(z, 0);
    EXPECT_EQ(importer->slope(0, importer->state())[1], -g);  // it flies
  }
}

// The other side of the rim strikes, which no event tells. Steps of any length and units of any tolerance notice it, at the
// speed that energy gives, (I + R^2 cos^2 β) β'^2/2 = g R (sin β0 - sin β), but for what is gained in a step.
TEST(ContactExchange, RefusesAStepOverAJumpOfTheNormal) {
  constexpr double R = 0.1, I = R * R / 4;
  for (const double of_unit : {1e-3, 1e-6, 1e-12}) {
    for (const double h : {3e-2, 1e-2, 1e-3, 1e-4}) {
      for (const double start : {0.02, 0.3, 0.8}) {
        const auto system = leaning_disc(R);
        Importer disc(system, {R * std::sin(start), start, 0, 0}, 0, of_unit);
        EXPECT_FALSE(disc.move(2.0, h)) << h << " " << start;
        EXPECT_EQ(disc.unit().result().status, ContactStatus::no_point) << h << " " << start;
        EXPECT_EQ(disc.unit().result().contact, 0);
        if (h > 1e-3) continue;
        const double speed = std::sqrt(2 * g * R * std::sin(start) / (I + R * R)), gained = h * g * R / (I + R * R);
        EXPECT_GT(disc.before()[1], 0);
        EXPECT_NEAR(-disc.before()[3], speed, 1.01 * gained + 1e-9) << h << " " << start;
      }
    }
  }
}

// What steps of one stage leave of a normal velocity is no jump, however much it is: an importer may be crude.
TEST(ContactExchange, TakesCrudeStepsWithoutAJump) {
  const auto system = particle_in_circle(0.1);
  for (const double h : {0.02, 0.01, 0.005}) {
    Importer slides(system, {0.1, 0, 0, 0});
    EXPECT_TRUE(slides.move(0.3, h, 0, 1)) << h << " " << slides.time();
  }
}

TEST(ContactExchange, RefusesAStartThatTheRuntimeRefuses) {
  const auto below = ball(0.5);
  Importer sunk(below, {-0.1, 0.0});
  EXPECT_FALSE(sunk.began());
  EXPECT_EQ(sunk.unit().result().status, ContactStatus::penetrates);
  const auto gains = ball(1.5);
  Importer wrong(gains, {0.1, 0.0});
  EXPECT_FALSE(wrong.began());
  EXPECT_EQ(wrong.unit().result().status, ContactStatus::invalid_rule);
}

}  // namespace
}  // namespace contact_exchange_test
