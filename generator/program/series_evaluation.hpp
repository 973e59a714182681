// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "torsor/generator/program/evaluation.hpp"
#include "torsor/generator/program/series_program.hpp"

namespace torsor {

/// Taylor coefficients 0..order of y' = outputs, y being the symbols of `state`, through the state at which `here`
/// evaluates: the recurrences that are emitted, in `double` or `Real`. With unknowns, the rates of the last of the state,
/// as many of the last outputs are equations 0 = M a + ... in them, solved order by order.
template <class Scalar>
class SeriesEvaluation {
 public:
  SeriesEvaluation(const SeriesProgram& program, const std::vector<SymbolPointer>& state, Evaluator<Scalar>& here)
      : program_(program), state_(state), here_(here), series_(program.nodes().size()) {}

  /// The unknowns' values at the start, and M = Lᵀ D L as L below its diagonal and 1/D.
  void solve_for(const std::vector<SymbolPointer>& unknowns, const std::vector<Value>& start,
                 const std::vector<std::vector<Value>>& lower, const std::vector<Value>& inverse_pivots) {
    unknowns_ = unknowns;
    for (const Value& value : start) starts_.push_back(here_(value));
    for (const std::vector<Value>& row : lower) {
      lower_.emplace_back();
      for (const Value& value : row) lower_.back().push_back(here_(value));
    }
    for (const Value& value : inverse_pivots) inverse_pivots_.push_back(here_(value));
  }

  /// coefficients[k][i], k = 0..order.
  std::vector<std::vector<Scalar>> operator()(int order) {
    std::vector<std::vector<Scalar>> coefficients(1);
    for (const SymbolPointer& symbol : state_) coefficients[0].push_back(here_(program_.symbol(symbol)));
    for (int k = 0; k < order; ++k) {
      for (std::vector<Scalar>& series : series_) series.push_back(Scalar(0));
      rates_ = k == 0 ? starts_ : std::vector<Scalar>(unknowns_.size(), Scalar(0));
      compute(k, coefficients);
      if (k > 0 && !unknowns_.empty()) {
        rates_ = solved(k);
        compute(k, coefficients);
      }
      std::vector<Scalar> next;
      const std::size_t explicit_count = state_.size() - unknowns_.size();
      for (std::size_t i = 0; i < explicit_count; ++i) {
        next.push_back(value(program_.outputs()[i], k) / Scalar(k + 1));
      }
      for (const Scalar& rate : rates_) next.push_back(rate / Scalar(k + 1));
      coefficients.push_back(std::move(next));
    }
    return coefficients;
  }

 private:
  void compute(int k, const std::vector<std::vector<Scalar>>& coefficients) {
    for (std::size_t id = 0; id < series_.size(); ++id) {
      series_[id][static_cast<std::size_t>(k)] = coefficient(program_.nodes()[id], id, k, coefficients);
    }
  }

  /// -M⁻¹ times coefficient k of the equations' left sides.
  std::vector<Scalar> solved(int k) {
    const std::size_t n = unknowns_.size(), first = state_.size() - n;
    std::vector<Scalar> x;
    for (std::size_t i = 0; i < n; ++i) x.push_back(-value(program_.outputs()[first + i], k));
    for (std::size_t j = n; j-- > 0;) {
      for (std::size_t i = 0; i < j; ++i) x[i] = x[i] - lower_[j][i] * x[j];
    }
    for (std::size_t j = 0; j < n; ++j) {
      x[j] = x[j] * inverse_pivots_[j];
      for (std::size_t i = 0; i < j; ++i) x[j] = x[j] - lower_[j][i] * x[i];
    }
    return x;
  }

  Scalar value(const SeriesForm& form, int k) {
    Scalar sum = k == 0 ? here_(program_.value(form.constant)) : Scalar(0);
    for (const SeriesForm::Term& term : form.terms) {
      sum = sum + here_(program_.value(term.coefficient)) * at(term.node, k);
    }
    return sum;
  }

  const Scalar& at(int node, int k) const {
    return series_[static_cast<std::size_t>(node)][static_cast<std::size_t>(k)];
  }

