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
#include "torsor/generator/program/derivative.hpp"
#include "torsor/generator/program/evaluation.hpp"
#include "torsor/generator/program/generic_state.hpp"

namespace torsor {
namespace {

constexpr int jump_digits = 60;
constexpr int root_digits = 160;  ///< what touches zero has 10^-78 beside that place, and is a difference of what is larger
constexpr std::size_t states = 60;     ///< around which each selection is looked at, at most
constexpr std::size_t fine_states = 6; ///< the same for cuts and roots
constexpr std::size_t states_alone = 2; ///< the same where one symbol decides, and only parameters differ
constexpr int most_places = 8;    ///< where it changes, that are looked at
constexpr int steps = 400;        ///< to such a place
constexpr int farthest = 15;      ///< powers of ten of the sizes of what moves, from -12 on

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
    return Real(number, Real::working_digits());
  }

  std::mt19937_64* random_;
  SymbolPointer moving_;
  std::unordered_map<const Symbol*, Real> numbers_;  // looked up only
};

/// What decides between the forms of a value.
struct Turn {
  enum class Kind {
    selection,  ///< the sign of `condition`
    cut,        ///< that of an argument of the angle `of`, where this jumps
    touch,      ///< that of the slope of the root's argument `of`, where this has its least value, zero
  };
  Kind kind;
  Value condition, of{};
};

