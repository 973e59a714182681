// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/expression/expression.hpp"

namespace torsor {

/// ∂e/∂symbol of a formula as its author wrote it, by the rules of sums, products, powers and functions; zero where the
/// symbol does not stand in it. A rate inside the formula does not change with a coordinate.
Expression partial_derivative(const Expression& e, const SymbolPointer& symbol);

}  // namespace torsor