  /// The terms a_i b_(k-i), i = 1..k-1; weighted by i for the derivative of a.
  Scalar inner(int a, int b, int k, bool weighted) const {
    Scalar sum = Scalar(0);
    for (int i = 1; i < k; ++i) {
      const Scalar product = at(a, i) * at(b, k - i);
      sum = sum + (weighted ? Scalar(i) * product : product);
    }
    return sum;
  }

  Scalar coefficient(const SeriesNode& node, std::size_t id, int k, const std::vector<std::vector<Scalar>>& y) {
    using Kind = SeriesNode::Kind;
    const int own = static_cast<int>(id);
    if (node.kind == Kind::symbol) {
      const auto unknown = std::find(unknowns_.begin(), unknowns_.end(), program_.symbol_of(node));
      if (unknown != unknowns_.end()) return rates_[static_cast<std::size_t>(unknown - unknowns_.begin())];
      const auto place = std::find(state_.begin(), state_.end(), program_.symbol_of(node));
      if (place != state_.end())
        return y[static_cast<std::size_t>(k)][static_cast<std::size_t>(place - state_.begin())];
      return k == 0 ? here_(program_.value(Polynomial(*node.value_number))) : Scalar(k == 1 ? 1 : 0);
    }
    if (node.kind == Kind::sum) return value(node.form, k);
    if (k == 0) {
      if (node.kind == Kind::weighted) return Scalar(0);
      if (node.kind == Kind::product) return at(*node.left, 0) * at(*node.right, 0);
      if (node.kind == Kind::quotient) return (node.left ? at(*node.left, 0) : Scalar(1)) / at(*node.right, 0);
      return here_(program_.value(Polynomial(*node.value_number)));
    }
    switch (node.kind) {
      case Kind::weighted:
        return Scalar(k) * at(*node.left, k);
      case Kind::integrated:
        return at(*node.left, k) / Scalar(k);
      case Kind::selection: {
        const Definition& call = program_.call_of(node);
        const auto argument = [&](std::size_t i) { return here_(program_.value(Polynomial(call.arguments[i]))); };
        const auto form = [&](std::optional<int> operand) { return operand ? at(*operand, k) : Scalar(0); };
        const Scalar first = form(node.left);
        if (call.function == Function::abs) return select(argument(0), first, -first);
        if (call.function == Function::select) return select(argument(0), first, form(node.right));
        return select(argument(0) - argument(1), first, form(node.right));
      }
      case Kind::product:
        return at(*node.left, 0) * at(*node.right, k) + at(*node.left, k) * at(*node.right, 0) +
               inner(*node.left, *node.right, k, false);
      case Kind::quotient: {
        const Scalar dividend = node.left ? at(*node.left, k) : Scalar(0);
        return (dividend - at(own, 0) * at(*node.right, k) - inner(own, *node.right, k, false)) / at(*node.right, 0);
      }
      case Kind::square_root:
        return (at(*node.left, k) - inner(own, own, k, false)) / (at(own, 0) + at(own, 0));
      case Kind::sine:
      case Kind::primitive:
        return at(*node.left, k) * at(*node.right, 0) + inner(*node.left, *node.right, k, true) / Scalar(k);
      case Kind::cosine:
        return -(at(*node.left, k) * at(*node.right, 0) + inner(*node.left, *node.right, k, true) / Scalar(k));
      case Kind::logarithm:
        return (at(*node.left, k) - inner(own, *node.left, k, true) / Scalar(k)) / at(*node.left, 0);
      case Kind::symbol:
      case Kind::sum:
        break;
    }
    return Scalar(0);
  }

  const SeriesProgram& program_;
  const std::vector<SymbolPointer>& state_;
  Evaluator<Scalar>& here_;
  std::vector<std::vector<Scalar>> series_;  ///< by node
  std::vector<SymbolPointer> unknowns_;
  std::vector<Scalar> starts_, rates_, inverse_pivots_;
  std::vector<std::vector<Scalar>> lower_;
};

}  // namespace torsor
