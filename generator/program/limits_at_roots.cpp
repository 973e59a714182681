// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/program/limits_at_roots.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <unordered_map>

namespace torsor {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// Of a value |r + s| with |r| <= C V^regular and |s| <= C V^singular, V small, where s alone is divided by V: `never` where
/// there is no such part, and for s -never where it has no known bound.
struct Orders {
  double regular = never, singular = never;
  [[nodiscard]] double least() const { return std::min(regular, singular); }
};

/// What a continuous function with a bounded slope makes of the part that is divided by V.
double kept(double singular) { return singular > 0 ? singular : -never; }

/// A term without names of products, which several sums may share, where it has odd powers of them.
Term spelt_out(const Program& program, const Term& term) {
  Term whole{{}, term.coefficient};
  for (const Factor& factor : term.monomial) {
    const std::vector<Term>& terms = program[factor.value_number].polynomial.terms();
    if (terms.size() == 1 && factor.exponent > 0 && factor.exponent % 2 != 0) {
      const Term inner = spelt_out(program, terms[0]);
      for (int i = 0; i < factor.exponent; ++i) {
        whole = {whole.monomial * inner.monomial, whole.coefficient * inner.coefficient};
      }
    } else {
      whole.monomial = whole.monomial * Monomial{factor};
    }
  }
  return whole;
}

/// The u_j of a root of a sum of squares; none where it is no such root.
std::set<ValueNumber> sizes_under(const Program& program, ValueNumber root) {
  std::set<ValueNumber> sizes;
  const Definition& definition = program[root];
  if (definition.function != Function::sqrt) return sizes;
  for (const Term& shared : program[definition.arguments[0]].polynomial.terms()) {
    const Term term = spelt_out(program, shared);
    const bool even = std::all_of(term.monomial.begin(), term.monomial.end(),
                                  [](const Factor& factor) { return factor.exponent > 0 && factor.exponent % 2 == 0; });
    if (!even || term.monomial.empty() || term.coefficient.sign() < 0) return {};
    if (term.monomial.size() != 1 || term.monomial[0].exponent != 2) continue;
    const ValueNumber size = term.monomial[0].value_number;
    if (program[size].stage > Stage::parameters) sizes.insert(size);
  }
  return sizes;
}

/// Orders of everything, with respect to one root.
class Smallness {
 public:
  Smallness(const Program& program, ValueNumber root)
      : program_(&program), root_(root), sizes_(sizes_under(program, root)) {}

  Orders of(const Polynomial& sum) {
    Orders all;
    for (const Term& term : sum.terms()) {
      const Orders orders = of_product(term.monomial);
      all = {std::min(all.regular, orders.regular), std::min(all.singular, orders.singular)};
    }
    return all;
  }

  /// Whether a size of another root vanishes with this one.
  bool shares(const Program& program, ValueNumber other) {
    const std::set<ValueNumber> sizes = sizes_under(program, other);
    return std::any_of(sizes.begin(), sizes.end(), [&](ValueNumber size) { return of(size).regular > 0; });
  }

 private:
  Orders of_product(const Monomial& monomial) {
    std::vector<Orders> factors;
    Orders all{0, never};
    double least = 0;
    for (const Factor& factor : monomial) {
      factors.push_back(of_power(factor));
      all.regular += factors.back().regular;
      least += factors.back().least();
    }
    for (const Orders& factor : factors) {  // each product in which this factor gives its singular part
      if (factor.singular == -never) return {all.regular, -never};
      if (factor.singular < never) all.singular = std::min(all.singular, least - factor.least() + factor.singular);
    }
    return all;
  }

  Orders of_power(const Factor& factor) {
    const int n = factor.exponent;
    if (factor.value_number == root_) return n > 0 ? Orders{double(n), never} : Orders{never, double(n)};
    const Orders base = of(factor.value_number);
    if (n > 0) {
      Orders power{n * base.regular, base.singular};
      if (base.singular < never && n > 1) power.singular += (n - 1) * base.least();
      return power;
    }
    // Of order 0: where it vanishes all the same the reciprocal is not finite, and so is what it enters.
    if (base.regular > 0) return {never, -never};
    return {0, base.singular == never ? never : kept(base.singular)};
  }

  Orders of(ValueNumber value_number) {
    if (value_number == root_ || sizes_.contains(value_number)) return {1, never};
    if (const auto known = known_.find(value_number); known != known_.end()) return known->second;
    const Definition& definition = (*program_)[value_number];
    Orders orders{0, never};
    if (definition.function) {
      orders = of_call(definition);
    } else if (!definition.symbol) {
      orders = of(definition.polynomial);
    }
    known_.emplace(value_number, orders);
    return orders;
  }

