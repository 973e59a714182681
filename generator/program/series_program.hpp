// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "torsor/generator/program/program.hpp"

namespace torsor {

/// constant + Σ coefficient · node: what costs no convolution. Constants and coefficients are sums in value numbers that do not
/// change with time.
struct SeriesForm {
  struct Term {
    int node = 0;
    Polynomial coefficient;
    friend bool operator==(const Term&, const Term&) = default;
  };
  Polynomial constant;
  std::vector<Term> terms;  ///< by node, each once, no coefficient zero

  void add(int node, const Polynomial& coefficient);
  void add(const SeriesForm& other, const Polynomial& factor);
  friend bool operator==(const SeriesForm&, const SeriesForm&) = default;
};

Polynomial product_of(const Polynomial& a, const Polynomial& b);

/// A quantity that changes with time, with the recurrence its Taylor coefficients follow.
struct SeriesNode {
  /// `weighted` is k x_k, the series of t dx/dt; `integrated` its inverse, x_k / k from the value of its value number on;
  /// `selection` has the coefficients of one of two series, left or right (none: of what does not change); `primitive`
  /// follows y' = right · left', right being any later node or itself, as `sine` does with its cosine.
  enum class Kind {
    symbol, sum, weighted, integrated, selection,
    product, quotient, square_root, sine, cosine, primitive, logarithm
  };
  Kind kind = Kind::symbol;
  std::optional<ValueNumber> value_number{};  ///< with just this value, if one is known; always for symbols and functions
  std::optional<int> left{};   ///< factor, dividend (none: one), or argument of a function
  /// Factor, divisor, second form, slope of a primitive, the cosine of a sine and the sine of a cosine.
  std::optional<int> right{};
  SeriesForm form{};           ///< of a sum
};

/// Whether the Taylor coefficients of a node take a convolution, k multiply-adds for the coefficient of order k.
bool is_nonlinear(const SeriesNode& node);
/// Whether its right node is its slope by the left one, up to sign.
bool has_slope(const SeriesNode& node);

/// The live part of a program as operations between Taylor series in time, with few that are not linear: sums of flat
/// monomials are factored, factors times a sum take one product, a quotient is one operation and so is each reciprocal,
/// equal operations are made once, sums make use of sin² + cos² = 1 and of divisors that cancel, and what is constant in
/// time multiplies coefficients only. Inputs, parameters and
/// numbers are constant; time, coordinates and velocities are series. Definitions are multiplied into what uses them
/// where that saves operations: in programs that are not large each is tried alone and with each other, in small ones by threes too.
///
/// What selects one of several forms by its argument (abs, sign, max, piecewise) keeps the form that it has at the start:
/// such a series holds until the next kink or jump.
///
/// Deterministic: nodes are numbered in the order of the program.
class SeriesProgram {
 public:
  SeriesProgram(Program& program, const std::vector<Value>& outputs);

  const std::vector<SeriesNode>& nodes() const { return nodes_; }
  const std::vector<SeriesForm>& outputs() const { return outputs_; }  ///< one for each value, in their order
  /// What must be known of the program at the start: constants, coefficients, and functions of series.
  std::vector<Polynomial> roots() const;
  Program& program() const { return *program_; }
  Value value(const Polynomial& root) const { return Value(*program_, root, Unit()); }
  Value symbol(const SymbolPointer& symbol) const { return program_->symbol(symbol); }
  /// Value numbers that the recurrence of a node starts from: a function, and what a selection chooses by.
  std::vector<ValueNumber> known_at_start(const SeriesNode& node) const;
  /// The call that a selection stands for.
  const Definition& call_of(const SeriesNode& node) const { return (*program_)[*node.value_number]; }
  const SymbolPointer& symbol_of(const SeriesNode& node) const { return (*program_)[*node.value_number].symbol; }
  int nonlinear_count() const;
  /// By node: whether it changes with these symbols.
  std::vector<bool> depending_on(const std::vector<SymbolPointer>& symbols) const;
  /// Whether the nodes so marked are sums, products with one marked factor, quotients of a marked dividend alone.
  bool linear_in(const std::vector<bool>& marked) const;

 private:
  Program* program_;
  std::vector<SeriesNode> nodes_;
  std::vector<SeriesForm> outputs_;
};

}  // namespace torsor
