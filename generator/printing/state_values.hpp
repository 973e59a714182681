// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "torsor/generator/expression/expression.hpp"

namespace torsor::printing {

/// A state that is given by values of its symbols, which may be formulas of others.
using StateValues = std::vector<std::pair<SymbolPointer, Expression>>;

/// Throws UsageError naming a value that needs a symbol to which the state gives a value too, or a rate, which is zero unless it
/// is given: all are put in at once, so that formulas would be partly at the one and partly at the other.
void refuse_values_of_each_other(const StateValues& state);

}  // namespace torsor::printing
