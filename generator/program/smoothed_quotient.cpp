// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/program/smoothed_quotient.hpp"

#include <algorithm>

namespace torsor {
namespace {

/// coefficient · exponent · monomial / value number: the partial derivative of a term with respect to one of its factors.
Term partial_of_factor(const Term& term, const Factor& factor) {
  return {term.monomial * Monomial{{factor.value_number, -1}}, term.coefficient * Number(factor.exponent)};
}

/// The root by which a factor divides: √… to the power −1, or one definition of that.
std::optional<ValueNumber> divides_by(const Program& program, const Factor& factor) {
  const Definition& definition = program[factor.value_number];
  if (factor.exponent == -1 && definition.function == Function::sqrt) return factor.value_number;
  if (factor.exponent != 1 || definition.polynomial.terms().size() != 1) return std::nullopt;
  const Term& term = definition.polynomial.terms()[0];
  if (!term.coefficient.is_one() || term.monomial.size() != 1 || term.monomial[0].exponent != -1) return std::nullopt;
  return divides_by(program, term.monomial[0]);
}

/// N of a term k N² with k > 0.
std::optional<Monomial> root_of_square(const Term& term) {
  Monomial root = term.monomial;
  if (root.empty() || term.coefficient.sign() < 0) return std::nullopt;
  for (Factor& factor : root) {
    if (factor.exponent <= 0 || factor.exponent % 2 != 0) return std::nullopt;
    factor.exponent /= 2;
  }
  return root;
}

bool stands_in(const Monomial& part, const Monomial& whole) {
  return std::all_of(part.begin(), part.end(), [&](const Factor& factor) {
    return std::any_of(whole.begin(), whole.end(), [&](const Factor& other) {
      return other.value_number == factor.value_number && other.exponent >= factor.exponent;
    });
  });
}

/// Whether a term is divided by a sum of exponentials.
bool divides_by_exponentials(const Program& program, const Factor& factor) {
  if (factor.exponent >= 0) return false;
  const Polynomial& sum = program[factor.value_number].polynomial;
  return std::any_of(sum.terms().begin(), sum.terms().end(), [&](const Term& term) {
    return std::any_of(term.monomial.begin(), term.monomial.end(),
                       [&](const Factor& each) { return program[each.value_number].function == Function::exp; });
  });
}

bool changes(const Program& program, const Term& term) {
  return std::any_of(term.monomial.begin(), term.monomial.end(),
                     [&](const Factor& factor) { return program[factor.value_number].stage > Stage::parameters; });
}

}  // namespace

std::optional<SmoothedQuotient> smoothed_quotient(Program& program, const Monomial& monomial) {
  for (const Factor& factor : monomial) {
    const std::optional<ValueNumber> root = divides_by(program, factor);
    if (!root) continue;
    const ValueNumber argument = program[*root].arguments[0];
    const Polynomial square = program[argument].polynomial;  // a copy: the program grows below
    for (std::size_t i = 0; i < square.terms().size(); ++i) {
      const std::optional<Monomial> numerator = root_of_square(square.terms()[i]);
      if (!numerator || !changes(program, square.terms()[i]) || !stands_in(*numerator, monomial)) continue;
      Polynomial rest = square;
      rest.erase(i);
      if (std::all_of(rest.terms().begin(), rest.terms().end(), [&](const Term& term) { return changes(program, term); }))
        continue;
      const Monomial others = monomial * pow(*numerator, -1) * Monomial{{factor.value_number, -factor.exponent}};
      const Value bound = program.bind({program, std::move(rest), program[argument].unit});
      return SmoothedQuotient{*numerator, others, *root, {program, bound.polynomial(), Unit()}};
    }
  }
  return std::nullopt;
}

std::vector<std::pair<ValueNumber, Value>> partials_of_term(Program& program, const Term& term) {
  std::vector<std::pair<ValueNumber, Value>> partials;
  const auto add = [&](const Term& whole, const Factor& factor, const Value& multiple) {
    partials.emplace_back(factor.value_number,
                          Value(program, Polynomial(partial_of_factor(whole, factor)), Unit()) * multiple);
  };
  const Value one = program.number(Number(1));
  const auto bound = [&program](const Value& value) { return Value(program, program.bind(value).polynomial(), Unit()); };
  const std::optional<SmoothedQuotient> quotient = smoothed_quotient(program, term.monomial);
  for (const Factor& factor : quotient ? quotient->others : term.monomial) {
    if (divides_by_exponentials(program, factor)) {
      // d(A/b) = -(A/b) b'/b, A/b a value of its own: b², b³ of the next derivatives are soon beyond what floats hold.
      const Term over{{{factor.value_number, -1}}, Number(factor.exponent)};
      const Value whole = bound(Value(program, Polynomial(term), Unit()));
      partials.emplace_back(factor.value_number, whole * Value(program, Polynomial(over), Unit()));
    } else {
      add(term, factor, one);
    }
  }
  if (!quotient) return partials;
  // R/√…² and N/√… are of the size of one: the cube of a root may be beyond what floats hold.
  const Monomial over_root{{quotient->root, -1}}, over_square{{quotient->root, -2}};
  const Value share = bound(quotient->rest * Value(program, Polynomial({over_square, Number(1)}), Unit()));
  const Value direction = bound(Value(program, Polynomial({quotient->numerator * over_root, Number(1)}), Unit()));
  const Term over{quotient->others * quotient->numerator * over_root, term.coefficient};
  for (const Factor& factor : quotient->numerator) add(over, factor, share);
  const Number minus_half = term.coefficient * Number::rational(-1, 2);
  const Value half = direction * Value(program, Polynomial({quotient->others * over_square, minus_half}), Unit());
  for (const Term& part : quotient->rest.polynomial().terms()) {
    for (const Factor& factor : part.monomial) add(part, factor, half);
  }
  return partials;
}

}  // namespace torsor
