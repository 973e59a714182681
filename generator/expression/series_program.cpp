// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/expression/series_program.hpp"

#include <algorithm>

namespace torsor {
namespace {

/// Sums of more terms, or with coefficients of more terms, stay behind a name.
constexpr std::size_t longest_sum = 8;
constexpr std::size_t longest_coefficient = 4;

Polynomial one() { return Polynomial(Number(1)); }

Polynomial multiplied(const Polynomial& a, const Polynomial& b) {
  Polynomial result;
  for (const Term& left : a.terms()) {
    for (const Term& right : b.terms()) {
      result.add({left.monomial * right.monomial, left.coefficient * right.coefficient});
    }
  }
  return result;
}

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

bool is_function(SeriesNode::Kind kind) { return kind >= SeriesNode::Kind::square_root; }

}  // namespace

bool is_nonlinear(const SeriesNode& node) {
  return node.kind != SeriesNode::Kind::symbol && node.kind != SeriesNode::Kind::sum;
}

void SeriesForm::add(int node, const Polynomial& coefficient) {
  const auto place =
      std::lower_bound(terms.begin(), terms.end(), node, [](const Term& term, int n) { return term.node < n; });
  if (place == terms.end() || place->node != node) {
    if (!coefficient.is_zero()) terms.insert(place, {node, coefficient});
    return;
  }
  place->coefficient += coefficient;
  if (place->coefficient.is_zero()) terms.erase(place);
}

void SeriesForm::add(const SeriesForm& other, const Polynomial& factor) {
  constant += multiplied(other.constant, factor);
  for (const Term& term : other.terms) add(term.node, multiplied(term.coefficient, factor));
}

SeriesProgram::SeriesProgram(Program& program, const std::vector<Value>& outputs)
    : program_(&program),
      constant_(program.size(), false),
      is_cancelled_(program.size(), false),
      direct_(program.size()),
      expanded_(program.size()) {
  for (const Atom atom : program.live(outputs)) define(atom);
  for (const Value& output : outputs) {
    SeriesForm expanded;
    outputs_.push_back(lowered(output.polynomial(), expanded));
  }
  keep_live();
}

int SeriesProgram::append(SeriesNode node) {
  nodes_.push_back(std::move(node));
  return static_cast<int>(nodes_.size()) - 1;
}

void SeriesProgram::define(Atom atom) {
  const auto index = static_cast<std::size_t>(atom);
  const Definition& definition = (*program_)[atom];
  const auto single = [](int node) {
    SeriesForm form;
    form.add(node, one());
    return form;
  };
  if (definition.symbol) {
    const SymbolKind kind = definition.symbol->kind;
    const bool moves = kind == SymbolKind::time || kind == SymbolKind::coordinate || kind == SymbolKind::velocity;
    constant_[index] = !moves;
    if (moves) direct_[index] = expanded_[index] = single(append({SeriesNode::Kind::symbol, atom, -1, -1, {}}));
    return;
  }
  if (definition.function) {
    constant_[index] = constant_[static_cast<std::size_t>(definition.argument)];
    if (!constant_[index] && direct_[index].terms.empty()) define_function(atom);
    return;
  }
  constant_[index] = true;
  for (const Term& term : definition.polynomial.terms()) {
    for (const Factor& factor : term.monomial) {
      if (!constant_[static_cast<std::size_t>(factor.atom)]) constant_[index] = false;
    }
  }
  if (constant_[index]) return;
  SeriesForm expanded;
  direct_[index] = lowered(definition.polynomial, expanded);
  expanded_[index] = is_short(expanded) ? expanded : direct_[index];
  const SeriesForm& form = direct_[index];
  constant_[index] = is_cancelled_[index] = form.terms.empty();  // what changes with time has cancelled
  if (is_single(form) && form.terms[0].coefficient == one()) {
    SeriesNode& node = nodes_[static_cast<std::size_t>(form.terms[0].node)];
    if (node.atom < 0) node.atom = atom;
  }
}

void SeriesProgram::define_function(Atom atom) {
  const Definition& definition = (*program_)[atom];
  const int argument = exact(direct_[static_cast<std::size_t>(definition.argument)]);
  const auto make = [&](Atom of, SeriesNode::Kind kind) {
    const int node = append({kind, of, argument, -1, {}});
    SeriesForm form;
    form.add(node, one());
    const auto index = static_cast<std::size_t>(of);
    direct_[index] = expanded_[index] = form;
    return node;
  };
  switch (*definition.function) {
    case Function::sqrt:
      make(atom, SeriesNode::Kind::square_root);
      return;
    case Function::exp:
      make(atom, SeriesNode::Kind::exponential);
      return;
    case Function::log:
      make(atom, SeriesNode::Kind::logarithm);
      return;
    case Function::sin:
    case Function::cos:
      break;
  }
  const bool is_sine = definition.function == Function::sin;
  const int sine = make(is_sine ? atom : definition.partner, SeriesNode::Kind::sine);
  const int cosine = make(is_sine ? definition.partner : atom, SeriesNode::Kind::cosine);
  nodes_[static_cast<std::size_t>(sine)].right = cosine;
  nodes_[static_cast<std::size_t>(cosine)].right = sine;
}

/// A node with the form's very value.
int SeriesProgram::exact(const SeriesForm& form) {
  if (is_single(form) && form.terms[0].coefficient == one()) return form.terms[0].node;
  const int first = form.terms[0].node;
  const auto [begin, end] = sums_.equal_range(first);
  for (auto each = begin; each != end; ++each) {
    if (nodes_[static_cast<std::size_t>(each->second)].form == form) return each->second;
  }
  const int node = append({SeriesNode::Kind::sum, -1, -1, -1, form});
  sums_.emplace(first, node);
  return node;
}

/// A node of which the form is a multiple; sums are told apart up to their sign.
SeriesProgram::Scaled SeriesProgram::scaled(const SeriesForm& form) {
  if (is_single(form)) return {form.terms[0].coefficient, form.terms[0].node};
  if (form.terms[0].coefficient.sign() > 0) return {one(), exact(form)};
  const Polynomial minus = Polynomial(Number(-1));
  SeriesForm negated;
  negated.add(form, minus);
  return {minus, exact(negated)};
}

int SeriesProgram::product(int left, int right) {
  const std::pair<int, int> key = std::minmax(left, right);
  const auto known = products_.find(key);
  if (known != products_.end()) return known->second;
  return products_[key] = append({SeriesNode::Kind::product, -1, key.first, key.second, {}});
}

int SeriesProgram::quotient(int dividend, int divisor) {
  const auto known = quotients_.find({dividend, divisor});
  if (known != quotients_.end()) return known->second;
  return quotients_[{dividend, divisor}] = append({SeriesNode::Kind::quotient, -1, dividend, divisor, {}});
}

/// Multiplies by atom^exponent; a multiple of a reciprocal counts as what it is.
void SeriesProgram::multiply(Product& result, Atom atom, int exponent) {
  const auto index = static_cast<std::size_t>(atom);
  if (constant_[index]) {
    const Polynomial& known = direct_[index].constant;
    const bool simple = known.terms().size() == 1 || (is_cancelled_[index] && known.is_zero());
    const Polynomial value = simple ? known : Polynomial(atom);
    result.coefficient = value.is_zero() ? value : multiplied(result.coefficient, power(value, exponent));
    return;
  }
  const Scaled operand = scaled(direct_[index]);
  result.coefficient = multiplied(result.coefficient, power(operand.coefficient, exponent));
  int node = operand.node;
  const SeriesNode& origin = nodes_[static_cast<std::size_t>(node)];
  if (origin.kind == SeriesNode::Kind::quotient && origin.left < 0) {
    node = origin.right;
    exponent = -exponent;
  }
  const auto place = std::lower_bound(result.powers.begin(), result.powers.end(), node,
                                      [](const Power& power, int n) { return power.node < n; });
  if (place == result.powers.end() || place->node != node) {
    result.powers.insert(place, {node, exponent});
  } else if ((place->exponent += exponent) == 0) {
    result.powers.erase(place);
  }
}

SeriesForm SeriesProgram::lowered(const Polynomial& polynomial, SeriesForm& expanded) {
  SeriesForm direct;
  std::vector<Product> products;
  for (const Term& term : polynomial.terms()) {
    Product result{Polynomial(Term{{}, term.coefficient}), {}};
    Atom linear = -1;
    int degree = 0;
    for (const Factor& factor : term.monomial) {
      if (constant_[static_cast<std::size_t>(factor.atom)]) continue;
      linear = factor.exponent == 1 ? factor.atom : -1;
      ++degree;
    }
    if (degree == 1 && linear >= 0) {
      for (const Factor& factor : term.monomial) {
        if (factor.atom != linear) multiply(result, factor.atom, factor.exponent);
      }
      const auto index = static_cast<std::size_t>(linear);
      expanded.add(expanded_[index], result.coefficient);
      if (direct_[index].terms.size() == 1) {
        direct.add(direct_[index], result.coefficient);
      } else {
        const Scaled sum = scaled(direct_[index]);
        direct.add(sum.node, multiplied(sum.coefficient, result.coefficient));
      }
      continue;
    }
    for (const Factor& factor : term.monomial) multiply(result, factor.atom, factor.exponent);
    if (!result.coefficient.is_zero()) products.push_back(std::move(result));
  }
  const SeriesForm nonlinear = lowered(std::move(products));
  direct.add(nonlinear, one());
  expanded.add(nonlinear, one());
  return expanded.terms.size() <= direct.terms.size() && is_short(expanded) ? expanded : direct;
}

/// The node of a product of two that has been made already: using it costs nothing.
std::optional<int> SeriesProgram::known_product(const std::vector<Power>& powers) const {
  const auto find = [](const auto& table, int left, int right) -> std::optional<int> {
    const auto known = table.find({left, right});
    return known == table.end() ? std::nullopt : std::optional<int>(known->second);
  };
  if (powers.size() == 1 && powers[0].exponent == 2) return find(products_, powers[0].node, powers[0].node);
  if (powers.size() == 1 && powers[0].exponent == -1) return find(quotients_, -1, powers[0].node);
  if (powers.size() != 2 || std::abs(powers[0].exponent) != 1 || std::abs(powers[1].exponent) != 1) return std::nullopt;
  const auto& [a, b] = std::pair(powers[0], powers[1]);
  if (a.exponent > 0 && b.exponent > 0) return find(products_, a.node, b.node);
  if (a.exponent > 0) return find(quotients_, a.node, b.node);
  return b.exponent > 0 ? find(quotients_, b.node, a.node) : std::nullopt;
}

int SeriesProgram::value_of(const std::vector<Power>& powers) {
  int value = -1;
  for (const Power& each : powers) {
    int base = each.node;
    for (int rest = each.exponent; rest > 0; rest /= 2) {
      if (rest % 2 == 1) value = value < 0 ? base : product(value, base);
      if (rest > 1) base = product(base, base);
    }
  }
  for (const Power& each : powers) {
    for (int rest = each.exponent; rest < 0; ++rest) value = quotient(value, each.node);
  }
  return value;
}

/// Takes the factor that most products share out, again and again.
SeriesForm SeriesProgram::lowered(std::vector<Product> products) {
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
    if (nonlinear.empty()) break;
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
    const SeriesForm sum = lowered(std::move(inside));
    const Scaled factor = sum.terms.empty() ? Scaled{sum.constant, -1} : scaled(sum);
    if (factor.node < 0) {
      form.add(best.second ? quotient(-1, best.first) : best.first, factor.coefficient);
    } else {
      form.add(best.second ? quotient(factor.node, best.first) : product(factor.node, best.first), factor.coefficient);
    }
  }
  return form;
}

