// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "generator/emission/cpp_emitter.hpp"
#include "generator/emission/cpp_names.hpp"

namespace torsor {

/// The text of a kernel of Taylor coefficients; see write_series.
class SeriesText {
  using Kind = SeriesNode::Kind;

 public:
  SeriesText(FunctionEmitter& emitter, const Program& program, const SeriesResult& series, const Block& block)
      : emitter_(emitter), program_(program), series_(series), nodes_(series.program.nodes()) {
    begin_.resize(nodes_.size());
    inverse_.resize(nodes_.size());
    weighted_.resize(nodes_.size(), false);
    known_.resize(program.size(), false);
    if (series.solve) {
      // Not all of the block: what it holds for the sake of coefficients depends on which of them are read.
      for (const Atom atom : program.live(series.solve->at_start(series.program))) {
        known_[static_cast<std::size_t>(atom)] = true;
      }
    } else {
      for (const auto* list : {&block.symbols, &block.given, &block.definitions}) {
        for (const Atom atom : *list) known_[static_cast<std::size_t>(atom)] = true;
      }
    }
    if (series_.solve) {
      marked_ = series_.program.depending_on(series_.solve->unknowns);
    } else {
      marked_.assign(nodes_.size(), false);
    }
    without_.resize(nodes_.size());
    partial_.resize(nodes_.size());
    for (const SeriesNode& each : nodes_) depth_.push_back(depth_of(each));
    lanes_.resize(nodes_.size(), -1);
    for (std::size_t id = 0; id < nodes_.size(); ++id) {
      if (is_nonlinear(nodes_[id])) lanes_[id] = lane_count_++;
    }
  }

  /// The coefficients that the text reads, in this order and repeated.
  const std::vector<Polynomial>& read() const { return read_; }

  void write() {
    std::vector<std::string> steps;
    for (std::size_t id = 0; id < nodes_.size(); ++id) {
      if (!marked_[id]) write_order(static_cast<int>(id), steps);
    }
    if (series_.solve) write_solve(steps);
    const std::vector<SeriesForm>& outputs = series_.program.outputs();
    const std::size_t given = outputs.size() - unknown_count();
    for (std::size_t i = 0; i < unknown_count(); ++i) {
      steps.push_back(fmt::format("coefficients[k_ + 1][{}] = next_ * {};", given + i, rate(i)));
    }
    for (std::size_t i = 0; i < given; ++i) {
      const std::string sum = text_of(outputs[i], false);
      const bool zero = outputs[i].terms.empty();
      const bool several = outputs[i].terms.size() > 1;
      steps.push_back(fmt::format("coefficients[k_ + 1][{}] = {};", i,
                                  zero      ? sum
                                  : several ? "next_ * (" + sum + ")"
                                            : "next_ * " + sum));
    }
    std::vector<std::string> first;
    for (std::size_t i = 0; i < outputs.size(); ++i) {
      first.push_back(fmt::format("coefficients[0][{}] = {};", i, symbol_access(*series_.state[i], "")));
    }
    for (std::size_t i = 0; i < given; ++i) {
      first.push_back(fmt::format("coefficients[1][{}] = {};", i, text_of(outputs[i], true)));
    }
    for (std::size_t i = 0; i < unknown_count(); ++i) {
      first.push_back(
          fmt::format("coefficients[1][{}] = {};", given + i, emitter_.text(series_.solve->start[i].polynomial())));
    }
    for (const std::string& text : first) emitter_.line(text);
    const std::string one = emitter_.name(Number(1));
    if (lane_count_ > 0) {
      const std::string type = fmt::format("torsor::Convolutions<Scalar, {}>", lane_count_);
      emitter_.line(type + " operations_;");
      emitter_.line(fmt::format("typename {}::Sums sums_;", type));
    }
    emitter_.line(fmt::format("Scalar number_ = {0}, inverse_ = {0};", one));
    emitter_.line("for (int k_ = 1; k_ < order; ++k_) {");
    emitter_.line(fmt::format("  const Scalar following_ = number_ + {0}, next_ = {0} / following_;", one));
    if (lane_count_ > 0) emitter_.line("  operations_.sum(k_, sums_);");
    for (const std::string& text : steps) emitter_.line("  " + text);
    if (lane_count_ > 0) {
      std::string left, right;
      for (std::size_t id = 0; id < nodes_.size(); ++id) {
        if (lanes_[id] < 0) continue;
        const auto [a, b] = operands(static_cast<int>(id));
        left += (left.empty() ? "" : ", ") + a;
        right += (right.empty() ? "" : ", ") + b;
      }
      emitter_.line("  const Scalar left_[] = {" + left + "};");
      emitter_.line("  const Scalar right_[] = {" + right + "};");
      emitter_.line("  operations_.keep(k_, left_, right_);");
    }
    emitter_.line("  number_ = following_;");
    emitter_.line("  inverse_ = next_;");
    emitter_.line("}");
    emitter_.line("static_cast<void>(inverse_);");
    for (std::size_t i = 0; i < outputs.size(); ++i) {
      if (i >= given || !outputs[i].terms.empty()) emitter_.check_finite(fmt::format("coefficients[order][{}]", i));
    }
  }

