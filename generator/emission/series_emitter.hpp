// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "generator/emission/cpp_emitter.hpp"

namespace torsor {

/// Writes the body of a kernel of Taylor coefficients: the values at the start, then a loop over orders. At order k the
/// convolutions over coefficients 1..k-1 of all operations come first, side by side in lanes, since none waits for
/// another; what remains is to add, one operation after another, the terms with the coefficients k and 0.
void write_series(FunctionEmitter& emitter, const Program& program, const SeriesResult& series, const Block& block);

}  // namespace torsor
