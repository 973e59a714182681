// SPDX-License-Identifier: GPL-3.0-or-later
// generation: what it costs to derive and to emit all kernels of a scene, in seconds and peak memory.

#include <sys/resource.h>

#include <chrono>
#include <cstdio>

#include <fmt/format.h>

#define TORSOR_NO_MAIN
#include "examples/arm7/scene.cpp"
#include "generator/cli/commands.hpp"
#include "generator/emission/header.hpp"
#include "generator/emission/kernel.hpp"
#include "generator/reading/print_equations.hpp"

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// Largest memory this process has had, in megabytes.
double peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

void row(const char* step, double seconds, double size, const char* unit) {
  fmt::print("{:<36}{:>12.4f}{:>14.0f} {:<12}{:>10.1f}\n", step, seconds, size, unit, peak_megabytes());
}

}  // namespace

int main() {
  fmt::print("arm7, all kernels\n{:<36}{:>12}{:>14} {:<12}{:>10}\n", "step", "seconds", "size", "", "peak MB");
  const auto start = Clock::now();
  const torsor::Scene scene = arm7_scene();
  const torsor::Equations equations(scene);
  std::vector<torsor::Kernel> kernels;
  for (const std::string& name : torsor::kernel_names()) {
    const auto before = Clock::now();
    const std::size_t size = equations.program().size();
    kernels.push_back(torsor::make_kernel(name, equations));
    row(name.c_str(), seconds_since(before), static_cast<double>(equations.program().size() - size), "definitions");
  }
  const auto emission = Clock::now();
  const std::string header = torsor::emit_header(equations, kernels);
  row("emission", seconds_since(emission), static_cast<double>(header.size()), "bytes");
  row("derivation and emission together", seconds_since(start), static_cast<double>(equations.program().size()),
      "definitions");
  const auto reading = Clock::now();
  const std::string text = torsor::print_equations(scene, torsor::Format::text);
  row("printed equations", seconds_since(reading), static_cast<double>(text.size()), "bytes");
  return 0;
}
