// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "torsor/generator/base/high_precision.hpp"
#include "torsor/generator/printing/canonical_sum.hpp"

namespace torsor::printing {

struct WrittenTerm;

/// A sum as it stands on paper: terms in the order of writing, factored and collected for reading.
using Written = std::vector<WrittenTerm>;

struct WrittenFactor {
  BasePointer base;  ///< a symbol, a definition or a function; null for a sum in parentheses
  Written inside;    ///< (first) argument of a function, or the sum in parentheses
  int halves = 2;    ///< the factor stands to the power halves/2
  bool size = false;  ///< of a sum in parentheses: |sum| stands to that power
  std::vector<Written> others{};  ///< further arguments of a function
  bool least = false;  ///< of a maximum: the smaller of its arguments as they stand here
  bool tangent = false;  ///< of a sine: over the cosine of the same angle
};

/// coefficient · factors, in the order of writing.
struct WrittenTerm {
  Number coefficient{1};
  std::vector<WrittenFactor> factors;
};

/// What is being written: decides which group of terms comes first.
struct Layout {
  SymbolPointer own{};  ///< the acceleration that comes first, may be null
  std::vector<WrittenTerm> whole{};  ///< terms that stand as they are, before what depends on no velocity
};

/// Collects by accelerations, then by products of velocities, then the rest, inputs and multipliers; inside by what
/// depends on the configuration; parameters gather in the coefficients. A sum in parentheses starts with a plus.
Written collected(const Sum& sum, const Layout& layout = {});

/// The same of a quantity that stands alone, as an entry of a matrix: what all terms share stands before parentheses where none are
/// inside, and a term with a plus leads.
Written collected_entry(const Sum& sum);

/// A sum as it is put down: a number with roots that stands alone is a term for each of its parts, those with a plus first,
/// so that its sign reaches them all.
Written with_parts_of_numbers(const Written& written);

/// How the function of a factor is called on paper.
std::string name_on_paper(const WrittenFactor& call);

/// One row of a selection by cases: its value where the condition holds (>= 0) or does not (< 0), the last one elsewhere.
struct Case {
  const Written* value = nullptr;
  const Written* condition = nullptr;  ///< null in the last row
  bool holds = true;
};
/// The rows of a select; of one that is the other form of another, one after the other.
std::vector<Case> cases_of(const WrittenFactor& select);

/// Value of what is written, for values of the symbols. Definitions throw Error.
Real evaluate(const Written& written, const std::function<Real(const SymbolPointer&)>& value_of, int digits);

}  // namespace torsor::printing
