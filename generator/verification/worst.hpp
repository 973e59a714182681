// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace torsor {

/// Whether x takes the place of the worst error so far. A NaN does, and nothing takes its place: comparisons and
/// std::max lose one at the next number.
inline bool is_worse(double x, double worst) { return !(x <= worst) && !std::isnan(worst); }

}  // namespace torsor
