// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/listing/generation_constant.hpp"

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/program/evaluation.hpp"

namespace torsor {
namespace {

Real evaluated(Program& program, ValueNumber value_number) {
  Evaluator<Real> evaluate(program, [&program, value_number](const SymbolPointer& symbol) {
    if (symbol->kind == SymbolKind::pi) return Real::pi(Real::working_digits());
    throw Error(fmt::format("'{}' depends on '{}': its value is not known when the header is generated",
                            label(program, value_number), symbol->name));
  });
  return evaluate(program.value_of_number(value_number));
}

}  // namespace

RoundedConstant rounded_constant(Program& program, ValueNumber value_number) {
  constexpr int most_digits = 1280;
  for (int digits = 40;; digits *= 2) {
    const auto at = [&](int precision) {
      const WorkingDigits working(precision);
      return evaluated(program, value_number);
    };
    const Real coarse = at(digits);
    const Real fine = at(2 * digits);
    if (fine.is_nan() || coarse.is_nan()) {
      throw Error(
          fmt::format("the constant '{}' of the scene has no value: it divides by zero, or takes the root or "
                      "logarithm of a negative number",
                      label(program, value_number)));
    }
    // A value known to 30 digits rounds to 53 bits at once, unless it lies within 1e-30 of a half: then two
    // precisions give two results.
    const bool agree = abs(fine - coarse) <= Real(Number(10).pow(-30), 2 * digits) * abs(fine);
    const Number exact = fine.to_number();
    const Number near = coarse.to_number();
    const RoundedConstant rounded{exact.to_double(), exact.to_float()};
    if (agree && rounded.in_double == near.to_double() && rounded.in_float == near.to_float()) return rounded;
    if (digits >= most_digits) return abs(fine) < Real(Number(10).pow(-500), digits) ? RoundedConstant{} : rounded;
  }
}

}  // namespace torsor
