// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/emission/series_emitter.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "generator/emission/cpp_names.hpp"

namespace torsor {
namespace {

using Kind = SeriesNode::Kind;

class SeriesEmitter {
 public:
  SeriesEmitter(FunctionEmitter& emitter, const Program& program, const SeriesResult& series, const Block& block)
      : emitter_(emitter), program_(program), series_(series), nodes_(series.program.nodes()) {
    begin_.resize(nodes_.size());
    inverse_.resize(nodes_.size());
    weighted_.resize(nodes_.size(), false);
    known_.resize(program.size(), false);
    for (const auto* list : {&block.symbols, &block.given, &block.definitions}) {
      for (const Atom atom : *list) known_[static_cast<std::size_t>(atom)] = true;
    }
    for (const SeriesNode& each : nodes_) depth_.push_back(depth_of(each));
    lanes_.resize(nodes_.size(), -1);
    for (std::size_t id = 0; id < nodes_.size(); ++id) {
      if (is_nonlinear(nodes_[id])) lanes_[id] = lane_count_++;
    }
  }

  void write() {
    std::vector<std::string> steps;
    for (std::size_t id = 0; id < nodes_.size(); ++id) write_order(static_cast<int>(id), steps);
    const std::vector<SeriesForm>& outputs = series_.program.outputs();
    for (std::size_t i = 0; i < outputs.size(); ++i) {
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
    for (std::size_t i = 0; i < outputs.size(); ++i) {
      first.push_back(fmt::format("coefficients[1][{}] = {};", i, text_of(outputs[i], true)));
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
      if (!outputs[i].terms.empty()) emitter_.check_finite(fmt::format("coefficients[order][{}]", i));
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
  std::string x(int id) const { return fmt::format("x{}", id); }
  std::string sum_of(int id) const { return fmt::format("sums_[{}]", lanes_[static_cast<std::size_t>(id)]); }

  /// The factor without its sign, empty for one.
  std::string factor(const Polynomial& coefficient, bool& negative) {
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
    OperationCount operations;
    if (at_begin && !form.constant.is_zero()) {
      bool negative = false;
      const std::string size = factor(form.constant, negative);
      text = (negative ? "-" : "") + (size.empty() ? emitter_.name(Number(1)) : size);
    }
    std::vector<SeriesForm::Term> terms = form.terms;  // what is known last is added last
    std::stable_sort(terms.begin(), terms.end(),
                     [this](const auto& a, const auto& b) { return is_deeper(b.node, a.node); });
    for (const SeriesForm::Term& term : terms) {
      bool negative = false;
      const std::string size = factor(term.coefficient, negative);
      text += text.empty() ? (negative ? "-" : "") : (negative ? " - " : " + ");
      if (!size.empty()) {
        text += size + " * ";
        operations.multiplications += 1;
      }
      text += at_begin ? begin(term.node) : x(term.node);
    }
    if (text.empty()) return emitter_.name(Number(0));
    operations.additions += static_cast<int>(form.terms.size()) - (at_begin && !form.constant.is_zero() ? 0 : 1);
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
        text = symbol_access(*program_[each.atom].symbol, "");
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
        if (place == series_.state.end()) {  // time
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
  SumTable factors_;
  int lane_count_ = 0;
};

}  // namespace

void write_series(FunctionEmitter& emitter, const Program& program, const SeriesResult& series, const Block& block) {
  SeriesEmitter(emitter, program, series, block).write();
}

}  // namespace torsor
