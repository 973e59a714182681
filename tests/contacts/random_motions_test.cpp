// SPDX-License-Identifier: GPL-3.0-or-later
// Random mechanisms thrown at walls and at each other. TORSOR_LONG_TESTS: 300 of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "runtime/contacts/integrate_contacts.hpp"
#include "runtime/contacts/moreau_jean.hpp"
#include "tests/contacts/random_scenes.hpp"

namespace random_motions_test {
namespace {

using namespace random_scenes;
using State = RandomScene::State;

constexpr DormandPrince853 precise{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12};

unsigned scenes() { return std::getenv("TORSOR_LONG_TESTS") == nullptr ? 20 : 300; }

ContactResult move(const RandomScene& scene, State& y, double end) {
  const ContactResult result = integrate_contacts(scene, y, 0, end, precise);
  EXPECT_LE(result.worst_residual, 1e-13);
  return result;
}

double distance(const State& a, const State& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

// The order of declaration moves a motion less than other starts, 1e-11 away, do.
TEST(RandomMotions, AreTheSameWhateverTheOrderOfDeclaration) {
  int compared = 0;
  for (unsigned k = 0; k < scenes(); ++k) {
    SCOPED_TRACE(testing::Message() << "scene " << k);
    const auto [scene, start] = random_start(k);
    State usual = start;
    if (scene.touches.size() < 2 || !move(scene, usual, 1)) continue;
    RandomScene other = scene;
    std::reverse(other.touches.begin(), other.touches.end());
    State permuted = start;
    EXPECT_TRUE(move(other, permuted, 1));
    double felt = 1e-11;
    for (const double sign : {1.0, -1.0}) {
      State near = start;
      for (std::size_t i = 0; i < near.size(); ++i) near[i] += start[i] == 0 ? 0 : sign * 1e-11;
      (void)move(scene, near, 1);
      felt = std::max(felt, distance(near, usual));
    }
    EXPECT_LE(distance(permuted, usual), felt);
    ++compared;
  }
  EXPECT_GE(compared, static_cast<int>(scenes() / 2));
}

// What happens along a motion: energy that comes from nowhere, and the deepest gap.
struct Along {
  const RandomScene& scene;
  double energy = INFINITY, gained = 0, deepest = 0;
  bool operator()(double, const State& y) {
    const auto [kinetic, potential] = scene.energies(y);
    gained = std::max(gained, kinetic + potential - energy);
    energy = kinetic + potential;
    for (const double gap : scene.gaps(y)) deepest = std::max(deepest, -gap);
    return true;
  }
};

// Newton's law with friction may give energy where several contacts strike at once: then the motion ends and says so.
// In three scenes contacts of two bodies strike in turn until no flight leaves the rounding of its gap.
TEST(RandomMotions, NeverGainEnergyAndNeverSink) {
  std::vector<unsigned> numbers{192, 285, 321};
  for (unsigned k = 0; k < scenes(); ++k) numbers.push_back(k);
  std::size_t ended = 0;
  for (const unsigned k : numbers) {
    SCOPED_TRACE(testing::Message() << "scene " << k);
    auto [scene, y] = random_start(k);
    Along along{scene};
    const ContactResult result = integrate_contacts(scene, y, 0, 1, precise, {}, along);
    EXPECT_TRUE(result || result.status == ContactStatus::energy_gained)
        << describe(result.status) << ": " << describe(result.integration_event) << " at " << result.time;
    EXPECT_LE(result.worst_residual, 1e-13);
    EXPECT_LE(along.gained, 1e-10);  // some hundred steps within 1e-12 of energies of some 10 J
    EXPECT_LE(along.deepest, 1e-14);
    ended += result ? 0 : 1;
  }
  EXPECT_LE(ended, numbers.size() / 20);
}

// Scene 38: four bodies in a loop, of which several contacts strike at once with friction. Newton's law would give energy.
TEST(RandomMotions, EndWhereTheLawOfImpactWouldGiveEnergy) {
  auto [scene, y] = random_start(38);
  const ContactResult result = integrate_contacts(scene, y, 0, 1, precise);
  EXPECT_EQ(result.status, ContactStatus::energy_gained);
  EXPECT_GE(result.contact, 0);
}

// Steps of Moreau and Jean, fifty times as short, come at least five times as near to the motion from event to event.
TEST(RandomMotions, AreWhatStepsTendTo) {
  int compared = 0;
  for (unsigned k = 0; k < scenes() / 4; ++k) {
    SCOPED_TRACE(testing::Message() << "scene " << k);
    const auto [scene, start] = random_start(k);
    State exact = start;
    if (!move(scene, exact, 0.8)) continue;
    const auto error = [&scene = scene, &start = start, &exact](long steps) {
      State y = start;
      EXPECT_EQ(step_contacts(scene, y, 0, 0.8, steps), ContactStatus::reached_end);
      return distance(y, exact);
    };
    const double coarse = error(800), fine = error(40000);
    EXPECT_LE(fine, coarse / 5 + 1e-9);
    ++compared;
  }
  EXPECT_GT(compared, 0);
}

}  // namespace
}  // namespace random_motions_test
