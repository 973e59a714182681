// SPDX-License-Identifier: GPL-3.0-or-later
// Discs that settle in a box: milliseconds of the processor a step, sweeps, and the residual reached.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "benchmarks/contacts/box_of_discs.hpp"
#include "runtime/grains/grain_motion.hpp"

namespace {

using namespace torsor::runtime;

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

}  // namespace

int main(int argc, char** argv) {
  const int count = argc > 1 ? std::atoi(argv[1]) : 10000;
  const int steps = argc > 2 ? std::atoi(argv[2]) : 400;
  const double tolerance = argc > 3 ? std::atof(argv[3]) : 1e-6;
  const unsigned threads = argc > 4 ? static_cast<unsigned>(std::atoi(argv[4])) : 1;
  if (count < 1 || steps < 1 || !(tolerance > 0) || threads < 1) {
    std::fprintf(stderr, "usage: contacts [discs [steps [tolerance [threads]]]]\n");
    return 2;
  }
  Grains<2> grains = box_of_discs(count, static_cast<int>(1.5 * std::sqrt(count)));
  GrainMotion<2> motion(grains, {.tolerance = tolerance, .threads = threads});
  std::printf("%8s %9s %7s %9s %9s %10s\n", "step", "contacts", "sweeps", "residual", "depth/mm", "ms a step");
  const double start = processor_seconds();
  double before = start;
  int missed = 0;
  const int group = steps < 10 ? 1 : steps / 10;
  for (int k = 1; k <= steps; ++k) {
    const GrainStep step = motion.step(1e-3);
    missed += step.converged ? 0 : 1;
    if (k % group != 0) continue;
    const double now = processor_seconds();
    std::printf("%8d %9zu %7d %9.1e %9.4f %10.2f\n", k, step.contacts, step.sweeps, step.residual, 1e3 * step.deepest,
                1e3 * (now - before) / group);
    before = now;
  }
  std::printf("%d discs: %.2f ms of the processor a step; %d of %d steps ended above the residual %.0e\n", count,
              1e3 * (processor_seconds() - start) / steps, missed, steps, tolerance);
  return 0;
}
