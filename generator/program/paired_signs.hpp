// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/program/polynomial.hpp"

namespace torsor {

class Program;

/// Products and powers of terms, with |x|^2 as x^2, sign(x)^2 as 1 and sign(x) |x| as x. So the square of a length sqrt(x^2)
/// has the slopes of x^2 at x = 0, where |x| has none. That sign(x)^2 is 0 at x = 0 alone is not kept.
/// Roots that cancel do so behind the names of products too: sqrt(s)^3 times s'/(2 sqrt(s)) is no 0/0 where s = 0.
Term product(const Program& program, const Term& a, const Term& b);
Term power(const Program& program, const Term& base, int exponent);

}  // namespace torsor
