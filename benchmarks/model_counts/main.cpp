// SPDX-License-Identifier: GPL-3.0-or-later
// model_counts MODELS.json: operation counts of the kernels of serial chains given as data.

#include <cstdio>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "benchmarks/model_counts/models.hpp"
#include "generator/base/error.hpp"
#include "generator/cli/command_texts.hpp"
#include "generator/kernels/kernel.hpp"

namespace {

int run(const std::string& path, const std::string& kernels, const std::string& only, bool json) {
  std::vector<torsor::SceneCounts> counts;
  const std::vector<std::string> names = torsor::parse_kernel_list(kernels);
  for (const torsor::Scene& scene : torsor::read_models(path)) {
    if (!only.empty() && scene.name() != only) continue;
    counts.push_back(torsor::count_scene(scene, names, {}));
  }
  if (counts.empty()) throw torsor::UsageError(fmt::format("'{}' has no model '{}'", path, only));
  const std::string text = json ? torsor::counts_json(counts) : torsor::counts_table(counts);
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0) {
    throw torsor::FileError("cannot write to the standard output: is the disk full or the reader gone?");
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Operation counts of the kernels of serial chains."};
  std::string path;
  std::string kernels = "inverse_dynamics,mass_matrix,forward_dynamics";
  std::string only;
  bool json = false;
  app.add_option("models", path, "JSON file of models")->required();
  app.add_option("--kernels", kernels, "comma-separated list, or all")->capture_default_str();
  app.add_option("--model", only, "one model only, by name");
  app.add_flag("--json", json, "print JSON");
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    std::fprintf(stderr, "%s: %s; see --help\n", argv[0], error.what());
    return 2;
  }
  try {
    return run(path, kernels, only, json);
  } catch (const torsor::UsageError& error) {
    std::fprintf(stderr, "%s: %s\n", argv[0], error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", argv[0], error.what());
    return 3;
  }
}
