// SPDX-License-Identifier: GPL-3.0-or-later
// Nothing is fused here: each lane has the bits, and the steps, of its member alone.
#include "torsor/runtime/batch/packed_taylor.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "generated/double_pendulum.hpp"
#include "generated/heavy_top.hpp"
#include "generated/torque_free_body.hpp"
#include "tests/batch/packed_records.hpp"

namespace torsor::packed_taylor_test {

using namespace torsor::runtime;
using packed_records::different;
using Pendulum = double_pendulum::Mechanism<double>;
using Top = heavy_top::Mechanism<double>;
using Body = torque_free_body::Mechanism<double>;

Taylor of_tolerance(double tolerance) { return {.relative_tolerance = tolerance, .absolute_tolerance = tolerance}; }

/// Pendulums that swing, and some that turn over.
Member<Pendulum> pendulum(std::uint64_t i) {
  Member<Pendulum> member;
  const auto x = static_cast<double>(i);
  member.state.q[0] = 0.3 + 0.2 * x;
  member.state.q[1] = 2.0 - 0.15 * x;
  member.state.v[0] = 0.1 * x * x;
  return member;
}

Member<Body> body(std::uint64_t i) {
  Member<Body> member;
  const auto x = static_cast<double>(i);
  member.parameters.I2 = member.parameters.I1 * (1.1 + 0.01 * x);
  for (int k = 0; k < 3; ++k) member.state.v[k] = 2.0 - 0.3 * k + 0.05 * x;
  return member;
}

TEST(PackedTaylor, GivesEachMemberTheBitsOfItsSingleRun) {
  for (const double tolerance : {1e-4, 1e-9, 1e-14}) {
    EXPECT_EQ((different<double_pendulum::Mechanism>(11, pendulum, of_tolerance(tolerance))), 0) << tolerance;
  }
  EXPECT_EQ((different<double_pendulum::Mechanism>(11, pendulum, Taylor{.order = 7, .largest_step = 0.03})), 0);
  EXPECT_EQ((different<double_pendulum::Mechanism>(11, pendulum, Taylor{.first_step = 0.5, .compensated = true})), 0);
}

TEST(PackedTaylor, TakesParametersOfEachMemberAndNormsOfQuaternions) {
  for (const bool compensated : {false, true}) {
    Taylor method = of_tolerance(1e-10);
    method.compensated = compensated;
    std::vector<double> records;
    EXPECT_EQ((different<torque_free_body::Mechanism>(11, body, method, &records)), 0);
    const std::size_t numbers = records.size() / 11;
    for (std::size_t i = 0; i < 11; ++i) {
      const double* w = &records[(i + 1) * numbers - 7];  // at the end
      // Four squares and a sum, rounded; compensated sums leave a correction within 4 roundings undone.
      EXPECT_NEAR(w[0] * w[0] + w[1] * w[1] + w[2] * w[2] + w[3] * w[3], 1.0, compensated ? 4e-15 : 1e-15);
    }
  }
}

/// Three members in four lanes: states, status and statistics are those of members alone. Gives the results.
std::vector<Result<double>> as_alone(const std::vector<Member<Pendulum>>& members, const std::vector<double>& times,
                                     const Taylor& method) {
  PackedTaylor<double_pendulum::Mechanism, double, NoInputs, 4> motions(members, method, {}, {});
  std::vector<std::vector<StateVector<Pendulum>>> found(members.size()), expected = found;
  motions.integrate_through(times, [&](std::size_t i, std::size_t k, const StateVector<Pendulum>& y) {
    EXPECT_EQ(k, found[i].size());
    found[i].push_back(y);
  });
  std::vector<Result<double>> results;
  for (std::size_t i = 0; i < members.size(); ++i) {
    auto y = pack<Pendulum>(members[i].state);
    const auto alone =
        integrate_through(equations_of_motion<Pendulum>(), y, members[i].state.time, times, method,
                          [&](double, const StateVector<Pendulum>& state) { expected[i].push_back(state); });
    const Result<double>& result = motions.result(i);
    EXPECT_EQ(motions.state(i), y) << i;
    EXPECT_EQ(result.time, alone.time) << i;
    EXPECT_EQ(result.status, alone.status) << i;
    EXPECT_EQ(result.evaluation, alone.evaluation) << i;
    EXPECT_EQ(result.statistics.accepted, alone.statistics.accepted) << i;
    EXPECT_EQ(result.statistics.rejected, alone.statistics.rejected) << i;
    EXPECT_EQ(result.statistics.calls, alone.statistics.calls) << i;
    results.push_back(result);
  }
  EXPECT_EQ(found, expected);
  return results;
}

TEST(PackedTaylor, RefusesStepsAndEndsInEachLaneForItself) {
  std::vector<Member<Pendulum>> members = {pendulum(0), pendulum(8), pendulum(2)};
  members[2].state.time = 2.5;  // backwards, and back
  Taylor method = of_tolerance(1e-9);
  method.first_step = 0.5;  // refused, by more or less
  const auto results = as_alone(members, {2.0, 3.0}, method);
  for (const Result<double>& result : results) {
    EXPECT_EQ(result.status, IntegrationStatus::reached_end);
    EXPECT_EQ(result.time, 3.0);
  }
  EXPECT_GT(results[0].statistics.rejected, 0);
  EXPECT_GT(results[1].statistics.rejected, results[0].statistics.rejected);
  EXPECT_NE(results[0].statistics.accepted, results[1].statistics.accepted);
}

// Polynomials of degree 30 lead two lanes to rates whose squares are not finite; the third rests, and is at its end in
// one step.
TEST(PackedTaylor, AsksWhichLanesFailWhereThePackDoes) {
  std::vector<Member<Pendulum>> members = {pendulum(0), Member<Pendulum>{}, pendulum(8)};
  members[1].state = {};
  const Taylor method{.order = 30, .first_step = 1e6, .step_limit = 100};
  const auto results = as_alone(members, {1e6}, method);
  EXPECT_EQ(results[0].status, IntegrationStatus::too_many_steps);
  EXPECT_EQ(results[1].status, IntegrationStatus::reached_end);
  EXPECT_EQ(results[1].statistics.accepted, 1);
  EXPECT_EQ(results[2].status, IntegrationStatus::too_many_steps);
}

// Against an absolute tolerance alone small motions take order 4 and large ones 20; those that grow change it.
TEST(PackedTaylor, GivesEachLaneItsOrder) {
  const auto members = [](std::uint64_t i) {
    Member<Pendulum> member;
    member.state.q[0] = std::pow(10.0, static_cast<double>(i % 8) - 7.0);
    if (i % 3 == 2) member.state.q[1] = 3.14159265358979;  // falls
    return member;
  };
  const Taylor method{.relative_tolerance = 0.0, .absolute_tolerance = 1e-8};
  EXPECT_EQ((different<double_pendulum::Mechanism>(16, members, method)), 0);
}

TEST(PackedTaylor, LetsALaneThatFailsBe) {
  // Outer axes that agree, at the start; rates without bounds; no state at all; another start; a start at the end.
  const auto members = [](std::uint64_t i) {
    Member<Top> member;
    for (int k = 0; k < 3; ++k) member.state.q[k] = 0.3 + 0.01 * static_cast<double>(i) + 0.1 * k;
    if (i % 4 == 1) member.state.q[1] = std::acos(0.0);
    if (i == 2) member.state.v[1] = 1e200;
    if (i == 4) member.state.q[0] = std::numeric_limits<double>::quiet_NaN();
    if (i == 6) member.state.time = 0.05;
    if (i == 7) member.state.time = 0.1;
    if (i == 8) member.state.time = std::numeric_limits<double>::infinity();
    return member;
  };
  std::vector<double> records;
  EXPECT_EQ((different<heavy_top::Mechanism>(11, members, of_tolerance(1e-9), &records)), 0);
  const std::size_t numbers = records.size() / 11;
  for (std::size_t i = 0; i < 11; ++i) {
    const bool invalid = i == 4 || i == 8, fails = i % 4 == 1 || i == 2;
    const IntegrationStatus expected = invalid ? IntegrationStatus::invalid_options
                                       : fails ? IntegrationStatus::model_failure
                                               : IntegrationStatus::reached_end;
    EXPECT_EQ(records[i * numbers], static_cast<double>(expected)) << i;
  }
}

// In its lane of the pack stands another one: what is told of it is its own all the same.
TEST(PackedTaylor, TellsTheStartOfAMemberThatCannotStart) {
  std::vector<Member<Pendulum>> members = {pendulum(0), pendulum(1), pendulum(2)};
  members[1].state.v[0] = 1e200;  // its square is infinite
  const auto results = as_alone(members, {0.0, 0.5}, of_tolerance(1e-9));
  EXPECT_EQ(results[0].status, IntegrationStatus::reached_end);
  EXPECT_EQ(results[1].status, IntegrationStatus::model_failure);
  EXPECT_EQ(results[2].status, IntegrationStatus::reached_end);
}

TEST(PackedTaylor, SaysOfInvalidOptionsWhatMembersAloneSay) {
  for (const int order : {-1, 3, 31}) {
    EXPECT_EQ((different<double_pendulum::Mechanism>(3, pendulum, Taylor{.order = order})), 0);
  }
  EXPECT_EQ((different<double_pendulum::Mechanism>(3, pendulum, Taylor{.relative_tolerance = 1e-16})), 0);
}

}  // namespace torsor::packed_taylor_test
