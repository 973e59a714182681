// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/program/identically_zero.hpp"

#include <algorithm>
#include <initializer_list>
#include <random>
#include <unordered_map>
#include <utility>

#include "torsor/generator/base/high_precision.hpp"
#include "torsor/generator/program/evaluation.hpp"
#include "torsor/generator/program/generic_state.hpp"
#include "torsor/generator/program/sized.hpp"

namespace torsor {
namespace {

constexpr int digits = 60;
/// Each form of a selection of two is left out in all of them with a probability of 2^-16.
constexpr int trials_of_forms = 16;

/// Whether this is a number that cancels; what is none says nothing.
bool vanishes(const Sized& x) {
  static const Real smallest(Number(10).pow(-40), digits);
  return abs(x.value) <= smallest * (x.size < Real(1) ? x.size : Real(1));  // terms of long eliminations are huge
}

/// Signs and sizes of the numbers of one trial. Parameters and times are always positive and of the size of one.
enum class Signs { positive, negative, either };
struct Trial {
  Signs signs;
  bool spread = false;
  bool of_another_base = false;  ///< of exponentials
};

class RandomNumbers {
 public:
  explicit RandomNumbers(Trial trial, std::mt19937_64& random) : trial_(trial), random_(&random) {}

  Sized operator()(const SymbolPointer& symbol) {
    return Sized(at_unit_quaternions(symbol, [this](const SymbolPointer& each) { return number_of(each); }));
  }

 private:
  Real number_of(const SymbolPointer& symbol) {
    if (const auto known = drawn_.find(symbol.get()); known != drawn_.end()) return known->second;
    const bool moves = symbol->kind != SymbolKind::parameter && symbol->kind != SymbolKind::time;
    return drawn_[symbol.get()] = draw(moves);
  }

  Real draw(bool moves) {
    const long size = static_cast<long>((*random_)() % 9000U) + 1000;
    const bool negative = moves && (trial_.signs == Signs::negative || (trial_.signs == Signs::either && size % 2 == 0));
    Number number = Number::rational(negative ? -size : size, 7919);
    if (moves && trial_.spread) number *= Number(10).pow(static_cast<int>((*random_)() % 7U) - 2);
    return Real(number, digits);
  }

