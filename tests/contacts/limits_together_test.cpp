// SPDX-License-Identifier: GPL-3.0-or-later
// Boxes on boxes whose contacts come to the bounds of their friction at one time: several regimes have the same accelerations.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "tests/contacts/told_motion.hpp"
#include "torsor/runtime/contacts/circle_roots.hpp"

namespace limits_together_test {
namespace {

using namespace told_motion;

/// Boxes on each other, the lowest on the floor, all pulled by forces A sin(w t) + B at an angle from x: q = (x, z) or (x, y, z) of each.
template <std::size_t boxes, std::size_t tangents>
struct Stack {
  static constexpr std::size_t freedoms = tangents + 1, nq = freedoms * boxes, nv = nq, contacts = boxes;
  struct Box {
    double m, f, f_static, A, B;
  };
  std::array<Box, boxes> of;
  double w;
  double angle = 0;

  [[nodiscard]] ContactRule rule(int i) const {
    const Box& box = of[static_cast<std::size_t>(i)];
    return {.tangents = tangents, .friction = box.f, .static_friction = box.f_static};
  }
  [[nodiscard]] Evaluation read(double t, const std::array<double, nq + nv>& y, ContactReading& r) const {
    r.M.setZero();
    r.F.setZero();
    r.J.setZero();
    r.drift.setZero();
    for (std::size_t box = 0; box < boxes; ++box) {
      const auto first = static_cast<Eigen::Index>(freedoms * box), normal = static_cast<Eigen::Index>(tangents);
      r.M.diagonal().segment<freedoms>(first).setConstant(of[box].m);
      const double pull = of[box].A * std::sin(w * t) + of[box].B;
      r.F(first) = pull * std::cos(angle);
      if (tangents == 2) r.F(first + 1) = pull * std::sin(angle);
      r.F(first + normal) = -of[box].m * g;
      r.gap[box] = y[freedoms * box + tangents] - (box > 0 ? y[freedoms * (box - 1) + tangents] : 0);
      const auto add = [&](Eigen::Index column, double sign) {
        r.J(first, column + normal) = sign;
        for (Eigen::Index k = 0; k < normal; ++k) r.J(first + 1 + k, column + k) = sign;
      };
      add(first, 1);
      if (box > 0) add(first - static_cast<Eigen::Index>(freedoms), -1);
    }
    r.w = r.J * Eigen::Map<const Eigen::VectorXd>(y.data() + nq, static_cast<Eigen::Index>(nv));
    return Evaluation::ok;
  }
  void coordinate_rates(double, const std::array<double, nq + nv>& y, std::array<double, nq>& rates) const {
    std::copy_n(y.begin() + nq, nq, rates.begin());
  }
};

constexpr DormandPrince853 usual{.relative_tolerance = 1e-10, .absolute_tolerance = 1e-10};

/// ∫ and ∫∫ of A sin(w t) + B from t0 to t1, divided by m.
struct Pulled {
  double speed, way;
  Pulled(double A, double B, double w, double m, double t0, double t1)
      : speed((A / w * (std::cos(w * t0) - std::cos(w * t1)) + B * (t1 - t0)) / m),
        way((A / w * (t1 - t0) * std::cos(w * t0) - A / (w * w) * (std::sin(w * t1) - std::sin(w * t0)) +
             B * (t1 - t0) * (t1 - t0) / 2) / m) {}
};

// A zero right at the beginning of the circle, where the value there and that a turn later round to either side of it.
TEST(CircleRoots, AreFoundWhereTheCircleCloses) {
  for (const double aside : {0.0, 1e-17, -1e-17, 1e-16, -1e-16}) {
    for (const double sign : {1.0, -1.0}) {
      std::array<double, 8> values{};
      for (std::size_t j = 0; j < values.size(); ++j) {
        values[j] = sign * (std::sin(std::numbers::pi / 4 * static_cast<double>(j)) + aside);
      }
      const CircleRoots roots(values);
      bool first = false, second = false;
      for (std::size_t k = 0; k < roots.count(); ++k) {
        first = first || std::abs(std::remainder(roots[k], 2 * std::numbers::pi)) < 1e-14;
        second = second || std::abs(roots[k] - std::numbers::pi) < 1e-14;
      }
      EXPECT_TRUE(first && second) << sign << ' ' << aside;
    }
  }
}

// f1 m1 = f2 (m1 + m2): once the upper box slides, its friction is that which the lower one has as it slides. It sticks, as it did,
// and does not slide at no speed: that slip ended where it began, and began again.
TEST(LimitsTogether, LeaveALowerBoxInSpaceAtRest) {
  constexpr double limit = 3 * 0.2 * g, w = 1, A = 1.5 * limit, B = 0.5 * limit;
  Stack<2, 2> stack{{{{5, 0.2 * 3 / 8, 0.26 * 3 / 8, 0, 0}, {3, 0.2, 0.24, A, B}}}, w};
  std::array<double, 12> y{};
  const Motion motion = move(stack, y, 1);
  ASSERT_EQ(motion.events.size(), 1U);
  const double begins = std::asin((1.2 * limit - B) / A) / w;
  EXPECT_NEAR(motion.events[0].time, begins, 1e-14);
  const Pulled pulled(A, B - limit, w, 3, begins, 1);
  for (const std::size_t k : {0U, 1U, 2U, 4U}) EXPECT_NEAR(y[k], 0, 1e-15) << k;
  EXPECT_NEAR(y[3], pulled.way, 1e-12);
  EXPECT_NEAR(y[9], pulled.speed, 1e-12);
}

// The lower box slides at a small constant speed while the upper one has its greatest: its direction across is stiff there, and was
// lost in errors of the integration.
TEST(LimitsTogether, LetBothBoxesSlideStraightOn) {
  constexpr double m = 0.7, M = 1 + m, limit = 0.1 * g, w = 5, A = 0.15 * g, B = 0.05 * g;
  Stack<2, 2> stack{{{{m, 0.1 / M, 0.1 / M, 0, 0}, {1, 0.1, 0.12, A, B}}}, w};
  std::array<double, 12> y{};
  Motion motion;
  motion.result = integrate_contacts(stack, y, 0, 0.8, usual, {}, Log{motion.events});
  ASSERT_TRUE(motion.result) << describe(motion.result.status);
  ASSERT_EQ(motion.events.size(), 2U);
  // Together from f2 (m1 + m2) g on, apart from where F - m1 (F - limit)/M = 1.2 f1 m1 g.
  const double first = std::asin((limit - B) / A) / w, second = std::asin((M / m * (1.2 * limit - limit / M) - B) / A) / w;
  EXPECT_NEAR(motion.events[0].time, first, 1e-9);
  EXPECT_NEAR(motion.events[1].time, second, 1e-9);
  const Pulled together(A, B - limit, w, M, first, second), apart(A, B - limit, w, 1, second, 0.8);
  // Ten tolerances for all steps.
  EXPECT_NEAR(y[6], together.speed, 1e-9);
  EXPECT_NEAR(y[9], together.speed + apart.speed, 1e-9);
  EXPECT_NEAR(y[0], together.way + together.speed * (0.8 - second), 1e-9);
  EXPECT_NEAR(y[3], together.way + together.speed * (0.8 - second) + apart.way, 1e-9);
  // Across, where the steps are as long as the method can take them, its errors are some tens of tolerances.
  for (const std::size_t k : {1U, 4U, 7U, 10U}) EXPECT_NEAR(y[k], 0, 1e-8) << k;
}

// The pull comes to the limits of both contacts at its greatest, to rounding, and falls again: nothing moves.
TEST(LimitsTogether, MoveNothingWhereThePullOnlyComesToThem) {
  struct Case {
    double mass, friction, w, more;
  };
  const auto rests = [](const auto& stack, auto y, double end = 0.6) {
    const auto result = integrate_contacts(stack, y, 0, end, usual);
    EXPECT_TRUE(result) << describe(result.status);
    // A pull of (1 + ε) times the limit moves a box for sqrt(8 ε)/w, 1e-6 s, by ε g: 1e-18 m/s. The rest is rounding.
    for (const double each : y) EXPECT_NEAR(each, 0, 1e-15);
  };
  for (const auto& [mass, friction, w, more] : {Case{0.3, 0.1, 5, 0}, Case{5, 0.3, 3, 1e-13}}) {
    SCOPED_TRACE(testing::Message() << mass << ' ' << friction << ' ' << more);
    const double limit = friction * mass * g, lower = friction * mass / (mass + 2);
    rests(Stack<2, 1>{{{{2, lower, lower, 0, 0}, {mass, friction, friction, limit * (1 + more), 0}}}, w}, std::array<double, 8>{});
  }
  // Steps are long here, and no step of the method ends while the force is below its bound.
  constexpr double below = 0.071428571428571425, f = 0.099999999999999978;
  rests(Stack<2, 2>{{{{2, below, 1.2 * below, 0, 0}, {5, f, f, 4.905, 0}}}, 5, 0.3}, std::array<double, 12>{}, 2);
}

}  // namespace
}  // namespace limits_together_test
