// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/program/formula.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <unordered_map>
#include <utility>

#include "torsor/generator/program/formula_parts.hpp"
#include "torsor/generator/program/sum_table.hpp"

namespace torsor {
namespace {

/// coefficient · monomial as a product, or a quotient when value numbers divide.
Formula of_term(const Monomial& monomial, const Number& size) {
  std::vector<Formula> numerator, denominator;
  if (!size.is_one()) numerator.push_back(Formula::of_number(size));
  for (const Factor& factor : monomial) {
    std::vector<Formula>& side = factor.exponent > 0 ? numerator : denominator;
    for (int k = 0; k < std::abs(factor.exponent); ++k) side.push_back(Formula::of_value_number(factor.value_number));
  }
  const auto collapse = [](std::vector<Formula> factors) {
    if (factors.empty()) return Formula::of_number(Number(1));
    return factors.size() == 1 ? std::move(factors[0]) : formula_parts::product(std::move(factors));
  };
  Formula top = collapse(std::move(numerator));
  return denominator.empty() ? std::move(top) : formula_parts::quotient(std::move(top), collapse(std::move(denominator)));
}

/// The value number that stands, with a positive exponent, in most terms; at least in two. Ties go to the earliest value number.
std::optional<ValueNumber> most_shared_value_number(const Polynomial& polynomial, int& uses) {
  std::map<ValueNumber, int> counts;
  for (const Term& term : polynomial.terms()) {
    for (const Factor& factor : term.monomial) {
      if (factor.exponent > 0) ++counts[factor.value_number];
    }
  }
  std::optional<ValueNumber> best;
  uses = 1;
  for (const auto& [value_number, count] : counts) {
    if (count > uses) best = value_number, uses = count;
  }
  return best;
}

std::optional<Number> most_shared_size(const Polynomial& polynomial, int& uses) {
  std::unordered_map<Number, int> counts;  // asked, and never gone through
  std::optional<Number> best;
  std::vector<Number> sizes;  // but for one
  for (const Term& term : polynomial.terms()) {
    Number size = term.coefficient.abs();
    if (size.is_one()) continue;
    ++counts[size];
    sizes.push_back(std::move(size));
  }
  uses = 1;
  for (const Number& size : sizes) {
    if (const int same = counts.at(size); same > uses) best = size, uses = same;
  }
  return best;
}

Formula multiplied(const Formula& factor, Formula rest) {
  Formula product = formula_parts::product({factor});
  if (rest.kind == Formula::Kind::product) {
    product.children.insert(product.children.end(), std::make_move_iterator(rest.children.begin()),
                            std::make_move_iterator(rest.children.end()));
  } else {
    product.children.push_back(std::move(rest));
  }
  return product;
}

/// Appends the terms of a sum, flattening nested sums.
void append(Formula& sum, Formula part, bool negative) {
  if (part.kind == Formula::Kind::sum) {
    for (std::size_t i = 0; i < part.children.size(); ++i) {
      sum.children.push_back(std::move(part.children[i]));
      sum.negative.push_back(part.negative[i] != negative);
    }
    return;
  }
  sum.children.push_back(std::move(part));
  sum.negative.push_back(negative);
}

}  // namespace

Formula Formula::of_value_number(ValueNumber value_number) {
  Formula formula;
  formula.kind = Kind::value_number;
  formula.value_number = value_number;
  return formula;
}

Formula Formula::of_number(const Number& number) {
  Formula formula;
  formula.number = number;
  return formula;
}

Formula negated(Formula formula) {
  if (formula.kind == Formula::Kind::sum) {
    formula.negative.flip();
    return formula;
  }
  Formula sum = formula_parts::sum({});
  formula_parts::add(sum, std::move(formula), true);
  return sum;
}

Formula factored(const Polynomial& polynomial) {
  const std::vector<Term>& terms = polynomial.terms();
  if (terms.empty()) return Formula::of_number(Number());
  if (terms.size() == 1 && terms[0].coefficient.sign() > 0) return of_term(terms[0].monomial, terms[0].coefficient);

  Formula sum = formula_parts::sum({});
  int value_number_uses = 0;
  int size_uses = 0;
  const std::optional<ValueNumber> value_number = most_shared_value_number(polynomial, value_number_uses);
  const std::optional<Number> size = most_shared_size(polynomial, size_uses);
  if (value_number || size) {
    Polynomial inside;
    Polynomial outside;
    const bool by_value_number = value_number && (!size || value_number_uses >= size_uses);
    for (const Term& term : terms) {
      const bool shares =
          by_value_number
              ? std::any_of(term.monomial.begin(), term.monomial.end(),
                            [&](const Factor& f) { return f.value_number == *value_number && f.exponent > 0; })
              : term.coefficient.abs() == *size;
      if (!shares) {
        outside.add(term);
      } else if (by_value_number) {
        inside.add({term.monomial * Monomial{{*value_number, -1}}, term.coefficient});
      } else {
        inside.add({term.monomial, Number(term.coefficient.sign())});
      }
    }
    const bool negative = inside.sign() < 0;
    if (negative) inside *= Number(-1);
    const Formula factor = by_value_number ? Formula::of_value_number(*value_number) : Formula::of_number(*size);
    append(sum, multiplied(factor, factored(inside)), negative);
    if (!outside.is_zero()) append(sum, factored(outside), false);
  } else {
    for (const Term& term : terms) {
      append(sum, of_term(term.monomial, term.coefficient.abs()), term.coefficient.sign() < 0);
    }
  }
  return formula_parts::collapsed(std::move(sum));
}

Formula expanded(const Polynomial& polynomial) {
  if (polynomial.is_zero()) return Formula::of_number(Number());
  Formula sum = formula_parts::sum({});
  for (const Term& term : polynomial.terms()) {
    append(sum, of_term(term.monomial, term.coefficient.abs()), term.coefficient.sign() < 0);
  }
  return formula_parts::collapsed(std::move(sum));
}

Formula formula(const Program& program, const Polynomial& sum) {
  return program.passes().factoring ? factored(sum) : expanded(sum);
}

Formula formula(const Program& program, const Definition& definition) {
  if (!definition.function) return formula(program, definition.polynomial);
  Formula call;
  call.kind = Formula::Kind::function;
  call.function = *definition.function;
  for (const ValueNumber argument : definition.arguments) call.children.push_back(Formula::of_value_number(argument));
  return call;
}

OperationCount& OperationCount::operator+=(const OperationCount& other) {
  additions += other.additions;
  multiplications += other.multiplications;
  divisions += other.divisions;
  square_roots += other.square_roots;
  sincos_pairs += other.sincos_pairs;
  others += other.others;
  return *this;
}

OperationCount count(const Formula& formula) {
  OperationCount total;
  for (const Formula& child : formula.children) total += count(child);
  const int joints = static_cast<int>(formula.children.size()) - 1;
  switch (formula.kind) {
    case Formula::Kind::sum:
      total.additions += joints;
      break;
    case Formula::Kind::product:
      total.multiplications += joints;
      break;
    case Formula::Kind::quotient:
      total.divisions += 1;
      break;
    case Formula::Kind::function:
      if (formula.function == Function::sqrt) total.square_roots += 1;
      // Sines and cosines are counted by pair, where the program is known.
      if (formula.function != Function::sqrt && formula.function != Function::sin &&
          formula.function != Function::cos) {
        total.others += 1;
      }
      break;
    case Formula::Kind::value_number:
    case Formula::Kind::constant:
      break;
  }
  return total;
}

namespace {

/// Counts the definitions and outputs of the stages that `belongs` picks, with right-hand sides made by `shape`.
template <class Belongs, class Shape>
OperationCount count_live(const Program& program, const std::vector<Value>& outputs, Belongs belongs, Shape shape) {
  OperationCount total;
  std::vector<ValueNumber> angles;
  for (const ValueNumber value_number : program.live(outputs)) {
    const Definition& definition = program[value_number];
    if (definition.symbol || !belongs(definition.stage)) continue;
    const bool trigonometric = definition.function == Function::sin || definition.function == Function::cos;
    if (trigonometric) {
      if (std::find(angles.begin(), angles.end(), definition.arguments[0]) == angles.end()) {
        angles.push_back(definition.arguments[0]);
        total.sincos_pairs += 1;
      }
      continue;
    }
    total += count(definition.function ? formula(program, definition) : shape(definition.polynomial));
  }
  SumTable seen;
  for (const Value& output : outputs) {
    if (output.is_zero() || !belongs(program.stage(output))) continue;
    const Polynomial positive = without_sign(output.polynomial()).first;
    if (seen.add(positive).second) total += count(shape(positive));
  }
  return total;
}

}  // namespace

OperationCount count(const Program& program, const std::vector<Value>& outputs, Occasion occasion) {
  const auto belongs = [occasion](Stage stage) {
    if (stage == Stage::generation) return false;
    return (stage == Stage::parameters) == (occasion == Occasion::parameters);
  };
  return count_live(program, outputs, belongs, [&](const Polynomial& sum) { return formula(program, sum); });
}

OperationCount count_unoptimised(const Program& program, const std::vector<Value>& outputs) {
  return count_live(
      program, outputs, [](Stage stage) { return stage != Stage::generation; }, expanded);
}

}  // namespace torsor
