// SPDX-License-Identifier: GPL-3.0-or-later
// Random mechanisms in space thrown at walls and at each other. TORSOR_LONG_TESTS: 300 of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "torsor/runtime/contacts/integrate_contacts.hpp"
#include "torsor/runtime/contacts/moreau_jean.hpp"
#include "tests/contacts/random_space_scenes.hpp"
#include "tests/contacts/random_watch.hpp"
#include "tests/long_tests.hpp"

namespace random_space_motions_test {
namespace {

using torsor::wanted;
using namespace random_space_scenes;
using namespace random_watch;
using State = SpaceScene::State;

/// The first scenes, all 300 in long tests, and some besides.
std::vector<unsigned> numbers(std::vector<unsigned> all) {
  for (unsigned k = 0; k < wanted(3U, 300U); ++k) all.push_back(k);
  return all;
}

// The readings of the scenes themselves, against quotients of differences.
TEST(RandomSpaceMotions, HaveRowsThatAreRatesOfTheirGaps) {
  for (unsigned k = 0; k < 40; ++k) {
    SCOPED_TRACE(testing::Message() << "scene " << k);
    const auto [scene, y] = random_space_start(k);
    std::array<double, SpaceScene::nq> rates;
    scene.coordinate_rates(0, y, rates);
    constexpr double h = 1e-5;
    State before = y, after = y;
    for (std::size_t i = 0; i < rates.size(); ++i) {
      before[i] -= h * rates[i];
      after[i] += h * rates[i];
    }
    scene.normalise(before);
    scene.normalise(after);
    const ContactReading here = scene.reading_at(y), a = scene.reading_at(before), b = scene.reading_at(after);
    const auto slope = [](double low, double high) { return (high - low) / (2 * h); };
    const Eigen::Map<const Eigen::VectorXd> v(y.data() + SpaceScene::nq, SpaceScene::nv);
    EXPECT_LE((here.J * v - here.w).cwiseAbs().maxCoeff(), 1e-13);
    int row = 0;
    for (std::size_t i = 0; i < scene.touches.size(); ++i) {
      EXPECT_NEAR(slope(a.gap[i], b.gap[i]), here.w(row), 1e-7);
      for (int j = 0; j < scene.rule(static_cast<int>(i)).rows(); ++j, ++row) {
        EXPECT_NEAR(slope(a.w(row), b.w(row)), here.drift(row), 1e-5);
      }
    }
    for (int j = 0; j < here.value.size(); ++j) {
      EXPECT_NEAR(slope(a.value(j), b.value(j)), here.rate(j), 1e-7);
      EXPECT_NEAR(slope(a.rate(j), b.rate(j)), here.gamma(j), 1e-5);
    }
  }
}

// Some scenes that once ended early: a body held by two contacts that share friction (124), a slip that ends with an error of
// the integration across their direction (107).
TEST(RandomSpaceMotions, NeverGainEnergyAndNeverSink) {
  std::size_t ended = 0;
  std::int64_t impacts = 0;
  const std::vector<unsigned> all = numbers({107, 124});
  for (const unsigned k : all) {
    SCOPED_TRACE(testing::Message() << "scene " << k);
    auto [scene, y] = random_space_start(k);
    const ContactResult result = move_watched(scene, y, 1.5);
    ended += result ? 0 : 1;
    impacts += result.impacts;
  }
  EXPECT_LE(ended, all.size() / 20);
  EXPECT_GE(impacts, static_cast<std::int64_t>(all.size()));
}

// Scene 1 with a ratio of a million has a light body that slides between heavy ones until it jams: forces grew without
// bound, changed their sign unseen, and gave energy.
TEST(RandomSpaceMotions, OfMassesFarApartNeverGainEnergyAndSayWhereTheyJam) {
  auto [scene, y] = random_space_start(1);
  make_uneven(scene, 1e6);
  const ContactResult jammed = integrate_contacts(scene, y, 0, 1.5, precise);
  EXPECT_EQ(jammed.status, ContactStatus::jams);
  EXPECT_EQ(jammed.contact, 1);
  const bool few = wanted(true, false);  // then one scene for each ratio
  unsigned next = 0;
  for (const double ratio : {1e-6, 1e-3, 1e3, 1e6}) {
    for (const unsigned k : few ? std::vector<unsigned>{next++ % 3} : numbers({})) {
      SCOPED_TRACE(testing::Message() << "scene " << k << ", ratio " << ratio);
      auto [uneven, start] = random_space_start(k);
      make_uneven(uneven, ratio);
      (void)move_uneven(uneven, start, 1.5);
    }
  }
}

// The order of declaration moves a motion less than other starts, 1e-11 away, do. Where contacts share friction, they let go
// at 4e-12 of the largest force beyond their bounds, one order a little later than another.
TEST(RandomSpaceMotions, AreTheSameWhateverTheOrderOfDeclaration) {
  std::size_t compared = 0;
  const std::vector<unsigned> all = numbers({121});
  for (const unsigned k : all) {
    SCOPED_TRACE(testing::Message() << "scene " << k);
    const auto [scene, start] = random_space_start(k);
    State usual = start, permuted = start;
    if (scene.touches.size() < 2) continue;
    const ContactResult result = integrate_contacts(scene, usual, 0, 1.5, precise);
    if (!result) continue;
    SpaceScene other = scene;
    std::reverse(other.touches.begin(), other.touches.end());
    EXPECT_TRUE(integrate_contacts(other, permuted, 0, 1.5, precise));
    ++compared;
    double felt = result.indeterminate > 0 ? 1e-7 : 1e-11;
    if (distance(permuted, usual) <= felt) continue;
    for (const double sign : {1.0, -1.0}) {
      State near = start;
      for (std::size_t i = 0; i < near.size(); ++i) near[i] += start[i] == 0 ? 0 : sign * 1e-11;
      (void)integrate_contacts(scene, near, 0, 1.5, precise);
      felt = std::max(felt, distance(near, usual));
    }
    EXPECT_LE(distance(permuted, usual), felt);
  }
  EXPECT_GE(compared, all.size() / 2);
}

// Steps of Moreau and Jean have errors of first order: ten times as short, they come at least five times as near to the motion
// from event to event. These scenes strike three to eight times.
TEST(RandomSpaceMotions, AreWhatStepsTendTo) {
  for (const unsigned k : {7U, 17U, 21U}) {
    SCOPED_TRACE(testing::Message() << "scene " << k);
    const auto [scene, start] = random_space_start(k);
    State exact = start;
    const ContactResult result = integrate_contacts(scene, exact, 0, 0.8, precise);
    ASSERT_TRUE(result) << describe(result.status);
    EXPECT_GT(result.impacts, 0);
    const auto error = [&scene = scene, &start = start, &exact](long steps) {
      State y = start;
      EXPECT_EQ(step_contacts(scene, y, 0, 0.8, {.count = steps}), ContactStatus::reached_end);
      return distance(y, exact);
    };
    EXPECT_LE(error(4000), error(400) / 5);
  }
}

}  // namespace
}  // namespace random_space_motions_test