 private:
  /// How many operations of one order follow one another up to this one.
  int depth_of(const SeriesNode& each) const {
    int depth = -1;
    const auto wait_for = [&](int operand) {
      if (operand >= 0) depth = std::max(depth, depth_[static_cast<std::size_t>(operand)]);
    };
    for (const SeriesForm::Term& term : each.form.terms) wait_for(term.node);
    wait_for(each.left);
    const bool paired = each.kind == Kind::sine || each.kind == Kind::cosine;
    if (!paired) wait_for(each.right);
    return depth + (each.kind == Kind::quotient ? 2 : 1);
  }
  bool is_deeper(int a, int b) const {
    return depth_[static_cast<std::size_t>(a)] > depth_[static_cast<std::size_t>(b)];
  }

  const SeriesNode& node(int id) const { return nodes_[static_cast<std::size_t>(id)]; }
  bool marked(int id) const { return id >= 0 && marked_[static_cast<std::size_t>(id)]; }
  std::string x(int id) const { return is_unknown(id) ? rate(unknown_of(id)) : fmt::format("x{}", id); }

  std::size_t unknown_count() const { return series_.solve ? series_.solve->unknowns.size() : 0; }
  static std::string rate(std::size_t unknown) { return fmt::format("a{}", unknown); }
  bool is_unknown(int id) const { return marked(id) && node(id).kind == Kind::symbol; }
  std::size_t unknown_of(int id) const {
    const std::vector<SymbolPointer>& all = series_.solve->unknowns;
    return static_cast<std::size_t>(std::find(all.begin(), all.end(), program_[node(id).atom].symbol) - all.begin());
  }
  std::string sum_of(int id) const { return fmt::format("sums_[{}]", lanes_[static_cast<std::size_t>(id)]); }

  /// The factor without its sign, empty for one.
  std::string factor(const Polynomial& coefficient, bool& negative) {
    read_.push_back(coefficient);
    auto [positive, minus] = without_sign(coefficient);
    negative = minus;
    if (positive.is_constant()) return positive.constant().is_one() ? "" : emitter_.name(positive.constant());
    if (positive.is_single_atom()) return local_name(program_, positive.terms()[0].monomial[0].atom);
    const auto [place, added] = factors_.add(positive);
    const std::string name = fmt::format("f{}", place);
    if (added) emitter_.line(fmt::format("const Scalar {} = {};", name, emitter_.text(positive)));
    return name;
  }

  std::string text_of(const SeriesForm& form, bool at_begin) {
    std::string text;
    if (at_begin && !form.constant.is_zero()) {
      bool negative = false;
      const std::string size = factor(form.constant, negative);
      text = (negative ? "-" : "") + (size.empty() ? emitter_.name(Number(1)) : size);
    }
    const auto name = [&](int id) { return at_begin ? begin(id) : x(id); };
    text = with_terms(
        text, form, [](int) { return true; }, name);
    return text.empty() ? emitter_.name(Number(0)) : text;
  }

