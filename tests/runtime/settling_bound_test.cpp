// SPDX-License-Identifier: GPL-3.0-or-later
// Steps that settling moves farther than their error: laws of time faster than a step, jumps of them, starts that are open.
#include "torsor/runtime/steps/settling_bound.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "torsor/runtime/integration/dormand_prince_54.hpp"
#include "torsor/runtime/integration/dormand_prince_853.hpp"
#include "torsor/runtime/integration/integrate.hpp"
#include "torsor/runtime/integration/radau_iia_5.hpp"
#include "torsor/runtime/integration/taylor.hpp"
#include "torsor/runtime/steps/angles_within_a_turn.hpp"

namespace settling_bound_test {
namespace {

using namespace torsor::runtime;
using Two = std::array<double, 2>;

/// A cart whose speed is to follow 1/(1 + exp(-(t - 1/2)/w)), from 0 to 1 m/s within some w: x' = v, v' = (v - v²)/w.
struct FastCart {
  double w = 1e-3;

  [[nodiscard]] double speed(double t) const noexcept { return 1 / (1 + std::exp(-(t - 0.5) / w)); }
  Evaluation operator()(double t, const Two& y, Two& slope) const noexcept {
    const double v = speed(t);
    slope = {y[1], v * (1 - v) / w};
    return Evaluation::ok;
  }
  Evaluation jets(double t, const Two& y, std::span<Two> c) const noexcept {
    std::array<double, 64> v{speed(t)};
    c[0] = y;
    for (std::size_t k = 0; k + 1 < c.size(); ++k) {
      double product = 0.0;
      for (std::size_t i = 0; i <= k; ++i) product += v[i] * v[k - i];
      const double order = static_cast<double>(k + 1);
      v[k + 1] = (v[k] - product) / (w * order);
      c[k + 1] = {c[k][1] / order, v[k + 1]};
    }
    return Evaluation::ok;
  }
  void project(double t, Two& y) const noexcept { y[1] = speed(t); }
};

/// One whose place, or else speed, is 0 and from t = 1/2 on 1.
struct JumpingCart {
  bool place = false;

  Evaluation operator()(double, const Two& y, Two& slope) const noexcept {
    slope = {y[1], 0.0};
    return Evaluation::ok;
  }
  Evaluation jets(double, const Two& y, std::span<Two> c) const noexcept {
    for (Two& each : c) each = {};
    c[0] = y;
    c[1] = {y[1], 0.0};
    return Evaluation::ok;
  }
  void project(double t, Two& y) const noexcept { y[place ? 0 : 1] = t < 0.5 ? 0.0 : 1.0; }
};

/// A rotor at 3 rad/s to which each settling adds some roundings.
struct Rotor {
  double rounding = 0.0;

  Evaluation operator()(double, const Two& y, Two& slope) const noexcept {
    slope = {y[1], 0.0};
    return Evaluation::ok;
  }
  void project(double, Two& y) const noexcept { y[1] *= 1 + rounding; }
};

template <class Method>
class EveryAdaptiveMethod : public testing::Test {};
using Methods = testing::Types<DormandPrince54, DormandPrince853, RadauIia5, Taylor>;
TYPED_TEST_SUITE(EveryAdaptiveMethod, Methods);

TYPED_TEST(EveryAdaptiveMethod, FollowsASpeedThatRisesWithinAStepWhateverTheTimesAskedFor) {
  const std::vector<std::vector<double>> plans{{1.0}, {0.3, 0.6, 0.9, 1.0}, {0.25, 0.5, 0.75, 1.0}};
  for (const auto& times : plans) {
    FastCart cart;
    Two y{0.0, cart.speed(0.0)};
    double t = 0.0;
    for (const double end : times) {
      const auto result = integrate(cart, y, t, end, TypeParam{});
      ASSERT_TRUE(result) << describe(result);
      t = end;
    }
    // The integral of the law from 0 to 1 is 1/2, by symmetry.
    EXPECT_NEAR(y[0], 0.5, 1e-7) << times.size();
  }
}

TYPED_TEST(EveryAdaptiveMethod, EndsWhereASpeedOrAPlaceJumps) {
  for (const bool place : {false, true}) {
    Two y{0.0, 0.0};
    const auto result = integrate(JumpingCart{place}, y, 0, 1, TypeParam{});
    EXPECT_EQ(result.status, IntegrationStatus::step_too_small) << describe(result);
    EXPECT_NEAR(result.time, 0.5, 1e-12);
    EXPECT_EQ(y, (Two{0.0, 0.0}));
  }
}

TYPED_TEST(EveryAdaptiveMethod, ClosesAnOpenStartByItsFirstStep) {
  Two y{0.0, 0.7};
  const auto result = integrate(JumpingCart{}, y, 0.6, 1, TypeParam{});
  EXPECT_TRUE(result) << describe(result);
  EXPECT_EQ(y[1], 1.0);
}

TYPED_TEST(EveryAdaptiveMethod, LetsAnOpenStartHideNoJumpLater) {
  Two y{0.0, 1e-3};
  const auto result = integrate(JumpingCart{}, y, 0, 1, TypeParam{});
  EXPECT_EQ(result.status, IntegrationStatus::step_too_small);
  EXPECT_NEAR(result.time, 0.5, 1e-12);
}

TEST(SettlingBound, TakesRoundingsForNoCorrection) {
  // Some 2000 roundings, which are 800 of these tolerances; 20000 are none any more.
  const DormandPrince853 method{.relative_tolerance = 1e-15, .absolute_tolerance = 1e-15};
  Two y{0.0, 3.0};
  const auto result = integrate(Rotor{5e-13}, y, 0, 1, method);
  EXPECT_TRUE(result) << describe(result);
  EXPECT_EQ(result.statistics.rejected, 0);
  EXPECT_GT(result.statistics.accepted, 1);
  y = {0.0, 3.0};
  EXPECT_EQ(integrate(Rotor{5e-12}, y, 0, 1, method).status, IntegrationStatus::step_too_small);
}

TEST(SettlingBound, CountsNoTurnThatIsTakenBack) {
  const auto rotor = angles_within_a_turn(Rotor{}, std::array<std::size_t, 1>{0});
  Two y{0.0, 3.0};
  const auto result = integrate(rotor, y, 0, 100, DormandPrince853{});
  ASSERT_TRUE(result) << describe(result);
  EXPECT_EQ(result.statistics.rejected, 0);
  EXPECT_NEAR(y[0], std::remainder(300.0, 2 * std::acos(-1.0)), 1e-10);
}

TEST(SettlingBound, IsAHundredTolerancesInTheirNorm) {
  const SettlingBound<double> bound{{.relative = 1e-9, .absolute = 1e-12}};
  const Two y{2.0, 0.0};
  // 100 (1e-12 + 1e-9 · 2) for the first of two components.
  EXPECT_NEAR(bound.share(y, y, Two{2.0 + 2.001e-7, 0.0}), 1 / std::sqrt(2.0), 1e-6);
  EXPECT_EQ(bound.share(y, y, y), 0.0);
  EXPECT_GT(bound.share(Two{}, Two{}, Two{0.0, 1e-9}), 1.0);
}

}  // namespace
}  // namespace settling_bound_test
