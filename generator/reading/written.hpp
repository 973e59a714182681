// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "generator/expression/high_precision.hpp"
#include "generator/reading/canonical_sum.hpp"

namespace torsor::reading {

struct WrittenTerm;

/// A sum as it stands on paper: terms in the order of writing, factored and collected for reading.
using Written = std::vector<WrittenTerm>;

struct WrittenFactor {
  BasePointer base;  ///< a symbol, a definition or a function; null for a sum in parentheses
  Written inside;    ///< argument of a function, or the sum in parentheses
  int halves = 2;    ///< the factor stands to the power halves/2
  bool size = false;  ///< of a sum in parentheses: |sum| stands to that power
};

/// coefficient · factors, in the order of writing.
struct WrittenTerm {
  Number coefficient{1};
  std::vector<WrittenFactor> factors;
};

/// What is being written: decides which group of terms comes first.
struct Layout {
  SymbolPointer own;  ///< the acceleration that comes first, may be null
};

/// Collects by accelerations, then by products of velocities, then the rest, inputs and multipliers; inside by what
/// depends on the configuration; parameters gather in the coefficients. A sum in parentheses starts with a plus.
Written collected(const Sum& sum, const Layout& layout = {});

/// f(argument) at the argument's precision.
Real apply(Function function, const Real& argument);

/// Value of what is written, for values of the symbols. Definitions throw Error.
Real evaluate(const Written& written, const std::function<Real(const SymbolPointer&)>& value_of, int digits);

}  // namespace torsor::reading
