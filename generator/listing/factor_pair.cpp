// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/listing/factor_pair.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <string>
#include <utility>

namespace torsor {
namespace {

int exponent_of(const Monomial& monomial, ValueNumber value_number) {
  const auto place = std::find_if(monomial.begin(), monomial.end(),
                                  [value_number](const Factor& factor) { return factor.value_number == value_number; });
  return place == monomial.end() ? 0 : place->exponent;
}

bool has_inner_sum(const Formula& formula, bool multiplied = false) {
  const bool is_sum = formula.kind == Formula::Kind::sum;
  if (is_sum && multiplied) return true;
  return std::any_of(formula.children.begin(), formula.children.end(),
                     [&](const Formula& child) { return has_inner_sum(child, multiplied || !is_sum); });
}

/// Texts that are equal where formulas are, but for the order of terms and factors, with the pair for its product.
class Shape {
 public:
  Shape(const FactorPair& pair, ValueNumber product) : product_(product) {
    const ValueNumber* other = pair.other();
    pair_ = {text(pair.first), other != nullptr ? text(*other) : std::get<Number>(pair.second).to_string()};
  }

  std::string operator()(const Formula& formula) const {
    switch (formula.kind) {
      case Formula::Kind::value_number:
        return formula.value_number == product_ ? joined("*", pair_) : text(*formula.value_number);
      case Formula::Kind::constant: return formula.number.to_string();
      case Formula::Kind::function: {
        std::string call(to_string(formula.function));
        for (const Formula& argument : formula.children) call += " " + (*this)(argument);
        return call;
      }
      case Formula::Kind::sum: {
        std::vector<std::string> terms;
        for (std::size_t i = 0; i < formula.children.size(); ++i)
          terms.push_back((formula.negative[i] ? "-" : "+") + (*this)(formula.children[i]));
        return joined("sum", std::move(terms));
      }
      case Formula::Kind::product: {
        std::vector<std::string> factors;
        for (const Formula& child : formula.children) {
          if (child.kind == Formula::Kind::value_number && child.value_number == product_)
            factors.insert(factors.end(), pair_.begin(), pair_.end());
          else
            factors.push_back((*this)(child));
        }
        return joined("*", std::move(factors));
      }
      case Formula::Kind::quotient: return (*this)(formula.children[0]) + "/" + (*this)(formula.children[1]);
    }
    return {};
  }

 private:
  static std::string text(ValueNumber value_number) { return "z" + std::to_string(value_number); }
  static std::string joined(const char* name, std::vector<std::string> parts) {
    std::sort(parts.begin(), parts.end());
    std::string result = std::string(name) + "(";
    for (const std::string& part : parts) result += part + ",";
    return result + ")";
  }

  ValueNumber product_;
  std::vector<std::string> pair_;
};

}  // namespace

Polynomial FactorPair::product() const {
  const Monomial single{{first, 1}};
  if (other() != nullptr) return Polynomial(Term{single * Monomial{{*other(), 1}}, Number(1)});
  return Polynomial(Term{single, std::get<Number>(second)});
}

Polynomial FactorPair::replaced(const Polynomial& sum, ValueNumber product) const {
  Polynomial result;
  for (const Term& term : sum.terms()) {
    Monomial monomial = term.monomial;
    Number coefficient = term.coefficient;
    const int power = exponent_of(monomial, first);
    int times = 0;
    if (other() == nullptr)
      times = power > 0 && coefficient.abs() == std::get<Number>(second) ? 1 : 0;
    else
      times = *other() == first ? power / 2 : std::min(power, exponent_of(monomial, *other()));
    if (times > 0) {
      monomial = monomial * Monomial{{first, -times}} * Monomial{{product, times}};
      if (other() != nullptr)
        monomial = monomial * Monomial{{*other(), -times}};
      else
        coefficient = Number(coefficient.sign());
    }
    result.add({std::move(monomial), std::move(coefficient)});
  }
  return result;
}

std::optional<FactorPair> as_pair(const Polynomial& sum) {
  if (sum.terms().size() != 1) return std::nullopt;
  const auto& [monomial, coefficient] = sum.terms()[0];
  const bool plain = coefficient.is_one();
  if (monomial.size() == 1) {
    const auto& [value_number, exponent] = monomial[0];
    if (plain && exponent == 2) return FactorPair{value_number, value_number};
    if (!plain && exponent == 1 && coefficient.sign() > 0) return FactorPair{value_number, coefficient};
  }
  if (!plain || monomial.size() != 2 || monomial[0].exponent != 1 || monomial[1].exponent != 1) return std::nullopt;
  return FactorPair{monomial[0].value_number, monomial[1].value_number};
}

void add_pairs(const Formula& formula, std::vector<FactorPair>& pairs) {
  for (const Formula& child : formula.children) add_pairs(child, pairs);
  if (formula.kind != Formula::Kind::product) return;
  std::map<ValueNumber, int> powers;
  const Number* number = nullptr;
  for (const Formula& child : formula.children) {
    if (child.kind == Formula::Kind::value_number) ++powers[*child.value_number];
    if (child.kind == Formula::Kind::constant) number = &child.number;
  }
  for (auto one = powers.begin(); one != powers.end(); ++one) {
    const auto& [value_number, power] = *one;
    if (number != nullptr) pairs.push_back({value_number, *number});
    for (int squares = power / 2; squares > 0; --squares) pairs.push_back({value_number, value_number});
    for (auto other = std::next(one); other != powers.end(); ++other) pairs.push_back({value_number, other->first});
  }
}

bool same_factoring(const Formula& before, const Formula& after, const FactorPair& pair, ValueNumber product) {
  if (!has_inner_sum(before) && !has_inner_sum(after)) return true;
  const Shape shape(pair, product);
  return shape(before) == shape(after);
}

}  // namespace torsor
