// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "torsor/runtime/contacts/regime_system.hpp"

namespace torsor::runtime {

/// Motions across the directions of the slips of the contacts `who`, and their slopes as these directions turn.
struct SlipsAcross {
  SlipsAcross(const ContactProblem& problem, const RegimeSystem& system, const ContactVector& motion,
              std::span<const int> who) noexcept;
  /// The largest of these over the sizes of motions, of each row.
  [[nodiscard]] double largest(const ContactProblem& problem, const ContactVector& sizes) const noexcept;

  ContactVector across;
  ContactMatrix slopes;

 private:
  std::span<const int> who_;
};

/// Turns these directions by angles, of which none is larger than `most`: if one is, all shrink alike. False where an
/// angle is no number.
[[nodiscard]] bool turn_slips(RegimeSystem::Regimes& regimes, const PerContact<int>& who, ContactVector angles,
                              double most) noexcept;

/// What directions of slips are sought by.
struct BeginningSlips {
  const PerContact<bool>& begins;  ///< whose
  const ContactVector& held;       ///< reactions that are not unique are those nearest to these
  PerContact<double> across = {};  ///< s κ of each
};

/// Directions of slips that have just begun, in space. With the slip w_T = s d, d = (cos θ, sin θ), and the
/// acceleration w'_T(θ) = W r + q,
///   s' = d · w'_T,   s θ' = d × w'_T.
/// While s is small, θ follows the zero of d × w'_T within a time s/(f N W), so that d is known from forces alone, to
/// first order in s, from d × w'_T = s κ, κ the rate at which that zero turns. Newton's method for all such contacts at
/// once starts from the directions given; false where it finds none.
[[nodiscard]] bool align_slips(const ContactProblem& problem, RegimeSystem::Regimes& regimes,
                               const BeginningSlips& slips) noexcept;

}  // namespace torsor::runtime
