// SPDX-License-Identifier: GPL-3.0-or-later
// Discs that settle in a box: milliseconds of the processor a step, sweeps, the residual reached, and the memory.
// Sweeps and residuals are the same in every run.
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "benchmarks/contacts/box_of_discs.hpp"
#include "torsor/runtime/grains/grain_motion.hpp"

namespace {

using namespace torsor::runtime;

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

}  // namespace

int main(int argc, char** argv) {
  const int count = argc > 1 ? std::atoi(argv[1]) : 10000;
  const int steps = argc > 2 ? std::atoi(argv[2]) : 400;
  const double tolerance = argc > 3 ? std::atof(argv[3]) : 1e-6;
  const unsigned threads = argc > 4 ? static_cast<unsigned>(std::atoi(argv[4])) : 1;
  const int coarse = argc > 5 ? std::atoi(argv[5]) : 0;
  if (count < 1 || steps < 1 || !(tolerance > 0) || threads < 1 || coarse < 0) {
    std::fprintf(stderr, "usage: contacts [discs [steps [tolerance [threads [coarse steps before them]]]]]\n");
    return 2;
  }
  Grains<2> grains = box_of_discs(count, static_cast<int>(1.5 * std::sqrt(count)));
  {
    GrainMotion<2> before(grains, {.tolerance = 1e-2, .sweeps = 30, .threads = threads});
    for (int k = 0; k < coarse; ++k) (void)before.step(1e-3);
  }
  GrainMotion<2> motion(grains, {.tolerance = tolerance, .threads = threads});
  std::printf("%8s %9s %7s %9s %9s %10s\n", "step", "contacts", "sweeps", "residual", "depth/mm", "ms a step");
  const double start = processor_seconds();
  double before = start, visits = 0, sweeps = 0, logarithms = 0;
  double last = start, reached_time = 0;
  int missed = 0;
  const int group = steps < 10 ? 1 : steps / 10;
  for (int k = 1; k <= steps; ++k) {
    const GrainStep step = motion.step(1e-3);
    const double now = processor_seconds();
    if (step.converged) {
      reached_time += now - last;
    } else {
      ++missed;
    }
    last = now;
    sweeps += step.sweeps;
    logarithms += std::log(std::max(step.residual, 1e-16));
    visits += static_cast<double>(step.sweeps) * static_cast<double>(step.contacts);
    if (k % group != 0) continue;
    std::printf("%8d %9zu %7d %9.1e %9.4f %10.2f\n", k, step.contacts, step.sweeps, step.residual, 1e3 * step.deepest,
                1e3 * (now - before) / group);
    before = now;
  }
  const double all = last - start;
  std::printf("%d discs: %.2f ms of the processor a step; %d of %d steps ended above the residual %.0e\n", count,
              1e3 * all / steps, missed, steps, tolerance);
  std::printf("%.0f sweeps a step, %.3g visits of contacts in all, residual %.1e (geometric mean)\n", sweeps / steps,
              visits, std::exp(logarithms / steps));
  if (missed < steps && missed > 0) {
    std::printf("steps that reached it took %.2f ms, the others %.2f ms\n", 1e3 * reached_time / (steps - missed),
                1e3 * (all - reached_time) / missed);
  }
  std::printf("%.2f ns for each contact in each sweep, all else included; %.0f MB at most\n",
              visits > 0 ? 1e9 * all / visits : 0.0, peak_megabytes());
  return 0;
}
