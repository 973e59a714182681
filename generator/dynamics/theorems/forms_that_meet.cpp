// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/theorems/forms_that_meet.hpp"

#include <algorithm>

#include "torsor/generator/program/flattening.hpp"
#include "torsor/generator/program/identically_zero.hpp"
#include "torsor/generator/program/sized.hpp"

namespace torsor {
namespace {

/// sign(c), or a where c >= 0 and b elsewhere, or the angle of (x, y), c = y, where x < 0. The forms of |c| and of the larger of
/// two meet without a jump; their slopes are such.
struct TwoForms {
  ValueNumber value_number;
  std::size_t condition;  ///< its place among those that vanish
  bool reversed;          ///< a multiple of it below zero
};

/// Of so many conditions all sides are compared; more are doubted.
constexpr std::size_t most_conditions = 8;

class Sides {
 public:
  Sides(Program& program, const std::vector<Value>& values, const AtState& at,
        const std::optional<Evaluator<Real>::SymbolValue>& numbers)
      : program_(program), values_(values), at_(at), numbers_(numbers) {
    Flattening flat(program, 100);
    for (const ValueNumber value_number : program.live(values)) {
      const Definition definition = program[value_number];  // a copy: the program grows below
      const bool angle = definition.function == Function::atan2;
      if (!angle && definition.function != Function::sign && definition.function != Function::select) continue;
      const Value named = program.argument(definition, 0);
      const Value argument = flat(named).value_or(named);  // -x and x - (-x) as multiples of x
      if (argument.is_constant() || !vanishes(argument) || (angle && !is_negative(program.argument(definition, 1)))) continue;
      const Number leading = argument.polynomial().terms()[0].coefficient;
      const Value condition = leading.pow(-1) * argument;
      const auto known = std::find_if(conditions_.begin(), conditions_.end(), [&](const Value& other) {
        return other.polynomial() == condition.polynomial();
      });
      meeting_.push_back({value_number, static_cast<std::size_t>(known - conditions_.begin()), leading.sign() < 0});
      if (known == conditions_.end()) conditions_.push_back(condition);
    }
  }

  std::vector<Value> that_differ() const {
    if (conditions_.empty() || !numbers_ || conditions_.size() > most_conditions) return conditions_;
    const std::vector<Sized> there = values_by(evaluator());
    for (std::size_t sides = 0; sides < std::size_t{1} << conditions_.size(); ++sides) {
      if (differ(there, values_on(sides))) return conditions_;
    }
    return {};
  }

 private:
  /// What is left of a value where the state is put in.
  Sized number_of(const Value& left) const {
    if (left.is_zero()) return Sized(Real(0));
    Evaluator<Sized> evaluate(program_, [this](const SymbolPointer& symbol) { return Sized((*numbers_)(symbol)); });
    const Sized number = evaluate(left);
    return number.cancels() ? Sized(Real(0)) : number;
  }

  bool vanishes(const Value& condition) const {
    const Value left = at_(condition);
    return left.is_zero() || identically_zero(left) || (numbers_ && number_of(left).value == Real(0));
  }

  bool is_negative(const Value& value) const {
    const Value left = at_(value);
    if (left.is_constant()) return !left.is_zero() && left.polynomial().constant().sign() < 0;
    return numbers_ && number_of(left).value < Real(0);
  }

  Evaluator<Sized> evaluator() const {
    return {program_, [this](const SymbolPointer& symbol) { return number_of(at_(program_.symbol(symbol))); }};
  }

  /// On the side of condition k that bit k tells: 1 below zero.
  std::vector<Sized> values_on(std::size_t sides) const {
    Evaluator<Sized> evaluate = evaluator();
    for (const TwoForms& each : meeting_) {  // those inside of others come first
      const Definition definition = program_[each.value_number];
      const bool second = ((sides >> each.condition) % 2 != 0) != each.reversed;
      const Sized one(Real(second ? -1 : 1));
      Sized form = one;
      if (definition.function == Function::atan2) form = one * atan2(Sized(Real(0)), Sized(Real(-1)));
      if (definition.function == Function::select) form = evaluate(program_.argument(definition, second ? 2 : 1));
      evaluate.fix(each.value_number, std::move(form));
    }
    return values_by(std::move(evaluate));
  }

  std::vector<Sized> values_by(Evaluator<Sized> evaluate) const {
    std::vector<Sized> result;
    for (const Value& value : values_) result.push_back(value.is_zero() ? Sized(Real(0)) : evaluate(value));
    return result;
  }

  /// What is not a number on either side is judged elsewhere.
  static bool differ(const std::vector<Sized>& a, const std::vector<Sized>& b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
      const Sized difference = a[i] - b[i];
      if (difference.is_number() && !difference.cancels()) return true;
    }
    return false;
  }

  Program& program_;
  const std::vector<Value>& values_;
  const AtState& at_;
  const std::optional<Evaluator<Real>::SymbolValue>& numbers_;
  std::vector<TwoForms> meeting_;
  std::vector<Value> conditions_;
};

}  // namespace

std::vector<Value> forms_that_meet(Program& program, const std::vector<Value>& values, const AtState& at,
                                   const std::optional<Evaluator<Real>::SymbolValue>& numbers) {
  return Sides(program, values, at, numbers).that_differ();
}

}  // namespace torsor
