// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/runtime/batch/batch.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <concepts>
#include <cstring>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "generated/heavy_top.hpp"
#include "tests/runtime/mechanisms.hpp"

namespace {

using namespace torsor::runtime;
using Tops = BatchOf<heavy_top::Mechanism, double>;
using Top = Tops::Single;

Top::State random_state(std::mt19937& random) {
  std::uniform_real_distribution<double> angle(-1.3, 1.3), rate(-3, 3);
  Top::State state{};
  state.time = rate(random);
  for (int i = 0; i < 3; ++i) state.q[i] = angle(random);
  for (int i = 0; i < 3; ++i) state.v[i] = rate(random);
  return state;
}

Tops::States random_states(std::size_t size, unsigned seed) {
  std::mt19937 random(seed);
  Tops::States states(size);
  for (std::size_t i = 0; i < size; ++i) states.set(i, random_state(random));
  return states;
}

template <class Value>
bool same_bits(const Value& a, const Value& b) {
  return std::memcmp(&a, &b, sizeof(Value)) == 0;
}

/// What one state alone gives.
Evaluation alone(const Top::State& state, Top::Accelerations& a) {
  Top::Multipliers none;
  return to_evaluation(Top::forward_dynamics(Top::precompute(Top::default_parameters()), state, {}, a, none));
}

struct Results {
  Tops::Accelerations a;
  std::vector<Evaluation> statuses;
  BatchReport report;

