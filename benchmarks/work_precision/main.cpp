// SPDX-License-Identifier: GPL-3.0-or-later
// work_precision: run time against true error of our integrators, Boost.odeint's and SUNDIALS', on the same generated
// right-hand sides. --help tells the options, docs/benchmarks.md what is measured.
#include <algorithm>
#include <cstdio>
#include <deque>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "benchmarks/work_precision/bars.hpp"
#include "benchmarks/work_precision/drift.hpp"
#include "benchmarks/work_precision/links.hpp"
#include "benchmarks/work_precision/measure.hpp"
#include "benchmarks/work_precision/problem.hpp"
#include "benchmarks/work_precision/report.hpp"

namespace {

using namespace work_precision;

struct Options {
  std::string output;
  std::vector<std::string> problems, ways;
  int turns = 31;
  double seconds = 0.2;
  bool drift = false, invariants = false, links = false, bars = false;
};

/// Whether all that is promised holds, where that was asked for.
bool run(const Options& options) {
#ifndef BENCHMARK_ODEINT
  std::puts("Boost.odeint was not found when this program was built");
#endif
#ifndef BENCHMARK_SUNDIALS
  std::puts("SUNDIALS was not found when this program was built");
#endif
  const auto chosen = [](const std::vector<std::string>& list, const std::string& name) {
    return list.empty() || std::find(list.begin(), list.end(), name) != list.end();
  };
  std::deque<Problem> problems;  // rows point into them
  std::vector<Row> all;
  for (const auto make : {double_pendulum_mild, double_pendulum_easy, double_pendulum_hard, top, hoop, chain5, ur5,
                          governor, elastic_pendulum, stiffer_pendulum, squeezer, bouncing, resting, sliding}) {
    Problem problem = make();
    if (!chosen(options.problems, problem.name)) continue;
    std::erase_if(problem.ways, [&](const Way& way) { return !chosen(options.ways, way.label()); });
    problems.push_back(std::move(problem));
    const std::vector<Row> rows = measure(problems.back(), options.turns, options.seconds);
    print(problems.back(), rows);
    std::fflush(stdout);
    if (!options.output.empty()) write_files(problems.back(), rows, options.output);
    all.insert(all.end(), rows.begin(), rows.end());
  }
  if (!all.empty()) print_reach(all);
  std::fflush(stdout);
  if (!options.output.empty()) write_all(all, options.output);
  if (options.links) measure_links(options.output, options.turns);
  if (options.invariants) measure_invariants(options.output);
  std::vector<Drift> drifts;
  if (options.drift || options.bars) drifts = measure_drift(options.output);
  return !options.bars || print_bars(all, drifts);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Run time against true error of integrators on generated right-hand sides."};
  Options options;
  app.add_option("--output", options.output, "folder for CSV files and pictures")->check(CLI::ExistingDirectory);
  app.add_option("--problems", options.problems, "some problems only; none: no table of them")->delimiter(',');
  CLI::Option* ways =
      app.add_option("--integrators", options.ways, "some integrators only, as the table names them")->delimiter(',');
  app.add_option("--turns", options.turns, "how often each setting is run, at most")->capture_default_str();
  app.add_option("--seconds", options.seconds, "for each setting")->capture_default_str();
  app.add_flag("--drift", options.drift, "also the energy over 10^4 s");
  app.add_flag("--invariants", options.invariants, "also momentum and constraints over 10^6 steps and 10^4 s");
  app.add_flag("--links", options.links, "also pendulums of 2 to 32 links");
  app.add_flag("--bars", options.bars, "also --drift, and what is promised and whether it holds; 1 if not")
      ->excludes(ways);
  CLI11_PARSE(app, argc, argv);
  try {
    return run(options) ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "work_precision: %s\n", error.what());
    return 3;
  }
}
