// SPDX-License-Identifier: GPL-3.0-or-later
// generation: what it costs to derive and to emit all kernels of a scene, in seconds and peak memory; with --chains,
// how that grows with the number of joints of a serial chain.

#include <cstdio>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#define TORSOR_NO_MAIN
#include "benchmarks/generation/growth.hpp"
#include "benchmarks/generation/resources.hpp"
#include "examples/arm7/scene.cpp"
#include "torsor/generator/cli/command_texts.hpp"
#include "torsor/generator/emission/header.hpp"
#include "torsor/generator/kernels/kernel.hpp"
#include "torsor/generator/printing/print_equations.hpp"

namespace {

void row(const char* step, double seconds, double size, const char* unit) {
  fmt::print("{:<36}{:>12.4f}{:>14.0f} {:<12}{:>10.1f}\n", step, seconds, size, unit, torsor::peak_megabytes());
}

void measure_arm7() {
  fmt::print("arm7, all kernels\n{:<36}{:>12}{:>14} {:<12}{:>10}\n", "step", "seconds", "size", "", "peak MB");
  const torsor::Scene scene = arm7_scene();
  const torsor::Equations equations(scene);
  for (const std::string& name : torsor::usual_kernel_names()) {
    const torsor::Stopwatch before;
    equations.start_over();
    const std::size_t size = equations.program().size();
    torsor::make_kernel(name, equations);
    row(name.c_str(), before.seconds(), static_cast<double>(equations.program().size() - size), "definitions");
  }
  const torsor::Stopwatch whole;
  const std::string header = torsor::emit_header(scene, torsor::usual_kernel_names());
  row("from the scene to the header", whole.seconds(), static_cast<double>(header.size()), "bytes");
  const torsor::Stopwatch reading;
  const std::string text = torsor::print_equations(scene, torsor::Format::text);
  row("printed equations", reading.seconds(), static_cast<double>(text.size()), "bytes");
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Seconds, memory and operations from a scene to its header."};
  std::vector<int> chains;
  std::string output;
  app.add_option("--chains", chains, "numbers of joints: serial chains, three kernels, instead of the arm")
      ->delimiter(',');
  app.add_option("--output", output, "folder for growth.csv and its pictures")->check(CLI::ExistingDirectory);
  CLI11_PARSE(app, argc, argv);
  try {
    if (chains.empty())
      measure_arm7();
    else
      torsor::measure_growth(chains, output);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
