// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "torsor/generator/dynamics/equations/equations.hpp"
#include "torsor/generator/kernels/kernel.hpp"
#include "torsor/generator/program/evaluation.hpp"

namespace torsor {

/// Numbers that a command line gives by name.
using NamedNumbers = std::map<std::string, double>;

/// Throws UsageError where a name that an option gives is not known.
void require_known(const NamedNumbers& given, const std::vector<std::string>& known, const std::string& what,
                   const std::string& option);

/// Throws UsageError where --initial gives some components of a quaternion: they say nothing of the others, and beside what the
/// scene starts from none would stay as given.
void require_whole_quaternions(const SceneContent& scene, const NamedNumbers& given);

/// What moves a scene, evaluated in `double` from its program: kernels without a compiler. Inputs are constant in time.
class EvaluatedMotion {
 public:
  /// `parameters` and `inputs` replace values of the scene; an input that is not named is 0. Throws UsageError for an unknown
  /// name and for a parameter without a value, SceneError where the accelerations are not determined.
  EvaluatedMotion(const Scene& scene, const ModelOptions& options, const NamedNumbers& parameters,
                  const NamedNumbers& inputs);

  const Equations& equations() const { return equations_; }
  /// Positions, quaternions' components included, and velocities, in the order of generated files.
  const std::vector<SymbolPointer>& symbols() const { return symbols_; }
  std::size_t position_count() const { return position_count_; }
  std::size_t velocity_count() const { return symbols_.size() - position_count_; }

  /// The state the scene starts from, with some numbers replaced: "theta", "theta'". Constraints may be open. Throws
  /// UsageError for an unknown name.
  std::vector<double> start(const NamedNumbers& replaced);

  /// Moves to a state, where `value` then evaluates.
  void move_to(double t, const std::vector<double>& y);
  double value(const Value& of) { return here_(of); }
  using Ready = Evaluator<double>::Ready;
  Ready ready(const Value& of) { return here_.ready(of); }
  double value(const Ready& of) { return here_(of); }
  void normalise(std::vector<double>& y) const;  ///< quaternions to norm 1
  double position_rate(std::size_t i) { return here_(ready_rates_[i]); }
  double mass(std::size_t i, std::size_t j) { return here_(ready_mass_[i][j]); }
  const ConstraintRow& constraint(std::size_t j) const { return rows_[j]; }
  /// λ_j of the motion.
  double multiplier(std::size_t j) { return here_(forward_.assignments[velocity_count() + j].value); }

  /// dy/dt; false where a pivot is not positive beyond rounding, or a number is none.
  bool slope(double t, const std::vector<double>& y, std::vector<double>& rates);
  /// The constraint that left nothing of its own where the last slope was asked for; null: none did.
  const ConstraintRow* lost() const { return lost_; }

  /// What `settle` must not change, by places among the velocities: positions that go with them, and velocities themselves.
  struct Kept { std::vector<std::size_t> positions, rates; };
  /// Puts a state onto its constraints by the least change in the metric of the masses, quaternions to norm 1:
  ///   δq = −M⁻¹ Fᵀ (F M⁻¹ Fᵀ)⁺ f, repeated until f is down to rounding;   δv = −M⁻¹ Aᵀ (A M⁻¹ Aᵀ)⁺ (A v − b),
  /// F the rows of holonomic constraints; rows that repeat others are left out. Numbers of `kept` are left as they are: δq and
  /// δv are then the least ones that are zero there. False where the constraints cannot be closed so.
  /// Source: Hairer-Wanner II, VII.2; Lubich, Engstler, Nowak & Poehle 1995.
  bool settle(double t, std::vector<double>& y, const Kept& kept = {});
  /// What a row of the constraints keeps beside the others, at least, of its usual size: about 1 where they are orthogonal in
  /// the metric of the masses, near 0 at a change point. Rows that repeat others everywhere do not count.
  double independence(double t, const std::vector<double>& y);
  /// The same of as many rows as are kept, the best of all at this state: near 0 at a change point only.
  double independence_of_all(double t, const std::vector<double>& y);
  /// The constraint that a state leaves open the most, beside its own size: "constraint 'pin' has the value 0.2 m".
  std::string most_open(double t, const std::vector<double>& y);
  bool needs_settling() const { return !rows_.empty() || !quaternions_.empty(); }

  /// A formula of coordinates, rates, parameters and time, for `value`. Throws UsageError where it has an acceleration.
  Value watched(const Expression& formula, const std::string& text);
  double value(double t, const std::vector<double>& y, const Value& formula);

  struct Observed {
    std::string name, unit;
  };
  /// T, −U, T − U [J], then the first integrals.
  std::vector<Observed> observed() const;
  std::vector<double> observe(double t, const std::vector<double>& y);

 private:
  void displace(double t, std::vector<double>& y, const std::vector<double>& change);
  /// The least change δv with A δv = right for these rows and δv = 0 at the places kept, in the metric of the masses at the
  /// state moved to.
  std::vector<double> least_change(const std::vector<std::size_t>& rows, const std::vector<double>& right,
                                   const std::vector<std::size_t>& kept);
  void look_around(double t, const std::vector<double>& y);
  std::vector<std::vector<double>> scaled_rows(double t, const std::vector<double>& y);
  double open(const std::vector<std::size_t>& rows, bool rates);
  double open(std::size_t row, bool rates);  ///< beside its own size

  Equations equations_;
  std::vector<SymbolPointer> symbols_;
  std::size_t position_count_ = 0;
  std::vector<std::size_t> quaternions_;  ///< places of their first components
  std::unordered_map<const Symbol*, double> values_;  // looked up only
  Evaluator<double> here_;
  Kernel forward_, energy_, integrals_;
  struct ReadyPivot {
    Ready pivot, measure;
  };
  std::vector<ReadyPivot> ready_pivots_;  ///< of forward_
  std::vector<Ready> ready_accelerations_, ready_rates_;
  std::vector<std::vector<Ready>> ready_mass_;
  std::vector<Value> position_rates_;
  std::vector<std::vector<Value>> mass_;
  std::vector<ConstraintRow> rows_;
  std::vector<std::vector<double>> usual_;  ///< sizes of the entries of rows
  std::vector<std::size_t> holonomic_, all_;
  const ConstraintRow* lost_ = nullptr;
};

}  // namespace torsor
