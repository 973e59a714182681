// SPDX-License-Identifier: GPL-3.0-or-later
// kernels: nanoseconds of generated kernels and of other libraries, at the same random states, after their results were
// found equal. --help tells the options, docs/benchmarks.md what is measured.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <set>
#include <stdexcept>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "benchmarks/kernels/comparison.hpp"
#include "benchmarks/kernels/measured.hpp"
#include "benchmarks/kernels/peers.hpp"
#include "benchmarks/kernels/report.hpp"

namespace {

using namespace kernels;

struct Options {
  std::string references = TORSOR_SOURCE_DIR "/tests/reference";
  std::string output;
  std::vector<std::string> models;
  int turns = 201;
  std::size_t states = 64;
  std::vector<std::string> single;
};

/// Our kernels first, with all passes and for this processor the very first; then the peers.
std::vector<Way> all_ways(const Options& options, const Chain& chain, Quantity quantity, const Batch& batch) {
  std::vector<Way> ways;
  for (const Measured& header : generated_headers()) {
    if (header.model != chain.name) continue;
    for (Way& way : header.ways(quantity, batch)) ways.push_back(std::move(way));
  }
  for (Way& way : peer_ways(options.references, chain, quantity, batch)) ways.push_back(std::move(way));
  return ways;
}

void measure(const Options& options, const Chain& chain, std::vector<Row>& rows) {
  const Batch batch = random_batch(chain.joints.size(), options.states);
  for (const Quantity quantity : quantities) {
    const std::vector<Way> ways = all_ways(options, chain, quantity, batch);
    const std::vector<double> difference = differences(ways, quantity, batch.states);
    const std::vector<Timing> timings = time_in_turns(ways, batch.states, options.turns);
    for (std::size_t i = 0; i < ways.size(); ++i) {
      Row row{chain.name, chain.joints.size(), quantity, ways[i], timings[i], difference[i]};
      for (const Measured& header : generated_headers()) {
        if (row.way.competitor != "torsor" || header.model != chain.name || header.without != row.way.without) continue;
        row.operations = operations_in(header.header, quantity);
        row.header_bytes = std::filesystem::file_size(header.header);
      }
      row.way.run = nullptr;  // with them goes what they hold
      row.way.result = nullptr;
      print(row);
      rows.push_back(std::move(row));
    }
    std::fflush(stdout);
  }
}

/// Calls one way and nothing else, for a tool that counts instructions: the difference of two numbers of calls counts.
void call(const Options& options, const Chain& chain) {
  const Batch batch = random_batch(chain.joints.size(), options.states);
  const auto quantity = std::find_if(quantities.begin(), quantities.end(),
                                     [&](Quantity each) { return name_of(each) == options.single[0]; });
  if (quantity == quantities.end()) throw std::runtime_error("no quantity is called " + options.single[0]);
  for (const Way& way : all_ways(options, chain, *quantity, batch)) {
    if (way.competitor != options.single[1] || way.scalar != "double") continue;
    for (int calls = std::stoi(options.single[2]), k = 0; k < calls; ++k) {
      const std::size_t state = static_cast<std::size_t>(k) % batch.states;
      way.run(state, state + 1);
    }
    return;
  }
  throw std::runtime_error("there is no competitor " + options.single[1]);
}

void run(const Options& options) {
  const std::vector<Chain> chains = read_chains(options.references + "/models.json");
  const std::set<std::string> chosen(options.models.begin(), options.models.end());
  std::vector<Row> rows;
  if (options.single.empty()) {
    for (const std::string& peer : missing_peers()) fmt::print("{} was not found when this program was built\n", peer);
    print_heading();
  }
  std::set<std::string> done;
  for (const Measured& header : generated_headers()) {
    if ((!chosen.empty() && !chosen.contains(header.model)) || !done.insert(header.model).second) continue;
    const auto chain =
        std::find_if(chains.begin(), chains.end(), [&](const Chain& c) { return c.name == header.model; });
    if (chain == chains.end()) throw std::runtime_error("models.json has no chain " + header.model);
    if (options.single.empty())
      measure(options, *chain, rows);
    else
      call(options, *chain);
  }
  if (!options.output.empty()) write_files(rows, options.output);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Times of generated kernels and of other libraries for the same mechanisms."};
  Options options;
  app.add_option("--references", options.references, "folder of models.json and mjcf/")->capture_default_str();
  app.add_option("--output", options.output, "folder for CSV files and pictures")->check(CLI::ExistingDirectory);
  app.add_option("--models", options.models, "some models only")->delimiter(',');
  app.add_option("--turns", options.turns, "how often each competitor goes through all states")->capture_default_str();
  app.add_option("--states", options.states, "random states of each model")->capture_default_str();
  app.add_option("--call", options.single, "QUANTITY COMPETITOR CALLS: time nothing, call one kernel so often")
      ->expected(3);
  CLI11_PARSE(app, argc, argv);
  try {
    run(options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "kernels: %s\n", error.what());
    return 1;
  }
  return 0;
}
