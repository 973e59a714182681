// SPDX-License-Identifier: GPL-3.0-or-later
// Nothing is fused here: the members of a pack have the bits of members alone.
#include "torsor/runtime/batch/packed_motion_ensemble.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <span>
#include <vector>

#include "generated/heavy_top.hpp"
#include "generated/satellite_arms.hpp"
#include "generated/torque_free_body.hpp"
#include "generated/turning_slot.hpp"
#include "tests/batch/packed_records.hpp"
#include "tests/runtime/temporary_folder.hpp"

namespace torsor::packed_ensemble_test {

using namespace torsor::runtime;
using namespace torsor::packed_records;
using Top = heavy_top::Mechanism<double>;
using Body = torque_free_body::Mechanism<double>;

/// Tops from states of their own; a pack's first start at the same time.
Member<Top> top(std::uint64_t i) {
  Member<Top> member;
  const auto x = static_cast<double>(i);
  for (int k = 0; k < 3; ++k) {
    member.state.q[k] = 0.3 + 0.01 * x + 0.1 * k;
    member.state.v[k] = 1.0 - 0.02 * x * (k + 1);
  }
  return member;
}

/// Bodies with inertias of their own, whose quaternions every step brings back to their norm.
Member<Body> body(std::uint64_t i) {
  Member<Body> member;
  const auto x = static_cast<double>(i);
  member.parameters.I2 = member.parameters.I1 * (1.1 + 0.01 * x);
  for (int k = 0; k < 3; ++k) member.state.v[k] = 2.0 - 0.3 * k + 0.05 * x;
  return member;
}

// 11 members: the last pack is not full, whatever the number of lanes.
TEST(PackedEnsemble, GivesEachMemberTheBitsOfItsSingleRun) {
  std::vector<double> records;
  EXPECT_EQ((different<heavy_top::Mechanism>(11, top, RungeKutta4{.step = 3e-3}, &records)), 0);
  // They went to the end: 4 evaluations for each of 34 + 50 + 250 steps.
  const std::size_t numbers = records.size() / 11;
  for (std::size_t i = 0; i < 11; ++i) {
    EXPECT_EQ(records[i * numbers], 0.0);
    EXPECT_EQ(records[i * numbers + 2], 1.0);
    EXPECT_EQ(records[i * numbers + 3], 4.0 * (34 + 50 + 250));
    EXPECT_TRUE(std::isfinite(records[i * numbers + numbers - 1]));
  }
  EXPECT_EQ((different<heavy_top::Mechanism>(11, top, RungeKutta4{.step = 3e-3, .compensated = true})), 0);
  EXPECT_EQ((different<heavy_top::Mechanism>(11, top, Midpoint{.step = 3e-3})), 0);
}

TEST(PackedEnsemble, AsksForMembersAgainWhereAGroupFailsOnly) {
  constexpr int lanes = native_lanes<double>;
  int asked = 0;
  const auto counted = [&asked](std::uint64_t i) {
    ++asked;
    return top(i);
  };
  const auto ensemble = packed_motion_ensemble<heavy_top::Mechanism, double>({.count = 3 * lanes, .times = times},
                                                                             counted, RungeKutta4{0.1});
  const RecordHead head = ensemble.head();
  asked = 0;
  records_of(ensemble, head);
  EXPECT_EQ(asked, 3 * lanes);
  const auto failing = packed_motion_ensemble<heavy_top::Mechanism, double>(
      {.count = 3 * lanes, .times = times},
      [&asked](std::uint64_t i) {
        ++asked;
        Member<Top> member = top(i);
        if (i == lanes) member.state.q[1] = std::acos(0.0);
        return member;
      },
      RungeKutta4{0.1});
  asked = 0;
  records_of(failing, head);
  EXPECT_EQ(asked, 4 * lanes);
}

// A point that a constraint holds in a slot: members are put back on it after every step, and packs are not.
template <class Method>
void expect_held_members(const Method& method) {
  using Slot = turning_slot::Mechanism<double>;
  const auto members = [](std::uint64_t i) {
    Member<Slot> member;
    for (int k = 0; k < Slot::velocity_count; ++k) member.state.v[k] *= 1.0 + 0.01 * static_cast<double>(i);
    return member;
  };
  const EnsemblePlan<double> plan{.count = 7, .times = times};
  const auto packed = packed_motion_ensemble<turning_slot::Mechanism, double>(plan, members, method);
  const auto alone = motion_ensemble<Slot>(plan, members, method);
  const RecordHead head = alone.head();
  EXPECT_EQ(packed.head().question, head.question);
  const std::vector<double> records = records_of(packed, head);
  for (std::uint64_t i = 0; i < head.count; ++i) {
    std::vector<double> expected(head.numbers);
    alone(i, expected);
    EXPECT_EQ(std::memcmp(expected.data(), &records[i * head.numbers], head.numbers * sizeof(double)), 0) << i;
  }
}
TEST(PackedEnsemble, HoldsMembersOnTheirConstraints) {
  expect_held_members(RungeKutta4{.step = 3e-3});
  expect_held_members(Midpoint{.step = 3e-3});
}

/// Body 3, with a quaternion of another size for each i; that of zeros where i is 5.
Member<Body> body_of_any_norm(std::uint64_t i) {
  Member<Body> member = body(3);
  const double size = i == 5 ? 0.0 : std::array{1.0, 1.01, 0x1p-600, 2.0}[i % 4];
  const std::array<double, 4> attitude{0.5, -0.5, 0.7, 0.1};
  for (int k = 0; k < 4; ++k) member.state.q[Body::quaternions[0] + k] = size * attitude[static_cast<std::size_t>(k)];
  return member;
}

template <class Method>
void expect_unit_quaternions(const Method& method) {
  std::vector<double> records;
  EXPECT_EQ((different<torque_free_body::Mechanism>(8, body_of_any_norm, method, &records)), 0);
  const std::size_t numbers = records.size() / 8;
  for (std::size_t i = 0; i < 8; ++i) {
    const MemberMotion<Body> first = member_motion<Body>(std::span(records).first(numbers)),
                             found = member_motion<Body>(std::span(records).subspan(i * numbers, numbers));
    if (i == 5) {
      EXPECT_EQ(found.status, IntegrationStatus::model_failure);
      EXPECT_EQ(found.evaluation, Evaluation::not_finite);
      EXPECT_TRUE(found.states.empty());
      continue;
    }
    ASSERT_EQ(found.status, IntegrationStatus::reached_end);
    for (std::size_t time = 0; time < times.size(); ++time) {
      for (std::size_t k = 0; k < first.states[time].size(); ++k) {
        EXPECT_NEAR(found.states[time][k], first.states[time][k], 1e-12) << i;
      }
    }
  }
}
TEST(PackedEnsemble, StartsWithUnitQuaternions) {
  expect_unit_quaternions(RungeKutta4{.step = 5e-3});
  expect_unit_quaternions(Taylor{.relative_tolerance = 1e-13, .absolute_tolerance = 1e-13});
}

TEST(PackedEnsemble, TakesParametersOfEachMemberAndNormsOfQuaternions) {
  std::vector<double> records;
  EXPECT_EQ((different<torque_free_body::Mechanism>(11, body, RungeKutta4{.step = 5e-3}, &records)), 0);
  const std::size_t numbers = records.size() / 11;
  const double* w = &records[numbers - 7];  // of the first member, at the end
  // Four squares and a sum, rounded; the steps alone would be 1e-10 away.
  EXPECT_NEAR(w[0] * w[0] + w[1] * w[1] + w[2] * w[2] + w[3] * w[3], 1.0, 1e-15);
  EXPECT_NE(records[numbers - 1], records[2 * numbers - 1]);
}

TEST(PackedEnsemble, ComputesAGroupWithAFailureMemberByMember) {
  // The middle axis turned so far that the outer ones agree, at once; and rates without bounds.
  const auto members = [](std::uint64_t i) {
    Member<Top> member = top(i);
    if (i == 5) member.state.q[1] = std::acos(0.0);
    if (i == 9) member.state.v[1] = 1e200;
    return member;
  };
  std::vector<double> records;
  EXPECT_EQ((different<heavy_top::Mechanism>(11, members, RungeKutta4{.step = 3e-3}, &records)), 0);
  const std::size_t numbers = records.size() / 11;
  for (std::size_t i = 0; i < 11; ++i) {
    const bool fails = i == 5 || i == 9;
    EXPECT_EQ(records[i * numbers] == static_cast<double>(IntegrationStatus::model_failure), fails) << i;
    EXPECT_EQ(std::isnan(records[i * numbers + numbers - 1]), fails) << i;
  }
}

TEST(PackedEnsemble, ComputesMembersThatStartAtDifferentTimesAlone) {
  const auto members = [](std::uint64_t i) {
    Member<Top> member = top(i);
    member.state.time = i == 3 ? 0.05 : 0.0;
    return member;
  };
  EXPECT_EQ((different<heavy_top::Mechanism>(11, members, RungeKutta4{.step = 3e-3})), 0);
}

/// Torques of the arms by gains that are set when the law is made.
template <class M>
struct Regulator {
  ScalarOf<M> stiffness, damping;
  typename M::Inputs operator()(const typename M::State& state) const noexcept {
    typename M::Inputs inputs{};
    for (int i = 0; i < 2; ++i) inputs[i] = -(stiffness * state.q[i + 1] + damping * state.v[i + 1]);
    return inputs;
  }
};

template <class... Laws>
concept TakesLaws = requires(Member<satellite_arms::Mechanism<double>> (*members)(std::uint64_t), Laws... laws) {
  packed_motion_ensemble<satellite_arms::Mechanism, double, Regulator>({.count = 1, .times = times}, members,
                                                                       RungeKutta4{}, {laws...});
};

TEST(PackedEnsemble, TakesTheGainsOfItsLaws) {
  using Arms = satellite_arms::Mechanism<double>;
  using Alone = Regulator<Arms>;
  using InPacks = Regulator<satellite_arms::Mechanism<NativeSimd<double>>>;
  // A law for members alone would leave packs to gains of zero: both, or none.
  static_assert(TakesLaws<Alone, InPacks> && !TakesLaws<Alone> && !TakesLaws<>);
  const auto members = [](std::uint64_t i) {
    Member<Arms> member;
    for (int k = 0; k < 3; ++k) member.state.q[k] = 0.2 + 0.05 * static_cast<double>(i) - 0.1 * k;
    return member;
  };
  const RungeKutta4 method{.step = 5e-3};
  const EnsemblePlan<double> plan{.count = 11, .times = times, .label = "regulated"};
  const auto records_with = [&](double stiffness, double damping) {
    using Pack = NativeSimd<double>;
    const auto packed = packed_motion_ensemble<satellite_arms::Mechanism, double, Regulator>(
        plan, members, method, {Alone{stiffness, damping}, InPacks{Pack(stiffness), Pack(damping)}});
    const auto alone = motion_ensemble<Arms>(plan, members, method, Alone{stiffness, damping});
    const RecordHead head = alone.head();
    const std::vector<double> records = records_of(packed, head);
    for (std::uint64_t i = 0; i < 11; ++i) {
      std::vector<double> expected(head.numbers);
      alone(i, expected);
      EXPECT_EQ(std::memcmp(expected.data(), &records[i * head.numbers], head.numbers * sizeof(double)), 0) << i;
      EXPECT_EQ(records[i * head.numbers], static_cast<double>(IntegrationStatus::reached_end));
    }
    return records;
  };
  EXPECT_NE(records_with(3.0, 0.5), records_with(0.0, 0.0));
}

TEST(PackedEnsemble, SaysOfInvalidOptionsWhatMembersAloneSay) {
  EXPECT_EQ((different<heavy_top::Mechanism>(3, top, RungeKutta4{.step = 0.0})), 0);
}

class PackedEnsembleFile : public TemporaryFolder {};

TEST_F(PackedEnsembleFile, DoesNotDependOnThreadsAndResumesInsideAGroup) {
  const auto ensemble = packed_motion_ensemble<heavy_top::Mechanism, double>({.count = 150, .times = {0.1}}, top,
                                                                             RungeKutta4{.step = 0.01});
  const RecordHead head = ensemble.head();
  run_ensemble(folder / "one", head, ensemble.groups());
  const std::string expected = contents(folder / "one");
  const Records records = read_records(folder / "one");
  ASSERT_TRUE(records.complete());
  EXPECT_EQ(member_motion<Top>(records[149]).states.size(), 1U);
  run_ensemble(folder / "three", head, ensemble.groups(), {.threads = 3});
  EXPECT_EQ(contents(folder / "three"), expected);
  // 7 words, then two more than the numbers of each record: see runtime/records/record_file.hpp
  const std::size_t record = (head.numbers + 2) * 8;
  for (const std::size_t kept : {0U, 1U, 2U, 3U, 5U, 66U, 149U}) {
    for (const unsigned threads : {1U, 2U}) {
      put("cut", expected.substr(0, 56 + kept * record));
      const EnsembleProgress progress = run_ensemble(folder / "cut", head, ensemble.groups(), {.threads = threads});
      EXPECT_EQ(progress.found, kept);
      EXPECT_EQ(contents(folder / "cut"), expected) << kept << " kept, " << threads << " threads";
    }
  }
}

TEST_F(PackedEnsembleFile, EndsWhenTheCallbackSaysSoAndGoesOn) {
  const auto ensemble = packed_motion_ensemble<heavy_top::Mechanism, double>({.count = 150, .times = {0.1}}, top,
                                                                             RungeKutta4{.step = 0.01});
  run_ensemble(folder / "whole", ensemble.head(), ensemble.groups());
  const auto until = [](std::uint64_t most) { return [most](const EnsembleProgress& p) { return p.done < most; }; };
  run_ensemble(folder / "parts", ensemble.head(), ensemble.groups(), {.progress = until(10)});
  const EnsembleProgress last = run_ensemble(folder / "parts", ensemble.head(), ensemble.groups(), {.threads = 2});
  EXPECT_GE(last.found, 10U);
  EXPECT_LT(last.found, 150U);
  EXPECT_EQ(contents(folder / "parts"), contents(folder / "whole"));
}

}  // namespace torsor::packed_ensemble_test
