// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "torsor/generator/program/program.hpp"

namespace torsor {

/// A derivation of a program: D(f g) = D(f) g + f D(g), fixed by what it does to symbols.
///
/// Taken definition by definition with the chain rule, memoised, each result bound: linear in the size of the program
/// (forward differentiation, Griewank & Walther, Evaluating Derivatives, 2nd ed., §3.1). The unit of the independent
/// variable divides that of the result.
class Derivation {
 public:
  /// D of a symbol; return an empty Value for zero.
  using Seed = std::function<Value(const SymbolPointer&)>;

  Derivation(Program& program, Seed seed, Unit variable);

  Value operator()(const Value& value);

 private:
  Value of_value_number(ValueNumber value_number);
  Value of_call(ValueNumber value_number, const Definition& definition);
  Value of_polynomial(const Polynomial& polynomial, const Unit& unit);

  Program* program_;
  Seed seed_;
  Unit variable_;
  std::vector<std::optional<Value>> known_;
};

/// ∂/∂symbol: every other symbol is constant.
Derivation partial_derivation(Program& program, const SymbolPointer& symbol);

/// ∂q̇/∂v for a coordinate and a velocity: 1 or 0, or an entry of the map from angular velocity to quaternion rates.
Value rate_along(Program& program, const SymbolPointer& coordinate, const SymbolPointer& velocity);
/// q̇ of a coordinate as a value: its velocity, or the rate of a quaternion's component.
Value rate_of(Program& program, const SymbolPointer& coordinate);

/// Derivative with respect to configuration along the freedom of a velocity: ∂/∂q where v = q̇, and for a component of
/// an angular velocity Σ_k (∂ė_k/∂ω_i) ∂/∂e_k (the derivative along a quasi-coordinate).
Derivation derivation_along(Program& program, const SymbolPointer& velocity);

/// d/dt: 1 for time, q̇ for q, q̈ for q̇, 0 for parameters. Other symbols throw SceneError.
Derivation time_derivation(Program& program);
Value time_derivative(const Value& value);

/// Gradient of one value with respect to many symbols by one reverse sweep: its cost is a small multiple of the
/// value's own, whatever the number of symbols (Griewank & Walther, §3.2).
std::vector<Value> gradient(const Value& value, const std::vector<SymbolPointer>& symbols);

/// The same along freedoms: Σ_k (∂q̇_k/∂v_i) ∂/∂q_k.
std::vector<Value> gradient_along(const Value& value, const std::vector<SymbolPointer>& velocities);

/// Replaces symbols throughout, rebuilding what depends on them; an empty optional leaves a symbol as it is.
class Substitution {
 public:
  using Replacement = std::function<std::optional<Value>(const SymbolPointer&)>;
  Substitution(Program& program, Replacement replacement);
  Value operator()(const Value& value);

 private:
  Value of_value_number(ValueNumber value_number);

  Program* program_;
  Replacement replacement_;
  std::vector<std::optional<Value>> known_;
};

}  // namespace torsor
