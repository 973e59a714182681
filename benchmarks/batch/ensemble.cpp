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
#include "generated/double_pendulum.hpp"
#include "torsor/runtime/batch/packed_motion_ensemble.hpp"

namespace {

using namespace torsor::runtime;

constexpr std::uint64_t member_count = 16;  // few: a turn that another program interrupts would take several
constexpr int step_count = 10;
constexpr RungeKutta4 method{.step = 1e-3};
constexpr double tolerance = 1e-12;
constexpr Taylor taylor{.relative_tolerance = tolerance, .absolute_tolerance = tolerance};

template <class Number>
Member<panda::Mechanism<Number>> member(std::uint64_t i) {
  Member<panda::Mechanism<Number>> result;
  for (int k = 0; k < 7; ++k) {
    result.state.q[k] = static_cast<Number>(0.1 * k + 0.01 * static_cast<double>(i));
    result.state.v[k] = static_cast<Number>(0.2 - 0.01 * static_cast<double>(i));
  }
  return result;
}

/// Starts as different as those of a study: steps, and how many there are, differ from lane to lane.
Member<double_pendulum::Mechanism<double>> pendulum(std::uint64_t i) {
  Member<double_pendulum::Mechanism<double>> result;
  result.state.q[0] = 1.0 + 0.1 * static_cast<double>(i);
  result.state.q[1] = 2.5 - 0.1 * static_cast<double>(i);
  return result;
}

/// One way to compute all members' records.
struct Way {
  EnsembleTimes times;
  std::function<void(std::span<double>)> run;
  std::vector<double> records{}, nanoseconds{}, ratios{};
};

/// Members alone, and in packs.
template <template <class> class Mechanism, class Number, class Method>
std::vector<Way> ways(const char* quantity, const char* scalar, Member<Mechanism<Number>> (*members)(std::uint64_t),
                      Number end, const Method& by) {
  const EnsemblePlan<Number> plan{.count = member_count, .times = {end}};
  const auto alone = motion_ensemble<Mechanism<Number>>(plan, members, by);
  const auto packed =
      std::make_shared<decltype(packed_motion_ensemble<Mechanism, Number>(plan, members, by))>(plan, members, by);
  const std::size_t numbers = alone.head().numbers;
  const EnsembleGroups groups = packed->groups();
  return {{{quantity, "torsor, members alone", scalar, {}},
           [alone, numbers](std::span<double> records) {
             for (std::uint64_t i = 0; i < member_count; ++i) alone(i, records.subspan(i * numbers, numbers));
           },
           std::vector<double>(member_count * numbers)},
          {{quantity, "torsor, packs of " + std::to_string(groups.together), scalar, {}},
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

/// In turns; the nanoseconds are for one of `parts` that each turn of a way does.
std::vector<EnsembleTimes> measured(std::vector<Way> all, double parts, int turns) {
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
      way.nanoseconds.push_back(taken.count() / parts);
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

}  // namespace

std::vector<EnsembleTimes> ensemble_times(int turns) {
  constexpr double end = step_count * 1e-3;
  std::vector<Way> steps = ways<panda::Mechanism, double>("step", "double", member<double>, end, method);
  for (Way& way : ways<panda::Mechanism, float>("step", "float", member<float>, static_cast<float>(end), method))
    steps.push_back(std::move(way));
  std::vector<EnsembleTimes> times = measured(std::move(steps), double{member_count} * step_count, turns);
  std::vector<Way> seconds = ways<double_pendulum::Mechanism, double>("Taylor", "double", pendulum, 1.0, taylor);
  for (EnsembleTimes& each : measured(std::move(seconds), double{member_count}, turns))
    times.push_back(std::move(each));
  return times;
}
