// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/expression/vanishing.hpp"

#include <algorithm>
#include <random>
#include <unordered_map>
#include <utility>

#include "generator/expression/evaluation.hpp"
#include "generator/expression/generic_state.hpp"
#include "generator/expression/high_precision.hpp"

namespace torsor {
namespace {

constexpr int digits = 60;

/// A number with what its terms come to without their signs: what cancels is told from what is small.
struct Sized {
  Real value, size;

  /// Sizes that multiply along a long elimination leave even CLN's exponents; nothing asks how far beyond one they are.
  Sized(Real v, Real s) : value(std::move(v)), size(huge() < s ? huge() : std::move(s)) {}
  explicit Sized(const Real& v) : value(v), size(abs(v)) {}
  static Sized of_number(const Number& number) { return Sized(Real(number, digits)); }
  static const Real& huge() {
    static const Real number(Number(10).pow(1000), digits);
    return number;
  }

  Sized operator-() const { return {-value, size}; }
  friend Sized operator+(const Sized& a, const Sized& b) { return {a.value + b.value, a.size + b.size}; }
  friend Sized operator-(const Sized& a, const Sized& b) { return {a.value - b.value, a.size + b.size}; }
  friend Sized operator*(const Sized& a, const Sized& b) { return {a.value * b.value, a.size * b.size}; }
  friend Sized operator/(const Sized& a, const Sized& b) { return {a.value / b.value, a.size / abs(b.value)}; }
  friend Sized sin(const Sized& x) { return {sin(x.value), x.size < Real(1) ? x.size : Real(1)}; }
  friend Sized cos(const Sized& x) { return {cos(x.value), Real(1)}; }
  friend Sized sqrt(const Sized& x) { return {sqrt(x.value), sqrt(x.size)}; }
  friend Sized exp(const Sized& x) { return Sized(exp(x.value)); }
  friend Sized log(const Sized& x) { return {log(x.value), Real(1) + abs(log(x.value))}; }
};

/// Signs and sizes of the numbers of one trial. Parameters and times are always positive and of the size of one.
enum class Signs { positive, negative, either };
struct Trial {
  Signs signs;
  bool spread;
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
bool has_regions(const Program& program, const std::vector<Value>& values) {
  const std::vector<Atom> live = program.live(values);
  return std::any_of(live.begin(), live.end(), [&](Atom atom) {
    const auto& function = program[atom].function;
    return function && *function != Function::sin && *function != Function::cos;
  });
}

}  // namespace

std::vector<bool> vanish(const std::vector<Value>& values) {
  std::vector<bool> result;
  for (const Value& value : values) result.push_back(value.is_zero() || !value.is_constant());
  const auto with_program =
      std::find_if(values.begin(), values.end(), [](const Value& v) { return v.program() != nullptr && !v.is_zero(); });
  if (with_program == values.end()) return result;
  const Program& program = *with_program->program();
  const WorkingDigits precision(digits);
  const Real smallest(Number(10).pow(-40), digits);
  // What moves is positive, then negative, then either: sqrt(x^2) is not x.
  std::vector<Trial> trials = {{Signs::positive, false}, {Signs::negative, false}, {Signs::either, false}};
  if (has_regions(program, values)) {
    trials.insert(trials.end(), {{Signs::positive, true}, {Signs::negative, true}, {Signs::either, true}});
  }
  std::mt19937_64 random(20240229);  // any fixed seed: the answer must not change from run to run
  for (const Trial& trial : trials) {
    RandomNumbers numbers(trial, random);
    Evaluator<Sized> evaluate(program, [&](const SymbolPointer& symbol) { return numbers(symbol); });
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!result[i] || values[i].is_zero()) continue;
      const Sized number = evaluate(values[i]);
      // Far from one a function may have no value, which says nothing.
      const bool undefined = number.value.is_nan() || number.size.is_nan();
      const Real size = number.size < Real(1) ? number.size : Real(1);  // terms of long eliminations are huge
      result[i] = undefined ? trial.spread : abs(number.value) <= smallest * size;
    }
  }
  return result;
}

void clear_vanishing(std::vector<Value>& values) {
  const std::vector<bool> zero = vanish(values);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (zero[i]) values[i] = Value();
  }
}

void clear_vanishing(std::vector<std::vector<Value>>& matrix) {
  std::vector<Value> all;
  for (const auto& row : matrix) all.insert(all.end(), row.begin(), row.end());
  clear_vanishing(all);
  std::size_t k = 0;
  for (auto& row : matrix) {
    for (Value& entry : row) entry = all[k++];
  }
}

bool vanishes(const Value& value) {
  if (value.is_zero()) return true;
  return !value.is_constant() && vanish({value})[0];
}

}  // namespace torsor
