// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/generation/growth.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <stdexcept>

#include <fmt/format.h>

#include "benchmarks/generation/resources.hpp"
#include "benchmarks/generation/serial_chain.hpp"
#include "torsor/generator/emission/header.hpp"
#include "torsor/generator/kernels/kernel.hpp"
#include "torsor/generator/program/formula.hpp"
#include "torsor/runtime/records/plot.hpp"

namespace torsor {
namespace {

constexpr std::array<const char*, 3> kernel_list = {"inverse_dynamics", "mass_matrix", "forward_dynamics"};

/// Plain numbers only: they come through a pipe.
struct Growth {
  std::array<double, 3> kernel_seconds;
  std::array<double, 3> operations;
  double emission_seconds, total_seconds, definitions, bytes, megabytes;
};

Growth grown(int joints) {
  Growth growth{};
  const Stopwatch total;
  const Scene scene = serial_chain(joints);
  const MechanismListing mechanism = lower_mechanism(scene, {kernel_list.begin(), kernel_list.end()});
  const Stopwatch emission;
  growth.bytes = static_cast<double>(emit_header(mechanism).size());
  growth.emission_seconds = emission.seconds();
  growth.total_seconds = total.seconds();
  growth.megabytes = peak_megabytes();
  const Equations equations(scene);
  for (std::size_t k = 0; k < kernel_list.size(); ++k) {
    equations.start_over();
    const Stopwatch step;
    const Kernel kernel = make_kernel(kernel_list[k], equations);
    growth.kernel_seconds[k] = step.seconds();
    growth.operations[k] = static_cast<double>(count(equations.program(), kernel.values()).total());
    growth.definitions += static_cast<double>(equations.program().size());
  }
  return growth;
}

Growth grown_alone(int joints) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) throw std::runtime_error("generation: no pipe could be opened");
  const pid_t child = fork();
  if (child == 0) {
    bool sent = false;
    try {
      const Growth growth = grown(joints);
      sent = write(ends[1], &growth, sizeof growth) == static_cast<ssize_t>(sizeof growth);
    } catch (const std::exception& error) {
      std::fprintf(stderr, "generation: %d joints: %s\n", joints, error.what());
    }
    _exit(sent ? 0 : 1);
  }
  close(ends[1]);
  Growth growth{};
  const bool received = child > 0 && read(ends[0], &growth, sizeof growth) == static_cast<ssize_t>(sizeof growth);
  close(ends[0]);
  if (child > 0) waitpid(child, nullptr, 0);
  if (!received) throw std::runtime_error(fmt::format("generation: the process for {} joints failed", joints));
  return growth;
}

void draw(const std::filesystem::path& folder) {
  const std::filesystem::path csv = folder / "growth.csv";
  runtime::Plot time{"from a chain's scene to its header", "joints", "seconds", {}, true, true};
  runtime::Plot operations{"operations of a chain's kernels", "joints", "operations", {}, true, true};
  for (const std::string name : kernel_list) {
    time.curves.push_back({csv, "joints", name + "_seconds", name, "linespoints"});
    operations.curves.push_back({csv, "joints", name + "_operations", name, "linespoints"});
  }
  time.curves.push_back({csv, "joints", "emission_seconds", "emission", "linespoints"});
  time.curves.push_back({csv, "joints", "seconds", "all", "linespoints"});
  runtime::write_plot(time, folder / "growth_seconds.svg");
  runtime::write_plot(operations, folder / "growth_operations.svg");
}

}  // namespace

void measure_growth(const std::vector<int>& joints, const std::string& folder) {
  std::string csv =
      "joints,inverse_dynamics_seconds,mass_matrix_seconds,forward_dynamics_seconds,emission_seconds,seconds,"
      "inverse_dynamics_operations,mass_matrix_operations,forward_dynamics_operations,definitions,header_bytes,"
      "peak_megabytes\n";
  fmt::print("{:>6}{:>10}{:>10}{:>10}{:>10}{:>10}{:>12}{:>12}{:>12}{:>10}{:>9}\n", "joints", "inverse/s", "mass/s",
             "forward/s", "emit/s", "all/s", "inverse", "mass", "forward", "kB", "peak MB");
  for (const int n : joints) {
    const Growth g = grown_alone(n);
    fmt::print("{:>6}{:>10.4f}{:>10.4f}{:>10.4f}{:>10.4f}{:>10.4f}{:>12.0f}{:>12.0f}{:>12.0f}{:>10.0f}{:>9.0f}\n", n,
               g.kernel_seconds[0], g.kernel_seconds[1], g.kernel_seconds[2], g.emission_seconds, g.total_seconds,
               g.operations[0], g.operations[1], g.operations[2], g.bytes / 1000, g.megabytes);
    std::fflush(stdout);
    csv += fmt::format("{},{:.5f},{:.5f},{:.5f},{:.5f},{:.5f},{},{},{},{},{},{:.1f}\n", n, g.kernel_seconds[0],
                       g.kernel_seconds[1], g.kernel_seconds[2], g.emission_seconds, g.total_seconds, g.operations[0],
                       g.operations[1], g.operations[2], g.definitions, g.bytes, g.megabytes);
  }
  if (folder.empty()) return;
  runtime::write_file(std::filesystem::path(folder) / "growth.csv", csv);
  draw(folder);
}

}  // namespace torsor
