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

#include "benchmarks/work_precision/drift.hpp"
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
  bool drift = false;
};

void run(const Options& options) {
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
  for (const auto make : {double_pendulum_mild, double_pendulum_easy, double_pendulum_hard, top, hoop, chain5, governor,
                          elastic_pendulum, squeezer}) {
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
  print_reach(all);
  std::fflush(stdout);
  if (!options.output.empty()) write_all(all, options.output);
  if (options.drift) measure_drift(options.output);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Run time against true error of integrators on generated right-hand sides."};
  Options options;
  app.add_option("--output", options.output, "folder for CSV files and pictures");
  app.add_option("--problems", options.problems, "some problems only")->delimiter(',');
  app.add_option("--integrators", options.ways, "some integrators only, as the table names them")->delimiter(',');
  app.add_option("--turns", options.turns, "how often each setting is run, at most")->capture_default_str();
  app.add_option("--seconds", options.seconds, "for each setting")->capture_default_str();
  app.add_flag("--drift", options.drift, "also the energy over 10^4 s");
  CLI11_PARSE(app, argc, argv);
  try {
    run(options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "work_precision: %s\n", error.what());
    return 1;
  }
  return 0;
}
