// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/work_precision/bars.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "benchmarks/work_precision/report.hpp"
#include "torsor/generator/verification/worst.hpp"

namespace work_precision {
namespace {

class Bars {
 public:
  void at_least(const std::string& what, double measured, double bar) { add(what, measured, bar, measured >= bar); }
  void at_most(const std::string& what, double measured, double bar) { add(what, measured, bar, measured <= bar); }
  [[nodiscard]] bool all() const { return all_; }

 private:
  // What was not run, and what no one reached, is NaN and missed: no comparison with it holds.
  void add(const std::string& what, double measured, double bar, bool met) {
    if (!printed_) fmt::print("\n{:<84}{:>10}{:>10}\n", "promised", "measured", "bar");
    printed_ = true;
    all_ = all_ && met;
    const std::string value = std::isnan(measured) ? "none" : fmt::format("{:.3g}", measured);
    fmt::print("{:<84}{:>10}{:>10.3g}  {}\n", what, value, bar, met ? "met" : "MISSED");
  }
  bool all_ = true, printed_ = false;
};

bool was_run(const std::vector<Row>& rows, const std::string& problem) {
  return std::any_of(rows.begin(), rows.end(), [&](const Row& row) { return row.problem == problem; });
}

bool fits(const Row& row, const std::string& library, const std::string& beginning) {
  return row.way->library == library && row.way->name.starts_with(beginning);
}

/// Time of the cheapest setting that reaches an error, by any way of the library whose name begins so; NaN if none of
/// them was run, infinity if none reached it.
double time_to(const std::vector<Row>& rows, const std::string& problem, const std::string& library,
               const std::string& beginning, double error) {
  double time = std::numeric_limits<double>::quiet_NaN();
  for (const Row& row : rows) {
    if (row.problem != problem || !fits(row, library, beginning)) continue;
    const double its =
        row.outcome.reached && row.outcome.error <= error ? row.median : std::numeric_limits<double>::infinity();
    time = std::isnan(time) ? its : std::min(time, its);
  }
  return time;
}

double smallest_error(const std::vector<Row>& rows, const std::string& problem) {
  double smallest = std::numeric_limits<double>::quiet_NaN();
  for (const Row& row : rows) {
    if (row.problem == problem && row.way->library == "torsor" && row.outcome.reached) {
      smallest = std::fmin(smallest, row.outcome.error);
    }
  }
  return smallest;
}

void ratios(Bars& bars, const std::vector<Row>& rows) {
  for (const std::string problem : {"dp_mild", "top", "hoop", "chain5"}) {
    if (!was_run(rows, problem)) continue;
    for (const double error : {1e-9, 1e-12}) {
      const double ours = time_to(rows, problem, "torsor", "", error);
      const auto text = [&](const char* others) { return fmt::format("{}, {:.0e}: {}", problem, error, others); };
      if (problem != "chain5") {
        bars.at_least(text("Boost.odeint's best takes this many times our best"),
                      time_to(rows, problem, "Boost.odeint", "", error) / ours, 2);
        bars.at_least(text("CVODE takes this many times our best"),
                      time_to(rows, problem, "SUNDIALS", "CVODE", error) / ours, 15);
      }
    }
    const double order_eight = time_to(rows, problem, "torsor", "Dormand-Prince 8", 1e-12);
    bars.at_least(fmt::format("{}, 1e-12: our 8(5,3) takes this many times Taylor's method", problem),
                  order_eight / time_to(rows, problem, "torsor", "Taylor", 1e-12), problem == "dp_mild" ? 2.5 : 1.5);
  }
}

// Every adaptive way at every tolerance: the end within 100 times the tolerance times how errors grow, and the energy
// within 1e4 times the tolerance; or a failure that says so, where rounding or a coarse tolerance excuses it.
void no_wrong_answer(Bars& bars, const std::vector<Row>& rows) {
  constexpr double growth = 9.4e5;
  double end = 0, energy = 0;
  int failures = 0, reached = 0;
  for (const Row& row : rows) {
    if (row.problem != "dp_hard" || row.way->library != "torsor" || row.way->fixed_step) continue;
    if (!row.outcome.reached) {
      failures += row.setting < 2e-4 && row.setting > 5e-12;
      continue;
    }
    ++reached;
    const double of_end = row.outcome.error / (100 * row.setting * growth);
    const double of_energy = row.outcome.energy / (1e4 * row.setting);
    if (torsor::is_worse(of_end, end)) end = of_end;
    if (torsor::is_worse(of_energy, energy)) energy = of_energy;
  }
  if (reached == 0) end = energy = std::numeric_limits<double>::quiet_NaN();
  bars.at_most("dp_hard: largest error of ours at any tolerance, in units of 100 tolerance 9.4e5", end, 1);
  bars.at_most("dp_hard: largest error of the energy, in units of 1e4 tolerance", energy, 1);
  bars.at_most("dp_hard: failures of ours at tolerances from 1e-4 to 1e-11", failures, 0);
}

void long_run(Bars& bars, const std::vector<Drift>& drifts) {
  double taylor = std::numeric_limits<double>::quiet_NaN(), taylor_seconds = taylor, others_seconds = taylor;
  for (const Drift& drift : drifts) {
    if (!drift.result) continue;
    if (drift.name.starts_with("Taylor compensated")) {
      taylor = drift.largest.back();
      taylor_seconds = drift.seconds;
    }
    if (drift.name.starts_with("Dormand-Prince 8") && drift.largest.back() <= 1e-8) {
      others_seconds = std::fmin(others_seconds, drift.seconds);
    }
  }
  bars.at_most("energy over 1e4 s of the chaotic double pendulum, Taylor compensated", taylor, 1e-12);
  bars.at_least("the same: 8(5,3) takes this many times as long for 1e-8", others_seconds / taylor_seconds, 1);
}

}  // namespace

bool print_bars(const std::vector<Row>& rows, const std::vector<Drift>& drifts) {
  Bars bars;
  ratios(bars, rows);
  for (const auto& [problem, bar] : {std::pair{"dp_mild", 2e-15}, std::pair{"top", 5e-14}, std::pair{"hoop", 5e-14}}) {
    if (was_run(rows, problem)) {
      bars.at_most(fmt::format("{}: smallest error", problem), smallest_error(rows, problem), bar);
    }
  }
  if (was_run(rows, "dp_hard")) no_wrong_answer(bars, rows);
  long_run(bars, drifts);
  return bars.all();
}

}  // namespace work_precision
