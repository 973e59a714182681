// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "torsor/generator/printing/linearised_equations.hpp"

namespace torsor::printing {

/// The linearised equations of a constrained scene in independent freedoms, written out:
///   M ẇ + C w + K e = F + E u,   ė = D e + N w,
/// e the deviations of `coordinates`, w of the rates of `velocities` (generator/dynamics/derivatives/reduction.hpp).
struct ReducedEquations {
  std::vector<std::string> coordinates, velocities;
  SumMatrix M, C, K, E, D, N;
  std::vector<Sum> F;

  /// Whether ė = w: where all constraints are holonomic and no freedom is that of an attitude.
  bool rates_are_velocities() const;
  /// Terms of all entries together.
  std::size_t terms() const;
};

/// Parameters and multipliers are symbols, accelerations zero; with a state `about` velocities too, as far as it does not name
/// them. Nothing where an entry has more terms than `limits` allows; no velocities where no freedom is left. Throws SceneError where
/// the freedoms cannot be chosen, as the kernel does.
std::optional<ReducedEquations> reduced_equations(const Scene& scene, const InlineLimits& limits, const About& about);

/// What a named state leaves of a constraint that it does not fulfil: f(q, t), or of a rate Σ a_i q̇_i − b.
struct ConstraintLeft {
  std::string name;
  bool rate = false;
  std::optional<Sum> left;  ///< nothing where it is too long to be written out
  /// Whether parameters, time or coordinates that are not named can make it zero.
  bool open = false;
};

/// Of every constraint and of its rate, with parameters as symbols and velocities that are not named zero.
std::vector<ConstraintLeft> constraints_left(const Scene& scene, const InlineLimits& limits, const About& about);

}  // namespace torsor::printing
