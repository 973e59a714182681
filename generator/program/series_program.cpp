// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/program/series_program.hpp"

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

#include "torsor/generator/program/series_lowering.hpp"

namespace torsor {
namespace {

/// Programs of more definitions are not searched for what is better multiplied in; and how often the others are.
constexpr std::size_t most_searched = 80, most_searched_by_threes = 60;
constexpr int most_rounds = 3;

/// What the program computes at the start.
bool is_function(SeriesNode::Kind kind) {
  return kind >= SeriesNode::Kind::square_root || kind == SeriesNode::Kind::integrated ||
         kind == SeriesNode::Kind::selection;
}

using Lowered = std::pair<std::vector<SeriesNode>, std::vector<SeriesForm>>;

/// Linear terms, and more so those with a factor.
double cost(const SeriesForm& form) {
  double sum = 0;
  for (const SeriesForm::Term& term : form.terms) {
    const Polynomial& factor = term.coefficient;
    const bool is_one = factor.is_constant() && (factor.constant().is_one() || (-factor.constant()).is_one());
    sum += is_one ? 0.01 : 0.013;
  }
  return sum;
}

/// Convolutions; a square has one operand to keep. Linear terms decide between equals.
double cost(const Lowered& lowered) {
  double sum = 0;
  for (const SeriesNode& node : lowered.first) {
    const bool square = node.kind == SeriesNode::Kind::product && node.left == node.right;
    if (is_nonlinear(node)) sum += square || node.kind == SeriesNode::Kind::square_root ? 0.95 : 1;
    sum += cost(node.form);
  }
  for (const SeriesForm& output : lowered.second) sum += cost(output);
  return sum;
}

class Search {
 public:
  Search(const Program& program, const std::vector<Value>& outputs)
      : program_(program), outputs_(outputs), live_(program.live(outputs)), inlined_(program.size(), false) {
    for (const ValueNumber value_number : live_) {
      if (is_candidate(value_number)) candidates_.push_back(value_number);
    }
    best_ = lowered();
    cost_ = cost(best_);
  }

  Lowered run() {
    try_those_used_once();
    if (candidates_.size() > most_searched) return std::move(best_);
    for (int round = 0; round < most_rounds; ++round) {
      const double before = cost_;
      for (const ValueNumber value_number : candidates_) try_toggled({value_number});
      const std::set<std::pair<ValueNumber, ValueNumber>> together = pairs();
      for (const auto& [a, b] : together) try_toggled({a, b});
      if (candidates_.size() <= most_searched_by_threes) {
        for (const auto& [a, b] : together) {
          for (const ValueNumber c : standing_in(a, b)) try_toggled({a, b, c});
        }
      }
      if (cost_ == before) break;
    }
    return std::move(best_);
  }

 private:
  Lowered lowered() const {
    SeriesLowering lowering(program_, live_, inlined_);
    for (const Value& output : outputs_) lowering.add_output(output.polynomial());
    return lowering.take();
  }

  void try_toggled(const std::vector<ValueNumber>& value_numbers) {
    const auto toggle = [&] {
      for (const ValueNumber value_number : value_numbers) inlined_[static_cast<std::size_t>(value_number)].flip();
    };
    toggle();
    Lowered candidate = lowered();
    const double its_cost = cost(candidate);
    if (its_cost < cost_ - 1e-6) {
      cost_ = its_cost;
      best_ = std::move(candidate);
    } else {
      toggle();
    }
  }

  /// Definitions that stand in one sum: multiplying in one of them may pay only with the other.
  std::set<std::pair<ValueNumber, ValueNumber>> pairs() const {
    std::set<std::pair<ValueNumber, ValueNumber>> found;
    const auto search = [&](const Polynomial& polynomial) {
      std::set<ValueNumber> together;
      for (const Term& term : polynomial.terms()) {
        for (const Factor& factor : term.monomial) together.insert(factor.value_number);
      }
      for (const ValueNumber a : together) {
        for (const ValueNumber b : together) {
          if (a < b && is_candidate(a) && is_candidate(b)) found.emplace(a, b);
        }
      }
    };
    for (const ValueNumber value_number : live_) search(program_[value_number].polynomial);
    for (const Value& output : outputs_) search(output.polynomial());
    return found;
  }

  /// Definitions that stand in one of these two.
  std::set<ValueNumber> standing_in(ValueNumber a, ValueNumber b) const {
    std::set<ValueNumber> found;
    for (const ValueNumber each : {a, b}) {
      for (const Term& term : program_[each].polynomial.terms()) {
        for (const Factor& factor : term.monomial) {
          if (is_candidate(factor.value_number) && factor.value_number != a && factor.value_number != b)
            found.insert(factor.value_number);
        }
      }
    }
    return found;
  }

  bool is_candidate(ValueNumber value_number) const {
    return !program_[value_number].symbol && !program_[value_number].function;
  }

