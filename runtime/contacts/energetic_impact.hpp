// SPDX-License-Identifier: MIT
#pragma once
#include "torsor/runtime/contacts/contact_problem.hpp"

namespace torsor::runtime {

/// The impact of one contact along its normal impulse p (Routh): dw/dp = W (1, τ), with τ = -f d while it slips along d,
/// and what keeps w_T = 0 where |τ| <= f_s suffices. Compression lasts until w_N = 0. Restitution lasts until the normal
/// force has given back e² of the work that it took (Stronge). No law of impact gives energy so. In space the direction
/// turns with the slip: its equations in dp = |w_T| ds are regular where the slip ends.
/// A contact that starts with w_N = 0 has an impact without collision where its slip makes dw_N/dp < 0 (Painlevé).
struct EnergeticImpact {
  ContactVector P, w;  ///< impulses and velocities after
  bool sticks = false;
  bool ended = false;  ///< false: no end was found
};

/// `problem` has one contact with a normal, and in q its velocities before.
[[nodiscard]] EnergeticImpact energetic_impact(const ContactProblem& problem, double restitution) noexcept;

}  // namespace torsor::runtime
