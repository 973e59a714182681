// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "torsor/generator/dynamics/equations/constraint_rank.hpp"
#include "torsor/generator/dynamics/forces/actions.hpp"
#include "torsor/generator/dynamics/forces/constraints.hpp"
#include "torsor/generator/dynamics/forces/virtual_power.hpp"
#include "torsor/generator/dynamics/recursions/forward_dynamics.hpp"

namespace torsor {

/// The equations of one scene in one program, each part derived when first asked for:
/// M q̈ + h = E u + B λ, A q̈ + γ = 0, with B = Aᵀ unless contacts have friction.
class Equations {
 public:
  explicit Equations(const Scene& scene, const ModelOptions& options = {});
  Equations(const Equations&) = delete;  // the model refers to the scene and the program in here
  Equations& operator=(const Equations&) = delete;

  /// Forgets all that was derived, as if nothing had been asked for yet: what is derived next does not depend on what
  /// was derived before. Values of these equations must not be used any more.
  void start_over() const;

  const Scene& scene() const { return scene_; }
  Program& program() const { return *program_; }
  const Model& model() const { return model_; }

  const AppliedActions& actions() const;
  const std::vector<ConstraintRow>& constraints() const;
  /// Which constraints repeat others: `forward` leaves those out and takes their multipliers as zero.
  const ConstraintRank& redundancy() const;
  /// M, unknowns only. Of up to twelve unknowns what vanishes identically is zero, here and in the bias.
  const ValueMatrix& mass() const;
  /// Unknowns that move no mass, of a scene that keeps such; see massless_coordinates. Otherwise none: validate refuses
  /// them.
  const std::vector<int>& massless() const;
  const std::vector<Value>& bias() const;                ///< h_i, every coordinate (released ones last)
  /// M q̈ + h − Σ λ_j column_j, every coordinate: by one recursion, or from M and h where that has fewer operations, as
  /// in coordinates that M does not couple.
  const std::vector<Value>& inverse_dynamics() const;
  /// Unknowns only: by the method that the options ask for, or the cheapest, unless that loses digits where a light link
  /// carries a heavy one (forward_choice.hpp). Throws SceneError that names the massless coordinates when there are any.
  const ForwardSolution& forward() const;
  /// Whether what is differentiated or expanded further shall be `forward` by sums of squares too: with L D Lᵀ of M the
  /// digits would be lost there. Of more than four unknowns that takes ten times the operations, and must be asked for.
  bool differentiates_squares() const;
  /// The accelerations by sums of squares with these generalised forces beside those of `forward`, unknowns only.
  std::vector<Value> accelerations_by_squares(const std::vector<Value>& added) const;
  /// L D Lᵀ of the mass matrix or the articulated-body recursion, whichever has fewer operations; of eight and more
  /// unknowns within 5 % the recursion, which is more accurate.
  ForwardSolution cheapest_forward() const;
  /// The same by L D Lᵀ, whatever it costs: for those who solve with it further.
  const ForwardSolution& forward_by_factorisation() const;
  std::vector<Value> of_inputs() const;                  ///< (E u)_i, unknowns only
  /// Solves M a = force + B λ, A a + γ = 0 by factorisation, γ for every constraint; multipliers of constraints that
  /// repeat others are zero.
  ForwardSolution solve(const std::vector<Value>& force, const std::vector<Value>& gamma) const;
  /// Power [W] of everything that has no force function. That of friction is N times a velocity, N being the multiplier
  /// of the motion: forward().multipliers, at the inputs.
  Value power() const;

 private:
  bool few_unknowns() const;
  std::vector<Value> inertia_and_passive(AccelerationInput input) const;
  /// M q̈ + h from its parts, of the unknowns; released coordinates as `recursive` has them.
  std::vector<Value> expanded_inverse_dynamics(const std::vector<Value>& recursive) const;
  const MotionSolver& solver() const;
  std::vector<Value> efforts() const;  ///< of inputs and passive actions, unknowns only
  bool recursion_possible() const;
  ForwardSolution forward_by_recursion() const;
  /// q̈ = q̈_r + M⁻¹ (E u + Q − P(q̈_r)), q̈_r of reference_motion: less to compute than the bias.
  ForwardSolution forward_about_reference() const;

  /// What has been derived.
  struct Derived {
    std::optional<AppliedActions> actions;
    std::optional<std::vector<ConstraintRow>> constraints;
    std::optional<ValueMatrix> mass;
    std::optional<std::vector<int>> massless;
    std::optional<std::vector<Value>> bias, inverse;
    std::optional<MotionSolver> solver;
    std::optional<ForwardSolution> forward, factored;
  };

  Scene scene_;
  std::unique_ptr<Program> program_;
  Model model_;
  std::size_t size_of_model_;  ///< of the program, before anything else was derived
  mutable Derived derived_;
  mutable std::optional<ConstraintRank> redundancy_;  ///< found in a program of its own
};

/// Operations of everything that the kernel computes, what it tests included.
int cost_of(const Program& program, const ForwardSolution& solution);

}  // namespace torsor