  /// What stands there and the terms of a sum that are asked for.
  template <class IsAsked, class Name>
  std::string with_terms(std::string text, const SeriesForm& form, const IsAsked& is_asked, const Name& name) {
    OperationCount operations;
    std::vector<SeriesForm::Term> terms = form.terms;  // what is known last is added last
    std::stable_sort(terms.begin(), terms.end(),
                     [this](const auto& a, const auto& b) { return is_deeper(b.node, a.node); });
    for (const SeriesForm::Term& term : terms) {
      if (!is_asked(term.node)) continue;
      bool negative = false;
      const std::string size = factor(term.coefficient, negative);
      const std::string value = name(term.node);
      if (!text.empty()) operations.additions += 1;
      text += text.empty() ? (negative ? "-" : "") : (negative ? " - " : " + ");
      if (!size.empty()) {
        text += size + " * ";
        operations.multiplications += 1;
      }
      text += value;
    }
    emitter_.add_operations(operations);
    return text;
  }

  /// Name of a node's value at the start; what is not known yet is written.
  std::string begin(int id) {
    std::string& name = begin_[static_cast<std::size_t>(id)];
    if (!name.empty()) return name;
    const SeriesNode& each = node(id);
    if (each.atom >= 0 && known_[static_cast<std::size_t>(each.atom)]) {
      return name = local_name(program_, each.atom);
    }
    std::string text;
    switch (each.kind) {
      case Kind::symbol:
        text = is_unknown(id) ? emitter_.text(series_.solve->start[unknown_of(id)].polynomial())
                              : symbol_access(*program_[each.atom].symbol, "");
        break;
      case Kind::sum:
        text = text_of(each.form, true);
        break;
      case Kind::product:
        begin(each.left);  // in this order: compilers evaluate arguments in different ones
        begin(each.right);
        text = product_text(begin(each.left), begin(each.right));
        break;
      case Kind::quotient:
        if (each.left >= 0) begin(each.left);
        begin(each.right);
        if (each.left < 0) {
          text = inverse(id);
        } else {
          text = begin(each.left) + " / " + begin(each.right);
          emitter_.add_operations({.divisions = 1});
        }
        break;
      case Kind::weighted:
        text = emitter_.name(Number(0));
        break;
      default:
        break;
    }
    const std::string made = fmt::format("b{}", id);
    emitter_.line(fmt::format("const Scalar {} = {};", made, text));
    return begin_[static_cast<std::size_t>(id)] = made;
  }

  std::string product_text(const std::string& a, const std::string& b) {
    emitter_.add_operations({.multiplications = 1});
    return a + " * " + b;
  }

  /// What a quotient, a square root or a logarithm is multiplied by at each order, written when it is first asked for.
  std::string inverse(int id) {
    std::string& name = inverse_[static_cast<std::size_t>(id)];
    if (!name.empty()) return name;
    const SeriesNode& each = node(id);
    const std::string one = emitter_.name(Number(1));
    const int divisor = each.kind == Kind::quotient ? each.right : each.kind == Kind::logarithm ? each.left : id;
    const std::string value = begin(divisor);
    const std::string text = each.kind == Kind::square_root ? fmt::format("({0} + {0})", value) : value;
    emitter_.add_operations({.divisions = 1});
    const std::string made = fmt::format("i{}", id);
    emitter_.line(fmt::format("const Scalar {} = {} / {};", made, one, text));
    return inverse_[static_cast<std::size_t>(id)] = made;
  }

  /// k times the coefficient of order k.
  std::string weighted(int id, std::vector<std::string>& steps) {
    const std::string name = fmt::format("w{}", id);
    if (!weighted_[static_cast<std::size_t>(id)]) {
      weighted_[static_cast<std::size_t>(id)] = true;
      steps.push_back(fmt::format("const Scalar {} = number_ * {};", name, x(id)));
      emitter_.add_operations({.multiplications = 1});
    }
    return name;
  }

