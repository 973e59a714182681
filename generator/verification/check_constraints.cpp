// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/verification/check_constraints.hpp"

#include <algorithm>

#include "generator/dynamics/forces/constraint_wrench.hpp"
#include "generator/verification/moving_state.hpp"
#include "generator/verification/posed_constraints.hpp"
#include "generator/verification/worst.hpp"

namespace torsor {
namespace {

class ConstraintCheck {
 public:
  ConstraintCheck(const Scene& scene, const CheckOptions& options)
      : scene_(scene),
        options_(options),
        // A quotient of second order with the step h has errors of h² and 10^-(working digits)/h²: half the digits and
        // ten more for h leave 20 digits of both below the digits asked for.
        precision_(2 * options.digits + 50),
        h_(pow(Real(10), -options.digits / 2 - 10)),
        program_(Model::resolver(scene, {})),
        model_(scene, program_),
        rows_(constraint_rows(model_)),
        poses_(model_) {
    for (std::size_t j = 0; j < rows_.size(); ++j) {
      // A reaction with a name acts where the scene says, on other bodies perhaps than those that the law names: what
      // it does along the coordinates is compared with the gradient elsewhere.
      const bool named = scene.content().constraints[j].reaction.has_value();
      wrenches_.push_back(named ? std::nullopt : ideal_wrench(model_, static_cast<int>(j)));
    }
  }

  std::vector<CheckResult> run() {
    for (int k = 0; k < options_.states; ++k) {
      const RandomState state(scene_, static_cast<std::uint64_t>(k) + 1);
      const MovingState motion(scene_, state);
      Evaluator<Real> here(program_, motion.at(Real(0))), before(program_, motion.at(-h_)),
          after(program_, motion.at(h_));
      for (std::size_t j = 0; j < rows_.size(); ++j) differentiate(rows_[j], before, here, after);
      const Poses middle = poses_.at(here), earlier = poses_.at(before), later = poses_.at(after);
      for (std::size_t j = 0; j < rows_.size(); ++j) {
        if (!wrenches_[j]) continue;
        const auto& law = scene_.content().constraints[j].law;
        if (rows_[j].holonomic) {
          displace(j, law, middle, here);
        } else if (std::holds_alternative<NoSlip>(law)) {
          const Real power = power_in_motion(*wrenches_[j], earlier, middle, later, here);
          keep(power - here(rows_[j].rate), sum_of_terms(rows_[j], here), wrench_);
        }
      }
    }
    const double bound = pow(Real(10), 5 - options_.digits).to_double();
    std::vector<CheckResult> results{
        {"constraint_motion", "constraints differentiated along a motion against a and gamma", motion_, bound}};
    if (std::any_of(wrenches_.begin(), wrenches_.end(), [](const auto& each) { return each.has_value(); })) {
      results.push_back(
          {"constraint_wrenches", "wrenches of constraints against virtual displacements of bodies", wrench_, bound});
    }
    return results;
  }

 private:
  /// |difference| over a scale. Numbers of the state are about 1: where all terms vanish identically, errors of the
  /// quotient are left, h² times a higher derivative, and no scale for them.
  void keep(const Real& difference, const Real& scale, double& worst) const {
    if (abs(difference) < pow(Real(10), -options_.digits - 5)) return;
    const double relative = (abs(difference) / scale).to_double();
    if (is_worse(relative, worst)) worst = relative;
  }

  Real sum_of_terms(const ConstraintRow& row, Evaluator<Real>& here) const {
    Real sum = abs(here(row.rate));
    for (int i = 0; i < model_.unknown_count(); ++i) {
      sum += abs(here(row.jacobian[static_cast<std::size_t>(i)]) * here(model_.v(i)));
    }
    return sum;
  }

  void differentiate(const ConstraintRow& row, Evaluator<Real>& before, Evaluator<Real>& here, Evaluator<Real>& after) {
    const Value& f = row.holonomic ? row.value : row.rate;
    const Real earlier = before(f), middle = here(f), later = after(f);
    const Real slope = (later - earlier) / (Real(2) * h_);
    Real acceleration = here(row.gamma);
    Real size = abs(acceleration);
    for (int i = 0; i < model_.unknown_count(); ++i) {
      const Real term = here(row.jacobian[static_cast<std::size_t>(i)]) * here(model_.a(i));
      acceleration += term;
      size += abs(term);
    }
    if (!row.holonomic) return keep(slope - acceleration, size, motion_);
    keep(slope - here(row.rate), sum_of_terms(row, here), motion_);
    keep((later - middle - middle + earlier) / (h_ * h_) - acceleration, size, motion_);
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

  /// Σ R·V + M·Ω, the twists from the poses: V = dO/dt, [Ω] = dR/dt Rᵀ.
  Real power_in_motion(const WrenchOnLinks& wrenches, const Poses& before, const Poses& middle, const Poses& after,
                       Evaluator<Real>& here) const {
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

  const Scene& scene_;
  CheckOptions options_;
  WorkingDigits precision_;
  Real h_;
  Program program_;
  Model model_;
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
