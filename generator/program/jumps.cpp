// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/program/jumps.hpp"

#include <random>
#include <unordered_map>
#include <utility>

#include "torsor/generator/base/high_precision.hpp"
#include "torsor/generator/program/evaluation.hpp"
#include "torsor/generator/program/generic_state.hpp"

namespace torsor {
namespace {

constexpr int jump_digits = 60;
constexpr int lines = 60;     ///< looked at for each selection
constexpr int halvings = 130; ///< of a line: to 10^-39 of it

/// Numbers along a line between two states; parameters are the same all along, and all but `only` where there is one.
class Line {
 public:
  Line(std::mt19937_64& random, SymbolPointer only) : random_(&random), only_(std::move(only)) {}

  Real operator()(const SymbolPointer& symbol, const Real& at) {
    return at_unit_quaternions(symbol, [&](const SymbolPointer& each) {
      const auto [place, added] = ends_.try_emplace(each.get());
      if (added) place->second = {draw(each->kind), draw(each->kind)};
      const auto& [first, second] = place->second;
      const bool stays = only_ ? each != only_ : each->kind == SymbolKind::parameter;
      return stays ? first : first + at * (second - first);
    });
  }

 private:
  /// Times and parameters are positive; all that is none of the latter is of any size.
  Real draw(SymbolKind kind) {
    const long size = static_cast<long>((*random_)() % 9000U) + 1000;
    if (kind == SymbolKind::pi) return Real::pi();
    const bool negative = kind != SymbolKind::parameter && kind != SymbolKind::time && size % 2 == 0;
    Number number = Number::rational(negative ? -size : size, 7919);
    if (kind != SymbolKind::parameter) number *= Number(10).pow(static_cast<int>((*random_)() % 5U) - 1);
    return Real(number, jump_digits);
  }

  std::mt19937_64* random_;
  SymbolPointer only_;
  std::unordered_map<const Symbol*, std::pair<Real, Real>> ends_;  // looked up only
};

/// Two values 10^-36 apart on a line: a root that begins there makes 10^-18 of it.
bool differ(const Real& a, const Real& b) {
  const Real relative(Number(10).pow(-12), jump_digits), least(Number(10).pow(-15), jump_digits), apart = abs(a - b);
  return !a.is_nan() && !b.is_nan() && apart > relative * (abs(a) + abs(b)) && apart > least;
}

bool jumps_on_lines(const Value& value, const SymbolPointer& only) {
  if (value.program() == nullptr || value.is_zero()) return false;
  Program& program = *value.program();
  const WorkingDigits precision(jump_digits);
  std::vector<Value> deciding;
  for (const ValueNumber number : program.live({value})) {
    const Definition definition = program[number];
    if (definition.function == Function::select || definition.function == Function::sign)
      deciding.push_back(program.argument(definition, 0));
  }
  std::mt19937_64 random(20240229);  // any fixed seed: the answer must not change from run to run
  for (const Value& condition : deciding) {
    for (int k = 0; k < lines; ++k) {
      Line line(random, only);
      Evaluator<Real> evaluate(program, {});
      const auto at = [&](const Real& place, const Value& what) {
        evaluate.move_to([&line, place](const SymbolPointer& symbol) { return line(symbol, place); });
        return evaluate(what);
      };
      Real low(0), high(1);
      const Real first = at(low, condition), last = at(high, condition);
      if (first.is_nan() || last.is_nan() || (first < Real(0)) == (last < Real(0))) continue;
      for (int halving = 0; halving < halvings; ++halving) {
        const Real middle = (low + high) * Real(Number::rational(1, 2), jump_digits);
        ((at(middle, condition) < Real(0)) == (first < Real(0)) ? low : high) = middle;
      }
      if (differ(at(low, value), at(high, value))) return true;
    }
  }
  return false;
}

}  // namespace

bool jumps(const Value& value) { return jumps_on_lines(value, nullptr); }
bool jumps_along(const Value& value, const SymbolPointer& symbol) { return jumps_on_lines(value, symbol); }

}  // namespace torsor
