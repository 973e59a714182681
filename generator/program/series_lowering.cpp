// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/program/series_lowering.hpp"

#include <algorithm>

namespace torsor {
namespace {

/// Sums of more terms, or with coefficients of more terms, stay behind a name.
constexpr std::size_t longest_sum = 8;
constexpr std::size_t longest_coefficient = 4;

/// Of so many products at most a product of sums is made.
constexpr std::size_t most_products = 12;

std::size_t at(int node) { return static_cast<std::size_t>(node); }

Polynomial unity() { return Polynomial(Number(1)); }

Polynomial power(const Polynomial& single, int exponent) {
  const Term& term = single.terms()[0];
  return Polynomial(Term{pow(term.monomial, exponent), term.coefficient.pow(exponent)});
}

bool is_single(const SeriesForm& form) {
  return form.constant.is_zero() && form.terms.size() == 1 && form.terms[0].coefficient.terms().size() == 1;
}

bool is_short(const SeriesForm& form) {
  return form.terms.size() <= longest_sum && std::all_of(form.terms.begin(), form.terms.end(), [](const auto& term) {
           return term.coefficient.terms().size() <= longest_coefficient;
         });
}

SeriesForm form_of_node(int node) {
  SeriesForm form;
  form.add(node, unity());
  return form;
}

}  // namespace

SeriesLowering::SeriesLowering(const Program& program, const std::vector<ValueNumber>& live, std::vector<bool> inlined)
    : program_(program),
      inlined_(std::move(inlined)),
      constant_(program.size(), false),
      pieces_(program.size()),
      direct_(program.size()),
      expanded_(program.size()) {
  for (const ValueNumber value_number : live) define(value_number);
}

void SeriesLowering::add_output(const Polynomial& polynomial) {
  SeriesForm expanded;
  outputs_.push_back(lowered(pieces_of(polynomial), expanded));
}

int SeriesLowering::append(SeriesNode node) {
  nodes_.push_back(std::move(node));
  return static_cast<int>(nodes_.size()) - 1;
}

bool SeriesLowering::is_constant(const Polynomial& polynomial) const {
  return std::all_of(polynomial.terms().begin(), polynomial.terms().end(), [&](const Term& term) {
    return std::all_of(term.monomial.begin(), term.monomial.end(),
                       [&](const Factor& factor) { return constant_[at(factor.value_number)]; });
  });
}

void SeriesLowering::define(ValueNumber value_number) {
  const Definition& definition = program_[value_number];
  if (definition.symbol) {
    const SymbolKind kind = definition.symbol->kind;
    constant_[at(value_number)] = kind != SymbolKind::time && kind != SymbolKind::coordinate &&
                                  kind != SymbolKind::velocity && kind != SymbolKind::acceleration;
    if (constant_[at(value_number)]) return;
    const int node = append({.kind = SeriesNode::Kind::symbol, .value_number = value_number});
    expanded_[at(value_number)] = form_of_node(node);
    direct_[at(value_number)] = expanded_[at(value_number)];
    return;
  }
  if (definition.function) {
    const std::vector<ValueNumber>& arguments = definition.arguments;
    for (const ValueNumber argument : arguments) {
      if (!constant_[at(argument)]) form_of(argument);
    }
    // A condition chooses once and for all: it counts at the start only.
    const bool condition = definition.function == Function::select;
    constant_[at(value_number)] = definition.function == Function::sign ||
                          std::all_of(arguments.begin() + (condition ? 1 : 0), arguments.end(),
                                      [&](ValueNumber argument) { return constant_[at(argument)]; });
    if (!constant_[at(value_number)] && !direct_[at(value_number)]) define_function(value_number);
    return;
  }
  constant_[at(value_number)] = is_constant(definition.polynomial);
  if (constant_[at(value_number)]) return;
  pieces_[at(value_number)] = pieces_of(definition.polynomial);
  if (!inlined_[at(value_number)]) form_of(value_number);
}

void SeriesLowering::define_function(ValueNumber value_number) {
  const Definition& definition = program_[value_number];
  const auto keep = [&](ValueNumber of, int node) {
    expanded_[at(of)] = form_of_node(node);
    direct_[at(of)] = expanded_[at(of)];
    return node;
  };
  // The series of an argument; none where it does not change, not even by its form (terms that cancel).
  const auto series = [&](std::size_t i) -> std::optional<int> {
    const ValueNumber argument = definition.arguments[i];
    if (constant_[at(argument)] || form_of(argument).terms.empty()) return std::nullopt;
    return exact(form_of(argument));
  };
  if (definition.function == Function::select || definition.function == Function::maximum) {
    const std::size_t first = definition.function == Function::select ? 1 : 0;
    const std::optional<int> left = series(first);
    const std::optional<int> right = series(first + 1);
    keep(value_number, append({SeriesNode::Kind::selection, value_number, left, right}));
    return;
  }
  if (definition.function == Function::atan2) {
    const std::optional<int> y = series(0);
    return define_arctangent(value_number, y, series(1));
  }
  const int argument = exact(form_of(definition.arguments[0]));
  const auto make = [&](ValueNumber of, SeriesNode::Kind kind) {
    return keep(of, append({.kind = kind, .value_number = of, .left = argument}));
  };
  switch (*definition.function) {
    case Function::abs:
      make(value_number, SeriesNode::Kind::selection);
      return;
    case Function::sign:
    case Function::maximum:
    case Function::atan2:
    case Function::select: return;
    case Function::sqrt:
      make(value_number, SeriesNode::Kind::square_root);
      return;
    case Function::exp: {
      const int own = make(value_number, SeriesNode::Kind::primitive);
      nodes_[at(own)].right = own;
      return;
    }
    case Function::log:
      make(value_number, SeriesNode::Kind::logarithm);
      return;
    case Function::sin:
    case Function::cos:
      break;
  }
  const bool is_sine = definition.function == Function::sin;
  const int sine = make(is_sine ? value_number : *definition.partner, SeriesNode::Kind::sine);
  const int cosine = make(is_sine ? *definition.partner : value_number, SeriesNode::Kind::cosine);
  nodes_[at(sine)].right = cosine;
  nodes_[at(cosine)].right = sine;
}

/// θ = atan2(y, x) from (x² + y²) θ' = x y' − y x', every derivative times t: of a series x_k that is k x_k.
void SeriesLowering::define_arctangent(ValueNumber value_number, std::optional<int> y, std::optional<int> x) {
  const auto value = [&](std::size_t i, std::optional<int> node) {
    Product product{unity(), {}};
    const Definition& constant = program_[program_[value_number].arguments[i]];
    const bool number = !constant.symbol && !constant.function && constant.polynomial.is_constant();
    if (node) {
      product.multiply(*node, 1);
    } else {
      product.coefficient = number ? constant.polynomial : Polynomial(program_[value_number].arguments[i]);
    }
    return product;
  };
  const auto times = [](Product a, const Product& b) {
    a.coefficient = product_of(a.coefficient, b.coefficient);
    for (const Power& power : b.powers) a.multiply(power.node, power.exponent);
    return a;
  };
  const Product along = value(1, x), up = value(0, y);
  std::vector<Product> rise, square;
  const auto add_change = [&](const Product& factor, std::optional<int> node, int sign) {
    if (!node) return;
    Product change{Polynomial(Number(sign)), {}};
    change.multiply(append({.kind = SeriesNode::Kind::weighted, .left = node}), 1);
    add(rise, times(change, factor));
  };
  add_change(along, y, 1);
  add_change(up, x, -1);
  add(square, times(along, along));
  add(square, times(up, up));
  std::erase_if(square, [](const Product& each) { return each.coefficient.is_zero(); });
  std::erase_if(rise, [](const Product& each) { return each.coefficient.is_zero(); });
  const SeriesForm numerator = lowered(std::move(rise));
  if (numerator.terms.empty()) {
    constant_[at(value_number)] = true;
    return;
  }
  const SeriesForm denominator = lowered(std::move(square));
  const int changing = exact(numerator);
  const int rate = quotient(changing, exact(denominator));
  const int angle = append({.kind = SeriesNode::Kind::integrated, .value_number = value_number, .left = rate});
  direct_[at(value_number)] = form_of_node(angle);
  expanded_[at(value_number)] = *direct_[at(value_number)];
}

/// The sum that gives a value number; from then on it stands behind a name if it is long.
const SeriesForm& SeriesLowering::form_of(ValueNumber value_number) {
  std::optional<SeriesForm>& form = direct_[at(value_number)];
  if (form) return *form;
  SeriesForm expanded;
  form = lowered(pieces_[at(value_number)], expanded);
  expanded_[at(value_number)] = is_short(expanded) ? expanded : *form;
  if (form->terms.empty()) constant_[at(value_number)] = true;  // what changes with time has cancelled
  if (is_single(*form) && form->terms[0].coefficient == unity()) {
    SeriesNode& node = nodes_[at(form->terms[0].node)];
    if (!node.value_number) node.value_number = value_number;
  }
  return *form;
}

/// A node with the form's very value.
int SeriesLowering::exact(const SeriesForm& form) {
  if (is_single(form) && form.terms[0].coefficient == unity()) return form.terms[0].node;
  const auto [begin, end] = sums_.equal_range(form.terms[0].node);
  for (auto each = begin; each != end; ++each) {
    if (nodes_[at(each->second)].form == form) return each->second;
  }
  const int first = form.terms[0].node;
  const int node = append({.kind = SeriesNode::Kind::sum, .form = form});
  sums_.emplace(first, node);
  return node;
}

/// A node of which the form is a multiple; sums are told apart up to their sign.
SeriesLowering::Scaled SeriesLowering::scaled(const SeriesForm& form) {
  if (is_single(form)) return {form.terms[0].coefficient, form.terms[0].node};
  if (form.terms[0].coefficient.sign() > 0) return {unity(), exact(form)};
  const Polynomial minus = Polynomial(Number(-1));
  SeriesForm negated;
  negated.add(form, minus);
  return {minus, exact(negated)};
}

int SeriesLowering::product(int left, int right) {
  const std::pair<int, int> key = std::minmax(left, right);
  const auto known = products_.find(key);
  if (known != products_.end()) return known->second;
  return products_[key] = append({.kind = SeriesNode::Kind::product, .left = key.first, .right = key.second});
}

int SeriesLowering::quotient(std::optional<int> dividend, int divisor) {
  const auto known = quotients_.find({dividend, divisor});
  if (known != quotients_.end()) return known->second;
  return quotients_[{dividend, divisor}] =
             append({.kind = SeriesNode::Kind::quotient, .left = dividend, .right = divisor});
}

/// Multiplies by node^exponent; a reciprocal counts as what it is.
void SeriesLowering::multiply_by_node(Product& result, int node, int exponent) const {
  const SeriesNode& origin = nodes_[at(node)];
  if (origin.kind == SeriesNode::Kind::quotient && !origin.left) {
    node = *origin.right;
    exponent = -exponent;
  }
  result.multiply(node, exponent);
}

void SeriesLowering::multiply(Product& result, ValueNumber value_number, int exponent) {
  const auto by_constant = [&](const Polynomial& known) {
    if (known.is_zero() && exponent < 0) throw Error("a Taylor series is divided by what vanishes identically");
    result.coefficient = known.is_zero() ? Polynomial() : product_of(result.coefficient, power(known, exponent));
  };
  if (!constant_[at(value_number)] && inlined_[at(value_number)] && pieces_[at(value_number)].size() == 1) {
    const Piece& piece = pieces_[at(value_number)][0];
    if (piece.product.coefficient.terms().size() == 1) {
      by_constant(piece.product.coefficient);
      for (const Power& each : piece.product.powers) multiply_by_node(result, each.node, each.exponent * exponent);
      if (piece.value_number) multiply(result, *piece.value_number, exponent);
      return;
    }
  }
  if (constant_[at(value_number)] && !direct_[at(value_number)]) return by_constant(Polynomial(value_number));
  const SeriesForm& form = form_of(value_number);
  if (form.terms.empty())
    return by_constant(form.constant.terms().size() > 1 ? Polynomial(value_number) : form.constant);
  const Scaled operand = scaled(form);
  by_constant(operand.coefficient);
  multiply_by_node(result, operand.node, exponent);
}

/// A sum that stands in a product and is multiplied in, unless too many products come of it.
bool SeriesLowering::is_multiplied_in(const Factor& factor, std::size_t times) const {
  const std::size_t count = pieces_[at(factor.value_number)].size();
  return factor.exponent == 1 && !constant_[at(factor.value_number)] && inlined_[at(factor.value_number)] &&
         count > 1 && count * times <= most_products;
}

std::vector<SeriesLowering::Product> SeriesLowering::multiplied(const Term& term, const Number& coefficient) {
  std::vector<Product> products = {{Polynomial(coefficient), {}}};
  for (const Factor& factor : term.monomial) {
    if (!is_multiplied_in(factor, products.size())) {
      for (Product& each : products) multiply(each, factor.value_number, factor.exponent);
      continue;
    }
    std::vector<Product> longer;
    for (const Product& each : products) {
      for (const Piece& piece : pieces_[at(factor.value_number)]) {
        Product product = each;
        product.coefficient = product_of(product.coefficient, piece.product.coefficient);
        for (const Power& power : piece.product.powers) multiply_by_node(product, power.node, power.exponent);
        if (piece.value_number) multiply(product, *piece.value_number, 1);
        longer.push_back(std::move(product));
      }
    }
    products = std::move(longer);
  }
  return products;
}

std::vector<SeriesLowering::Piece> SeriesLowering::pieces_of(const Polynomial& polynomial) {
  std::vector<Piece> pieces;
  for (const Term& term : polynomial.terms()) {
    std::optional<ValueNumber> alone;
    int degree = 0;
    for (const Factor& factor : term.monomial) {
      if (constant_[at(factor.value_number)]) continue;
      alone = factor.exponent == 1 ? std::optional(factor.value_number) : std::nullopt;
      ++degree;
    }
    if (degree != 1) alone.reset();
    Term rest = term;
    std::erase_if(rest.monomial, [alone](const Factor& factor) { return factor.value_number == alone; });
    for (Product& product : multiplied(rest, term.coefficient)) {
      if (product.coefficient.is_zero()) continue;
      if (!alone || !inlined_[at(*alone)]) {
        pieces.push_back({std::move(product), alone});
        continue;
      }
      for (Piece inner : pieces_[at(*alone)]) {
        inner.product.coefficient = product_of(inner.product.coefficient, product.coefficient);
        pieces.push_back(std::move(inner));
      }
    }
  }
  return pieces;
}

SeriesForm SeriesLowering::lowered(const std::vector<Piece>& pieces, SeriesForm& expanded) {
  SeriesForm direct;
  std::vector<Product> products;
  for (const Piece& piece : pieces) {
    if (!piece.value_number) {
      products.push_back(piece.product);
      continue;
    }
    const SeriesForm& form = form_of(*piece.value_number);
    expanded.add(expanded_[at(*piece.value_number)], piece.product.coefficient);
    if (form.terms.size() <= 1) {
      direct.add(form, piece.product.coefficient);
    } else {
      const Scaled sum = scaled(form);
      direct.add(sum.node, product_of(sum.coefficient, piece.product.coefficient));
    }
  }
  const SeriesForm nonlinear = lowered(std::move(products));
  direct.add(nonlinear, unity());
  expanded.add(nonlinear, unity());
  return expanded.terms.size() <= direct.terms.size() && is_short(expanded) ? expanded : direct;
}

/// The node of a product of two that has been made already: using it costs nothing.
std::optional<int> SeriesLowering::known_product(const std::vector<Power>& powers) const {
  const auto find = [](const auto& table, const auto& left, int right) -> std::optional<int> {
    const auto known = table.find({left, right});
    return known == table.end() ? std::nullopt : std::optional<int>(known->second);
  };
  if (powers.size() == 1 && powers[0].exponent == 2) return find(products_, powers[0].node, powers[0].node);
  if (powers.size() == 1 && powers[0].exponent == -1) return find(quotients_, std::nullopt, powers[0].node);
  if (powers.size() != 2 || std::abs(powers[0].exponent) != 1 || std::abs(powers[1].exponent) != 1) return std::nullopt;
  const auto& [a, b] = std::pair(powers[0], powers[1]);
  if (a.exponent > 0 && b.exponent > 0) return find(products_, a.node, b.node);
  if (a.exponent > 0) return find(quotients_, a.node, b.node);
  return b.exponent > 0 ? find(quotients_, b.node, a.node) : std::nullopt;
}

int SeriesLowering::value_of(const std::vector<Power>& powers) {
  std::optional<int> value;
  for (const Power& each : powers) {
    int base = each.node;
    for (int rest = each.exponent; rest > 0; rest /= 2) {
      if (rest % 2 == 1) value = value ? product(*value, base) : base;
      if (rest > 1) base = product(base, base);
    }
  }
  for (const Power& each : powers) {
    for (int rest = each.exponent; rest < 0; ++rest) value = quotient(value, each.node);
  }
  return *value;
}

/// Takes the factor that most products share out, again and again.
SeriesForm SeriesLowering::lowered(std::vector<Product> products) {
  unite_squares(products);
  unite_quotients(products);
  SeriesForm form;
  while (!products.empty()) {
    std::vector<Product> nonlinear;
    std::map<std::pair<int, bool>, int> uses;  // (node, whether it divides)
    for (Product& each : products) {
      if (each.powers.empty()) {
        form.constant += each.coefficient;
      } else if (each.powers.size() == 1 && each.powers[0].exponent == 1) {
        form.add(each.powers[0].node, each.coefficient);
      } else if (const std::optional<int> known = known_product(each.powers)) {
        form.add(*known, each.coefficient);
      } else {
        for (const Power& power : each.powers) ++uses[{power.node, power.exponent < 0}];
        nonlinear.push_back(std::move(each));
      }
    }
    products.clear();
    std::pair<int, bool> best;
    int most = 1;
    for (const auto& [factor, count] : uses) {
      if (count > most) best = factor, most = count;
    }
    if (most == 1) {
      for (const Product& each : nonlinear) form.add(value_of(each.powers), each.coefficient);
      break;
    }
    std::vector<Product> inside;
    for (Product& each : nonlinear) {
      const auto place = std::find_if(each.powers.begin(), each.powers.end(), [&](const Power& power) {
        return power.node == best.first && (power.exponent < 0) == best.second;
      });
      if (place == each.powers.end()) {
        products.push_back(std::move(each));
        continue;
      }
      place->exponent += best.second ? 1 : -1;
      if (place->exponent == 0) each.powers.erase(place);
      inside.push_back(std::move(each));
    }
    form.add(taken_out(best, std::move(inside)), unity());
  }
  return form;
}

SeriesForm SeriesLowering::taken_out(std::pair<int, bool> factor, std::vector<Product> inside) {
  const auto& [node, divides] = factor;
  const SeriesForm sum = lowered(std::move(inside));
  SeriesForm form;
  if (sum.terms.empty()) {
    if (!sum.constant.is_zero()) form.add(divides ? quotient(std::nullopt, node) : node, sum.constant);
    return form;
  }
  const Scaled other = scaled(sum);
  form.add(divides ? quotient(other.node, node) : product(other.node, node), other.coefficient);
  return form;
}

std::pair<std::vector<SeriesNode>, std::vector<SeriesForm>> SeriesLowering::take() {
  std::vector<bool> live(nodes_.size(), false);
  const auto mark = [&live](const SeriesForm& form) {
    for (const SeriesForm::Term& term : form.terms) live[at(term.node)] = true;
  };
  for (const SeriesForm& output : outputs_) mark(output);
  // A slope stands behind what it is one of, and so behind no user of that.
  std::vector<std::optional<int>> slope_of(nodes_.size());
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    if (has_slope(nodes_[k])) slope_of[at(*nodes_[k].right)] = static_cast<int>(k);
  }
  for (std::size_t k = nodes_.size(); k-- > 0;) {
    const SeriesNode& node = nodes_[k];
    if (slope_of[k] && live[at(*slope_of[k])]) live[k] = true;
    if (!live[k]) continue;
    mark(node.form);
    if (node.left) live[at(*node.left)] = true;
    if (node.right) live[at(*node.right)] = true;
  }
  std::vector<int> place(nodes_.size());
  std::vector<SeriesNode> kept;
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    if (!live[k]) continue;
    place[k] = static_cast<int>(kept.size());
    kept.push_back(std::move(nodes_[k]));
  }
  const auto move = [&place](SeriesForm& form) {
    for (SeriesForm::Term& term : form.terms) term.node = place[at(term.node)];
  };
  for (SeriesNode& node : kept) {
    if (node.left) node.left = place[at(*node.left)];
    if (node.right) node.right = place[at(*node.right)];
    move(node.form);
  }
  for (SeriesForm& output : outputs_) move(output);
  return {std::move(kept), std::move(outputs_)};
}

}  // namespace torsor
