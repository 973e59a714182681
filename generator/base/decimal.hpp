// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "torsor/generator/base/number.hpp"

namespace torsor {

/// The exact value of a text: "12", "-1.5e-3", ".5", "+2.", "3/4" (a quotient of two integers). The whole text must be
/// read. Throws Error naming the text, also for a zero denominator and for an exponent beyond ±10000.
Number parse_decimal(std::string_view text);

/// The exact value of the shortest decimal that reads back as `value`: 0.1 gives 1/10. Throws Error when not finite.
Number from_double(double value);

/// Shortest decimal that reads back as the same number ("0.1", "1e+22", "2"; "inf" and "nan" as std::to_chars).
std::string shortest(double value);
std::string shortest(float value);

}  // namespace torsor
