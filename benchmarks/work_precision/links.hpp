// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace work_precision {

/// One integrator on a pendulum of some links: from the tolerance to the state at the end and whether it was reached.
struct LinksWay {
  std::string name;
  std::function<bool(double tolerance, std::vector<double>& end)> run;
};

/// A pendulum of equal rods, one below the other, released at rest from 0.5 rad and nearly straight.
struct Links {
  int count = 0;
  std::vector<LinksWay> ways;
};

/// s of the motion; the same for all.
inline constexpr double links_end = 2.0;

Links links_2();
Links links_4();
Links links_8();
Links links_16();
Links links_32();

/// For pendulums of 2 to 32 links: time of the processor for a second of motion at an error of at most 1e-9 rad and
/// rad/s, by the loosest tolerance that gives it, against Taylor's method with compensated sums at 1e-15. A table;
/// links.csv and links.svg where there is a folder.
void measure_links(const std::filesystem::path& folder, int turns);

}  // namespace work_precision
