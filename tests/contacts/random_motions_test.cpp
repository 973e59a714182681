// SPDX-License-Identifier: GPL-3.0-or-later
// Random mechanisms thrown at walls and at each other. TORSOR_LONG_TESTS: 300 of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "torsor/runtime/contacts/integrate_contacts.hpp"
#include "torsor/runtime/contacts/moreau_jean.hpp"
#include "tests/contacts/plane_truth.hpp"
#include "tests/contacts/random_scenes.hpp"
#include "tests/contacts/random_watch.hpp"
#include "tests/long_tests.hpp"

namespace random_motions_test {
namespace {

using torsor::wanted;
using namespace random_scenes;
using namespace random_watch;
using State = RandomScene::State;

unsigned scenes() { return wanted(20U, 300U); }

ContactResult move(const RandomScene& scene, State& y, double end) {
  const ContactResult result = integrate_contacts(scene, y, 0, end, precise);
  EXPECT_LE(result.worst_residual, 1e-13);
  return result;
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

// Newton's law with friction may give energy where several contacts strike at once: then the motion ends and says so.
// In three scenes contacts of two bodies strike in turn until no flight leaves the rounding of its gap.
TEST(RandomMotions, NeverGainEnergyAndNeverSink) {
  std::vector<unsigned> numbers{192, 285, 321};
  for (unsigned k = 0; k < scenes(); ++k) numbers.push_back(k);
  std::size_t ended = 0;
  for (const unsigned k : numbers) {
    SCOPED_TRACE(testing::Message() << "scene " << k);
    auto [scene, y] = random_start(k);
    const ContactResult result = move_watched(scene, y, 1);
    ended += result ? 0 : 1;
  }
  EXPECT_LE(ended, numbers.size() / 20);
}

// A status that ends a motion is what the state there says, asked in another way.
void judge(const RandomScene& scene, const State& end, const ContactResult& result) {
  const plane_truth::PlaneTruth truth(scene, end);
  switch (result.status) {
    case ContactStatus::no_solution:
      EXPECT_FALSE(truth.goes_on());
      break;
    case ContactStatus::no_impact:
      EXPECT_EQ(truth.impact().energy, INFINITY);
      break;
    case ContactStatus::energy_gained: {
      const auto loss = truth.impact();
      EXPECT_LT(loss.energy, -1e-12L * loss.terms);
      break;
    }
    case ContactStatus::jams:
      // A thousandth, of what it began with: friction makes that ten at most where f is below 0.4.
      EXPECT_LT(std::abs(truth.regularity()), 1e-2L);
      break;
    default:
      EXPECT_EQ(result.status, ContactStatus::reached_end) << describe(result.integration_event) << " at " << result.time;
  }
}

// Forty scenes; in long tests ratios of a thousand too, and 300 scenes of each.
TEST(RandomMotions, OfMassesFarApartNeverGainEnergyAndEndWhereTheirStateSaysSo) {
  const bool few = wanted(true, false);
  int reached = 0, all = 0;
  for (const double ratio : few ? std::vector<double>{1e-6, 1e6} : std::vector<double>{1e-6, 1e-3, 1e3, 1e6}) {
    for (unsigned k = 0; k < scenes(); ++k, ++all) {
      SCOPED_TRACE(testing::Message() << "scene " << k << ", ratio " << ratio);
      auto [scene, y] = random_start(k);
      make_uneven(scene, ratio);
      const ContactResult result = move_uneven(scene, y, 1);
      judge(scene, y, result);
      reached += result ? 1 : 0;
    }
  }
  EXPECT_GE(reached, all * 4 / 5);  // or a solver that ends every motion would pass: one in ten jams here
}

// Scene 29 with a ratio of a million has a light body that jams between a heavy one and a wall. At 1e-7 of the determinant
// rounding of forces stops the steps.
TEST(RandomMotions, OfMassesFarApartSayWhereTheyJam) {
  auto [scene, y] = random_start(29);
  make_uneven(scene, 1e6);
  const ContactResult jammed = integrate_contacts(scene, y, 0, 1, precise);
  EXPECT_EQ(jammed.status, ContactStatus::jams);
  EXPECT_EQ(jammed.contact, 3);
  judge(scene, y, jammed);
}

// Scene 24 with a ratio of a million: two bodies on joints of a third slide on each other until their contact comes onto the
// line of these joints, as teeth of wheels do at their pitch point. The rows of N and T are parallel there: the slip is zero,
// no force stops it, and beyond it goes the other way, where friction draws the bodies into each other (f |W_NT| > W_NN).
// It begins half a millisecond before, where the bodies slide: dozens of impacts on the way there make it depend on rounding.
TEST(RandomMotions, HaveNoSolutionWhereASlipTurnsRoundAndFrictionDrawsIn) {
  auto [scene, y] = random_start(24);
  make_uneven(scene, 1e6);
  y = {1.478697862,  0.1869624222, 0.9593622804,  0.4289911461, 1.376313944,  -1.221385982, 0, 0, 0, 0, 0, 0,
       -9.453894267, 1.973188248,  -0.3846849159, -1.635498781, -12.57558888, 26.99075477,  0, 0, 0, 0, 0, 0};
  const ContactResult result = integrate_contacts(scene, y, 0, 1, precise);
  EXPECT_EQ(result.status, ContactStatus::no_solution);
  EXPECT_EQ(result.contact, 0);
  const plane_truth::PlaneTruth truth(scene, y);
  ASSERT_EQ(truth.touches.size(), 1U);
  const auto N = truth.J.row(0), T = truth.J.row(1);
  EXPECT_LT((N * N.dot(T) - T * N.squaredNorm()).norm(), 1e-12L * N.squaredNorm() * T.norm());
  EXPECT_GT(truth.touches[0].friction * std::abs(truth.W(0, 1)), 2 * truth.W(0, 0));
  judge(scene, y, result);
}

// From its own start that scene comes to the pitch point by an impact. Sticking has no impulses there, and a slide draws in, or is
// turned round by Newton's law: that law has no solution, while rigid bodies have accelerations. Once that was `no_solution`.
TEST(RandomMotions, SayWhereALawOfImpactHasNoSolution) {
  auto [scene, y] = random_start(24);
  make_uneven(scene, 1e6);
  const ContactResult result = move_uneven(scene, y, 1);
  EXPECT_EQ(result.status, ContactStatus::no_impact);
  EXPECT_EQ(result.contact, 0);
  judge(scene, y, result);
  EXPECT_TRUE(plane_truth::PlaneTruth(scene, y).goes_on());
  // Poisson's law has one there, which begins with compression alone.
  ContactResult by_poisson = integrate_contacts(scene, y, 0, 1e-9, precise, {.law = ImpactLaw::poisson});
  EXPECT_NE(by_poisson.status, ContactStatus::no_impact);
  EXPECT_NE(by_poisson.status, ContactStatus::no_solution);
}

// Scene 6: a body of 10^6 kg on a link of 1 kg, to which another one closes a loop. Its motion is another than that of equal
// masses, and as smooth: it takes about as many steps, 28 instead of 21. Where A M^-1 A^T is formed, accelerations have so few
// digits that there are 16093.
TEST(RandomMotions, OfALoopOfMassesFarApartTakeAsManyStepsAsOfEqualOnes) {
  std::array<std::int64_t, 2> steps{};
  for (const bool uneven : {false, true}) {
    auto [scene, y] = random_start(6);
    if (uneven) make_uneven(scene, 1e6);
    const ContactResult result = integrate_contacts(scene, y, 0, 1, precise);
    EXPECT_TRUE(result) << describe(result.status);
    EXPECT_EQ(result.events, 0);
    steps[uneven ? 1 : 0] = result.integration.statistics.accepted;
  }
  EXPECT_LE(steps[1], 2 * steps[0]);
}

// Scene 38: four bodies in a loop, of which several contacts strike at once with friction. Newton's law would give energy.
TEST(RandomMotions, EndWhereTheLawOfImpactWouldGiveEnergy) {
  auto [scene, y] = random_start(38);
  const ContactResult result = integrate_contacts(scene, y, 0, 1, precise);
  EXPECT_EQ(result.status, ContactStatus::energy_gained);
  EXPECT_GE(result.contact, 0);
  judge(scene, y, result);
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
      EXPECT_EQ(step_contacts(scene, y, 0, 0.8, {.count = steps}), ContactStatus::reached_end);
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
