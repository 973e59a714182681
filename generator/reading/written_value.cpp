// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/expression/error.hpp"
#include "generator/reading/written.hpp"

namespace torsor::reading {
namespace {

Real of_factor(const WrittenFactor& factor, const std::function<Real(const SymbolPointer&)>& value_of, int digits) {
  if (!factor.base) {
    const Real sum = evaluate(factor.inside, value_of, digits);
    return factor.size ? abs(sum) : sum;
  }
  switch (factor.base->kind) {
    case Base::Kind::function:
      return apply(factor.base->function, evaluate(factor.inside, value_of, digits));
    case Base::Kind::symbol:
      if (factor.base->symbol->kind == SymbolKind::pi) return Real::pi(digits);
      return value_of(factor.base->symbol);
    default:
      throw Error("a named definition has no value of its own: evaluate the program instead");
  }
}

}  // namespace

Real apply(Function function, const Real& argument) {
  switch (function) {
    case Function::sin:
      return sin(argument);
    case Function::cos:
      return cos(argument);
    case Function::sqrt:
      return sqrt(argument);
    case Function::exp:
      return exp(argument);
    case Function::log:
      return log(argument);
  }
  return Real::not_a_number();
}

Real evaluate(const Written& written, const std::function<Real(const SymbolPointer&)>& value_of, int digits) {
  Real sum(Number(0), digits);
  for (const WrittenTerm& term : written) {
    Real product(term.coefficient, digits);
    for (const WrittenFactor& factor : term.factors) {
      const Real base = of_factor(factor, value_of, digits);
      product *= pow(base, factor.halves / 2);
      if (factor.halves % 2 != 0) {
        const Real root = sqrt(base);
        product = factor.halves > 0 ? product * root : product / root;
      }
    }
    sum += product;
  }
  return sum;
}

}  // namespace torsor::reading
