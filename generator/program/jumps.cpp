// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/program/jumps.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

#include "torsor/generator/base/high_precision.hpp"
#include "torsor/generator/program/evaluation.hpp"
#include "torsor/generator/program/generic_state.hpp"

namespace torsor {
namespace {

constexpr int jump_digits = 60;
constexpr int states = 60;      ///< around which each selection is looked at, at most
constexpr int most_places = 8;  ///< where it changes, that are looked at
constexpr int steps = 400;      ///< to such a place
constexpr int farthest = 15;    ///< powers of ten of the sizes of what moves, from -12 on

/// Numbers of a state, of which one moves alone.
class MovingState {
 public:
  MovingState(std::mt19937_64& random, SymbolPointer moving) : random_(&random), moving_(std::move(moving)) {}

  Real operator()(const SymbolPointer& symbol, const Real& place) {
    return at_unit_quaternions(symbol, [&](const SymbolPointer& each) {
      if (each == moving_) return place;
      const auto [known, added] = numbers_.try_emplace(each.get());
      if (added) known->second = draw(each->kind);
      return known->second;
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
  SymbolPointer moving_;
  std::unordered_map<const Symbol*, Real> numbers_;  // looked up only
};

/// Places of a symbol, in order: zero and powers of ten, with both signs but for the time.
std::vector<Number> places_of(const Symbol& symbol) {
  std::vector<Number> places{Number(0)};
  for (int power = -12; power <= farthest; ++power) places.push_back(Number(10).pow(power));
  if (symbol.kind == SymbolKind::time) return places;
  std::vector<Number> all;
  for (auto place = places.rbegin(); place + 1 != places.rend(); ++place) all.push_back(-*place);
  all.insert(all.end(), places.begin(), places.end());
  return all;
}

/// Two values 10^-36 apart on a line: a root that begins there makes 10^-18 of it, of the size that it has around.
bool differ(const Real& a, const Real& b, const Real& around) {
  const Real relative(Number(10).pow(-12), jump_digits), small(Number(10).pow(-15), jump_digits), apart = abs(a - b);
  const Real least = relative * around < small ? relative * around : small;
  return !a.is_nan() && !b.is_nan() && apart > relative * (abs(a) + abs(b)) && !(apart <= least);
}

/// Two places on either side of where a function changes its sign between two others, 10^-39 apart, by the Illinois method:
/// conditions are mostly linear in what moves. They are further apart where it has not got there.
template <class Function>
std::pair<Real, Real> sides_of_change(const Function& function, Real low, Real high) {
  const Real apart(Number(10).pow(-39), jump_digits), half(Number::rational(1, 2), jump_digits);
  Real at_low = function(low), at_high = function(high);
  const auto take = [&](const Real& place) {
    const Real here = function(place);
    const bool before = (here < Real(0)) == (at_low < Real(0));
    (before ? low : high) = place;
    (before ? at_low : at_high) = here;
    return before;
  };
  bool was_before = false;
  for (int step = 0; step < steps && high - low > apart; ++step) {
    // Beside the place that the chord gives, so that both sides come near; halves now and then where it is no straight line.
    const Real chord = low + (high - low) * (at_low / (at_low - at_high));
    const bool before = take(step % 4 == 3 || chord.is_nan() ? (low + high) * half : chord);
    if (step > 0 && before == was_before) (before ? at_high : at_low) = (before ? at_high : at_low) * half;
    was_before = before;
    const Real beside = before ? low + apart * half : high - apart * half;
    if (beside > low && beside < high) take(beside);
  }
  return {low, high};
}

/// What decides between the forms of a value, each once.
std::vector<Value> conditions_of(Program& program, const Value& value) {
  std::vector<Value> conditions;
  std::set<ValueNumber> known;
  for (const ValueNumber number : program.live({value})) {
    const Definition definition = program[number];
    if (definition.function != Function::select && definition.function != Function::sign) continue;
    if (known.insert(definition.arguments.front()).second) conditions.push_back(program.argument(definition, 0));
  }
  return conditions;
}

/// Symbols that a condition depends on and that change along a motion; `only` that one where it is given.
std::vector<SymbolPointer> moving_symbols(const Program& program, const Value& condition, const SymbolPointer& only) {
  std::vector<SymbolPointer> symbols;
  for (const ValueNumber number : program.live({condition})) {
    const SymbolPointer symbol = program[number].symbol;
    if (!symbol || symbol->kind == SymbolKind::pi || symbol->kind == SymbolKind::parameter) continue;
    if (!only || symbol == only) symbols.push_back(symbol);
  }
  return symbols;
}

bool jumps_where(const Value& value, const SymbolPointer& only) {
  if (value.program() == nullptr || value.is_zero()) return false;
  Program& program = *value.program();
  const WorkingDigits precision(jump_digits);
  const std::vector<Value> conditions = conditions_of(program, value);
  // A table has many selections; each is looked at in two places at least.
  const int enough = std::max(2, std::min(most_places, 160 / std::max(1, static_cast<int>(conditions.size()))));
  std::mt19937_64 random(20240229);  // any fixed seed: the answer must not change from run to run
  Evaluator<double> roughly(program, {});
  Evaluator<Real> evaluate(program, {});
  for (const Value& condition : conditions) {
    const std::vector<SymbolPointer> symbols = moving_symbols(program, condition, only);
    int seen = 0;
    for (std::size_t k = 0; !symbols.empty() && k < states && seen < enough; ++k) {
      const SymbolPointer& moving = symbols[k % symbols.size()];
      MovingState state(random, moving);
      const auto at = [&](const Real& place, const Value& what) {
        evaluate.move_to([&state, place](const SymbolPointer& symbol) { return state(symbol, place); });
        return evaluate(what);
      };
      std::optional<Number> before;
      double last = 0;
      for (const Number& place : places_of(*moving)) {
        const Real there(place, jump_digits);
        roughly.move_to([&](const SymbolPointer& symbol) { return state(symbol, there).to_double(); });
        const double here = roughly(condition);
        if (before && std::isfinite(last) && std::isfinite(here) && (last < 0) != (here < 0)) {
          ++seen;
          const auto [low, high] =
              sides_of_change([&](const Real& at_place) { return at(at_place, condition); }, Real(*before, jump_digits), there);
          const Real from(*before, jump_digits), way = there - from;
          Real around(0);
          for (const Real& beside : {from - way, from, there, there + way}) {
            const Real size = abs(at(beside, value));
            if (!size.is_nan()) around = around + size;
          }
          if (differ(at(low, value), at(high, value), around > Real(0) ? around : Real(1))) return true;
        }
        before = place;
        last = here;
      }
    }
  }
  return false;
}

}  // namespace

bool jumps(const Value& value) { return jumps_where(value, nullptr); }
bool jumps_along(const Value& value, const SymbolPointer& symbol) { return jumps_where(value, symbol); }

}  // namespace torsor