  void try_those_used_once() {
    std::vector<int> uses(program_.size(), 0);
    const auto count = [&uses](const Polynomial& polynomial) {
      for (const Term& term : polynomial.terms()) {
        for (const Factor& factor : term.monomial) ++uses[static_cast<std::size_t>(factor.value_number)];
      }
    };
    for (const ValueNumber value_number : live_) {
      count(program_[value_number].polynomial);
      for (const ValueNumber argument : program_[value_number].arguments) ++uses[static_cast<std::size_t>(argument)];
    }
    for (const Value& output : outputs_) count(output.polynomial());
    std::vector<ValueNumber> once;
    for (const ValueNumber value_number : candidates_) {
      if (uses[static_cast<std::size_t>(value_number)] == 1) once.push_back(value_number);
    }
    try_toggled(once);
  }

  const Program& program_;
  const std::vector<Value>& outputs_;
  std::vector<ValueNumber> live_, candidates_;
  std::vector<bool> inlined_;
  Lowered best_;
  double cost_ = 0;
};

}  // namespace

bool is_nonlinear(const SeriesNode& node) {
  return node.kind >= SeriesNode::Kind::product;
}

bool has_slope(const SeriesNode& node) {
  using Kind = SeriesNode::Kind;
  return node.kind == Kind::sine || node.kind == Kind::cosine || node.kind == Kind::primitive;
}

Polynomial product_of(const Polynomial& a, const Polynomial& b) {
  Polynomial result;
  for (const Term& left : a.terms()) {
    for (const Term& right : b.terms()) {
      result.add({left.monomial * right.monomial, left.coefficient * right.coefficient});
    }
  }
  return result;
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
  constant += product_of(other.constant, factor);
  for (const Term& term : other.terms) add(term.node, product_of(term.coefficient, factor));
}

SeriesProgram::SeriesProgram(Program& program, const std::vector<Value>& outputs) : program_(&program) {
  std::tie(nodes_, outputs_) = Search(program, outputs).run();
}

std::vector<ValueNumber> SeriesProgram::known_at_start(const SeriesNode& node) const {
  if (!is_function(node.kind)) return {};
  std::vector<ValueNumber> value_numbers = {*node.value_number};
  if (node.kind == SeriesNode::Kind::selection) {
    const std::vector<ValueNumber>& arguments = call_of(node).arguments;
    // The forms of a piecewise function are series of their own.
    const bool condition_alone = call_of(node).function == Function::select;
    value_numbers.insert(value_numbers.end(), arguments.begin(),
                         condition_alone ? arguments.begin() + 1 : arguments.end());
  }
  return value_numbers;
}

std::vector<Polynomial> SeriesProgram::roots() const {
  std::vector<Polynomial> all;
  const auto read = [&all](const SeriesForm& form) {
    all.push_back(form.constant);
    for (const SeriesForm::Term& term : form.terms) all.push_back(term.coefficient);
  };
  for (const SeriesNode& node : nodes_) {
    for (const ValueNumber value_number : known_at_start(node)) all.emplace_back(value_number);
    read(node.form);
  }
  for (const SeriesForm& output : outputs_) read(output);
  return all;
}

int SeriesProgram::nonlinear_count() const {
  return static_cast<int>(std::count_if(nodes_.begin(), nodes_.end(), is_nonlinear));
}

std::vector<bool> SeriesProgram::depending_on(const std::vector<SymbolPointer>& symbols) const {
  std::vector<bool> marked(nodes_.size(), false);
  const auto is_marked = [&marked](std::optional<int> node) { return node && marked[static_cast<std::size_t>(*node)]; };
  for (std::size_t id = 0; id < nodes_.size(); ++id) {
    const SeriesNode& node = nodes_[id];
    if (node.kind == SeriesNode::Kind::symbol) {
      marked[id] = std::find(symbols.begin(), symbols.end(), symbol_of(node)) != symbols.end();
      continue;
    }
    marked[id] = is_marked(node.left) || is_marked(node.right) ||
                 std::any_of(node.form.terms.begin(), node.form.terms.end(),
                             [&](const SeriesForm::Term& term) { return is_marked(term.node); });
  }
  return marked;
}

bool SeriesProgram::linear_in(const std::vector<bool>& marked) const {
  for (std::size_t id = 0; id < nodes_.size(); ++id) {
    if (!marked[id]) continue;
    const SeriesNode& node = nodes_[id];
    const bool right = node.right && marked[static_cast<std::size_t>(*node.right)];
    if (is_function(node.kind) || node.kind == SeriesNode::Kind::weighted || (node.kind == SeriesNode::Kind::quotient && right)) return false;
    if (node.kind == SeriesNode::Kind::product && right && marked[static_cast<std::size_t>(*node.left)]) return false;
  }
  return true;
}

}  // namespace torsor
