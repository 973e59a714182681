// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "torsor/generator/dynamics/equations/equations.hpp"
#include "torsor/generator/kernels/kernel.hpp"
#include "torsor/generator/program/evaluation.hpp"
#include "torsor/generator/program/pivot_test.hpp"

namespace torsor::testing_motions {

/// What moves a scene, evaluated in `double` from its program: the kernels of its header without a compiler. Inputs are
/// zero. Parameters have their values; the others, and times, are given by the state.
class EvaluatedScene {
 public:
  explicit EvaluatedScene(const Scene& scene);

  struct Sizes {
    int quaternions = 0, others = 0;  ///< positions: four of each quaternion, and coordinates with q' = v
    int velocities = 0, constraints = 0, independent_constraints = 0;
  };
  [[nodiscard]] const Sizes& sizes() const { return sizes_; }
  /// Of every position, quaternions first: the velocities have their own order.
  [[nodiscard]] const std::vector<SymbolPointer>& positions() const { return positions_; }
  [[nodiscard]] const std::vector<double>& initial_positions() const { return initial_; }
  [[nodiscard]] const std::vector<SymbolPointer>& velocities() const { return velocities_; }

  /// Before anything else at a state: positions in the order above, then velocities.
  void move_to(double time, std::span<const double> positions, std::span<const double> velocities);

  /// False where a pivot is not positive beyond rounding, as the emitted kernel says `singular`.
  [[nodiscard]] bool forward_dynamics(std::span<double> accelerations, std::span<double> multipliers);
  void rates(std::span<double> positions);
  [[nodiscard]] double mass(int i, int j) { return here_(mass_[index(i)][index(j)]); }
  [[nodiscard]] double bias(int i) { return here_(bias_[index(i)]); }
  [[nodiscard]] double constraint(int j) { return here_(rows_[index(j)].value); }
  [[nodiscard]] double constraint_rate(int j) { return here_(rows_[index(j)].rate); }
  [[nodiscard]] double constraint_jacobian(int j, int i) { return here_(rows_[index(j)].jacobian[index(i)]); }
  [[nodiscard]] double constraint_gamma(int j) { return here_(rows_[index(j)].gamma); }
  /// Whether friction makes other generalised forces of the multipliers than Aᵀ does.
  [[nodiscard]] bool has_friction() const { return friction_; }
  /// Coefficients 0..order of the motion, positions then velocities.
  [[nodiscard]] std::vector<std::vector<double>> jets(int order);
  [[nodiscard]] bool has_jets() const { return jets_.series.has_value(); }

  /// E = T2 − T0 − U at this state, and what Painlevé's equation says of its rate along the motion (course, 6.4):
  /// Σ Q_i q̇_i of all that has no force function, −∂T/∂t − ∂U/∂t, and Σ λ_j b_j with the work of friction.
  [[nodiscard]] double energy() { return here_(energy_); }
  [[nodiscard]] double energy_rate();
  [[nodiscard]] const std::vector<Value>& first_integrals() const { return integrals_; }
  [[nodiscard]] double evaluate(const Value& value) { return here_(value); }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  Equations equations_;
  Sizes sizes_;
  std::vector<SymbolPointer> positions_, velocities_;
  std::vector<double> initial_;
  std::unordered_map<const Symbol*, double> values_;  // looked up only
  Evaluator<double> here_;
  std::vector<Value> rates_, accelerations_, multipliers_, bias_;
  ValueMatrix mass_;
  std::vector<ConstraintRow> rows_;
  Kernel jets_;
  std::vector<PivotTest> pivots_;
  Value energy_, force_function_, explicit_rate_, power_;
  std::vector<Value> integrals_;
  bool friction_ = false;
};

}  // namespace torsor::testing_motions
