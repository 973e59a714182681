// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/work_precision/contact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "benchmarks/work_precision/processor_time.hpp"
#include "runtime/integration/dormand_prince_54.hpp"
#include "runtime/integration/dormand_prince_853.hpp"
#include "runtime/integration/events.hpp"
#include "runtime/integration/midpoint.hpp"
#include "runtime/integration/runge_kutta_4.hpp"

namespace work_precision {
namespace {

using namespace torsor::runtime;
constexpr double gravity = 9.81;

struct ContactOutcome {
  bool reached = false;
  double error = 0.0;  ///< of the time at which the motion changes for good, relative, and of the state there
  Statistics statistics{};
  long long events = 0;
};

/// Dropped from 1 m with a coefficient of restitution of 0.8: at rest from 4.06371... s on.
template <class Method>
ContactOutcome bounce(const Method& method) {
  constexpr double e = 0.8, end = 4.0637127688715781400573;
  const auto fall = [](double, const std::array<double, 2>& y, std::array<double, 2>& rate) noexcept {
    rate = {y[1], -gravity};
    return Evaluation::ok;
  };
  const auto floor = barrier([](double, const std::array<double, 2>& y) noexcept { return y[0]; },
                             [](double, std::array<double, 2>& y) noexcept { y[1] *= -e; });
  std::array<double, 2> y{1.0, 0.0};
  const auto result = integrate_with_events(fall, y, 0, 10, method, Events(floor));
  return {result.status == EventStatus::accumulation, std::abs(result.accumulation_time / end - 1.0),
          result.integration.statistics, static_cast<long long>(result.fired[0])};
}

/// A billiard ball thrown at 2 m/s without spin on cloth of mu = 0.2: it rolls from 2 v/(7 mu g) on, at 5/7 of the
/// speed, 12 v^2/(49 mu g) away. y = (x, v, omega).
template <class Method>
ContactOutcome slide(const Method& method) {
  constexpr double speed = 2.0, mu = 0.2, radius = 0.05;
  constexpr double end = 2 * speed / (7 * mu * gravity);
  using State = std::array<double, 3>;
  const auto sliding = [](double, const State& y, State& rate) noexcept {
    rate = {y[1], -mu * gravity, 2.5 * mu * gravity / radius};
    return Evaluation::ok;
  };
  const auto rolls = stop_at([](double, const State& y) noexcept { return y[1] - radius * y[2]; });
  State y{0.0, speed, 0.0};
  const auto result = integrate_with_events(sliding, y, 0, 10, method, Events(rolls));
  const double error = std::max({std::abs(result.time / end - 1.0), std::abs(y[1] / (5.0 / 7.0 * speed) - 1.0),
                                 std::abs(y[0] / (12 * speed * speed / (49 * mu * gravity)) - 1.0)});
  return {result.status == EventStatus::stopped_at_event, error, result.integration.statistics,
          static_cast<long long>(result.fired[0])};
}

struct Contact {
  std::string problem, method;
  std::function<ContactOutcome()> run;
};

template <class Method>
void add(std::vector<Contact>& all, const std::string& name, const Method& method) {
  all.push_back({"bouncing", name, [method] { return bounce(method); }});
  all.push_back({"sliding", name, [method] { return slide(method); }});
}

}  // namespace

void measure_contact(int turns) {
  std::vector<Contact> all;
  add(all, "Dormand-Prince 8(5,3)", DormandPrince853{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12});
  add(all, "Dormand-Prince 5(4)", DormandPrince54{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12});
  add(all, "Runge-Kutta 4, h 0.05", RungeKutta4{.step = 0.05});
  add(all, "midpoint, h 0.05", Midpoint{.step = 0.05});
  std::stable_sort(all.begin(), all.end(), [](const Contact& a, const Contact& b) { return a.problem < b.problem; });
  std::vector<std::vector<double>> times(all.size());
  std::vector<ContactOutcome> outcomes(all.size());
  for (int turn = 0; turn < turns; ++turn) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      const double start = processor_seconds();
      outcomes[i] = all[i].run();
      times[i].push_back((processor_seconds() - start) * 1e6);
    }
  }
  fmt::print("\nballs that bounce until they rest and slide until they roll, against their closed forms\n");
  fmt::print("{:<10}{:<26}{:>14}{:>10}{:>10}{:>10}\n", "motion", "integrator", "error", "us", "calls", "events");
  for (std::size_t i = 0; i < all.size(); ++i) {
    std::sort(times[i].begin(), times[i].end());
    const ContactOutcome& outcome = outcomes[i];
    fmt::print("{:<10}{:<26}{:>14}{:>10.1f}{:>10}{:>10}\n", all[i].problem, all[i].method,
               outcome.reached ? fmt::format("{:.1e}", outcome.error) : "failed", times[i][times[i].size() / 2],
               outcome.statistics.calls, outcome.events);
  }
}

}  // namespace work_precision
