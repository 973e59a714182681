// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/runtime/constraints/partitioned_motion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "torsor/runtime/constraints/constrained_motion.hpp"
#include "torsor/runtime/integration/dormand_prince_853.hpp"
#include "tests/runtime/closed_loops.hpp"
#include "tests/runtime/windows.hpp"

namespace partitioned_motion_test {
namespace {

using namespace torsor::runtime;
using Pendulum = mechanisms::CartesianPendulum<double>;
using ThreeCranks = mechanisms::CrankLoop<mechanisms::ThreeEqualCranksSmallSwing>;
constexpr DormandPrince853 precise{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12};

TEST(PartitionedMotion, ChangesCoordinatesWhereThePendulumTurnsFromOneToTheOther) {
  // x determines y below the pivot, y determines x beside it: from (-1, 0) both must serve in turn. Closed form of A01.
  const std::array<double, 4> exact{-0.275087462576116860054391449254, -0.961419205099125064265135068597,
                                    4.17559810095172883646051950627, -1.19474905456047527164747276163};
  const auto motion = equations_of_motion<Pendulum>();
  auto y = motion.initial();
  double worst = 0.0, reached = -1.0;
  std::int64_t steps = -1;  // the start is seen too
  const auto result = integrate_partitioned<1>(motion, y, 0, 10, precise, [&](double t, const StateVector<Pendulum>& s) {
    worst = std::max(worst, std::abs(s[0] * s[0] + s[1] * s[1] - 1));
    steps += t > reached ? 1 : 0;
    reached = t;
  });
  ASSERT_TRUE(result) << describe(result.integration);
  EXPECT_GE(result.switches, 2 * 8);  // two each half period of 1.18 s
  EXPECT_EQ(result.integration.statistics.accepted, steps);  // of all partitions
  EXPECT_LT(worst, 4e-15);
  // 10 s at speeds to 5, a motion that amplifies ten times, and dependent coordinates that do so up to four times.
  const double tolerance = 1e-12 * 10 * 5 * 10 * 4;
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(y[i], exact[i], tolerance);
}

TEST(PartitionedMotion, KeepsRedundantLoopsClosed) {
  const auto motion = constrained_motion<ThreeCranks>();
  auto y = motion.initial();
  const double before = ThreeCranks::energy(unpack<ThreeCranks>(0.0, y));
  const auto swung = integrate_partitioned<1>(motion, y, 0, 5, precise);
  ASSERT_TRUE(swung);
  // Closures of two lengths to 2, each rounded a few times, magnified by 1/cos 1.25 = 3.2.
  EXPECT_NEAR(y[1], y[0], 3.2 * 12 * 1.1e-16);
  EXPECT_NEAR(y[2], y[0], 3.2 * 12 * 1.1e-16);
  // Each step errs by 1e-12 (1 + |y|) in θ and in θ', |θ'| <= 3.7; T - U changes by 3.5 g = 34 J a radian, 3.5 · 3.7 Js.
  const double steps = static_cast<double>(swung.integration.statistics.accepted);
  EXPECT_NEAR(ThreeCranks::energy(unpack<ThreeCranks>(0.0, y)), before, 1e-12 * steps * (2.25 * 34 + 4.7 * 13));
  auto z = motion.initial();
  EXPECT_EQ((integrate_partitioned<2>(motion, z, 0, 1, precise).integration.status),
            IntegrationStatus::unsuitable_model);
}

TEST(PartitionedMotion, EndsAtAChangePointInFewSteps) {
  // Its equations as they are, up to where rounding hides them.
  const auto motion = constrained_motion<mechanisms::Windows<3>>(mechanisms::Windows<3>::default_parameters(), {}, 1e-15);
  for (const double tolerance : {1e-8, 1e-10, 1e-12}) {
    const DormandPrince853 method{.relative_tolerance = tolerance, .absolute_tolerance = tolerance};
    auto y = motion.initial();
    const auto result = integrate_partitioned<1>(motion, y, 0, 2, method).integration;
    const std::int64_t steps = result.statistics.accepted;
    EXPECT_LT(steps, 5000) << tolerance;
    if (result) continue;  // a step may go over it
    EXPECT_EQ(result.status, IntegrationStatus::model_failure) << describe(result);
    EXPECT_EQ(result.evaluation, Evaluation::singular) << describe(result);
    EXPECT_NEAR(std::cos(y[0]), 0, 1e-3);
  }
}

}  // namespace
}  // namespace partitioned_motion_test
