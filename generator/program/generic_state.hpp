// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "torsor/generator/base/high_precision.hpp"
#include "torsor/generator/expression/symbol.hpp"

namespace torsor {

/// The number of a symbol at a state made of `numbers`, with unit quaternions: a component of one gets its own number
/// over the norm of all four, the first of them 1 where all are zero; any other symbol keeps its number and π is π.
/// Each state at which a program is tried is made so: formulas of rotations hold for |e| = 1 only, and elsewhere a mass
/// matrix is not even positive definite.
Real at_unit_quaternions(const SymbolPointer& symbol, const std::function<Real(const SymbolPointer&)>& numbers);

/// A pseudo-random but fixed value for every symbol, at the working precision: between 1/3 and 5/3, components of unit
/// quaternions then over their norm; π is π. No relation holds between those of different symbols or trials.
Real generic_value(const SymbolPointer& symbol, int trial);

}  // namespace torsor
