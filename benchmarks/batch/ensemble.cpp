// SPDX-License-Identifier: GPL-3.0-or-later
// Compiled for this processor, as packs.cpp is. The build defines MODEL_HEADER.
#include "benchmarks/batch/ensemble.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>

#include MODEL_HEADER
#include "runtime/batch/packed_motion_ensemble.hpp"

namespace {

using namespace torsor::runtime;

constexpr std::uint64_t member_count = 16;  // few: a turn that another program interrupts would take several
constexpr int step_count = 10;
constexpr RungeKutta4 method{.step = 1e-3};

template <class Number>
Member<panda::Mechanism<Number>> member(std::uint64_t i) {
  Member<panda::Mechanism<Number>> result;
  for (int k = 0; k < 7; ++k) {
    result.state.q[k] = static_cast<Number>(0.1 * k + 0.01 * static_cast<double>(i));
    result.state.v[k] = static_cast<Number>(0.2 - 0.01 * static_cast<double>(i));
  }
  return result;
}

/// One way to compute all members' records.
struct Way {
  EnsembleTimes times;
  std::function<void(std::span<double>)> run;
  std::vector<double> records{}, nanoseconds{}, ratios{};
};

template <class Number>
std::vector<Way> ways(const char* scalar) {
  using M = panda::Mechanism<Number>;
  const std::vector<Number> end = {Number(step_count * 1e-3)};
  const auto alone = motion_ensemble<M>(member_count, member<Number>, end, method);
  const auto packed = std::make_shared<decltype(packed_motion_ensemble<panda::Mechanism, Number>(
      member_count, member<Number>, end, method))>(member_count, member<Number>, end, method);
  const std::size_t numbers = alone.head().numbers;
  const EnsembleGroups groups = packed->groups();
  return {{{"torsor, members alone", scalar, {}},
           [alone, numbers](std::span<double> records) {
             for (std::uint64_t i = 0; i < member_count; ++i) alone(i, records.subspan(i * numbers, numbers));
           },
           std::vector<double>(member_count * numbers)},
          {{"torsor, packs of " + std::to_string(groups.together), scalar, {}},
           [packed, groups, numbers](std::span<double> records) {
             for (std::uint64_t i = 0; i < member_count; i += groups.together)
               groups.compute(i, groups.together, records.subspan(i * numbers, groups.together * numbers));
           },
           std::vector<double>(member_count * numbers)}};
}

/// The greatest difference of a state, as a part of the greatest number. Throws where a member did not reach its end or
/// a number is none.
double difference(const Way& way, const std::vector<double>& expected) {
  const std::vector<double>& records = way.records;
  const std::size_t numbers = records.size() / member_count;
  double greatest = 0, worst = 0;
  for (std::size_t i = 0; i < records.size(); ++i) {
    if (i % numbers == 0 && records[i] != static_cast<double>(IntegrationStatus::reached_end))
      throw std::runtime_error("ensemble: " + way.times.name + ", " + way.times.scalar + ": member " +
                               std::to_string(i / numbers) + " did not reach its end");
    if (i % numbers < 4) continue;  // how it ended, not a state
    const double each = std::abs(records[i] - expected[i]);
    if (!std::isfinite(each))
      throw std::runtime_error("ensemble: " + way.times.name + ", " + way.times.scalar + ": member " +
                               std::to_string(i / numbers) + " has a state that is not finite");
    greatest = std::max(greatest, std::abs(expected[i]));
    worst = std::max(worst, each);
  }
  return worst / greatest;
}

}  // namespace

std::vector<EnsembleTimes> ensemble_times(int turns) {
  std::vector<Way> all = ways<double>("double");
  for (Way& way : ways<float>("float")) all.push_back(std::move(way));
  // Equal results first; float is printed, not bounded.
  for (Way& way : all) way.run(way.records);
  for (Way& way : all) {
    way.times.difference = difference(way, all[0].records);
    if (way.times.scalar == "double" && !(way.times.difference <= 1e-9))
      throw std::runtime_error("ensemble: " + way.times.name + " differs from members alone by " +
                               std::to_string(way.times.difference));
  }
  for (int turn = 0; turn < turns; ++turn) {
    for (Way& way : all) {
      using Clock = std::chrono::steady_clock;
      const auto start = Clock::now();
      way.run(way.records);
      const std::chrono::duration<double, std::nano> taken = Clock::now() - start;
      way.nanoseconds.push_back(taken.count() / static_cast<double>(member_count * step_count));
      way.ratios.push_back(way.nanoseconds.back() / all[0].nanoseconds.back());
    }
  }
  std::vector<EnsembleTimes> times;
  for (Way& way : all) {
    way.times.timing = {kernels::spread_of(way.nanoseconds), kernels::spread_of(way.ratios)};
    times.push_back(way.times);
  }
  return times;
}
