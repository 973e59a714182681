// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "torsor/generator/verification/check.hpp"

namespace torsor {

/// Contacts of a scene against their own motion: along random motions the gap's first and second difference quotients are
/// w and J v̇ + drift of its normal, those of every w are J v̇ + drift of its row, and w changes with each velocity by its
/// entry of J. Nothing for a scene without contacts.
std::vector<CheckResult> check_contacts(const Scene& scene, const CheckOptions& options);

}  // namespace torsor
