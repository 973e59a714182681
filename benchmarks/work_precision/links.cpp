// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/work_precision/links.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "benchmarks/work_precision/processor_time.hpp"
#include "torsor/runtime/records/file.hpp"
#include "torsor/runtime/records/plot.hpp"

namespace work_precision {
namespace {

constexpr double wanted_error = 1e-9;
constexpr double never = std::numeric_limits<double>::infinity();

double error_of(const std::vector<double>& y, const std::vector<double>& truth) {
  double largest = 0.0;
  for (std::size_t i = 0; i < y.size(); ++i) {
    const double error = std::abs(y[i] - truth[i]);
    largest = std::isfinite(error) ? std::max(largest, error) : never;
  }
  return largest;
}

/// The loosest tolerance, of half decades, that meets the error; 0 if none does.
double tolerance_for(const LinksWay& way, const std::vector<double>& truth) {
  for (double exponent = -6; exponent > -14.75; exponent -= 0.5) {
    const double tolerance = std::pow(10.0, exponent);
    std::vector<double> end;
    if (way.run(tolerance, end) && error_of(end, truth) <= wanted_error) return tolerance;
  }
  return 0.0;
}

}  // namespace

void measure_links(const std::filesystem::path& folder, int turns) {
  fmt::print("\npendulums of many links: us of the processor for a second of motion, error at most {:.0e}\n",
             wanted_error);
  std::vector<std::string> names;
  std::string csv;
  for (const auto make : {links_2, links_4, links_8, links_16, links_32}) {
    const Links links = make();
    // The first way is the reference too, at its sharpest.
    std::vector<double> truth;
    if (!links.ways.front().run(1e-15, truth)) {
      fmt::print("{:>6}  the reference failed\n", links.count);
      continue;
    }
    std::vector<double> tolerances;
    for (const LinksWay& way : links.ways) tolerances.push_back(tolerance_for(way, truth));
    std::vector<std::vector<double>> times(links.ways.size());
    for (int turn = 0; turn < turns; ++turn) {
      for (std::size_t i = 0; i < links.ways.size(); ++i) {
        if (tolerances[i] == 0.0) continue;
        std::vector<double> end;
        const double start = processor_seconds();
        (void)links.ways[i].run(tolerances[i], end);
        times[i].push_back((processor_seconds() - start) * 1e6 / links_end);
      }
    }
    if (names.empty()) {
      fmt::print("{:>6}", "links");
      csv = "links";
      for (const LinksWay& way : links.ways) {
        names.push_back(way.name);
        fmt::print("{:>32}", way.name);
        csv += "," + way.name;
      }
      fmt::print("\n");
    }
    fmt::print("{:>6}", links.count);
    csv += fmt::format("\n{}", links.count);
    for (std::size_t i = 0; i < links.ways.size(); ++i) {
      if (times[i].empty()) {
        fmt::print("{:>32}", "not reached");
        csv += ",";
        continue;
      }
      std::sort(times[i].begin(), times[i].end());
      const double median = times[i][times[i].size() / 2];
      fmt::print("{:>32}", fmt::format("{:.0f} (at {:.0e})", median, tolerances[i]));
      csv += fmt::format(",{:.2f}", median);
    }
    fmt::print("\n");
    std::fflush(stdout);
  }
  if (folder.empty() || names.empty()) return;
  torsor::runtime::write_file(folder / "links.csv", csv + "\n");
  torsor::runtime::Plot plot{
      "Pendulums of many links at an error of 1e-9", "links", "us for a second of motion", {}, true, true};
  for (const std::string& name : names)
    plot.curves.push_back({folder / "links.csv", "links", name, name, "linespoints"});
  torsor::runtime::write_plot(plot, folder / "links.svg");
}

}  // namespace work_precision
