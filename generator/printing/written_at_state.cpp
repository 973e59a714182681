// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/printing/written_at_state.hpp"

#include "torsor/generator/program/limits_at_roots.hpp"

namespace torsor::printing {

WrittenAtState::WrittenAtState(const Scene& scene, const Equations& equations, const InlineLimits& limits, const About& about)
    : program_(equations.program()),
      at_rest_(!about.empty()),
      at_(program_, [this](const SymbolPointer& symbol) { return value_of(symbol); }),
      view_(program_, limits, scene.content()) {
  for (const auto& [symbol, formula] : named_state(scene, about)) {
    state_.emplace_back(symbol, formula.is_zero() ? program_.number(Number(), symbol->unit) : program_.lower(formula));
  }
}

Sum WrittenAtState::operator()(const Value& value) {
  const Value at_state = too_long_ ? Value() : there(value);
  if (at_state.is_zero()) return {};
  const std::optional<Sum> sum = view_.sum(at_state);
  too_long_ = !sum;
  return sum ? *sum : Sum();
}

std::vector<Sum> WrittenAtState::operator()(const std::vector<Value>& values) {
  std::vector<Sum> sums;
  for (const Value& value : values) sums.push_back((*this)(value));
  return sums;
}

SumMatrix WrittenAtState::operator()(const ValueMatrix& matrix) {
  SumMatrix sums;
  for (const std::vector<Value>& row : matrix) sums.push_back((*this)(row));
  return sums;
}

Value WrittenAtState::there(const Value& value) {
  return value.is_zero() ? Value() : at_(at_rest_ ? with_limits_at_roots(program_, {value})[0] : value);
}

std::optional<Value> WrittenAtState::value_of(const SymbolPointer& symbol) const {
  for (const auto& [known, value] : state_) {
    if (known == symbol) return value;
  }
  const bool zero = symbol->kind == SymbolKind::acceleration || (at_rest_ && symbol->kind == SymbolKind::velocity);
  return zero ? std::optional<Value>(program_.number(Number(), symbol->unit)) : std::nullopt;
}

std::vector<Value> without_inputs(const Equations& equations, std::vector<Value> F, const ValueMatrix& E) {
  const std::vector<SymbolPointer> inputs = equations.model().inputs();
  for (std::size_t i = 0; i < F.size(); ++i) {
    for (std::size_t k = 0; k < inputs.size(); ++k) {
      if (!E[i][k].is_zero()) F[i] -= E[i][k] * equations.program().symbol(inputs[k]);
    }
  }
  return F;
}

}  // namespace torsor::printing
