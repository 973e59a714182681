// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/verification/check_constraints.hpp"

#include <algorithm>

#include "torsor/generator/dynamics/forces/constraint_wrench.hpp"
#include "torsor/generator/verification/motion_check.hpp"
#include "torsor/generator/verification/posed_constraints.hpp"

namespace torsor {
namespace {

class ConstraintCheck : MotionCheck {
 public:
  ConstraintCheck(const Scene& scene, const CheckOptions& options)
      : MotionCheck(scene, options), rows_(constraint_rows(model_)), poses_(model_) {
    for (std::size_t j = 0; j < rows_.size(); ++j) {
      // A reaction with a name acts where the scene says, on other bodies perhaps than those that the law names: what
      // it does along the coordinates is compared with the gradient elsewhere.
      const bool named = scene.content().constraints[j].reaction.has_value();
      wrenches_.push_back(named ? std::nullopt : ideal_wrench(model_, static_cast<int>(j)));
    }
  }

  std::vector<CheckResult> run() {
    for (int k = 0; k < options_.states; ++k) {
      Moment at(*this, k + 1);
      for (const ConstraintRow& row : rows_) differentiate(row, at);
      const Poses middle = poses_.at(at.here), earlier = poses_.at(at.before), later = poses_.at(at.after);
      const PosesInMotion poses{.before = earlier, .here = middle, .after = later};
      for (std::size_t j = 0; j < rows_.size(); ++j) {
        if (!wrenches_[j]) continue;
        const auto& law = scene_.content().constraints[j].law;
        if (rows_[j].holonomic) {
          displace(j, law, middle, at.here);
        } else if (std::holds_alternative<NoSlip>(law)) {
          const Real power = power_in_motion(*wrenches_[j], poses, at.here);
          keep(power - at.here(rows_[j].rate), sum_of_terms(rows_[j], at.here), wrench_);
        }
      }
    }
    std::vector<CheckResult> results{
        {"constraint_motion", "constraints differentiated along a motion against a and gamma", motion_, bound()}};
    if (std::any_of(wrenches_.begin(), wrenches_.end(), [](const auto& each) { return each.has_value(); })) {
      results.push_back(
          {"constraint_wrenches", "wrenches of constraints against virtual displacements of bodies", wrench_, bound()});
    }
    return results;
  }

 private:
  Real sum_of_terms(const ConstraintRow& row, Evaluator<Real>& here) const {
    Real sum = abs(here(row.rate));
    for (int i = 0; i < model_.unknown_count(); ++i) {
      sum += abs(here(row.jacobian[static_cast<std::size_t>(i)]) * here(model_.v(i)));
    }
    return sum;
  }

  void differentiate(const ConstraintRow& row, Moment& at) {
    const auto [acceleration, size] = this->acceleration(row.jacobian, row.gamma, at.here);
    if (!row.holonomic) return keep(slope(row.rate, at) - acceleration, size, motion_);
    keep(slope(row.value, at) - at.here(row.rate), sum_of_terms(row, at.here), motion_);
    keep(curvature(row.value, at) - acceleration, size, motion_);
  }

  static std::array<Real, 6> evaluated(const Wrench& wrench, Evaluator<Real>& here) {
    std::array<Real, 6> numbers;
    for (int i = 0; i < 3; ++i) {
      numbers[static_cast<std::size_t>(i)] = here(wrench.resultant[i]);
      numbers[static_cast<std::size_t>(i) + 3] = here(wrench.moment[i]);
    }
    return numbers;
  }

  /// Each body of the constraint alone, along and about its axes.
  void displace(std::size_t j, const ConstraintLaw& law, const Poses& poses, Evaluator<Real>& here) {
    const std::optional<PosedConstraint> f = poses_.constraint(law, here);
    if (!f) return;
    const Real value = here(rows_[j].value);
    keep((*f)(poses)-value, f->size(poses), wrench_);
    for (const auto& [link, wrench] : *wrenches_[j]) {
      const std::array<Real, 6> work = evaluated(wrench, here);
      Real size(0);
      for (const Real& component : work) size += abs(component);
      for (std::size_t k = 0; k < 6; ++k) {
        const Real forth = (*f)(displaced(poses, link, k, h_)), back = (*f)(displaced(poses, link, k, -h_));
        keep((forth - back) / (Real(2) * h_) - work[k], size, wrench_);
      }
    }
  }

  /// A step before, now, and a step later.
  struct PosesInMotion {
    const Poses &before, &here, &after;
  };

  /// Σ R·V + M·Ω, the twists from the poses: V = dO/dt, [Ω] = dR/dt Rᵀ.
  Real power_in_motion(const WrenchOnLinks& wrenches, const PosesInMotion& poses, Evaluator<Real>& here) const {
    const auto& [before, middle, after] = poses;
    Real sum(0);
    for (const auto& [link, wrench] : wrenches) {
      const auto at = static_cast<std::size_t>(link);
      const std::array<Real, 6> numbers = evaluated(wrench, here);
      const RealRotation& r = middle[at].rotation;
      const RealVector force = r * RealVector{numbers[0], numbers[1], numbers[2]};
      const RealVector moment = r * RealVector{numbers[3], numbers[4], numbers[5]};
      const Real per_step = Real(1) / (Real(2) * h_);
      const RealVector velocity = per_step * (after[at].origin - before[at].origin);
      RealVector omega{Real(0), Real(0), Real(0)};  // 2Ω = Σ e_i ∧ ė_i
      for (int i = 0; i < 3; ++i) {
        const RealVector slope = per_step * (column(after[at].rotation, i) - column(before[at].rotation, i));
        omega = omega + (Real(1) / Real(2)) * cross(column(r, i), slope);
      }
      sum += dot(force, velocity) + dot(moment, omega);
    }
    return sum;
  }

  std::vector<ConstraintRow> rows_;
  PosedScene poses_;
  std::vector<std::optional<WrenchOnLinks>> wrenches_;
  double motion_ = 0, wrench_ = 0;
};

}  // namespace

std::vector<CheckResult> check_constraints(const Scene& scene, const CheckOptions& options) {
  if (scene.content().constraints.empty()) return {};
  return ConstraintCheck(scene, options).run();
}

}  // namespace torsor
