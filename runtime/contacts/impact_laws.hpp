// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "torsor/runtime/contacts/contact_problem.hpp"

namespace torsor::runtime {

/// How the velocity after an impact follows from that before; w+ = w- + W P, friction by Coulomb's disc on impulses.
enum class ImpactLaw {
  newton_moreau,  ///< all contacts at once: 0 <= w_N+ + e w_N-, P_N >= 0, one of them zero
  poisson,        ///< compression to w_N = 0 with the impulse P_c, then P_N >= e P_c of restitution
  energetic,      ///< of one contact: restitution gives back e² of the work of compression (energetic_impact.hpp)
  sequential,     ///< one contact after the other by Newton's law, in the order of declaration, until none closes
};

[[nodiscard]] constexpr std::string_view describe(ImpactLaw law) noexcept {
  switch (law) {
    case ImpactLaw::newton_moreau:
      return "Newton-Moreau";
    case ImpactLaw::poisson:
      return "Poisson";
    case ImpactLaw::energetic:
      return "energetic";
    case ImpactLaw::sequential:
      return "sequential";
  }
  return "unknown impact law";
}

/// The impulses of an impact and what is known of them.
struct ImpactResult {
  ContactVector P, w;         ///< impulses and velocities after
  PerContact<bool> closed{};  ///< w_N = 0 after
  PerContact<bool> sticks{};  ///< w_T = 0 after
  ContactVerdict verdict = ContactVerdict::none;
  /// Where several impulses fulfil the law of all contacts at once: regimes of each, those taken first. Of Poisson's law,
  /// those of the first of its two phases that has several.
  std::array<PerContact<ContactRegime>, ContactAnswer::kept> found{};
  std::size_t found_count = 0;
  double residual = 0;
  double lost = 0;      ///< -P (w- + w+)/2 of all: T- - T+ where no surface moves by itself
  bool gains = false;   ///< T+ > T- of bodies that act on each other, whatever others lose
  int collisions = 0;   ///< of the sequential law
  /// Of the sequential law: another order of contacts than that of declaration gives other velocities, or no end. All are
  /// tried of up to four contacts, of more the reverse one.
  bool order_matters = false;
  bool applies = true;  ///< false: the energetic law of one contact, and several strike at once
};

/// Solves an impact. `problem` holds W, the laws with f, and in q the velocities w-; e is the restitution of each
/// contact. Sources: Moreau 1988; Glocker & Pfeiffer 1995 (Poisson); Stronge 1990 (energetic); Pommier §7.6 (percussions).
[[nodiscard]] ImpactResult impact(const ContactProblem& problem, std::span<const double> restitution,
                                  ImpactLaw law = ImpactLaw::newton_moreau) noexcept;

}  // namespace torsor::runtime
