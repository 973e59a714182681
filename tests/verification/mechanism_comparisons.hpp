// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "tests/dynamics/random_mechanism.hpp"

namespace torsor::testing_mechanisms {

// Comparisons of one random mechanism by derivations that have nothing in common, at a random state, in 50 digits. Each
// gives what differs, empty when nothing does.

constexpr int comparison_digits = 50;

/// What was compared, summed over the mechanisms.
struct ComparisonCounts {
  int energies = 0, painleve = 0, momenta = 0;                  ///< first integrals that are not constants
  int constrained_integrals = 0;                                ///< those of mechanisms with constraints
  int reactions = 0;                                            ///< of released coordinates
  /// See LinearisationOutcome.
  int linearised = 0, turning = 0, forward = 0, reduced = 0, redundant = 0;
};

/// Both derivations, M, forward dynamics, the energy theorem in Painlevé's form, constraints.
std::string compare_derivations(const RandomMechanismOptions& options, unsigned seed, ComparisonCounts& counts);
/// First integrals of the mechanism without what has none do not change along the motion, constraints or not.
std::string differentiate_first_integrals(const RandomMechanismOptions& options, unsigned seed,
                                          ComparisonCounts& counts);
/// The multiplier of a constraint q = 0 against the reaction of a released coordinate that the joint holds at zero.
std::string compare_parametrisations(const RandomMechanismOptions& options, unsigned seed, ComparisonCounts& counts);
/// The linearisation, reduced too, against finite differences: compare_linearisation.
std::string compare_linearisations(const RandomMechanismOptions& options, unsigned seed, ComparisonCounts& counts);

}  // namespace torsor::testing_mechanisms
