// SPDX-License-Identifier: GPL-3.0-or-later
// batch: nanoseconds for one of many states of the panda, by the single kernels, by packs of each kind of registers that
// this processor has and by MuJoCo where it is installed, on one thread, after their results were found equal; then of an
// ensemble's step, and of a large batch on several threads. --help tells the options, docs/benchmarks.md what is measured.
#include <algorithm>
#include <cstdio>
#include <stdexcept>
#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "benchmarks/batch/ensemble.hpp"
#include "benchmarks/batch/packs.hpp"
#include "benchmarks/batch/threads.hpp"
#include "benchmarks/kernels/comparison.hpp"
#include "benchmarks/kernels/measured.hpp"
#include "benchmarks/kernels/peers.hpp"
#include "benchmarks/kernels/timing.hpp"

namespace native_build {
kernels::Measured measured_panda();
}

namespace {

using namespace kernels;

struct Options {
  std::string references = TORSOR_SOURCE_DIR "/tests/reference";
  std::string csv;
  int turns = 1001;
  std::size_t states = 256;
  std::size_t large = 65536;  // their states, inputs and results do not fit a cache of 2 MB
};

std::string text_of(const Spread& spread) {
  return fmt::format("{:.1f} ({:.1f} to {:.1f})", spread.median, spread.lower, spread.upper);
}

// MuJoCo's cheapest calls for a quantity, and what its users call.
constexpr const char* cheapest = "MuJoCo";
constexpr const char* whole = "MuJoCo whole";

/// The single kernel in double first.
std::vector<Way> all_ways(const Options& options, const Chain& chain, Quantity quantity, const Batch& batch) {
  std::vector<Way> ways = native_build::measured_panda().ways(quantity, batch);
  constexpr PackedWays* packed[] = {
#define PACKED(kind) packed_ways_##kind,
#include "packs.inc"
#undef PACKED
  };
  for (PackedWays* const packed_ways : packed) {
    for (Way& way : packed_ways(quantity, batch)) ways.push_back(std::move(way));
  }
  for (Way& way : peer_ways(options.references, chain, quantity, batch)) {
    if (way.competitor == cheapest || way.competitor == whole) ways.push_back(std::move(way));
  }
  return ways;
}

void measure(const Options& options, const Chain& chain, Quantity quantity, std::string& csv) {
  const Batch batch = random_batch(chain.joints.size(), options.states);
  const std::vector<Way> ways = all_ways(options, chain, quantity, batch);
  const std::vector<double> difference = differences(ways, quantity, batch.states);
  const std::vector<Timing> timings = time_in_turns(ways, batch.states, options.turns);
  // Than the competitor of that name; empty where there is none.
  const auto times_faster = [&](double ratio, const char* competitor, const char* format) -> std::string {
    const auto place =
        std::find_if(ways.begin(), ways.end(), [&](const Way& way) { return way.competitor == competitor; });
    if (place == ways.end()) return "";
    return fmt::format(fmt::runtime(format), timings[static_cast<std::size_t>(place - ways.begin())].ratio.median / ratio);
  };
  for (std::size_t i = 0; i < ways.size(); ++i) {
    const auto& [ns, ratio] = timings[i];
    fmt::print("{:<18}{:<40}{:<8}{:>28}{:>10.2f}{:>10}{:>10}{:>9.0e}\n", name_of(quantity), ways[i].competitor,
               ways[i].scalar, text_of(ns), 1 / ratio.median, times_faster(ratio.median, cheapest, "{:.1f}"),
               times_faster(ratio.median, whole, "{:.1f}"), difference[i]);
    std::string name = ways[i].competitor;  // a cell holds no comma
    name.erase(std::remove(name.begin(), name.end(), ','), name.end());
    csv += fmt::format("{},{},{},1,{:.3f},{:.3f},{:.3f},{:.4f},{},{},{:.1e}\n", name_of(quantity), name, ways[i].scalar,
                       ns.median, ns.lower, ns.upper, 1 / ratio.median, times_faster(ratio.median, cheapest, "{:.3f}"),
                       times_faster(ratio.median, whole, "{:.3f}"), difference[i]);
  }
  std::fflush(stdout);
}

/// Members of an ensemble: one step of Runge-Kutta's method, and a second by Taylor's.
void measure_ensemble(int turns, std::string& csv) {
  for (const auto& [quantity, name, scalar, timing, difference] : ensemble_times(turns)) {
    const auto& [ns, ratio] = timing;
    fmt::print("{:<18}{:<40}{:<8}{:>28}{:>10.2f}{:>20}{:>9.0e}\n", "ensemble's " + quantity, name, scalar, text_of(ns),
               1 / ratio.median, "-", difference);
    std::string cell = name;
    cell.erase(std::remove(cell.begin(), cell.end(), ','), cell.end());
    csv += fmt::format("ensemble_{},{},{},1,{:.3f},{:.3f},{:.3f},{:.4f},,,{:.1e}\n", quantity, cell, scalar, ns.median,
                       ns.lower, ns.upper, 1 / ratio.median, difference);
  }
}

/// A batch that leaves the caches. A call takes milliseconds, and so fewer turns are enough.
void measure_threads(const Options& options, std::string& csv) {
  fmt::print("\n{:<18}{:<40}{:<8}{:>28}{:>14}\n", "forward_dynamics", fmt::format("{} states", options.large), "scalar",
             "ns for one state (quartiles)", "x one thread");
  for (const auto& [threads, scalar, lanes, timing] : thread_times(options.large, 1 + options.turns / 20)) {
    const auto& [ns, ratio] = timing;
    fmt::print("{:<18}{:<40}{:<8}{:>28}{:>14.2f}\n", "",
               fmt::format("packs of {}, {} thread{}", lanes, threads, threads == 1 ? "" : "s"), scalar, text_of(ns),
               1 / ratio.median);
    csv += fmt::format("forward_dynamics_large,torsor packs of {},{},{},{:.3f},{:.3f},{:.3f},,,,\n", lanes, scalar,
                       threads, ns.median, ns.lower, ns.upper);
  }
}

void run(const Options& options) {
  const std::vector<Chain> chains = read_chains(options.references + "/models.json");
  const auto chain = std::find_if(chains.begin(), chains.end(), [](const Chain& each) { return each.name == "panda"; });
  if (chain == chains.end()) throw std::runtime_error("models.json has no chain panda");
  fmt::print("{:<18}{:<40}{:<8}{:>28}{:>10}{:>10}{:>10}{:>9}\n", "quantity", "", "scalar", "ns for one state (quartiles)",
             "x single", "x MuJoCo", "x whole", "differs");
  std::string csv =
      "quantity,competitor,scalar,threads,ns,ns_lower_quartile,ns_upper_quartile,times_single,times_mujoco,"
      "times_mujoco_whole,difference\n";
  for (const Quantity quantity : quantities) measure(options, *chain, quantity, csv);
  measure_ensemble(options.turns, csv);
  measure_threads(options, csv);
  if (options.csv.empty()) return;
  std::FILE* file = std::fopen(options.csv.c_str(), "w");
  if (file == nullptr) throw std::runtime_error("cannot write " + options.csv);
  const bool written = std::fputs(csv.c_str(), file) >= 0;
  if (std::fclose(file) != 0 || !written)
    throw std::runtime_error("cannot write " + options.csv + ": is the disk full?");
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Times of generated kernels for many states of one arm, and of MuJoCo's for the same states."};
  Options options;
  app.add_option("--references", options.references, "folder of models.json and mjcf/")->capture_default_str();
  app.add_option("--csv", options.csv, "file to write");
  app.add_option("--turns", options.turns, "how often each competitor goes through the states")->capture_default_str();
  app.add_option("--states", options.states, "random states")->capture_default_str();
  app.add_option("--large", options.large, "random states of the batch on several threads")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  try {
    run(options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "batch: %s\n", error.what());
    return 1;
  }
  return 0;
}
