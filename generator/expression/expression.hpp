// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "torsor/generator/base/unit.hpp"
#include "torsor/generator/expression/function.hpp"
#include "torsor/generator/expression/symbol.hpp"

namespace torsor {

class Number;

/// A formula as its author wrote it: an immutable tree over symbols and exact numbers, cheap to copy.
///
/// Dimensions are checked when a node is made, so that an error points at the line that is wrong: both sides of a sum
/// must have the same unit and the argument of a transcendental function must be dimensionless. Numbers are exact: a
/// `double` is read as its shortest round-trip decimal (0.1 is 1/10), text and raw literals (`9.81_r`) as they stand.
/// Nothing is simplified here; a `Program` does that when it lowers the tree.
class Expression {
 public:
  struct Node;

  Expression();                         ///< zero, which fits any unit
  Expression(int value);                // NOLINT(google-explicit-constructor): numbers are formulas
  Expression(double value);             // NOLINT(google-explicit-constructor)
  Expression(const Number& value);      // NOLINT(google-explicit-constructor)
  Expression(SymbolPointer symbol);     // NOLINT(google-explicit-constructor)

  /// An exact decimal or fraction with a unit, e.g. `quantity("9.81", "m/s^2")`.
  static Expression quantity(std::string_view decimal, std::string_view unit = "1");
  static Expression quantity(const Number& value, const Unit& unit);

  const Unit& unit() const;
  bool is_zero() const;              ///< the literal 0 (a formula that only evaluates to 0 is not recognised here)
  SymbolPointer as_symbol() const;   ///< the symbol when the formula is just one, else null
  std::string to_string() const;     ///< plain text for messages
  /// Whether the symbol stands in the formula, or in what a measured quantity of it is a function of.
  bool depends_on(const SymbolPointer& symbol) const;
  /// Every symbol that stands in the formula, each once, in order of appearance.
  std::vector<SymbolPointer> symbols() const;
  const Node& node() const { return *node_; }

  friend Expression operator+(const Expression& a, const Expression& b);
  friend Expression operator-(const Expression& a, const Expression& b);
  friend Expression operator*(const Expression& a, const Expression& b);
  friend Expression operator/(const Expression& a, const Expression& b);
  friend Expression operator-(const Expression& a);
  friend Expression pow(const Expression& base, int exponent);
  friend Expression call(Function function, const std::vector<Expression>& arguments);
  friend Expression rate(const Expression& formula);

 private:
  explicit Expression(std::shared_ptr<const Node> node);
  void collect(std::vector<SymbolPointer>& symbols) const;
  std::shared_ptr<const Node> node_;
};

Expression sin(const Expression& angle);
Expression cos(const Expression& angle);
Expression tan(const Expression& angle);
Expression exp(const Expression& x);
/// (1 - e)/(1 + e) with e = exp(-2 |x|) and the sign of x: for every x, without overflow, right to a rounding of 1.
Expression tanh(const Expression& x);
Expression log(const Expression& x);
Expression sqrt(const Expression& x);
/// |x|, of any unit; its derivative at 0 is taken as 0.
Expression abs(const Expression& x);
/// −1, 0 or 1, of an x of any unit; its derivative is 0.
Expression sign(const Expression& x);
/// The larger and the smaller of two quantities of one unit; where they are equal the derivative is a's.
Expression max(const Expression& a, const Expression& b);
Expression min(const Expression& a, const Expression& b);
/// The angle in (−π, π] from the x axis to (x, y), two quantities of one unit; 0 for (0, 0), where it has no derivative.
Expression atan2(const Expression& y, const Expression& x);

Expression apply(Function function, const Expression& argument);
Expression call(Function function, const std::vector<Expression>& arguments);

/// π as an exact constant: sine and cosine of multiples of π/12 stay exact.
Expression pi();

/// Time derivative of any formula of time, coordinates and velocities, e.g. `rate(x)` for the velocity of x.
Expression rate(const Expression& formula);

namespace literals {
/// Raw literal: `9.81_r` is exactly 981/100.
Expression operator""_r(const char* decimal);
}  // namespace literals

}  // namespace torsor