  Results(const Tops::States& states, unsigned threads)
      : a(states.size()), statuses(states.size(), Evaluation::not_finite) {
    const Tops tops;
    Tops::Multipliers none(states.size());
    report =
        tops.forward_dynamics(states, Tops::Inputs(states.size()), a, none, {.threads = threads, .statuses = statuses});
  }
};

TEST(Batch, KeepsWhatIsPutIntoIt) {
  std::mt19937 random(1);
  for (const std::size_t size : {1U, 2U, 3U, 7U, 64U}) {
    Tops::States states(size, random_state(random));
    std::vector<Top::State> expected;
    for (std::size_t i = 0; i < size; ++i) {
      expected.push_back(random_state(random));
      states.set(i, expected.back());
    }
    ASSERT_EQ(states.entries(), 7U);
    for (std::size_t i = 0; i < size; ++i) {
      EXPECT_TRUE(same_bits(states[i], expected[i]));
      EXPECT_EQ(states.entry(i, 2), expected[i].q[1]);
      states.set_entry(i, 2, 0.25);
      EXPECT_EQ(states[i].q[1], 0.25);
      EXPECT_EQ(states[i].q[2], expected[i].q[2]);
    }
  }
}

TEST(Batch, StoresOneEntryOfConsecutiveStatesSideBySide) {
  const Tops::States states = random_states(9, 2);
  constexpr int lanes = native_lanes<double>;
  for (std::size_t i = 0; i < states.size(); ++i) {
    EXPECT_EQ(states.block(i / lanes).v[1][static_cast<int>(i % lanes)], states[i].v[1]);
  }
}

TEST(Batch, StartsWithOneValueEverywhere) {
  std::mt19937 random(3);
  const Top::State state = random_state(random);
  const Tops::States states(5, state);
  for (std::size_t i = 0; i < states.size(); ++i) EXPECT_TRUE(same_bits(states[i], state));
  EXPECT_EQ(Tops::States(0).block_count(), 0U);
}

// These files are compiled without fused operations.
TEST(BatchOf, GivesEveryStateWhatItGivesAlone) {
  for (const std::size_t size : {0U, 1U, 2U, 3U, 5U, 17U, 1000U}) {
    const Tops::States states = random_states(size, 4);
    const Results results(states, 1);
    EXPECT_TRUE(results.report);
    for (std::size_t i = 0; i < size; ++i) {
      Top::Accelerations a;
      EXPECT_EQ(alone(states[i], a), results.statuses[i]);
      EXPECT_TRUE(same_bits(results.a[i], a)) << i << " of " << size;
    }
  }
}

TEST(BatchOf, DoesNotDependOnTheNumberOfThreads) {
  Tops::States states = random_states(1003, 5);
  for (const std::size_t i : {0U, 17U, 500U, 1002U}) states.set_entry(i, 2, std::acos(0.0));
  const Results expected(states, 1);
  EXPECT_EQ(expected.report.failed, 4U);
  for (const unsigned threads : {2U, 3U, 8U, 0U, 2000U}) {
    const Results found(states, threads);
    EXPECT_EQ(found.report.failed, expected.report.failed) << threads;
    EXPECT_EQ(found.report.worst, expected.report.worst) << threads;
    EXPECT_EQ(found.statuses, expected.statuses) << threads;
    for (std::size_t i = 0; i < states.size(); ++i) EXPECT_TRUE(same_bits(found.a[i], expected.a[i])) << threads;
  }
}

TEST(BatchOf, SaysWhichForcesAreNoNumbers) {
  Tops::States states = random_states(20, 8);
  states.set_entry(12, 4, std::numeric_limits<double>::max());  // a rate whose square is no number
  const Tops tops;
  const Tops::Accelerations a(20);
  const Tops::Multipliers none(20);
  Tops::Forces forces(20);
  std::vector<Evaluation> statuses(20, Evaluation::singular);
  const BatchReport report = tops.inverse_dynamics(states, a, none, forces, {.statuses = statuses});
  EXPECT_EQ(report.failed, 1U);
  EXPECT_EQ(report.worst, Evaluation::not_finite);
  for (std::size_t i = 0; i < 20; ++i) {
    EXPECT_EQ(statuses[i], i == 12 ? Evaluation::not_finite : Evaluation::ok) << i;
    Top::GeneralizedForces expected;
    Top::inverse_dynamics(tops.single(), states[i], {}, {}, expected);
    EXPECT_TRUE(i == 12 || same_bits(forces[i], expected)) << i;
  }
}

TEST(BatchOf, SaysWhichStatesFailedAndSparesTheirNeighbours) {
  Tops::States states = random_states(20, 6);
  states.set_entry(5, 2, std::acos(0.0));                             // two axes agree
  states.set_entry(12, 4, std::numeric_limits<double>::max());        // a rate whose square is no number
  states.set_entry(19, 4, std::numeric_limits<double>::quiet_NaN());  // the last, beside lanes that hold no state
  const Results results(states, 1);
  EXPECT_EQ(results.report.failed, 3U);
  EXPECT_EQ(results.report.worst, Evaluation::not_finite);
  EXPECT_FALSE(results.report);
  for (std::size_t i = 0; i < states.size(); ++i) {
    Top::Accelerations a;
    const Evaluation evaluation = alone(states[i], a);
    EXPECT_EQ(results.statuses[i], evaluation) << i;
    EXPECT_EQ(evaluation == Evaluation::ok, i != 5 && i != 12 && i != 19) << i;
    EXPECT_TRUE(evaluation != Evaluation::ok || same_bits(results.a[i], a)) << i;
  }
}

TEST(BatchOf, FinishesTheNeighboursOfAStateThatAKernelGaveUp) {
  Tops::States states = random_states(20, 8);
  for (const std::size_t i : {5U, 19U}) states.set_entry(i, 2, std::acos(0.0));  // two axes agree
  Tops::Arrays<1> kinetic(20);
  std::vector<Evaluation> statuses(20, Evaluation::not_finite);
  const auto kernel = []<class M>(std::type_identity<M>, const auto& precomputed, const typename M::State& state,
                                  auto& result) {
    // Roundings of fused operations differ between numbers and packs: packs alone tell what becomes of a pack's lane.
    static_assert(std::same_as<M, Tops::Packed>);
    typename M::Accelerations a;
    typename M::Multipliers none;
    const auto status = M::forward_dynamics(precomputed, state, {}, a, none);
    if (status != torsor::Status::ok) return status;
    typename M::Energy energy;
    M::energy(precomputed, state, {}, energy);
    result[0] = energy.kinetic;
    return status;
  };
  const BatchReport report = Tops().for_each(kernel, {.statuses = statuses}, states, kinetic);
  EXPECT_EQ(report.failed, 2U);
  for (std::size_t i = 0; i < states.size(); ++i) {
    ASSERT_EQ(statuses[i] == Evaluation::ok, i != 5 && i != 19) << i;
    Top::Energy energy;
    Top::energy(Tops().single(), states[i], {}, energy);
    EXPECT_EQ(kinetic[i][0], statuses[i] == Evaluation::ok ? energy.kinetic : 0.0) << i;
  }
}

TEST(BatchOf, RefusesBatchesAndStatusesOfDifferentSizes) {
  const Tops tops;
  const Tops::States states(9);
  Tops::Accelerations a(9), fewer(8);
  Tops::Multipliers none(9);
  std::vector<Evaluation> statuses(8);
  const auto error_of = [&](const Tops::Inputs& inputs, Tops::Accelerations& results, const BatchOptions& options) {
    try {
      tops.forward_dynamics(states, inputs, results, none, options);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(error_of(Tops::Inputs(9), a, {}), "");
  EXPECT_EQ(error_of(Tops::Inputs(8), a, {}),
            "BatchOf: one batch holds 9 states and another 8; give them one size");
  EXPECT_NE(error_of(Tops::Inputs(9), fewer, {}), "");
  EXPECT_EQ(error_of(Tops::Inputs(9), a, {.statuses = statuses}),
            "BatchOf: there are 8 statuses for 9 states; give one for each, or none");
}

TEST(BatchOf, TakesParametersForAllAndInputsForEach) {
  using Oscillators = BatchOf<mechanisms::Oscillator, double>;
  // 2 x'' = -8 x + u
  const Oscillators oscillators({2.0, 8.0});
  Oscillators::States states(5);
  Oscillators::Inputs inputs(5);
  for (std::size_t i = 0; i < 5; ++i) {
    states.set(i, {0.0, {{double(i)}}, {{1.0}}});
    inputs.set(i, {{6.0 - double(i)}});
  }
  Oscillators::Accelerations a(5);
  Oscillators::Multipliers none(5);
  ASSERT_TRUE(oscillators.forward_dynamics(states, inputs, a, none));
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(a[i][0], 3.0 - 4.5 * double(i));
}

TEST(BatchOf, TakesAKernelOfTheUsersWithParametersForEach) {
  using Oscillators = BatchOf<mechanisms::Oscillator, float>;
  Oscillators::Parameters parameters(11);
  for (std::size_t i = 0; i < 11; ++i) parameters.set(i, {float(1U << (i % 4)), float(i)});
  const Oscillators::States states(11, {0.0F, {{2.0F}}, {{0.0F}}});
  Oscillators::Accelerations a(11);
  const auto kernel = []<class M>(std::type_identity<M>, const auto&, const typename M::Parameters& p,
                                  const typename M::State& state, typename M::Accelerations& acceleration) {
    typename M::Multipliers none;
    return M::forward_dynamics(M::precompute(p), state, {}, acceleration, none);
  };
  ASSERT_TRUE(Oscillators().for_each(kernel, {.threads = 2}, parameters, states, a));
  for (std::size_t i = 0; i < 11; ++i) EXPECT_EQ(a[i][0], -2.0F * float(i) / float(1U << (i % 4)));
}

TEST(BatchOf, HasTheOtherKernelsOfAMechanism) {
  const Tops::States states = random_states(6, 7);
  const Tops tops;
  Tops::Accelerations a(6);
  Tops::Multipliers none(6);
  Tops::Forces forces(6);
  ASSERT_TRUE(tops.forward_dynamics(states, Tops::Inputs(6), a, none));
  tops.inverse_dynamics(states, a, none, forces);
  // No motor: what must be supplied is nothing, but for roundings of forces of some hundreds, magnified by 1/cos 1.3.
  for (std::size_t i = 0; i < 6; ++i) {
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(forces[i][k], 0.0, 1e-11);
  }
  Tops::Arrays<9> masses(6);
  tops.for_each([]<class M>(std::type_identity<M>, const auto& precomputed, const typename M::State& state,
                            auto& mass) { M::mass_matrix(precomputed, state, mass); },
                {}, states, masses);
  for (std::size_t i = 0; i < 6; ++i) {
    std::array<double, 9> mass;
    Top::mass_matrix(tops.single(), states[i], mass);
    EXPECT_EQ(masses[i], mass);
  }
}

}  // namespace
