// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "torsor/generator/program/polynomial.hpp"
#include "torsor/generator/program/program.hpp"

namespace torsor {

/// How the right-hand side of a definition is computed: the tree that emitters print and that is counted.
struct Formula {
  enum class Kind { value_number, constant, sum, product, quotient, function };

  Kind kind = Kind::constant;
  std::optional<ValueNumber> value_number;  ///< of a value number
  Number number;                            ///< of a constant
  Function function{};                      ///< of a function
  std::vector<Formula> children;  ///< of sums, products, quotients (numerator, denominator); of a function: its value numbers
  std::vector<bool> negative;     ///< of a sum: which children are subtracted

  static Formula of_value_number(ValueNumber value_number);
  static Formula of_number(const Number& number);
};

/// −formula, with the signs of a sum turned round.
Formula negated(Formula formula);

/// Factors a flat sum: again and again the factor that most terms share (a value number or the size of a coefficient) is taken
/// out. Exact; it only regroups.
Formula factored(const Polynomial& polynomial);

/// The same sum term by term, nothing taken out.
Formula expanded(const Polynomial& polynomial);

/// A sum as the program's passes have it, factored or not; its terms as they stand.
Formula formula(const Program& program, const Polynomial& sum);

/// The right-hand side of a definition (not of a symbol).
Formula formula(const Program& program, const Definition& definition);

/// Operation counts under the project's rules: additions and subtractions, multiplications (xⁿ its multiplications),
/// divisions and square roots 1, a sine-cosine pair 2, other functions 1; sign changes and copies nothing.
struct OperationCount {
  int additions = 0;
  int multiplications = 0;
  int divisions = 0;
  int square_roots = 0;
  int sincos_pairs = 0;
  int others = 0;
  int total() const { return additions + multiplications + divisions + square_roots + 2 * sincos_pairs + others; }
  OperationCount& operator+=(const OperationCount& other);
};

OperationCount count(const Formula& formula);

/// When operations are done: once for a set of parameters, or at every state.
enum class Occasion { parameters, state };

/// Counts what one occasion costs for some outputs: every live definition once, then each output's own formula; outputs
/// that are equal up to sign are computed once. What is known when the program is generated costs nothing.
OperationCount count(const Program& program, const std::vector<Value>& outputs, Occasion occasion = Occasion::state);

/// What the outputs would cost at every state without factoring and without doing anything once for all states.
OperationCount count_unoptimised(const Program& program, const std::vector<Value>& outputs);

}  // namespace torsor
