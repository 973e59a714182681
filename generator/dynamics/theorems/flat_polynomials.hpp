// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "torsor/generator/dynamics/recursions/forward_dynamics.hpp"
#include "torsor/generator/program/program.hpp"

namespace torsor {

/// Small results that a person reads and whose zeros must be seen: values multiplied out to one flat polynomial in
/// symbols, functions of them and quotients. Kernels are never made of these: they grow with the number of coordinates
/// as no program does.

/// The value with every sum it was bound to put back (not in denominators, roots and arguments of functions), and
/// sin² + cos² = 1 used. Throws UsageError when more than `limit` terms arise.
Value multiplied_out(const Value& value, std::size_t limit = 20000);

/// The determinant of a square matrix, multiplied out, by minors of its first rows: for some eight rows at most. Zero
/// when it vanishes. Throws UsageError for a matrix that is not square.
Value determinant(Program& program, const ValueMatrix& matrix);

/// A flat value as a person writes it: "7 k m - 2 P l", "M2 g d cos(theta)".
std::string readable(const Value& value);

}  // namespace torsor