  /// The coefficient of order k of a node.
  void write_order(int id, std::vector<std::string>& steps) {
    const SeriesNode& each = node(id);
    std::string text;
    OperationCount operations;
    switch (each.kind) {
      case Kind::symbol: {
        const SymbolPointer& symbol = program_[each.atom].symbol;
        const auto place = std::find(series_.state.begin(), series_.state.end(), symbol);
        if (place == series_.state.end()) {                  // time
          const std::string one = emitter_.name(Number(1));  // named in this order under every compiler
          const std::string zero = emitter_.name(Number(0));
          text = fmt::format("k_ == 1 ? {} : {}", one, zero);
        } else {
          text = fmt::format("coefficients[k_][{}]", place - series_.state.begin());
        }
        break;
      }
      case Kind::sum:
        text = text_of(each.form, false);
        break;
      case Kind::weighted:
        text = "number_ * " + x(each.left);
        operations = {.multiplications = 1};
        break;
      case Kind::integrated:
        text = "inverse_ * " + x(each.left);
        operations = {.multiplications = 1};
        break;
      case Kind::selection:
        text = selection_text(each);
        operations = {.others = 1};
        break;
      case Kind::product:
        if (each.left == each.right) {
          text = fmt::format("{0} + ({1} + {1}) * {2}", sum_of(id), begin(each.left), x(each.left));
          operations = {.additions = 2, .multiplications = 1};
        } else {
          const bool left_first = is_deeper(each.right, each.left);
          const auto [soon, late] = left_first ? std::pair(each.left, each.right) : std::pair(each.right, each.left);
          const std::string a = begin(late);
          const std::string b = begin(soon);
          text = fmt::format("{} + {} * {} + {} * {}", sum_of(id), a, x(soon), b, x(late));
          operations = {.additions = 2, .multiplications = 2};
        }
        break;
      case Kind::quotient: {
        const std::string q = begin(id);
        const std::string factor = inverse(id);
        if (each.left < 0) {
          text = fmt::format("({} + {} * {}) * -{}", sum_of(id), q, x(each.right), factor);
          operations = {.additions = 1, .multiplications = 2};
        } else {
          text = is_deeper(each.left, each.right)
                     ? fmt::format("({} - ({} + {} * {})) * {}", x(each.left), sum_of(id), q, x(each.right), factor)
                     : fmt::format("({} - {} - {} * {}) * {}", x(each.left), sum_of(id), q, x(each.right), factor);
          operations = {.additions = 2, .multiplications = 2};
        }
        break;
      }
      case Kind::square_root:
        text = fmt::format("({} - {}) * {}", x(each.left), sum_of(id), inverse(id));
        operations = {.additions = 1, .multiplications = 1};
        break;
      case Kind::sine:
        text = fmt::format("inverse_ * {} + {} * {}", sum_of(id), begin(each.right), x(each.left));
        operations = {.additions = 1, .multiplications = 2};
        break;
      case Kind::cosine:
        text = fmt::format("-inverse_ * {} - {} * {}", sum_of(id), begin(each.right), x(each.left));
        operations = {.additions = 1, .multiplications = 2};
        break;
      case Kind::exponential:
        text = fmt::format("inverse_ * {} + {} * {}", sum_of(id), begin(id), x(each.left));
        operations = {.additions = 1, .multiplications = 2};
        break;
      case Kind::logarithm:
        text = fmt::format("({} - inverse_ * {}) * {}", x(each.left), sum_of(id), inverse(id));
        operations = {.additions = 1, .multiplications = 2};
        break;
    }
    emitter_.add_operations(operations);
    const std::string meaning = each.atom >= 0 && each.kind != Kind::symbol ? program_[each.atom].name : "";
    steps.push_back(
        fmt::format("const Scalar {} = {};{}", x(id), text, meaning.empty() ? "" : "  // " + comment_text(meaning)));
    if (each.kind == Kind::sine || each.kind == Kind::exponential) weighted(each.left, steps);
    if (each.kind == Kind::logarithm) weighted(id, steps);
  }

