// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "torsor/generator/base/unit.hpp"
#include "torsor/generator/expression/expression.hpp"
#include "torsor/generator/expression/symbol.hpp"
#include "torsor/generator/program/passes.hpp"
#include "torsor/generator/program/polynomial.hpp"

namespace torsor {

class Program;

/// When the value of a definition is known; a kernel computes each at the earliest stage it can.
enum class Stage { generation, parameters, configuration, state, call };

/// A quantity inside a program: a flat sum of monomials in the program's value numbers, with its unit.
///
/// `+ - * /` are exact and stay flat: a sum is bound to a definition before it enters a product or a function. Adding
/// different units throws UnitError. Zero fits any unit.
class Value {
 public:
  Value() = default;  ///< zero, tied to no program
  Value(Program& program, Polynomial polynomial, Unit unit);

  bool is_zero() const { return polynomial_.is_zero(); }
  bool is_constant() const { return polynomial_.is_constant(); }
  bool is_number(int value) const { return is_constant() && polynomial_.constant() == Number(value); }
  const Polynomial& polynomial() const { return polynomial_; }
  const Unit& unit() const { return unit_; }
  Program* program() const { return program_; }
  std::optional<ValueNumber> value_number() const;  ///< the value number when the value is exactly one

  Value& operator+=(const Value& other);
  Value& operator-=(const Value& other);
  friend Value operator+(Value a, const Value& b) { return a += b; }
  friend Value operator-(Value a, const Value& b) { return a -= b; }
  friend Value operator-(Value a);
  friend Value operator*(const Value& a, const Value& b);
  friend Value operator*(const Number& a, Value b);
  friend Value operator/(const Value& a, const Value& b) { return a * pow(b, -1); }
  friend Value pow(const Value& base, int exponent);

 private:
  Program* program_ = nullptr;
  Polynomial polynomial_;
  Unit unit_;
};

/// One entry of a program: a symbol of the scene, a flat sum, or a function of earlier value numbers.
struct Definition {
  SymbolPointer symbol;              ///< set for symbols
  Polynomial polynomial;             ///< set for sums
  std::optional<Function> function;  ///< set for functions, with
  std::vector<ValueNumber> arguments;       ///< the value numbers it is applied to
  std::optional<ValueNumber> partner;       ///< cosine of the same argument for a sine, and the other way round
  Unit unit;
  Stage stage = Stage::generation;
  std::string name;                  ///< what it means, for the reader of the emitted text; may be empty
};

/// The straight-line program under everything: an ordered list of definitions z_k = flat sum or function of earlier
/// value numbers, hash-consed up to sign but for what is bound apart. Everything that is derived appends to it; nothing walks an
/// expanded tree.
///
/// Determinism: value numbers are numbered in order of creation and every order used anywhere is that order. Hash tables are
/// looked up, never iterated.
class Program {
 public:
  /// Replaces symbols when formulas are lowered: the value of a folded parameter, the law of a driven coordinate.
  /// Returns nothing for a symbol that stays.
  using Resolver = std::function<std::optional<Expression>(const SymbolPointer&)>;

  /// Who tells the values of what is measured on the motion of frames (Symbol::measure).
  struct Measurer {
    std::function<Value(const Symbol&)> value;
    std::function<void(std::size_t size)> forget;  ///< what was made while the program was larger: it is truncated to this size
  };

  explicit Program(Resolver resolver = {}, const Passes& passes = {});
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  /// Without one, measured quantities are symbols like any other.
  void set_measurer(Measurer measurer) { measurer_ = std::move(measurer); }

  Value lower(const Expression& formula);
  Value symbol(const SymbolPointer& symbol);
  Value number(const Number& value, const Unit& unit = Unit());

  /// Gives a sum or product a definition of its own, so that users of the value see one symbol. Numbers and single
  /// symbols are returned as they are. The name tells a reader what it is.
  Value bind(const Value& value, const std::string& name = {}) { return bind(value, name, passes_.sharing); }
  /// The same, but with a definition after all there are even where the sum has one, and that nobody finds again.
  Value bind_apart(const Value& value, const std::string& name = {}) { return bind(value, name, false); }
  Value value_of_number(ValueNumber value_number);  ///< the value number as a value

  Value apply(Function function, const Value& argument) { return apply(function, std::vector<Value>{argument}); }
  Value apply(Function function, const std::vector<Value>& arguments);
  /// The value that a function is applied to there: a number where the value number only names one.
  Value argument(const Definition& call, std::size_t i);
  Value sin(const Value& angle) { return apply(Function::sin, angle); }
  Value cos(const Value& angle) { return apply(Function::cos, angle); }
  Value sqrt(const Value& x) { return apply(Function::sqrt, x); }
  /// a where c is not negative, else b; not a number where c is none.
  Value select(const Value& c, const Value& a, const Value& b) { return apply(Function::select, {c, a, b}); }

  const Passes& passes() const { return passes_; }
  std::size_t size() const { return definitions_.size(); }
  const Definition& operator[](ValueNumber value_number) const {
    return definitions_[static_cast<std::size_t>(value_number)];
  }
  std::optional<ValueNumber> find(const SymbolPointer& symbol) const;
  /// Forgets every definition but the first `size`, as if the others had never been asked for. Values that name one of
  /// those forgotten must not be used any more.
  void truncate(std::size_t size);

  /// Every value number the values depend on, directly or not, in creation order: the live part of the program.
  std::vector<ValueNumber> live(const std::vector<Value>& outputs) const;
  Stage stage(const Value& value) const;

  /// Uses sin² + cos² = 1 where both squares stand with one coefficient.
  void simplify(Polynomial& polynomial) const;

 private:
  ValueNumber append(Definition definition);
  Value bind(const Value& value, const std::string& name, bool shared);
  ValueNumber function_value_number(Function function, const std::vector<ValueNumber>& arguments, const Unit& unit);
  ValueNumber constant_value_number(const Value& number);
  ValueNumber argument_value_number(const Value& argument);
  Value apply_to_number(Function function, const Value& argument);
  std::optional<Value> known_choice(Function function, const std::vector<Value>& arguments);
  std::optional<Value> exact_angle(const Value& y, const Value& x);
  std::optional<Value> root_of_square(const Value& square);
  Value shifted_angle(Function function, const Value& angle);
  Stage stage_of(const Polynomial& polynomial) const;

  Resolver resolver_;
  Measurer measurer_;
  Passes passes_;
  std::vector<Definition> definitions_;
  std::unordered_map<const Symbol*, ValueNumber> symbols_;
  std::unordered_map<std::size_t, std::vector<ValueNumber>> sums_;  ///< by hash of the polynomial
  std::vector<std::vector<std::pair<Function, ValueNumber>>> functions_;  ///< by first argument
  struct Resolved {
    Value value;
    std::size_t size = 0;  ///< of the program when it had been lowered
  };
  std::unordered_map<const Symbol*, Resolved> resolved_;
};

/// What a reader calls a value number: the symbol's name, else the definition's name, else z<k>.
std::string label(const Program& program, ValueNumber value_number);
std::string to_string(const Value& value);

}  // namespace torsor
