// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/program/flattening.hpp"

#include <algorithm>
#include <vector>

#include "torsor/generator/program/formula.hpp"
#include "torsor/generator/program/paired_signs.hpp"

namespace torsor {
namespace {

Polynomial of_factor(ValueNumber value_number, int exponent) {
  return Polynomial(Term{{{value_number, exponent}}, Number(1)});
}

/// Of a parameter, and what is made of parameters without a difference: those that enter masses are positive.
bool is_positive(const Program& program, const Term& term);

bool is_positive(const Program& program, ValueNumber value_number) {
  const Definition& definition = program[value_number];
  if (definition.symbol) return definition.symbol->kind == SymbolKind::parameter;
  if (definition.function || definition.stage != Stage::parameters) return false;
  const std::vector<Term>& terms = definition.polynomial.terms();
  return std::all_of(terms.begin(), terms.end(), [&](const Term& term) { return is_positive(program, term); });
}

/// Of squares and positive parameters, with a positive coefficient.
bool is_positive(const Program& program, const Term& term) {
  return term.coefficient.sign() > 0 && std::all_of(term.monomial.begin(), term.monomial.end(), [&](const Factor& factor) {
           return factor.exponent % 2 == 0 || is_positive(program, factor.value_number);
         });
}

bool is_sum_of_positives(const Program& program, const Polynomial& sum) {
  const std::vector<Term>& terms = sum.terms();
  return std::all_of(terms.begin(), terms.end(), [&](const Term& term) { return is_positive(program, term); });
}

/// Whether what a difference leaves is small beside what it starts from, or may be: of numbers it is known, of
/// parameters it is not. m1 + m2 − m2 cos² is worth a term more as m1 + m2 sin²: nothing of a small m1 is lost.
bool is_much_less(const Number& left, const Number& whole) {
  return whole.is_zero() || (Number(4) * left.abs() - whole.abs()).sign() < 0;
}

/// What is made of parameters alone in each term, as a definition of its own, done once for a set of them.
Polynomial hoisted(Program& program, const Polynomial& sum) {
  Polynomial result;
  for (const Term& term : sum.terms()) {
    Monomial of_parameters, rest;
    Unit unit;
    for (const Factor& factor : term.monomial) {
      const Definition& definition = program[factor.value_number];
      const bool parameter = definition.stage == Stage::parameters;
      (parameter ? of_parameters : rest).push_back(factor);
      if (parameter) unit = unit * definition.unit.pow(factor.exponent);
    }
    const Value bound = program.bind(Value(program, Polynomial(Term{std::move(of_parameters), term.coefficient}), unit));
    for (const Term& each : bound.polynomial().terms()) result.add({each.monomial * rest, each.coefficient});
  }
  return result;
}

}  // namespace

std::optional<Polynomial> Flattening::product(const Polynomial& a, const Polynomial& b) const {
  Polynomial result;
  for (const Term& left : a.terms()) {
    for (const Term& right : b.terms()) {
      result.add(torsor::product(*program_, left, right));
    }
    if (result.terms().size() > limit_) return std::nullopt;
  }
  return result;
}

const std::optional<Polynomial>& Flattening::flat_definition(ValueNumber value_number, std::size_t levels) {
  auto& known = known_[levels];
  if (const auto place = known.find(value_number); place != known.end()) return place->second;
  std::optional<Polynomial> made = flat((*program_)[value_number].polynomial, levels);
  return known.emplace(value_number, std::move(made)).first->second;
}

/// part · factor, with the definition of the factor's value number put back where that is a product or a sum on one of the
/// levels.
Flattening::Power Flattening::multiply_power(Polynomial& part, const Factor& factor, std::size_t levels) {
  const Definition& definition = (*program_)[factor.value_number];
  if (definition.symbol || definition.function) return Power::stays;
  const bool sum = definition.polynomial.terms().size() > 1;
  const bool all = levels == all_levels;
  if (sum && levels == 0) return Power::stays;
  const std::optional<Polynomial>& inner = flat_definition(factor.value_number, sum && !all ? levels - 1 : levels);
  if (!inner) return all ? Power::too_long : Power::stays;
  std::optional<Polynomial> power;  // of an exponent other than one
  if (factor.exponent < 0) {
    if (inner->terms().size() != 1) return Power::stays;
    const Term& only = inner->terms()[0];
    power = Polynomial(Term{pow(only.monomial, factor.exponent), only.coefficient.pow(factor.exponent)});
  }
  for (int i = 1; i < factor.exponent; ++i) {
    std::optional<Polynomial> longer = product(power ? *power : *inner, *inner);
    if (!longer) return all ? Power::too_long : Power::stays;
    power = std::move(longer);
  }
  std::optional<Polynomial> longer = product(part, power ? *power : *inner);
  if (!longer) return Power::too_long;
  part = std::move(*longer);
  return Power::put_back;
}

std::optional<Polynomial> Flattening::flat(const Polynomial& polynomial, std::size_t levels) {
  Polynomial result;
  for (const Term& term : polynomial.terms()) {
    Polynomial part(Term{{}, term.coefficient});
    Monomial staying;  // multiplied in at the end: it makes no term more
    for (const Factor& factor : term.monomial) {
      const Power power = multiply_power(part, factor, levels);
      if (power == Power::too_long) return std::nullopt;
      if (power == Power::stays) staying.push_back(factor);
    }
    const std::optional<Polynomial> whole =
        staying.empty() ? std::move(part) : product(part, Polynomial(Term{std::move(staying), Number(1)}));
    if (!whole) return std::nullopt;
    result += *whole;
    if (result.terms().size() > limit_) return std::nullopt;
  }
  return shortest(std::move(result));
}

/// With every square of one value number as 1 less the square of another.
std::optional<Polynomial> Flattening::replaced(const Polynomial& polynomial, ValueNumber square_of,
                                               ValueNumber by) const {
  Polynomial one_less(Number(1));
  one_less.add({{{by, 2}}, Number(-1)});
  Polynomial result;
  for (const Term& term : polynomial.terms()) {
    Polynomial part{Term{{}, term.coefficient}};
    for (const Factor& each : term.monomial) {
      const bool squares = each.value_number == square_of && each.exponent >= 2;
      const int left = squares ? each.exponent % 2 : each.exponent;
      if (left != 0) part = *product(part, of_factor(each.value_number, left));  // as many terms as before
    }
    for (const Factor& each : term.monomial) {
      for (int i = each.value_number == square_of ? each.exponent : 0; i >= 2; i -= 2) {
        std::optional<Polynomial> longer = product(part, one_less);
        if (!longer) return std::nullopt;
        part = std::move(*longer);
      }
    }
    result += part;
    if (result.terms().size() > limit_) return std::nullopt;
  }
  return result;
}

/// Whether terms that never change their sign have different ones: such a sum may cancel.
bool Flattening::mixed_signs(const Polynomial& polynomial) const {
  bool positive = false, negative = false;
  for (const Term& term : polynomial.terms()) {
    const bool keeps_sign = std::all_of(term.monomial.begin(), term.monomial.end(), [this](const Factor& factor) {
      const SymbolPointer& symbol = (*program_)[factor.value_number].symbol;
      return factor.exponent % 2 == 0 || (symbol && symbol->kind == SymbolKind::parameter);
    });
    if (keeps_sign) (term.coefficient.sign() < 0 ? negative : positive) = true;
  }
  return positive && negative;
}

Polynomial Flattening::shortest(Polynomial polynomial) const {
  std::vector<ValueNumber> sines;
  for (const Term& term : polynomial.terms()) {
    for (const Factor& factor : term.monomial) {
      const Definition& definition = (*program_)[factor.value_number];
      if (factor.exponent < 2 || !definition.partner) continue;
      const ValueNumber sine = definition.function == Function::sin ? factor.value_number : *definition.partner;
      if (std::find(sines.begin(), sines.end(), sine) == sines.end()) sines.push_back(sine);
    }
  }
  std::sort(sines.begin(), sines.end());
  for (const ValueNumber sine : sines) {
    const ValueNumber cosine = *(*program_)[sine].partner;
    const Polynomial before = polynomial;
    for (const bool by_sine : {true, false}) {
      const std::optional<Polynomial> other =
          by_sine ? replaced(before, cosine, sine) : replaced(before, sine, cosine);
      if (!other) continue;
      const std::size_t now = polynomial.terms().size(), then = other->terms().size();
      if (then < now || (then == now && mixed_signs(polynomial) && !mixed_signs(*other))) polynomial = *other;
    }
  }
  return polynomial;
}

std::optional<Value> Flattening::operator()(const Value& value) {
  if (value.program() == nullptr || value.is_constant()) return value;
  const std::optional<Polynomial> result = flat(value.polynomial(), all_levels);
  if (!result) return std::nullopt;
  return Value(*program_, *result, value.unit());
}

int Flattening::operations(const Value& value) const {
  return count(formula(*program_, value.polynomial())).total();
}

Value Flattening::difference(const Value& a, const Value& b, const Value& c) {
  const Value plain = a - b * c;
  if (limit_ == 0 || !program_->passes().identities || b.is_zero() || c.is_zero()) return plain;
  Value best = plain;
  int least = 4;  // plainly two, a product and a difference, for a is a definition already; one more for what is saved
  std::optional<Polynomial> left, first, second;
  for (std::size_t levels = 1; levels <= all_levels; ++levels) {
    std::optional<Polynomial> left_now = flat(a.polynomial(), levels);
    std::optional<Polynomial> first_now = left_now ? flat(b.polynomial(), levels) : std::nullopt;
    std::optional<Polynomial> second_now = first_now ? flat(c.polynomial(), levels) : std::nullopt;
    if (!second_now) continue;
    if (second == second_now && first == first_now && left == left_now) continue;  // nothing more was put back
    left = std::move(left_now), first = std::move(first_now), second = std::move(second_now);
    std::optional<Polynomial> moved = product(*first, *second);
    if (!moved) continue;
    *moved *= Number(-1);
    *moved += *left;
    const bool cancels = !is_sum_of_positives(*program_, *moved);
    const Number whole = moved->constant();
    Polynomial sum = shortest(std::move(*moved));
    const bool keeps_digits =
        cancels && is_sum_of_positives(*program_, sum) && is_much_less(sum.constant(), whole);
    if (keeps_digits) sum = hoisted(*program_, sum);
    const Value flat(*program_, std::move(sum), plain.unit());
    const std::size_t terms = flat.polynomial().terms().size(), before = left->terms().size();
    if (terms == 0) return flat;
    // A sum of so many terms has as many additions less one, however it is factored.
    if (terms > before + (keeps_digits ? 1 : 0) || static_cast<int>(terms) > least) continue;
    const int cost = operations(flat) + (terms < before || terms == 1 || keeps_digits ? 0 : 1);
    if (cost >= least) continue;
    best = flat;
    least = cost;
  }
  return best;
}

Value Flattening::cheaper(const Value& value) {
  if (limit_ == 0 || !program_->passes().identities || value.is_zero() || value.is_constant()) return value;
  Value best = value;
  int least = operations(value) + 1;
  std::optional<Polynomial> sum;
  for (std::size_t levels = 1; levels <= all_levels; ++levels) {
    std::optional<Polynomial> now = flat(value.polynomial(), levels);
    if (!now || now == sum) continue;  // too long, or nothing more was put back
    sum = std::move(now);
    const Value flat(*program_, *sum, value.unit());
    const int cost = operations(flat);
    if (cost >= least) continue;
    best = flat;
    least = cost;
  }
  return best;
}

Value cancelled(const Program& program, const Value& value) {
  constexpr int levels = 3;
  if (!program.passes().identities) return value;
  const std::size_t at_most = value.polynomial().terms().size();
  Polynomial now = value.polynomial(), best = now;
  std::size_t least = at_most + 1;
  for (int level = 0; level < levels; ++level) {
    Polynomial next;
    std::size_t put_in = 0;
    for (const Term& term : now.terms()) {
      const bool alone = term.monomial.size() == 1 && term.monomial[0].exponent == 1;
      const Polynomial* sum = alone ? &program[term.monomial[0].value_number].polynomial : nullptr;
      if (sum == nullptr || sum->terms().size() < 2) {
        next.add(term);
        ++put_in;
        continue;
      }
      for (const Term& inner : sum->terms()) next.add({inner.monomial, term.coefficient * inner.coefficient});
      put_in += sum->terms().size();
    }
    now = std::move(next);
    const std::size_t left = now.terms().size();
    // Two terms that become one are no gain, two that vanish are.
    if (left + 2 <= put_in && left < least) {
      best = now;
      least = left;
    }
  }
  return least <= at_most ? Value(*value.program(), best, value.unit()) : value;
}

}  // namespace torsor