  /// The coefficient of the form that a selection takes at the start.
  std::string selection_text(const SeriesNode& each) {
    const Definition& call = program_[each.atom];
    const auto argument = [&](std::size_t i) { return local_name(program_, call.arguments[i]); };
    const std::string zero = emitter_.name(Number(0));
    const auto form = [&](int operand) { return operand < 0 ? zero : x(operand); };
    const std::string taken = call.function == Function::maximum ? argument(0) + " >= " + argument(1)
                                                                 : argument(0) + " >= " + zero;
    const std::string second = call.function == Function::abs ? "-" + x(each.left) : form(each.right);
    return fmt::format("traits::select({}, {}, {})", taken, form(each.left), second);
  }

  /// What depends on the accelerations of order k: first without them, which gives the equations' left sides, then, the
  /// accelerations known, what convolutions of higher orders read.
  void write_solve(std::vector<std::string>& steps);

  /// Coefficient k of an operation, where the accelerations are taken as zero: of its operands that do not depend on
  /// them alone, and with the others.
  void write_partial(int id, std::vector<std::string>& steps);

  /// Lᵀ D L a_k = -(left sides without a_k).
  void write_accelerations(std::vector<std::string>& steps);

  /// The marked factor of a product and the other one.
  std::pair<int, int> factors_of(const SeriesNode& product) const {
    return marked(product.left) ? std::pair(product.left, product.right) : std::pair(product.right, product.left);
  }

  /// What an operation is without marked operands, and these added under the names given; empty if all is zero.
  template <class Name>
  std::string with_marked(int id, const Name& name) {
    const SeriesNode& each = node(id);
    const std::string& alone = without_[static_cast<std::size_t>(id)];
    if (each.kind == Kind::sum) {
      return with_terms(
          alone, each.form, [&](int operand) { return marked(operand) && !name(operand).empty(); }, name);
    }
    const bool product = each.kind == Kind::product;
    const auto [with, other] = product ? factors_of(each) : std::pair(each.left, -1);
    const std::string value = name(with);
    if (value.empty()) return alone;
    const std::string factor = product ? begin(other) : inverse(id);
    emitter_.add_operations({.additions = 1, .multiplications = 1});
    return fmt::format("{} + {} * {}", alone, factor, value);
  }

  /// The two series whose convolution an operation takes.
  std::pair<std::string, std::string> operands(int id) const {
    const SeriesNode& each = node(id);
    switch (each.kind) {
      case Kind::product:
        return {x(each.left), x(each.right)};
      case Kind::quotient:
        return {x(id), x(each.right)};
      case Kind::sine:
      case Kind::cosine:
        return {fmt::format("w{}", each.left), x(each.right)};
      case Kind::exponential:
        return {fmt::format("w{}", each.left), x(id)};
      case Kind::logarithm:
        return {fmt::format("w{}", id), x(each.left)};
      default:
        return {x(id), x(id)};
    }
  }

  FunctionEmitter& emitter_;
  const Program& program_;
  const SeriesResult& series_;
  const std::vector<SeriesNode>& nodes_;
  std::vector<bool> known_;           ///< by atom: computed by the block
  std::vector<std::string> begin_;    ///< by node: name of its value at the start
  std::vector<std::string> inverse_;  ///< by node
  std::vector<bool> weighted_;        ///< by node
  std::vector<int> depth_;            ///< by node
  std::vector<int> lanes_;            ///< by node: which convolution is its own
  std::vector<bool> marked_;          ///< by node: depends on the accelerations that are solved for
  std::vector<std::string> without_;  ///< by marked node: name of what does not come from marked operands
  std::vector<std::string> partial_;  ///< by marked node: name of its coefficient without the accelerations
  SumTable factors_;
  std::vector<Polynomial> read_;
  int lane_count_ = 0;
};

}  // namespace torsor
