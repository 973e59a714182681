// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "torsor/generator/printing/inline_view.hpp"
#include "torsor/generator/printing/linearised_equations.hpp"
#include "torsor/generator/program/derivative.hpp"

namespace torsor::printing {

/// Values where the state is, written out; remembers whether one was too long. What has a limit where a root vanishes has it.
class WrittenAtState {
 public:
  WrittenAtState(const Scene& scene, const Equations& equations, const InlineLimits& limits, const About& about);

  Sum operator()(const Value& value);
  std::vector<Sum> operator()(const std::vector<Value>& values);
  SumMatrix operator()(const ValueMatrix& matrix);

  Value there(const Value& value);
  bool too_long() const { return too_long_; }

 private:
  std::optional<Value> value_of(const SymbolPointer& symbol) const;

  Program& program_;
  bool at_rest_;
  std::vector<std::pair<SymbolPointer, Value>> state_;
  Substitution at_;
  InlineView view_;
  bool too_long_ = false;
};

/// Forces of a linearisation without the inputs, which those of the program have in them; E are the columns of these.
std::vector<Value> without_inputs(const Equations& equations, std::vector<Value> F, const ValueMatrix& E);

}  // namespace torsor::printing
