// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/base/high_precision.hpp"
#include "torsor/generator/base/linear_algebra/real_rows.hpp"
#include "torsor/generator/expression/symbol.hpp"
#include "torsor/generator/program/evaluation.hpp"
#include "tests/base/error_of.hpp"

namespace torsor::testing_symbols {

inline SymbolPointer make_symbol(const std::string& name, std::string_view unit = "1",
                                 SymbolKind kind = SymbolKind::parameter, SymbolPointer rate = nullptr) {
  return std::make_shared<const Symbol>(Symbol{name, Unit::parse(unit), kind, 0, std::move(rate)});
}

/// A coordinate q with its velocity and acceleration, named q, q' and q''.
struct TestCoordinate {
  explicit TestCoordinate(const std::string& name, const Unit& unit = Unit())
      : a(std::make_shared<const Symbol>(
            Symbol{name + "''", unit / units::second.pow(2), SymbolKind::acceleration, 0, nullptr})),
        v(std::make_shared<const Symbol>(Symbol{name + "'", unit / units::second, SymbolKind::velocity, 0, a})),
        q(std::make_shared<const Symbol>(Symbol{name, unit, SymbolKind::coordinate, 0, v})) {}
  SymbolPointer a, v, q;
};

/// Values by symbol name; pi is known.
using Point = std::map<std::string, Real>;
inline Evaluator<Real>::SymbolValue at(const Point& point) {
  return [point](const SymbolPointer& symbol) {
    return symbol->kind == SymbolKind::pi ? Real::pi() : point.at(symbol->name);
  };
}

inline Real rational(long numerator, long denominator) {
  return Real(Number::rational(numerator, denominator), Real::working_digits());
}

/// |x − y| ≤ 10^exponent · max(1, |y|), as a double of the left side over the factor, for messages.
inline double relative_difference(const Real& x, const Real& y) {
  const Real size = abs(y) > Real(1) ? abs(y) : Real(1);
  return (abs(x - y) / size).to_double();
}

using testing_errors::error_of;

}  // namespace torsor::testing_symbols
