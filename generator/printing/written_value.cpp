// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/printing/written.hpp"
#include "torsor/generator/program/function_values.hpp"

namespace torsor::printing {
namespace {

Real of_factor(const WrittenFactor& factor, const std::function<Real(const SymbolPointer&)>& value_of, int digits) {
  if (!factor.base) {
    const Real sum = evaluate(factor.inside, value_of, digits);
    return factor.size ? abs(sum) : sum;
  }
  switch (factor.base->kind) {
    case Base::Kind::function:
    {
      std::vector<Real> arguments{evaluate(factor.inside, value_of, digits)};
      for (const Written& other : factor.others) arguments.push_back(evaluate(other, value_of, digits));
      if (factor.tangent) {
        return value_of_call(Function::sin, arguments) / value_of_call(Function::cos, arguments);
      }
      if (!factor.least) return value_of_call(factor.base->function, arguments);
      for (Real& argument : arguments) argument = -argument;
      return -value_of_call(factor.base->function, arguments);
    }
    case Base::Kind::symbol:
      if (factor.base->symbol->kind == SymbolKind::pi) return Real::pi(digits);
      return value_of(factor.base->symbol);
    default:
      throw Error("a named definition has no value of its own: evaluate the program instead");
  }
}

}  // namespace

Written with_parts_of_numbers(const Written& written) {
  constexpr int parts = 4;
  Written apart;
  for (const WrittenTerm& term : written) {
    if (!term.factors.empty() || term.coefficient.is_rational()) {
      apart.push_back(term);
      continue;
    }
    const auto begin = static_cast<Written::difference_type>(apart.size());
    for (int i = 0; i < parts; ++i) {
      std::array<cln::cl_RA, parts> alone{0, 0, 0, 0};
      alone[static_cast<std::size_t>(i)] = term.coefficient.part(i);
      const Number part = Number::from_parts(alone[0], alone[1], alone[2], alone[3]);
      if (!part.is_zero()) apart.push_back({part, {}});
    }
    std::stable_partition(apart.begin() + begin, apart.end(), [](const WrittenTerm& part) { return part.coefficient.sign() > 0; });
  }
  return apart;
}

std::string name_on_paper(const WrittenFactor& call) {
  return call.tangent ? "tan" : call.least ? "min" : std::string(to_string(call.base->function));
}

std::vector<Case> cases_of(const WrittenFactor& select) {
  const auto inner = [](const Written& form) -> const WrittenFactor* {
    if (form.size() != 1 || form[0].factors.size() != 1 || !form[0].coefficient.is_one()) return nullptr;
    const WrittenFactor& only = form[0].factors[0];
    const bool call = only.base && only.base->kind == Base::Kind::function && only.halves == 2;
    return call && only.base->function == Function::select ? &only : nullptr;
  };
  std::vector<Case> rows;
  for (const WrittenFactor* at = &select;;) {
    const Written &first = at->others[0], &second = at->others[1];
    const WrittenFactor *in_first = inner(first), *in_second = inner(second);
    // The form that goes on stands last.
    const bool first_goes_on = in_first != nullptr && in_second == nullptr;
    rows.push_back({first_goes_on ? &second : &first, &at->inside, !first_goes_on});
    const WrittenFactor* next = first_goes_on ? in_first : in_second;
    if (next == nullptr) {
      rows.push_back({&second, nullptr, true});
      return rows;
    }
    at = next;
  }
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

}  // namespace torsor::printing
