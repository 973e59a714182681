// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/work_precision/report.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

#include <fmt/format.h>

#include "torsor/runtime/records/file.hpp"
#include "torsor/runtime/records/plot.hpp"

namespace work_precision {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

struct Reach {
  double nine = never, twelve = never;  ///< µs to an error of 1e-9 and 1e-12
  double smallest = never;              ///< error
};

Reach reach_of(const std::vector<Row>& rows, const std::string& problem, const std::string& label) {
  Reach reach;
  for (const Row& row : rows) {
    if (row.problem != problem || row.way->label() != label || !row.outcome.reached) continue;
    if (row.outcome.error <= 1e-9) reach.nine = std::min(reach.nine, row.median);
    if (row.outcome.error <= 1e-12) reach.twelve = std::min(reach.twelve, row.median);
    reach.smallest = std::min(reach.smallest, row.outcome.error);
  }
  return reach;
}

template <class Get>
std::vector<std::string> all_of(const std::vector<Row>& rows, Get get) {
  std::vector<std::string> result;
  for (const Row& row : rows) {
    const std::string each = get(row);
    if (std::find(result.begin(), result.end(), each) == result.end()) result.push_back(each);
  }
  return result;
}

std::string time_and_ratio(double time, double quickest) {
  return std::isfinite(time) ? fmt::format("{:.0f} ({:.2f})", time, time / quickest) : "not reached";
}

std::string column(std::string label) {
  std::replace(label.begin(), label.end(), ',', ' ');  // a cell holds no comma
  return label;
}

// What a picture shows: the best of each family, lest its curves hide each other. The CSV file has all.
bool stands_in_picture(const std::string& label) {
  for (const char* left_out :
       {"midpoint", "Taylor compensated", "Gauss collocation 6", "variational 6", "SUNDIALS CVODE BDF", "SUNDIALS ARKODE 5"}) {
    if (label == left_out) return false;
  }
  return true;
}

std::string cell(double value) { return std::isfinite(value) ? fmt::format("{:.6g}", value) : ""; }

}  // namespace

void print(const Problem& problem, const std::vector<Row>& rows) {
  fmt::print("\n{}: {}\n{:<28}{:>10}{:>13}{:>12}{:>24}{:>10}{:>9}{:>9}\n", problem.name, problem.text, "integrator",
             "setting", "error", "energy", "us (quartiles)", "calls", "steps", "rejected");
  for (const Row& row : rows) {
    const auto& statistics = row.outcome.statistics;
    fmt::print("{:<28}{:>10}{:>13}{:>12.1e}{:>24}{:>10}{:>9}{:>9}\n", row.way->label(),
               fmt::format("{}{:.1e}", row.way->fixed_step ? "h " : "", row.setting),
               row.outcome.reached ? fmt::format("{:.2e}", row.outcome.error) : "failed", row.outcome.energy,
               fmt::format("{:.0f} ({:.0f} to {:.0f})", row.median, row.lower, row.upper), statistics.calls,
               statistics.accepted, statistics.rejected);
  }
}

void print_reach(const std::vector<Row>& rows) {
  const auto labels = all_of(rows, [](const Row& row) { return row.way->label(); });
  fmt::print("\nus to reach an error of 1e-9 and of 1e-12 (multiple of the quickest), and the smallest error\n");
  for (const std::string& problem : all_of(rows, [](const Row& row) { return row.problem; })) {
    Reach best;
    for (const std::string& label : labels) {
      const Reach reach = reach_of(rows, problem, label);
      best.nine = std::min(best.nine, reach.nine);
      best.twelve = std::min(best.twelve, reach.twelve);
    }
    fmt::print("{:<10}{:<28}{:>18}{:>18}{:>12}\n", problem, "integrator", "1e-9", "1e-12", "smallest");
    for (const std::string& label : labels) {
      const bool was_run = std::any_of(rows.begin(), rows.end(), [&](const Row& row) {
        return row.problem == problem && row.way->label() == label;
      });
      if (!was_run) continue;
      const Reach reach = reach_of(rows, problem, label);
      fmt::print("{:<10}{:<28}{:>18}{:>18}{:>12.1e}\n", "", label, time_and_ratio(reach.nine, best.nine),
                 time_and_ratio(reach.twelve, best.twelve), reach.smallest);
    }
  }
}

void write_files(const Problem& problem, const std::vector<Row>& rows, const std::filesystem::path& folder) {
  const auto labels = all_of(rows, [](const Row& row) { return row.way->label(); });
  std::size_t longest = 0;
  for (const Way& way : problem.ways) longest = std::max(longest, way.settings.size());
  std::string text;
  for (const std::string& label : labels) {
    text += fmt::format("{}{} error,{}", text.empty() ? "" : ",", column(label), column(label));
  }
  text += '\n';
  for (std::size_t line = 0; line < longest; ++line) {
    std::string cells;
    for (std::size_t i = 0; i < labels.size(); ++i) {
      const Row* found = nullptr;
      std::size_t seen = 0;
      for (const Row& row : rows) {
        if (row.way->label() == labels[i] && seen++ == line) found = &row;
      }
      // An error of 0 has no place on a logarithmic axis; one of the size of the motion is no solution.
      const bool drawn =
          found != nullptr && found->outcome.reached && found->outcome.error > 0.0 && found->outcome.error < 1.0;
      cells += i > 0 ? "," : "";
      cells += drawn ? fmt::format("{},{}", cell(found->outcome.error), cell(found->median)) : ",";
    }
    text += cells + '\n';
  }
  const std::filesystem::path csv = folder / ("work_precision_" + problem.name + ".csv");
  torsor::runtime::write_file(csv, text);
  torsor::runtime::Plot plot{problem.name + ": " + problem.text, "largest error at the end", "us", {}, true, true};
  for (const std::string& label : labels) {
    if (!stands_in_picture(label)) continue;
    plot.curves.push_back({csv, column(label) + " error", column(label), label, "linespoints"});
  }
  torsor::runtime::write_plot(plot, folder / ("work_precision_" + problem.name + ".svg"));
}

void write_all(const std::vector<Row>& rows, const std::filesystem::path& folder) {
  std::string text =
      "problem,library,integrator,setting,is_step,reached,error,energy,us,us_lower_quartile,us_upper_quartile,calls,"
      "steps,"
      "rejected\n";
  for (const Row& row : rows) {
    const auto& statistics = row.outcome.statistics;
    text += fmt::format("{},{},{},{:.6e},{},{},{:.6e},{:.6e},{:.2f},{:.2f},{:.2f},{},{},{}\n", row.problem,
                        row.way->library, column(row.way->name), row.setting, int{row.way->fixed_step},
                        int{row.outcome.reached}, row.outcome.error, row.outcome.energy, row.median, row.lower,
                        row.upper, statistics.calls, statistics.accepted, statistics.rejected);
  }
  torsor::runtime::write_file(folder / "work_precision.csv", text);
}

}  // namespace work_precision
