// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/verification/verify.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/verification/ball.hpp"
#include "tests/dynamics/random_mechanism.hpp"
#include "tests/scenes/pendulums.hpp"

namespace torsor::verify_test {
namespace {

using namespace testing_mechanisms;

VerifyOptions asked(std::vector<std::string> kernels, int states) {
  VerifyOptions options;
  options.kernels = std::move(kernels);
  options.states = states;
  return options;
}

/// A block of 2 kg on a spring of 4 N/m, and beside it a hinge with the torque `torque` of its angle.
Scene block_and_hinge(const std::function<Expression(const Expression&)>& torque) {
  Scene scene("block_and_hinge");
  const Expression x = scene.coordinate("x", "m"), angle = scene.coordinate("angle", "rad");
  const FrameHandle slide = scene.prismatic("slide", scene.ground(), axis::x, x);
  scene.body("block", slide, Inertia::point(kilograms("2")));
  scene.spring("spring", x, Expression::quantity("4", "N/m"), Expression::quantity("0", "m"));
  const FrameHandle hinge = scene.revolute("hinge", scene.ground(), axis::z, angle);
  scene.body("flywheel", hinge, Inertia::point(kilograms("1")).at({metres("1"), 0, 0}));
  scene.generalised_force("torque", angle, torque(angle));
  return scene;
}

TEST(Verify, PassesAPendulumAndRepeatsItself) {
  const VerifyOptions options = asked({"bias", "forward_dynamics", "energy"}, 16);
  const std::vector<VerifyRow> first = verify_scene(pendulum(), options), second = verify_scene(pendulum(), options);
  ASSERT_EQ(first.size(), second.size());
  EXPECT_GE(first.size(), 8U);  // forces, accelerations, kinetic, force function; in two formats
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_TRUE(first[i].passed()) << first[i].kernel << " " << first[i].group << " " << first[i].worst.scaled;
    EXPECT_EQ(first[i].worst.scaled, second[i].worst.scaled);
    EXPECT_EQ(first[i].state, second[i].state);
    EXPECT_GE(first[i].states, 16);
  }
}

/// 4 x is exact; the sum 2 x'' + 4 x of exact products is rounded once, by half an ulp at most.
TEST(Verify, FindsNoErrorInExactResultsAndHalfAnUlpInOneRounding) {
  const Scene scene =
      block_and_hinge([](const Expression& angle) { return angle * Expression::quantity("-8", "N m"); });
  const auto rows = verify_scene(scene, asked({"bias", "inverse_dynamics"}, 32));
  for (const VerifyRow& row : rows) {
    const bool exact = row.kernel == "bias";
    EXPECT_LE(row.worst.scaled, exact ? 0.0 : 0.5001 * std::sqrt(2.0)) << row.kernel << " " << row.group;
    if (exact) {
      EXPECT_EQ(row.worst.error, 0.0) << row.group;
    } else {
      // Of many roundings, each anywhere up to half an ulp, the worst is above a quarter.
      EXPECT_GT(row.worst.error, 0.26) << row.kernel << " " << row.group;
    }
  }
}

/// 3 (1 - cos a): of the condition 1 + a sin a/(1 - cos a) ≤ 3, but cos a next to 1 is rounded by half an ulp of 1.
TEST(Verify, FlagsAKnownCancellation) {
  const Scene scene = block_and_hinge([](const Expression& angle) {
    return Expression::quantity("3", "N m") * (1 - cos(angle));
  });
  VerifyOptions options = asked({"bias"}, 32);
  options.precisions = {Precision::in_double};
  const auto flagged = [](const std::vector<VerifyRow>& rows) {
    return std::find_if(rows.begin(), rows.end(), [](const VerifyRow& row) { return row.worst.scaled > accuracy_bar; });
  };
  std::vector<VerifyRow> rows = verify_scene(scene, options);
  ASSERT_NE(flagged(rows), rows.end());
  EXPECT_FALSE(flagged(rows)->passed());
  EXPECT_TRUE(flagged(rows)->bounded());
  EXPECT_GT(flagged(rows)->worst.scaled, 1e3);
  EXPECT_LE(flagged(rows)->worst.condition, 3.0 + 1e-9);
  EXPECT_NE(flagged(rows)->state.find("angle="), std::string::npos);

  options.exceptions =
      parse_accuracy_exceptions("# known\n\nblock_and_hinge | bias | * | double | 1e300 | it cancels\n");
  rows = verify_scene(scene, options);
  EXPECT_TRUE(flagged(rows)->passed());
  EXPECT_EQ(flagged(rows)->reason, "it cancels");
  EXPECT_TRUE(needless_exceptions(scene.name(), rows, options.exceptions).empty());

  options.exceptions = parse_accuracy_exceptions("another_scene | bias | * | double | 1e300 | it cancels\n");
  rows = verify_scene(scene, options);
  EXPECT_FALSE(flagged(rows)->passed());
  EXPECT_EQ(flagged(rows)->reason, "");
}

/// One of a result that needs none, one of a kernel that is not there; that of another scene is not looked at.
TEST(Verify, FindsExceptionsThatAreNotNeeded) {
  const Scene scene = pendulum();
  VerifyOptions options = asked({"bias"}, 4);
  options.precisions = {Precision::in_double};
  options.exceptions = parse_accuracy_exceptions(scene.name() + " | bias | * | double | 9 | none\n" + scene.name() +
                                                 " | energy | * | double | 9 | not asked for\n"
                                                 "another_scene | bias | * | double | 9 | none\n");
  const auto needless = needless_exceptions(scene.name(), verify_scene(scene, options), options.exceptions);
  ASSERT_EQ(needless.size(), 2U);
  EXPECT_EQ(needless[0].kernel, "bias");
  EXPECT_EQ(needless[1].kernel, "energy");
}

TEST(Verify, RefusesAnExceptionThatItCannotRead) {
  for (const char* text : {"scene | kernel | group | double | 9", "scene | kernel | group | double | nine | reason",
                           "scene | kernel | group | double | 9x | reason", "a | b | c | d | 9 |  "}) {
    EXPECT_THROW(parse_accuracy_exceptions(text), UsageError) << text;
  }
}

/// The bound of every result holds at every state, and where a bound says that eight ulp cannot be exceeded, they are
/// not.
TEST(Verify, BoundsEveryErrorOfRandomMechanisms) {
  for (const Precision precision : {Precision::in_double, Precision::in_float}) {
    for (unsigned seed = 1; seed <= 6; ++seed) {
      const Scene scene = random_mechanism(seed, {.motors = true, .joints = seed % 2 == 0, .most_bodies = 3});
      const auto accuracy = kernel_accuracy(
          scene, {}, {"kinematics", "inverse_dynamics", "forward_dynamics", "energy", "constraints"}, precision);
      for (std::uint64_t k = 0; k < 8; ++k) {
        const StressState state(scene, accuracy->symbols(), k,
                                precision == Precision::in_double ? double_states : float_states);
        accuracy->move_to(state);
        for (std::size_t g = 0; g < accuracy->groups().size(); ++g) {
          const Accuracy found = accuracy->estimate(g);
          if (!found.counted) continue;
          // `long double` is wrong by 2^-11 of the rounding of double, in which the bound's own sums are small.
          EXPECT_LE(found.error, found.bound * 1.001) << seed << " " << k << " " << accuracy->groups()[g].name;
          if (k % 4 != 0 || g % 3 != 0) continue;
          const Accuracy sure = accuracy->certify(g, 40);
          EXPECT_EQ(sure.enclosed, Ball::available()) << seed << " " << k << " " << accuracy->groups()[g].name;
          EXPECT_LE(sure.error, sure.bound) << seed << " " << k << " " << accuracy->groups()[g].name;
          // The ulp doubles at a power of two, and a norm may fall on either side of one.
          EXPECT_LE(sure.error, 2.01 * found.error + 0.01);
          EXPECT_GE(sure.error, found.error / 2.01 - 0.01);
          EXPECT_LE(sure.scaled, sure.error);
        }
      }
    }
  }
}

TEST(StressState, IsExactInItsFormatAndKeepsQuaternionsAtOne) {
  const Scene scene = torque_free_body();
  const auto accuracy = kernel_accuracy(scene, {}, {"kinematics", "energy"}, Precision::in_float);
  std::mt19937_64 random(1);
  for (std::uint64_t seed = 0; seed < 32; ++seed) {
    const StressState start(scene, accuracy->symbols(), seed, float_states);
    const StressState moved = start.with_step(seed % start.symbols().size(), random);
    for (const StressState& state : {start, moved, start.jittered(random)}) {
      double square = 0;
      for (const SymbolPointer& symbol : state.symbols()) {
        const double value = state.value(symbol);
        EXPECT_EQ(value, static_cast<double>(static_cast<float>(value)));
        if (!symbol->attitude.expired()) square += value * value;
      }
      EXPECT_NEAR(square, 1.0, 4 * 0x1p-23);  // four components rounded
    }
  }
}

}  // namespace
}  // namespace torsor::verify_test