  Trial trial_;
  std::mt19937_64* random_;
  std::unordered_map<const Symbol*, Real> drawn_;  // looked up only
};

/// Functions that may be next to nothing, or cancel, in one region only.
bool has_regions(const Program& program, const std::vector<ValueNumber>& live) {
  return std::any_of(live.begin(), live.end(), [&](ValueNumber value_number) {
    const auto& function = program[value_number].function;
    return function && *function != Function::sin && *function != Function::cos;
  });
}

std::vector<ValueNumber> selections(const Program& program, const std::vector<ValueNumber>& live) {
  std::vector<ValueNumber> found;
  for (const ValueNumber value_number : live) {
    const auto& function = program[value_number].function;
    if (function && traits_of(*function).selects) found.push_back(value_number);
  }
  return found;
}

std::vector<ValueNumber> calls_of(const Program& program, const std::vector<ValueNumber>& live,
                                  const std::initializer_list<Function> functions) {
  std::vector<ValueNumber> found;
  for (const ValueNumber value_number : live) {
    const auto& function = program[value_number].function;
    if (function && std::find(functions.begin(), functions.end(), *function) != functions.end()) found.push_back(value_number);
  }
  return found;
}

/// Gives exponentials and logarithms another base, of which no power is next to nothing beside others: exp(c x) and log(x)/c
/// obey the same laws, and a law of time that acts for a millisecond is next to nothing at all other times. False where the
/// arguments are no larger than others.
bool take_another_base(Program& program, const std::vector<ValueNumber>& exponentials, Evaluator<Sized>& as_it_is,
                       Evaluator<Sized>& evaluate) {
  const auto argument = [&](ValueNumber value_number, Evaluator<Sized>& by) {
    return by(program.argument(program[value_number], 0)).value;
  };
  Real largest(16);
  for (const ValueNumber value_number : exponentials) {
    const Real x = argument(value_number, as_it_is);
    if (program[value_number].function == Function::exp && largest < abs(x)) largest = abs(x);
  }
  if (!(Real(16) < largest)) return false;
  const Real c = Real(2) / largest;
  for (const ValueNumber value_number : exponentials) {
    const Real x = argument(value_number, evaluate);
    evaluate.fix(value_number, Sized(program[value_number].function == Function::exp ? exp(c * x) : log(x) / c));
  }
  return true;
}

/// Gives each selection one of its forms at random, in the order of the program, so that forms are known before.
void take_forms_at_random(Program& program, const std::vector<ValueNumber>& selections, Evaluator<Sized>& evaluate,
                          std::mt19937_64& random) {
  std::unordered_map<ValueNumber, bool> negative;  // by argument, for abs and sign; looked up only
  for (const ValueNumber value_number : selections) {
    const Definition definition = program[value_number];
    const bool second = random() % 2 == 0;
    const auto argument = [&](std::size_t i) { return evaluate(program.argument(definition, i)); };
    if (definition.function == Function::maximum) {
      evaluate.fix(value_number, argument(second ? 1 : 0));
    } else if (definition.function == Function::select) {
      const Sized a = argument(1), b = argument(2);
      const bool zero = (!a.is_number() || vanishes(a)) && (!b.is_number() || vanishes(b));
      const Real unknown(Number::rational(static_cast<long>(random() % 9000U) + 1000, 7919), digits);
      evaluate.fix(value_number, zero ? Sized(Real(0)) : Sized(second ? -unknown : unknown));
    } else {
      const bool minus = negative.emplace(definition.arguments[0], second).first->second;
      const Sized x = argument(0);
      const Sized form = definition.function == Function::sign ? Sized(Real(1)) : x;
      evaluate.fix(value_number, minus ? -form : form);
    }
  }
}

}  // namespace

std::vector<bool> identically_zero_entries(const std::vector<Value>& values) {
  std::vector<bool> result;
  for (const Value& value : values) result.push_back(value.is_zero() || !value.is_constant());
  const auto with_program =
      std::find_if(values.begin(), values.end(), [](const Value& v) { return v.program() != nullptr && !v.is_zero(); });
  if (with_program == values.end()) return result;
  Program& program = *with_program->program();
  const WorkingDigits precision(digits);
  // What moves is positive, then negative, then either: sqrt(x^2) is not x.
  std::vector<Trial> trials = {{Signs::positive}, {Signs::negative}, {Signs::either}};
  const std::vector<ValueNumber> live = program.live(values);
  if (has_regions(program, live)) {
    trials.insert(trials.end(), {{Signs::positive, true}, {Signs::negative, true}, {Signs::either, true}});
  }
  const std::vector<ValueNumber> selecting = selections(program, live);
  const std::size_t as_they_are = trials.size();
  for (int more = 0; more < trials_of_forms && !selecting.empty(); ++more) trials.push_back({Signs::either});
  const std::vector<ValueNumber> exponentials = calls_of(program, live, {Function::exp, Function::log});
  if (!exponentials.empty()) trials.insert(trials.end(), 2, {Signs::either, false, true});
  std::mt19937_64 random(20240229);  // any fixed seed: the answer must not change from run to run
  for (std::size_t number_of_trial = 0; number_of_trial < trials.size(); ++number_of_trial) {
    const Trial& trial = trials[number_of_trial];
    RandomNumbers numbers(trial, random);
    Evaluator<Sized> evaluate(program, [&](const SymbolPointer& symbol) { return numbers(symbol); });
    const bool of_forms = number_of_trial >= as_they_are;
    if (trial.of_another_base) {
      Evaluator<Sized> as_it_is(program, [&](const SymbolPointer& symbol) { return numbers(symbol); });
      if (!take_another_base(program, exponentials, as_it_is, evaluate)) continue;
    } else if (of_forms) {
      take_forms_at_random(program, selecting, evaluate, random);
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!result[i] || values[i].is_zero()) continue;
      const Sized number = evaluate(values[i]);
      // Far from one, and in a form that does not count, a function may have no value, which says nothing.
      result[i] = number.is_number() ? vanishes(number) : trial.spread || of_forms;
    }
  }
  return result;
}

void clear_identically_zero(std::vector<Value>& values) {
  const auto without_test = [](const Value& value) {
    return value.program() != nullptr && !value.program()->passes().zero_test;
  };
  if (std::any_of(values.begin(), values.end(), without_test)) return;
  const std::vector<bool> zero = identically_zero_entries(values);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (zero[i]) values[i] = Value();
  }
}

void clear_identically_zero(std::vector<std::vector<Value>>& matrix) {
  std::vector<Value> all;
  for (const auto& row : matrix) all.insert(all.end(), row.begin(), row.end());
  clear_identically_zero(all);
  std::size_t k = 0;
  for (auto& row : matrix) {
    for (Value& entry : row) entry = all[k++];
  }
}

bool identically_zero(const Value& value) {
  if (value.is_zero()) return true;
  return !value.is_constant() && identically_zero_entries({value})[0];
}

}  // namespace torsor
