// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "torsor/generator/base/high_precision.hpp"
#include "torsor/generator/mechanics/scene.hpp"

namespace torsor::test {

/// How well the printed equations agree with the program that kernels are made of.
struct InlineCheck {
  bool written_out = false;  ///< false: too long, only definitions are printed; nothing was compared
  int states = 0;
  Real worst;            ///< largest relative difference over everything compared
  std::string worst_of;  ///< what differs most: "T", "U", a coordinate or a constraint
  std::vector<std::string> compared;
};

/// Evaluates what print_equations writes (factored and collected, term by term as it stands) at random states, inputs,
/// multipliers and parameters and compares T, U, each P_i − Q_i and each constraint with the program's own values:
/// twists for T, virtual power for P. Differences are relative to the largest magnitude of what is compared, so
/// agreement means about 10^(2 − digits). Seeded: the same states in every run.
InlineCheck check_inline(const Scene& scene, int digits, int states, std::uint64_t seed = 1);

}  // namespace torsor::test