std::vector<Polynomial> SeriesProgram::roots() const {
  std::vector<Polynomial> all;
  const auto read = [&all](const SeriesForm& form) {
    all.push_back(form.constant);
    for (const SeriesForm::Term& term : form.terms) all.push_back(term.coefficient);
  };
  for (const SeriesNode& node : nodes_) {
    if (is_function(node.kind)) all.emplace_back(node.atom);
    read(node.form);
  }
  for (const SeriesForm& output : outputs_) read(output);
  return all;
}

int SeriesProgram::nonlinear_count() const {
  return static_cast<int>(std::count_if(nodes_.begin(), nodes_.end(), is_nonlinear));
}

void SeriesProgram::keep_live() {
  std::vector<bool> live(nodes_.size(), false);
  const auto mark = [&live](const SeriesForm& form) {
    for (const SeriesForm::Term& term : form.terms) live[static_cast<std::size_t>(term.node)] = true;
  };
  for (const SeriesForm& output : outputs_) mark(output);
  for (std::size_t k = nodes_.size(); k-- > 0;) {
    const SeriesNode& node = nodes_[k];
    const bool paired = node.kind == SeriesNode::Kind::sine || node.kind == SeriesNode::Kind::cosine;
    if (paired && live[static_cast<std::size_t>(node.right)]) live[k] = true;
    if (!live[k]) continue;
    mark(node.form);
    if (node.left >= 0) live[static_cast<std::size_t>(node.left)] = true;
    if (node.right >= 0) live[static_cast<std::size_t>(node.right)] = true;
  }
  std::vector<int> place(nodes_.size(), -1);
  std::vector<SeriesNode> kept;
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    if (!live[k]) continue;
    place[k] = static_cast<int>(kept.size());
    kept.push_back(nodes_[k]);
  }
  const auto moved = [&place](int node) { return node < 0 ? node : place[static_cast<std::size_t>(node)]; };
  const auto move = [&moved](SeriesForm& form) {
    for (SeriesForm::Term& term : form.terms) term.node = moved(term.node);
  };
  for (SeriesNode& node : kept) {
    node.left = moved(node.left);
    node.right = moved(node.right);
    move(node.form);
  }
  for (SeriesForm& output : outputs_) move(output);
  nodes_ = std::move(kept);
}

}  // namespace torsor
