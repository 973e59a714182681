// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/verification/check.hpp"

namespace torsor {

/// The recurrences of the kernel `jets` at random states, in 140 digits: with y_N the Taylor polynomial of degree N,
/// y_N'(h) - f(y_N(h)) = -(N + 1) c_(N+1) h^N + O(h^(N+1)), f being the forward dynamics evaluated as it stands. At
/// hρ = 1e-10, ρ the growth of the coefficients, an error in any coefficient up to N would stand out by 1e10 or more.
/// And the same coefficients in double against CLN, as a multiple of max(1, condition of the motion / 10).
std::vector<CheckResult> check_jets(const Scene& scene, const CheckOptions& options);

}  // namespace torsor
