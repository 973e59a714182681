// SPDX-License-Identifier: MIT
#pragma once
#include "torsor/runtime/contacts/contact_problem.hpp"

namespace torsor::runtime {

/// Whether a problem whose W is regular has at most one solution, as far as a bound says so; false says nothing.
///
/// Two solutions differ by Δr and Δu = W Δr. Signorini's law gives ΔN Δu_N <= 0, and friction, which opposes the slip with
/// |T| <= f N + b, gives ΔT · Δu_T <= f |ΔN| |Δu_T|. Hence
///   Δr · W Δr <= Σ f_i |ΔN_i| |Δu_T,i| <= Σ f_i/2 (c_i ΔN_i² + |Δu_T,i|²/c_i)   with any c_i > 0,
/// and if the right side is less than Δr · W Δr for every Δr, there is none. Friction at rest that is greater than in motion,
/// and joints pressed across their axes, have no such bound.
[[nodiscard]] bool solution_is_unique(const ContactProblem& problem) noexcept;

}  // namespace torsor::runtime
