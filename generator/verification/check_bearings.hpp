// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "torsor/generator/verification/check.hpp"

namespace torsor {

/// What joints with friction in proportion to it transmit across their axes, in its parts, against Newton's theorem for all
/// that they carry, whose acceleration is differentiated from positions alone. Reactions of contacts are left out.
std::vector<CheckResult> check_bearings(const Scene& scene, const CheckOptions& options);

}  // namespace torsor
