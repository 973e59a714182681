// SPDX-License-Identifier: GPL-3.0-or-later
// Discs that settle in a box: milliseconds of the processor a step, sweeps, and the residual reached.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "runtime/grains/grain_motion.hpp"

namespace {

using namespace torsor::runtime;

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Discs of radii from 8 to 12 mm in columns, a little apart, in a box of three walls.
Grains<2> box_of_discs(int count) {
  Grains<2> grains;
  const int columns = static_cast<int>(1.5 * std::sqrt(count));
  unsigned long long state = 1;
  for (int i = 0; i < count; ++i) {
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    const double R = 0.008 + 0.004 * static_cast<double>(state >> 40) / static_cast<double>(1 << 24);
    grains.add({0.0125 + 0.025 * (i % columns), 0.0125 + 0.025 * (i / columns)}, R, 3000 * R * R);
  }
  GrainWall<2> left, right, floor;
  left.normal = {1, 0};
  right.normal = {-1, 0};
  right.point = {0.025 * columns, 0};
  grains.walls = {floor, left, right};
  return grains;
}

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
  Grains<2> grains = box_of_discs(count);
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