/// Places of a symbol, in order: zero and powers of ten, with both signs but for the time; on request many in between.
std::vector<Number> places_of(const Symbol& symbol, bool densely) {
  std::vector<Number> places{Number(0)};
  for (int power = -12; power <= farthest; ++power) {
    const bool finely = densely && power >= -3 && power < 4;
    for (int tenths = 10; tenths < (finely ? 100 : 11); ++tenths) {
      places.push_back(Number(10).pow(power) * Number::rational(tenths, 10));
    }
  }
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

Real apart() { return {Number(10).pow(-39), Real::working_digits()}; }

/// Two places on either side of where a function changes its sign between two others, 10^-39 apart, by the Illinois method:
/// conditions are mostly linear in what moves. They are further apart where it has not got there.
template <class Function>
std::pair<Real, Real> sides_of_change(const Function& function, Real low, Real high) {
  const Real half(Number::rational(1, 2), Real::working_digits());
  Real at_low = function(low), at_high = function(high);
  const auto take = [&](const Real& place) {
    const Real here = function(place);
    const bool before = (here < Real(0)) == (at_low < Real(0));
    (before ? low : high) = place;
    (before ? at_low : at_high) = here;
    return before;
  };
  bool was_before = false;
  for (int step = 0; step < steps && high - low > apart(); ++step) {
    // Beside the place that the chord gives, so that both sides come near; halves now and then where it is no straight line.
    const Real chord = low + (high - low) * (at_low / (at_low - at_high));
    const bool before = take(step % 4 == 3 || chord.is_nan() ? (low + high) * half : chord);
    if (step > 0 && before == was_before) (before ? at_high : at_low) = (before ? at_high : at_low) * half;
    was_before = before;
    const Real beside = before ? low + apart() * half : high - apart() * half;
    if (beside > low && beside < high) take(beside);
  }
  return {low, high};
}

/// What decides between the forms of values, each once; roots where `along` is given.
std::vector<Turn> turns_of(Program& program, const std::vector<Value>& values, const SymbolPointer& along) {
  std::vector<Turn> turns;
  std::set<std::pair<Turn::Kind, ValueNumber>> known;
  const auto add = [&](Turn turn, ValueNumber by) {
    if (turn.condition.is_constant() || turn.condition.is_zero()) return;
    if (known.insert({turn.kind, by}).second) turns.push_back(std::move(turn));
  };
  for (const ValueNumber number : program.live(values)) {
    const Definition definition = program[number];
    if (definition.function == Function::select || definition.function == Function::sign) {
      add({Turn::Kind::selection, program.argument(definition, 0)}, definition.arguments[0]);
    } else if (definition.function == Function::atan2) {
      for (const std::size_t i : {0U, 1U}) {
        const Value angle = program.value_of_number(number);
        add({Turn::Kind::cut, program.argument(definition, i), angle}, 2 * number + static_cast<ValueNumber>(i));
      }
    } else if (definition.function == Function::sqrt && along) {
      const Value of = program.argument(definition, 0);
      add({Turn::Kind::touch, partial_derivation(program, along)(of), of}, number);
    }
  }
  return turns;
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

/// Looks for jumps of values at the turns of one of them.
class JumpSearch {
 public:
  JumpSearch(Program& program, const std::vector<Value>& values, SymbolPointer only, Deciding deciding)
      : program_(&program), values_(values), only_(std::move(only)), turns_(turns_of(program, values, only_)),
        deciding_(deciding), roughly_(program, {}), evaluate_(program, {}) {}

  std::optional<double> place() {
    // A table has many selections; each is looked at in two places at least.
    const int enough = std::max(2, std::min(most_places, 160 / std::max(1, static_cast<int>(turns_.size()))));
    for (const Turn& turn : turns_) {
      if (const std::optional<double> place = place_at(turn, enough)) return place;
    }
    return std::nullopt;
  }

 private:
  std::optional<double> place_at(const Turn& turn, int enough) {
    const WorkingDigits precision(turn.kind == Turn::Kind::touch ? root_digits : jump_digits);
    const std::vector<SymbolPointer> symbols = moving_symbols(*program_, turn.condition, only_);
    const bool selection = turn.kind == Turn::Kind::selection;
    const bool alone = moving_symbols(*program_, selection ? turn.condition : turn.of, nullptr).size() <= 1;
    if (deciding_ == Deciding::alone && !alone) return std::nullopt;
    // What several coordinates make together is looked at roughly: a platform on six legs has thirty roots and angles of six.
    const std::size_t most = selection ? states : alone ? states_alone : fine_states;
    int seen = 0;
    for (std::size_t k = 0; !symbols.empty() && k < most && seen < enough; ++k) {
      MovingState state(random_, symbols[k % symbols.size()]);
      const auto found = along(turn, places_of(*symbols[k % symbols.size()], !selection && alone), state, seen);
      if (found) return found;
    }
    return std::nullopt;
  }

  std::optional<double> along(const Turn& turn, const std::vector<Number>& places, MovingState& state, int& seen) {
    std::optional<Number> before;
    double last = 0;
    for (const Number& place : places) {
      const double here = rough(turn.condition, state, Real(place, Real::working_digits()));
      const bool changes = before && std::isfinite(last) && std::isfinite(here) && (last < 0) != (here < 0);
      if (changes && may_jump(turn, state, *before, place, last < 0)) {
        ++seen;
        if (const std::optional<double> found = jump_between(turn, state, *before, place)) return found;
      }
      before = place;
      last = here;
    }
    return std::nullopt;
  }

  double rough(const Value& what, MovingState& state, const Real& place) {
    roughly_.move_to([&](const SymbolPointer& symbol) { return state(symbol, place).to_double(); });
    return roughly_(what);
  }

  Real at(const Real& place, MovingState& state, const Value& what) {
    evaluate_.move_to([&state, place](const SymbolPointer& symbol) { return state(symbol, place); });
    return evaluate_(what);
  }

  /// As far as numbers of double precision tell.
  bool may_jump(const Turn& turn, MovingState& state, const Number& from, const Number& to, bool rises) {
    if (turn.kind == Turn::Kind::selection) return true;
    if (turn.kind == Turn::Kind::touch && !rises) return false;
    Real low(from, jump_digits), high(to, jump_digits);
    const Real half(Number::rational(1, 2), jump_digits);
    for (int step = 0; step < 60; ++step) {
      const Real middle = (low + high) * half;
      ((rough(turn.condition, state, middle) < 0) == rises ? low : high) = middle;
    }
    const double a = rough(turn.of, state, low), b = rough(turn.of, state, high);
    if (turn.kind == Turn::Kind::cut) return !(std::abs(a - b) < 0.5);
    const double before = rough(turn.of, state, Real(from, jump_digits)), after = rough(turn.of, state, Real(to, jump_digits));
    const double around = std::abs(before) + std::abs(after);
    return !(std::min(std::abs(a), std::abs(b)) > 1e-6 * around);
  }

  std::optional<double> jump_between(const Turn& turn, MovingState& state, const Number& before, const Number& there) {
    const int digits = Real::working_digits();
    const Real from(before, digits), to(there, digits), way = to - from;
    auto [low, high] = sides_of_change([&](const Real& place) { return at(place, state, turn.condition); }, from, to);
    if (turn.kind != Turn::Kind::selection) {  // there a root has no slope, and an angle no value
      low = low - apart();
      high = high + apart();
    }
    const Real rounding(Number(10).pow(-digits / 2), digits);  // what all that vanishes there has left
    for (const Value& value : values_) {
      Real around(0);
      for (const Real& beside : {from - way, from, to, to + way}) {
        const Real size = abs(at(beside, state, value));
        if (!size.is_nan()) around = around + size;
      }
      if (differ(at(low, state, value), at(high, state, value), around > rounding ? around : Real(1))) {
        return ((low + high) / Real(2)).to_double();
      }
    }
    return std::nullopt;
  }

  Program* program_;
  const std::vector<Value>& values_;
  SymbolPointer only_;
  std::vector<Turn> turns_;
  Deciding deciding_;
  std::mt19937_64 random_{20240229};  // any fixed seed: the answer must not change from run to run
  Evaluator<double> roughly_;
  Evaluator<Real> evaluate_;
};

std::optional<double> jump_of(std::vector<Value> values, const SymbolPointer& only, Deciding deciding) {
  std::erase_if(values, [](const Value& value) { return value.program() == nullptr || value.is_zero(); });
  if (values.empty()) return std::nullopt;
  return JumpSearch(*values[0].program(), values, only, deciding).place();
}

}  // namespace

bool jumps(const Value& value) { return jump_of({value}, nullptr, Deciding::any).has_value(); }
bool jumps_along(const Value& value, const SymbolPointer& symbol) { return jump_of({value}, symbol, Deciding::any).has_value(); }

std::optional<double> place_of_jump(const std::vector<Value>& values, const SymbolPointer& symbol, Deciding deciding) {
  return jump_of(values, symbol, deciding);
}

}  // namespace torsor
