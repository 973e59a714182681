// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "generator/emission/cpp_emitter.hpp"

namespace torsor {

/// Writes the body of a kernel of Taylor coefficients: the values at the start, then a loop over orders. At order k the
/// convolutions over coefficients 1..k-1 of all operations come first, side by side in lanes, since none waits for
/// another; what remains is to add, one operation after another, the terms with the coefficients k and 0. With a solve,
/// what depends on the accelerations is added up twice: without those of order k, and with them.
void write_series(FunctionEmitter& emitter, const Program& program, const SeriesResult& series, const Block& block);

/// Coefficients and constants that the text of a kernel with a solve reads: not all that its program has, since the
/// equations are solved without their terms in the accelerations themselves.
std::vector<Polynomial> coefficients_read(Program& program, const SeriesResult& series);

}  // namespace torsor
