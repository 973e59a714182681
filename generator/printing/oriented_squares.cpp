// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/printing/oriented_squares.hpp"

#include <algorithm>
#include <utility>

#include "torsor/generator/printing/notation.hpp"

namespace torsor::printing {
namespace {

bool is_sum(const WrittenFactor& factor) { return !factor.base && !factor.size && factor.inside.size() > 1; }

/// −sum, with a plus in front.
Written opposite(Written sum) {
  for (WrittenTerm& term : sum) term.coefficient = -term.coefficient;
  std::stable_partition(sum.begin(), sum.end(), [](const WrittenTerm& term) { return term.coefficient.sign() > 0; });
  return sum;
}

}  // namespace

void OrientedSquares::see(const Written& written) {
  for (const WrittenTerm& term : written) {
    for (const WrittenFactor& factor : term.factors) {
      if (is_sum(factor) && factor.halves == 2) factors_.insert(text(factor.inside));
      see(factor.inside);
      for (const Written& other : factor.others) see(other);
    }
  }
}

Written OrientedSquares::oriented(Written written) const {
  for (WrittenTerm& term : written) {
    for (WrittenFactor& factor : term.factors) {
      factor.inside = oriented(std::move(factor.inside));
      for (Written& other : factor.others) other = oriented(std::move(other));
      if (!is_sum(factor) || factor.halves % 4 != 0 || factors_.count(text(factor.inside)) > 0) continue;
      Written other = opposite(factor.inside);
      if (factors_.count(text(other)) > 0) factor.inside = std::move(other);
    }
  }
  return written;
}

Written OrientedSquares::oriented_entry(Written entry) const {
  for (WrittenTerm& term : entry) {
    for (WrittenFactor& factor : term.factors) {
      if (!is_sum(factor) || factor.halves != 2 || factors_.count(text(factor.inside)) > 0) continue;
      Written other = opposite(factor.inside);
      if (factors_.count(text(other)) == 0) continue;
      factor.inside = std::move(other);
      term.coefficient = -term.coefficient;
    }
  }
  return oriented(std::move(entry));
}

}  // namespace torsor::printing
