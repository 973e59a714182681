// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>

#include "torsor/runtime/contacts/contact_scale.hpp"
#include "torsor/runtime/contacts/regime_system.hpp"

namespace torsor::runtime {

/// What u_N = 0 of pressed contacts and u_T = 0 of sticking ones leave of the slips whose directions are sought. Contacts of
/// one body depend on each other: where two corners of a face stick the others do, and where one does each of the others
/// moves across the line to it. Rows of W and of q say so, whatever the forces are.
class SlipRelations {
 public:
  SlipRelations(const ContactProblem& problem, const ContactScale& scale, const RegimeSystem::Regimes& regimes) noexcept;

  /// Whether a slip is held at zero. Its regimes are then among those where that contact sticks: |T| = f N there.
  [[nodiscard]] bool holds_one() const noexcept { return holds_one_; }
  /// Whether all slips are multiples of one number: their directions are then `direction` of each, or all of them reversed.
  [[nodiscard]] bool leaves_one_number() const noexcept { return one_number_; }
  [[nodiscard]] const std::array<double, 2>& direction(int contact) const noexcept {
    return directions_[static_cast<std::size_t>(contact)];
  }

 private:
  bool holds_one_ = false, one_number_ = false;
  PerContact<std::array<double, 2>> directions_{};
};

}  // namespace torsor::runtime
