// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "torsor/generator/program/formula.hpp"

namespace torsor {

/// Formulas as lists of operations, for an evaluator that meets the same ones at many states: the operations of the
/// text, in its order.
class FormulaCode {
 public:
  /// What an operation takes: a value number, a constant by its place in `constants()`, or the result of an earlier
  /// operation by its register.
  struct Operand {
    enum class Kind : std::uint8_t { value_number, constant, result };
    Kind kind = Kind::constant;
    std::uint32_t index = 0;
  };
  struct Operation {
    enum class Kind : std::uint8_t { negate, add, subtract, multiply, divide, call };
    Kind kind = Kind::add;
    Function function{};       ///< of a call, whose arguments are the value numbers from needs()[left.index] on
    std::uint32_t result = 0;  ///< a register
    Operand left, right;       ///< of a call `right.index` is the number of arguments
  };
  /// One formula: what must be known before, then its operations.
  struct Part {
    std::uint32_t first_need = 0, last_need = 0, first = 0, last = 0;
    Operand result;
  };

  Part add(const Formula& formula);

  const std::vector<ValueNumber>& needs() const { return needs_; }
  const std::vector<Operation>& operations() const { return operations_; }
  const std::vector<Number>& constants() const { return constants_; }
  std::size_t registers() const { return registers_; }

 private:
  Operand operand(const Formula& formula, std::uint32_t depth);
  Operand emit(Operation::Kind kind, const Operand& left, const Operand& right, std::uint32_t depth);

  std::vector<ValueNumber> needs_;
  std::vector<Operation> operations_;
  std::vector<Number> constants_;
  std::unordered_map<Number, std::uint32_t> places_;  ///< of constants; looked up only
  std::size_t registers_ = 0;
};

}  // namespace torsor
