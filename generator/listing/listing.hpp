// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "torsor/generator/base/unit.hpp"
#include "torsor/generator/expression/symbol.hpp"
#include "torsor/generator/listing/generation_constant.hpp"
#include "torsor/generator/listing/target.hpp"
#include "torsor/generator/program/formula.hpp"

namespace torsor {

/// Where a number that a function names stands.
enum class Table {
  time,
  coordinate,
  velocity,
  acceleration,
  multiplier,
  input,
  parameter,    ///< arguments, by their place in the layout
  precomputed,  ///< members of Precomputed behind its parameters
  output,       ///< of the function itself, written before
  local,
  coefficient,  ///< of the order that a recurrence is at: of the state
  convolution,  ///< of that order, without the terms of order 0
  order         ///< OrderQuantity
};

/// What a recurrence knows of the order k that it is at.
enum class OrderQuantity : std::size_t {
  number,
  inverse,
  next,
  first
};  // k, 1/k, 1/(k + 1), and 1 where k = 1, else 0

/// The numbers that a header's functions may be given, in the order of their structures.
struct Layout {
  std::vector<SymbolPointer> coordinates, velocities, accelerations, multipliers, inputs, parameters;

  const std::vector<SymbolPointer>& of(Table table) const;
};

/// A number that a listing names.
struct Quantity {
  Table table = Table::local;
  std::size_t index = 0;  ///< in its table
  std::string name;       ///< of the local variable that holds it; empty for one that is read where it stands
};

/// Local quantities that a statement defines. Leaves of a listing's formulas are quantities by their number.
struct Assigned {
  ValueNumber quantity = 0;
  Formula right;
  std::string meaning{};
};

/// A constant that depends on numbers only, rounded once, with the formula for scalars that no literal is exact enough
/// for; of a sine or cosine the angle is its only child.
struct Literal {
  ValueNumber quantity = 0;
  Formula right;
  RoundedConstant rounded;
  std::string meaning{};
};

/// π, under a name.
struct Pi {
  ValueNumber quantity = 0;
};

/// Sines and cosines of several angles at once; one of an angle that nothing reads is none.
struct SineCosinePair {
  ValueNumber angle = 0;
  std::optional<ValueNumber> sine, cosine;
  std::string meaning{};
};
struct SinesAndCosines {
  std::vector<SineCosinePair> angles;
};

using Statement = std::variant<Assigned, Literal, Pi, SinesAndCosines>;

/// A formula, or minus it.
struct Signed {
  Formula formula;
  bool negative = false;
};

/// A result of the function. One that repeats another up to sign has the other as its formula.
struct Output {
  Target target;
  Signed value;
  bool checked = false;  ///< whether a status looks at it: it is no number, and repeats no other
  std::string meaning{};
  std::optional<Unit> unit{};  ///< none: always zero, or not said
};

/// A pivot, and what it is measured against.
struct Pivot {
  Signed pivot, diagonal;
};

/// Taylor coefficients of a motion, order after order: from those up to order k the rates of order k, which over k + 1
/// are the coefficients of order k + 1.
struct Recurrence {
  std::vector<Statement> steps;
  std::vector<std::pair<ValueNumber, ValueNumber>> convolutions;  ///< pairs of series, whose coefficients of order k are these
  std::vector<Formula> rates;                       ///< of each entry of the state
  std::vector<bool> constant;                       ///< which rates are constant
};

/// One function of a generated text: what it reads, computes and writes, in order. It is data: nothing in it is text of
/// some language, and nothing refers to the program that it came from.
struct Listing {
  std::vector<Quantity> quantities;
  std::vector<ValueNumber> given;  ///< read from arguments before anything is computed
  std::vector<Statement> statements;
  std::vector<Output> outputs;
  std::optional<Recurrence> recurrence;
  std::vector<Statement> of_pivots;  ///< computed after the outputs, for pivots
  std::vector<Pivot> pivots;         ///< but for those that are regular whatever the state
  bool has_status = false;

  bool reads(Table table) const;  ///< any quantity of that table
  const Quantity& quantity(ValueNumber number) const { return quantities[static_cast<std::size_t>(number)]; }
};

/// By quantity: whether anything reads it that is needed itself; formulas of literals do if these are computed.
std::vector<bool> read_quantities(const Listing& listing, bool literals_are_computed);
/// Whether a statement is needed, quantities being read or not.
bool is_needed(const Statement& statement, const std::vector<bool>& read);

/// Operations that it states; a status costs nothing.
OperationCount count(const Listing& listing);
/// The work of one order.
OperationCount count(const Recurrence& recurrence);

}  // namespace torsor