  Orders of_call(const Definition& call) {
    std::vector<Orders> arguments;
    for (const ValueNumber argument : call.arguments) arguments.push_back(of(argument));
    double singular = never, regular = never;
    for (const Orders& argument : arguments) {
      if (argument.singular < never) singular = std::min(singular, kept(argument.singular));
      regular = std::min(regular, argument.regular);
    }
    switch (*call.function) {
      case Function::sin:
      case Function::abs:
      case Function::maximum: return {regular, singular};
      case Function::sqrt: return {regular / 2, singular < never ? singular / 2 : never};
      case Function::select:
        if (arguments[0].singular < never) return {0, -never};  // it decides by what is not known
        return {std::min(arguments[1].regular, arguments[2].regular), singular};
      case Function::sign: return {0, singular < never ? -never : never};
      case Function::log: return {0, singular < never && regular > 0 ? -never : singular};
      case Function::atan2: return {0, singular < never ? -never : never};  // it has no limit at (0, 0)
      case Function::cos:
      case Function::exp: break;
    }
    return {0, singular};
  }

  const Program* program_;
  ValueNumber root_;
  std::set<ValueNumber> sizes_;
  std::unordered_map<ValueNumber, Orders> known_;
};

/// The roots by which something is divided that the values need, in order of creation.
std::set<ValueNumber> dividing_roots(const Program& program, const std::vector<Value>& values) {
  std::set<ValueNumber> roots;
  const auto add = [&](const Polynomial& sum) {
    for (const Term& term : sum.terms()) {
      for (const Factor& factor : term.monomial) {
        if (factor.exponent < 0 && !sizes_under(program, factor.value_number).empty()) roots.insert(factor.value_number);
      }
    }
  };
  for (const Value& value : values) add(value.polynomial());
  for (const ValueNumber value_number : program.live(values)) add(program[value_number].polynomial);
  return roots;
}

/// Rebuilds values with other denominators.
class Rebuilt {
 public:
  Rebuilt(Program& program, const std::set<ValueNumber>& roots) : program_(&program) {
    for (const ValueNumber root : roots) {
      const Value value = program.value_of_number(root);
      divisors_.emplace(root, program.select(-value, program.number(Number(1), value.unit()), value));
    }
  }

  Value operator()(const Value& value) {
    if (value.is_zero()) return value;
    Value sum(*program_, Polynomial(), value.unit());
    for (const Term& term : value.polynomial().terms()) {
      Value product = program_->number(term.coefficient);
      for (const Factor& factor : term.monomial) {
        const auto divisor = factor.exponent < 0 ? divisors_.find(factor.value_number) : divisors_.end();
        product = product * pow(divisor != divisors_.end() ? divisor->second : of(factor.value_number), factor.exponent);
      }
      sum += Value(*program_, product.polynomial(), value.unit());
    }
    return sum;
  }

 private:
  Value of(ValueNumber value_number) {
    if (const auto known = known_.find(value_number); known != known_.end()) return known->second;
    const Definition definition = (*program_)[value_number];  // a copy: the program grows below
    Value result = program_->value_of_number(value_number);
    if (definition.function) {
      const std::vector<Unit> units = argument_units(*definition.function, definition.unit);
      std::vector<Value> arguments;
      bool changed = false;
      for (std::size_t i = 0; i < units.size(); ++i) {
        const Value argument = of(definition.arguments[i]);
        changed = changed || argument.value_number() != definition.arguments[i];
        arguments.emplace_back(*program_, argument.polynomial(), units[i]);
      }
      if (changed) result = program_->apply(*definition.function, arguments);
    } else if (!definition.symbol) {
      const Value rebuilt = (*this)(Value(*program_, definition.polynomial, definition.unit));
      if (rebuilt.polynomial() != definition.polynomial) result = program_->bind(rebuilt, definition.name);
    }
    known_.emplace(value_number, result);
    return result;
  }

  Program* program_;
  std::map<ValueNumber, Value> divisors_;
  std::unordered_map<ValueNumber, Value> known_;
};

}  // namespace

std::vector<Value> with_limits_at_roots(Program& program, const std::vector<Value>& values) {
  std::set<ValueNumber> roots = dividing_roots(program, values);
  std::erase_if(roots, [&](ValueNumber root) {
    Smallness smallness(program, root);
    return std::any_of(values.begin(), values.end(),
                       [&](const Value& value) { return smallness.of(value.polynomial()).singular <= 0; });
  });
  // What is small for two roots would be counted for each of them: x^2/(V W) with V = sqrt(x^2 + y^2), W = sqrt(x^2 + z^2).
  // One of them stays as it is, so that the value where both vanish is none.
  std::vector<ValueNumber> apart;
  for (const ValueNumber root : roots) {
    Smallness smallness(program, root);
    const bool shared = std::any_of(apart.begin(), apart.end(), [&](ValueNumber other) {
      return smallness.shares(program, other) || Smallness(program, other).shares(program, root);
    });
    if (!shared) apart.push_back(root);
  }
  roots = {apart.begin(), apart.end()};
  if (roots.empty()) return values;
  Rebuilt rebuilt(program, roots);
  std::vector<Value> result;
  result.reserve(values.size());
  for (const Value& value : values) result.push_back(rebuilt(value));
  return result;
}

}  // namespace torsor
