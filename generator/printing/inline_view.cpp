// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/printing/inline_view.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/printing/cancelled_fractions.hpp"
#include "torsor/generator/printing/knots.hpp"
#include "torsor/generator/printing/trigonometry.hpp"
#include "torsor/generator/printing/unit_quaternions.hpp"
#include "torsor/generator/program/identically_zero.hpp"

namespace torsor::printing {
namespace {

template <class T>
std::optional<T>& slot(std::vector<std::optional<T>>& table, ValueNumber value_number) {
  const auto index = static_cast<std::size_t>(value_number);
  if (table.size() <= index) table.resize(index + 1);
  return table[index];
}

// Functions that GiNaC lacks, or has with simplifications of its own: it differentiates these, and knows some of numbers.
DECLARE_FUNCTION_1P(absolute)
DECLARE_FUNCTION_1P(sign_of)
DECLARE_FUNCTION_2P(larger_of)
DECLARE_FUNCTION_2P(angle_of)
DECLARE_FUNCTION_3P(one_of)

GiNaC::ex slope_of_absolute(const GiNaC::ex& x, unsigned) { return sign_of(x); }
GiNaC::ex slope_of_sign(const GiNaC::ex&, unsigned) { return 0; }
GiNaC::ex slope_of_larger(const GiNaC::ex& a, const GiNaC::ex& b, unsigned by) {
  return one_of(a - b, by == 0 ? 1 : 0, by == 0 ? 0 : 1);
}
GiNaC::ex slope_of_angle(const GiNaC::ex& y, const GiNaC::ex& x, unsigned by) {
  const GiNaC::ex square = x * x + y * y;
  return by == 0 ? x / square : -y / square;
}
GiNaC::ex slope_of_choice(const GiNaC::ex& condition, const GiNaC::ex&, const GiNaC::ex&, unsigned by) {
  if (by == 0) return 0;
  return one_of(condition, by == 1 ? 1 : 0, by == 1 ? 0 : 1);
}

// Of numbers, which arise where a state is put in. Where two forms meet they stand as they are, so that a reader sees it.
bool is_number(const GiNaC::ex& x) { return GiNaC::is_a<GiNaC::numeric>(x); }
bool tells(const GiNaC::ex& condition) { return is_number(condition) && !condition.is_zero(); }
GiNaC::ex known_absolute(const GiNaC::ex& x) {
  return is_number(x) ? GiNaC::ex(GiNaC::abs(GiNaC::ex_to<GiNaC::numeric>(x))) : absolute(x).hold();
}
GiNaC::ex known_sign(const GiNaC::ex& x) {
  return tells(x) ? GiNaC::ex(GiNaC::ex_to<GiNaC::numeric>(x).csgn()) : sign_of(x).hold();
}
GiNaC::ex known_larger(const GiNaC::ex& a, const GiNaC::ex& b) {
  if (!tells(a - b)) return larger_of(a, b).hold();
  return GiNaC::ex_to<GiNaC::numeric>(a - b).is_positive() ? a : b;
}
GiNaC::ex known_choice(const GiNaC::ex& condition, const GiNaC::ex& a, const GiNaC::ex& b) {
  if (!tells(condition)) return one_of(condition, a, b).hold();
  return GiNaC::ex_to<GiNaC::numeric>(condition).is_positive() ? a : b;
}

REGISTER_FUNCTION(absolute, eval_func(known_absolute).derivative_func(slope_of_absolute))
REGISTER_FUNCTION(sign_of, eval_func(known_sign).derivative_func(slope_of_sign))
REGISTER_FUNCTION(larger_of, eval_func(known_larger).derivative_func(slope_of_larger))
REGISTER_FUNCTION(angle_of, derivative_func(slope_of_angle))
REGISTER_FUNCTION(one_of, eval_func(known_choice).derivative_func(slope_of_choice))

cln::cl_RA rational(const GiNaC::numeric& number) { return cln::the<cln::cl_RA>(number.to_cl_N()); }

/// Whether a law of time is more than a product of parameters and time.
bool is_long(const Sum& law) {
  if (law.size() != 1) return law.size() > 1;
  const Product& product = law.terms().begin()->first;
  return std::any_of(product.begin(), product.end(), [](const Power& p) { return p.base->kind == Base::Kind::function; });
}

}  // namespace

GiNaC::ex to_ginac(const Number& number) {
  const auto part = [&number](int i) { return GiNaC::ex(GiNaC::numeric(number.part(i))); };
  if (number.is_rational()) return part(0);
  const GiNaC::ex half = GiNaC::numeric(1, 2);
  const GiNaC::ex root_2 = GiNaC::power(GiNaC::ex(2), half);
  const GiNaC::ex root_3 = GiNaC::power(GiNaC::ex(3), half);
  return part(0) + part(1) * root_2 + part(2) * root_3 + part(3) * root_2 * root_3;
}

GiNaC::ex called(Function function, const std::vector<GiNaC::ex>& arguments) {
  const GiNaC::ex& argument = arguments[0];
  switch (function) {
    case Function::sin:
      return GiNaC::sin(argument);
    case Function::cos:
      return GiNaC::cos(argument);
    case Function::sqrt:
      return GiNaC::power(argument, GiNaC::numeric(1, 2));
    case Function::exp:
      return GiNaC::exp(argument);
    case Function::log:
      return GiNaC::log(argument);
    case Function::abs:
      return absolute(argument);
    case Function::sign:
      return sign_of(argument);
    case Function::maximum:
      return larger_of(argument, arguments[1]);
    case Function::atan2:
      return angle_of(argument, arguments[1]);
    case Function::select:
      return one_of(argument, arguments[1], arguments[2]);
  }
  return argument;
}

InlineView::InlineView(Program& program, const InlineLimits& limits, const SceneContent& scene)
    : program_(&program), limits_(limits), positive_(positive_parameters(scene)) {
  struct Law {
    SymbolPointer name;
    GiNaC::ex value;
    Sum written;
  };
  std::vector<Law> laws;  // all are written before one has a name
  // Whether it is listed, and longer than its name.
  const auto list = [&](const SymbolPointer& name, const Expression& law) {
    const std::optional<GiNaC::ex> value = expression_to_read(program.lower(law));
    const std::optional<Sum> written = value ? bounded_sum(*value) : std::nullopt;
    if (!written) return false;
    const bool is_rate = name->kind != SymbolKind::coordinate;
    if (!is_rate || (is_long(*written) && depends_on_time(*written))) laws.push_back({name, *value, *written});
    return is_long(*written);
  };
  for (const CoordinateContent& coordinate : scene.coordinates) {
    if (!coordinate.law || !list(coordinate.q, *coordinate.law)) continue;
    list(coordinate.v, rate(*coordinate.law));
    list(coordinate.a, rate(rate(*coordinate.law)));
  }
  for (Law& law : laws) {
    const bool stands = is_long(law.written);
    if (stands) named_values_[symbol(law.name)] = law.value;
    driven_.add(law.name, std::move(law.written), stands);
  }
  written_.clear();  // without the names
}

double InlineView::term_bound(const Value& value) { return term_bound(value.polynomial()); }

double InlineView::term_bound(const Polynomial& polynomial) {
  double sum = 0;
  for (const Term& term : polynomial.terms()) {
    double product = 1;
    for (const Factor& factor : term.monomial) {
      // A denominator is written as often as what stands over it.
      product *= std::pow(term_bound(factor.value_number), std::max(factor.exponent, 1));
    }
    sum += product;
  }
  return sum;
}

double InlineView::term_bound(ValueNumber value_number) {
  if (const auto& known = slot(bounds_, value_number)) return *known;
  const Definition& definition = (*program_)[value_number];
  double bound = 1;
  if (definition.function) {
    // What stands in the argument is written as often as the function.
    for (const ValueNumber argument : definition.arguments) bound = std::max(bound, term_bound(argument));
  } else if (!definition.symbol) {
    bound = std::max(1.0, term_bound(definition.polynomial));
  }
  slot(bounds_, value_number) = bound;
  return bound;
}

GiNaC::ex InlineView::symbol(const SymbolPointer& symbol) {
  if (symbol->kind == SymbolKind::pi) {
    if (symbols_.empty() || numbers_.find(symbol.get()) == numbers_.end()) {
      numbers_.emplace(symbol.get(), symbols_.size());
      symbols_.push_back(symbol);
      ginac_symbols_.push_back(GiNaC::Pi);
    }
    return GiNaC::Pi;
  }
  const auto [place, added] = numbers_.emplace(symbol.get(), symbols_.size());
  if (added) {
    symbols_.push_back(symbol);
    ginac_symbols_.push_back(GiNaC::symbol(std::to_string(place->second)));
  }
  return ginac_symbols_[place->second];
}

GiNaC::ex InlineView::of_polynomial(const Polynomial& polynomial) {
  GiNaC::exvector sum;
  for (const Term& term : polynomial.terms()) {
    GiNaC::exvector product{to_ginac(term.coefficient)};
    for (const Factor& factor : term.monomial) {
      product.push_back(GiNaC::power(of_value_number(factor.value_number), factor.exponent));
    }
    sum.push_back(GiNaC::mul(product));
  }
  return GiNaC::add(sum);
}

GiNaC::ex InlineView::of_value_number(ValueNumber value_number) {
  if (const auto& known = slot(value_numbers_, value_number)) return *known;
  const Definition& definition = (*program_)[value_number];
  GiNaC::ex result;
  if (definition.symbol) {
    result = symbol(definition.symbol);
  } else if (definition.function) {
    const auto product =
        *definition.function == Function::sqrt ? product_under_root(definition.arguments[0]) : std::nullopt;
    std::vector<GiNaC::ex> arguments;
    if (product) {
      arguments.push_back(1 - GiNaC::power(named_product(*product), 2));
    } else {
      for (const ValueNumber argument : definition.arguments) arguments.push_back(of_value_number(argument));
    }
    result = called(*definition.function, arguments);
  } else {
    result = of_polynomial(definition.polynomial);
  }
  slot(value_numbers_, value_number) = result;
  return result;
}

std::optional<std::size_t> InlineView::product_under_root(ValueNumber radicand) const {
  if (!(*program_)[radicand].unit.is_dimensionless()) return std::nullopt;
  for (std::size_t k = 0; k < products_.size(); ++k) {
    Program& program = *products_[k].value.program();
    Value difference = Value(program, Polynomial(radicand), Unit()) + pow(products_[k].value, 2);
    difference -= program.number(Number(1));
    if (identically_zero(difference)) return k;
  }
  return std::nullopt;
}

GiNaC::ex InlineView::named_product(std::size_t k) {
  const GiNaC::ex value = of_polynomial(products_[k].value.polynomial());
  if (sum(value).size() <= 1) return value;
  const GiNaC::ex name = symbol(products_[k].symbol);
  if (std::find(in_use_.begin(), in_use_.end(), k) == in_use_.end()) in_use_.push_back(k);
  named_values_[name] = value;
  return name;
}

std::vector<NamedProduct> InlineView::products_in_use() const {
  std::vector<NamedProduct> products;
  for (const std::size_t k : in_use_) products.push_back(products_[k]);
  return products;
}

const std::optional<InlineView::Reduced>& InlineView::reduced(ValueNumber value_number) {
  if (const auto& known = slot(reduced_, value_number)) return *known;
  const Definition& definition = (*program_)[value_number];
  std::optional<Reduced> result;
  if (definition.symbol || (definition.function && term_bound(value_number) <= limits_.terms)) {
    result = Reduced{of_value_number(value_number), 1};
  } else if (definition.function) {
    std::vector<GiNaC::ex> arguments;
    double terms = 1;
    for (const ValueNumber each : definition.arguments) {
      const std::optional<Reduced>& argument = reduced(each);
      if (!argument) break;
      arguments.push_back(argument->expression);
      terms = std::max(terms, argument->terms);
    }
    if (arguments.size() == definition.arguments.size()) result = Reduced{called(*definition.function, arguments), terms};
  } else {
    result = reduced(definition.polynomial);
  }
  return *(slot(reduced_, value_number) = std::move(result));
}

std::optional<InlineView::Reduced> InlineView::reduced(const Polynomial& polynomial) {
  GiNaC::exvector sum;
  double bound = 0;
  for (const Term& term : polynomial.terms()) {
    GiNaC::exvector product{to_ginac(term.coefficient)};
    double size = 1;
    for (const Factor& factor : term.monomial) {
      const std::optional<Reduced>& value = reduced(factor.value_number);
      if (!value) return std::nullopt;
      product.push_back(GiNaC::power(value->expression, factor.exponent));
      size *= std::pow(value->terms, std::max(factor.exponent, 1));
    }
    sum.push_back(GiNaC::mul(product));
    bound += size;
    if (!(bound <= limits_.expansion)) return std::nullopt;
  }
  const Sum written = shortened(GiNaC::ex(GiNaC::add(sum)).expand());
  const auto terms = static_cast<double>(written_terms(written));
  if (!(terms <= limits_.terms)) return std::nullopt;
  return Reduced{expression(written), std::max(1.0, terms)};
}

std::optional<GiNaC::ex> InlineView::expression_to_read(const Value& value) {
  if (term_bound(value) <= limits_.expansion) return of_polynomial(value.polynomial());
  const std::optional<Reduced> result = reduced(value.polynomial());
  return result ? std::optional(result->expression) : std::nullopt;
}

std::optional<GiNaC::ex> InlineView::expression(const Value& value) {
  const std::optional<GiNaC::ex> named = expression_to_read(value);
  return named && !named_values_.empty() ? GiNaC::ex(named->subs(named_values_)) : named;
}

Sum InlineView::canonical_power(const GiNaC::ex& expression) {
  const GiNaC::ex& exponent = expression.op(1);
  if (!GiNaC::is_a<GiNaC::numeric>(exponent)) throw Error("a printed equation has an exponent that is not a number");
  const GiNaC::numeric halves = GiNaC::ex_to<GiNaC::numeric>(exponent) * GiNaC::numeric(2);
  if (!halves.is_integer()) throw Error("a printed equation has a power that is neither whole nor a root");
  if (halves.to_int() % 2 != 0) return root(shortened(expression.op(0)), halves.to_int(), positive_);
  return power(halves.is_negative() ? shortened(expression.op(0)) : canonical(expression.op(0)), halves.to_int());
}

Sum InlineView::canonical(const GiNaC::ex& e) {
  if (GiNaC::is_a<GiNaC::numeric>(e)) {
    const auto& number = GiNaC::ex_to<GiNaC::numeric>(e);
    if (!number.is_rational()) throw Error("a printed equation has a number that is not exact");
    return Sum(Number(rational(number)));
  }
  if (GiNaC::is_a<GiNaC::symbol>(e)) {
    const std::string name = GiNaC::ex_to<GiNaC::symbol>(e).get_name();
    return Sum::symbol(symbols_[static_cast<std::size_t>(std::stoul(name))]);
  }
  if (GiNaC::is_a<GiNaC::constant>(e)) return Sum::symbol(pi().as_symbol());
  if (GiNaC::is_a<GiNaC::add>(e)) {
    Sum sum;
    for (std::size_t i = 0; i < e.nops(); ++i) sum += canonical(e.op(i));
    return sum;
  }
  if (GiNaC::is_a<GiNaC::mul>(e)) {
    Sum product{Number(1)};
    for (std::size_t i = 0; i < e.nops(); ++i) product = product * canonical(e.op(i));
    return product;
  }
  // A root or a call stands in many terms.
  const auto known = written_.find(e);
  if (known != written_.end()) return known->second;
  return written_.emplace(e, GiNaC::is_a<GiNaC::power>(e) ? canonical_power(e) : canonical_call(e)).first->second;
}

Sum InlineView::canonical_call(const GiNaC::ex& e) {
  const auto call = [&](Function function) {
    std::vector<Sum> arguments;
    for (std::size_t i = 0; i < e.nops(); ++i) arguments.push_back(shortened(e.op(i)));
    if (function == Function::sin || function == Function::cos) arguments[0] = driven_.named_in_angle(std::move(arguments[0]));
    return Sum::function(function, arguments);
  };
  if (GiNaC::is_the_function<GiNaC::sin_SERIAL>(e)) return call(Function::sin);
  if (GiNaC::is_the_function<GiNaC::cos_SERIAL>(e)) return call(Function::cos);
  if (GiNaC::is_the_function<GiNaC::exp_SERIAL>(e)) return call(Function::exp);
  if (GiNaC::is_the_function<GiNaC::log_SERIAL>(e)) return call(Function::log);
  if (GiNaC::is_the_function<absolute_SERIAL>(e)) return call(Function::abs);
  if (GiNaC::is_the_function<sign_of_SERIAL>(e)) return call(Function::sign);
  if (GiNaC::is_the_function<larger_of_SERIAL>(e)) return call(Function::maximum);
  if (GiNaC::is_the_function<angle_of_SERIAL>(e)) return call(Function::atan2);
  if (GiNaC::is_the_function<one_of_SERIAL>(e)) return call(Function::select);
  throw Error("a printed equation has a function that cannot be printed");
}

Sum InlineView::shortened(const GiNaC::ex& expression) {
  Knots knots;
  const Sum sum = with_squares_beside_roots(with_unit_quaternions(knots.named(canonical(expression))));
  const Sum simple = simplified(sum), shorter = cancelled(simple);
  Sum result = driven_.named(with_squares_in_roots(compare(simple, shorter) == 0 ? simple : simplified(shorter)));
  return knots.put_back(knots.named(std::move(result)));
}

Sum InlineView::sum(const GiNaC::ex& expression) { return shortened(expression.expand()); }

std::optional<Sum> InlineView::bounded_sum(const GiNaC::ex& expression) {
  Sum result = sum(expression);
  if (static_cast<int>(written_terms(result)) > limits_.terms) return std::nullopt;
  return result;
}

std::optional<Sum> InlineView::sum(const Value& value) {
  const std::optional<GiNaC::ex> written = expression_to_read(value);
  if (!written) return std::nullopt;
  return bounded_sum(*written);
}

GiNaC::ex InlineView::of_call(const Base& call) {
  std::vector<GiNaC::ex> arguments{expression(call.inside)};
  for (const Sum& other : call.others) arguments.push_back(expression(other));
  return called(call.function, arguments);
}

GiNaC::ex InlineView::expression(const Sum& sum) {
  GiNaC::exvector terms;
  for (const auto& [product, coefficient] : sum.terms()) {
    GiNaC::exvector factors{to_ginac(coefficient)};
    for (const Power& power : product) {
      GiNaC::ex base;
      switch (power.base->kind) {
        case Base::Kind::symbol:
          base = symbol(power.base->symbol);
          break;
        case Base::Kind::function:
          base = of_call(*power.base);
          break;
        case Base::Kind::group:
          base = expression(power.base->inside);
          break;
        case Base::Kind::definition:
          throw Error("a named definition has no inline form");
      }
      factors.push_back(GiNaC::power(base, GiNaC::numeric(power.halves, 2)));
    }
    terms.push_back(GiNaC::mul(factors));
  }
  const GiNaC::ex total = GiNaC::add(terms);
  return named_values_.empty() ? total : GiNaC::ex(total.subs(named_values_));
}

}  // namespace torsor::printing
