// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/program/formula_code.hpp"

#include <algorithm>

namespace torsor {

FormulaCode::Part FormulaCode::add(const Formula& formula) {
  Part part;
  part.first_need = static_cast<std::uint32_t>(needs_.size());
  part.first = static_cast<std::uint32_t>(operations_.size());
  part.result = operand(formula, 0);
  part.last_need = static_cast<std::uint32_t>(needs_.size());
  part.last = static_cast<std::uint32_t>(operations_.size());
  return part;
}

FormulaCode::Operand FormulaCode::operand(const Formula& formula, std::uint32_t depth) {
  using Kind = Operation::Kind;
  switch (formula.kind) {
    case Formula::Kind::constant: {
      const auto [place, added] = places_.emplace(formula.number, static_cast<std::uint32_t>(constants_.size()));
      if (added) constants_.push_back(formula.number);
      return {Operand::Kind::constant, place->second};
    }
    case Formula::Kind::value_number: {
      needs_.push_back(*formula.value_number);
      return {Operand::Kind::value_number, static_cast<std::uint32_t>(*formula.value_number)};
    }
    case Formula::Kind::function: {
      const auto first = static_cast<std::uint32_t>(needs_.size());
      for (const Formula& child : formula.children) needs_.push_back(*child.value_number);
      const Operand result = emit(Kind::call, {Operand::Kind::value_number, first},
                                  {Operand::Kind::value_number, static_cast<std::uint32_t>(formula.children.size())}, depth);
      operations_.back().function = formula.function;
      return result;
    }
    case Formula::Kind::quotient: {
      const Operand numerator = operand(formula.children[0], depth);
      return emit(Kind::divide, numerator, operand(formula.children[1], depth + 1), depth);
    }
    case Formula::Kind::sum:
    case Formula::Kind::product: break;
  }
  const bool sum = formula.kind == Formula::Kind::sum;
  Operand result = operand(formula.children[0], depth);
  if (sum && formula.negative[0]) result = emit(Kind::negate, result, result, depth);
  for (std::size_t i = 1; i < formula.children.size(); ++i) {
    const Operand next = operand(formula.children[i], depth + 1);
    result = emit(!sum ? Kind::multiply : formula.negative[i] ? Kind::subtract : Kind::add, result, next, depth);
  }
  return result;
}

FormulaCode::Operand FormulaCode::emit(Operation::Kind kind, const Operand& left, const Operand& right,
                                       std::uint32_t depth) {
  operations_.push_back({.kind = kind, .result = depth, .left = left, .right = right});
  registers_ = std::max<std::size_t>(registers_, depth + 1);
  return {Operand::Kind::result, depth};
}

}  // namespace torsor
