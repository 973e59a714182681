// SPDX-License-Identifier: GPL-3.0-or-later
// model_counts MODELS.json ROBOT.urdf ...: operation counts of the kernels of robots given as data.

#include <cstdio>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "benchmarks/model_counts/models.hpp"
#include "torsor/generator/base/error.hpp"
#include "torsor/generator/cli/command_texts.hpp"
#include "torsor/generator/import/urdf.hpp"
#include "torsor/generator/kernels/kernel.hpp"

namespace {

std::vector<torsor::Scene> read(const std::string& path) {
  if (path.ends_with(".urdf")) return {torsor::read_urdf(path).scene};
  return torsor::read_models(path);
}

int run(const std::vector<std::string>& paths, const std::string& kernels, const std::string& only, bool json) {
  std::vector<torsor::SceneCounts> counts;
  const std::vector<std::string> names = torsor::parse_kernel_list(kernels);
  for (const std::string& path : paths) {
    for (const torsor::Scene& scene : read(path)) {
      if (!only.empty() && scene.name() != only) continue;
      counts.push_back(torsor::count_scene(scene, names, {}));
    }
  }
  if (counts.empty()) {
    throw torsor::UsageError(fmt::format("no model '{}' in '{}'", only, fmt::join(paths, "', '")));
  }
  const std::string text = json ? torsor::counts_json(counts) : torsor::counts_table(counts);
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0) {
    throw torsor::FileError("cannot write to the standard output: is the disk full or the reader gone?");
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Operation counts of the kernels of robots."};
  std::vector<std::string> paths;
  std::string kernels = "inverse_dynamics,mass_matrix,forward_dynamics";
  std::string only;
  bool json = false;
  app.add_option("models", paths, "JSON files of serial chains, URDF files")->required();
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
    return run(paths, kernels, only, json);
  } catch (const torsor::UsageError& error) {
    std::fprintf(stderr, "%s: %s\n", argv[0], error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", argv[0], error.what());
    return 3;
  }
}
