// SPDX-License-Identifier: GPL-3.0-or-later
// Motions with contacts, ours beside those of MuJoCo, Siconos, Simbody, Box2D and Chipmunk where they are installed:
// time of the processor and error, in one run.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "benchmarks/contact_peers/problems.hpp"

// Of Siconos' linear algebra: threads that wait would count as time of the processor. Null without it.
extern "C" void openblas_set_num_threads(int) __attribute__((weak));

namespace {

using namespace torsor::contact_peers;

struct Row {
  double milliseconds, error;
};

/// Every way in turns, so that what else the machine does meets all alike; the median of the times.
std::vector<Row> measure(const Problem& problem, int turns) {
  std::vector<std::vector<double>> times(problem.ways.size());
  std::vector<Row> rows(problem.ways.size());
  for (int turn = 0; turn < turns; ++turn) {
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const Outcome outcome = problem.ways[k].run();
      times[k].push_back(1e3 * outcome.seconds);
      rows[k].error = outcome.error;
    }
  }
  for (std::size_t k = 0; k < rows.size(); ++k) {
    std::sort(times[k].begin(), times[k].end());
    rows[k].milliseconds = times[k][times[k].size() / 2];
  }
  return rows;
}

/// How many times as long a way takes as the quickest of ours that is at least as exact.
std::string ratio(const Problem& problem, const std::vector<Row>& rows, std::size_t k) {
  double ours = INFINITY;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (problem.ways[i].who == "torsor" && rows[i].error <= rows[k].error) ours = std::min(ours, rows[i].milliseconds);
  }
  if (!std::isfinite(rows[k].error)) return "fails";
  if (problem.ways[k].who == "torsor") return "";
  if (!std::isfinite(ours)) return "not reached";
  char text[32];
  std::snprintf(text, sizeof text, "%.2g", rows[k].milliseconds / ours);
  return text;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Motions with contacts beside MuJoCo, Siconos, Simbody, Box2D and Chipmunk");
  int turns = 3, discs = 400, steps = 600;
  std::vector<std::string> names;
  app.add_option("--turns", turns, "how often each way runs")->check(CLI::PositiveNumber)->capture_default_str();
  app.add_option("--discs", discs, "discs that settle")->check(CLI::PositiveNumber)->capture_default_str();
  app.add_option("--steps", steps, "steps of 1 ms in which they do")->check(CLI::PositiveNumber)->capture_default_str();
  const std::vector<std::pair<std::string, std::function<Problem()>>> problems{
      {"bouncing", bouncing_ball},
      {"billiard", billiard_ball},
      {"chain", chain_on_floor},
      {"quadruped", quadruped},
      {"spheres", spheres_in_a_box},
      {"pile", six_discs},
      {"discs", [&] { return discs_that_settle(discs, steps); }}};
  std::vector<std::string> all;
  for (const auto& [name, make] : problems) all.push_back(name);
  app.add_option("--problems", names, "some only: bouncing, billiard, chain, quadruped, spheres, pile, discs")
      ->delimiter(',')
      ->check(CLI::IsMember(all));
  CLI11_PARSE(app, argc, argv);
  if (openblas_set_num_threads != nullptr) openblas_set_num_threads(1);
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  std::printf(
      "Milliseconds of the processor (median of %d); the last column: times as long as torsor takes for an error no "
      "larger\n",
      turns);
  for (const auto& [name, make] : problems) {
    if (!names.empty() && std::find(names.begin(), names.end(), name) == names.end()) continue;
    const Problem problem = make();
    const std::vector<Row> rows = measure(problem, turns);
    std::printf("\n%s\n%-10s %-52s %12s %20s %12s\n", problem.name.c_str(), "", "", "ms", problem.error.c_str(),
                "x torsor");
    for (std::size_t k = 0; k < rows.size(); ++k) {
      std::printf("%-10s %-52s %12.4g %20.1e %12s\n", problem.ways[k].who.c_str(), problem.ways[k].setting.c_str(),
                  rows[k].milliseconds, rows[k].error, ratio(problem, rows, k).c_str());
    }
  }
  return 0;
}
