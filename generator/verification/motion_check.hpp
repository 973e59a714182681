// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/dynamics/motion/model.hpp"
#include "torsor/generator/verification/check.hpp"
#include "torsor/generator/verification/moving_state.hpp"
#include "torsor/generator/verification/worst.hpp"

namespace torsor {

/// What checks have in common that differentiate along motions by quotients: a model of their own, and the precision that
/// it takes.
class MotionCheck {
 protected:
  MotionCheck(const Scene& scene, const CheckOptions& options)
      : scene_(scene),
        options_(options),
        // A quotient of second order with the step h has errors of h² and 10^-(working digits)/h²: half the digits and
        // ten more for h leave 20 digits of both below the digits asked for.
        precision_(2 * options.digits + 50),
        h_(pow(Real(10), -options.digits / 2 - 10)),
        program_(Model::resolver(scene, {})),
        model_(scene, program_) {}

  /// A motion at -h, 0 and h.
  struct Moment {
    Moment(const MotionCheck& check, int seed)
        : state(check.scene_, static_cast<std::uint64_t>(seed)),
          motion(check.scene_, state),
          before(check.program_, motion.at(-check.h_)),
          here(check.program_, motion.at(Real(0))),
          after(check.program_, motion.at(check.h_)) {}
    Moment(const Moment&) = delete;
    Moment& operator=(const Moment&) = delete;

    RandomState state;
    MovingState motion;
    Evaluator<Real> before, here, after;
  };

  Real slope(const Value& x, Moment& at) const { return (at.after(x) - at.before(x)) / (Real(2) * h_); }
  Real curvature(const Value& x, Moment& at) const {
    const Real middle = at.here(x);
    return (at.after(x) - middle - middle + at.before(x)) / (h_ * h_);
  }

  /// Σ row_i v̇_i + drift, and the size of its terms.
  std::pair<Real, Real> acceleration(const std::vector<Value>& row, const Value& drift, Evaluator<Real>& here) const {
    Real sum = here(drift), size = abs(sum);
    for (int i = 0; i < model_.unknown_count(); ++i) {
      const Real term = here(row[static_cast<std::size_t>(i)]) * here(model_.a(i));
      sum += term;
      size += abs(term);
    }
    return {sum, size};
  }

  /// |difference| over a scale. Numbers of the state are about 1: where all terms vanish identically, errors of the
  /// quotient are left, h² times a higher derivative, and no scale for them.
  void keep(const Real& difference, const Real& scale, double& worst) const {
    if (abs(difference) < pow(Real(10), -options_.digits - 5)) return;
    const double relative = (abs(difference) / scale).to_double();
    if (is_worse(relative, worst)) worst = relative;
  }

  double bound() const { return pow(Real(10), 5 - options_.digits).to_double(); }

  const Scene& scene_;
  CheckOptions options_;
  WorkingDigits precision_;
  Real h_;
  Program program_;
  Model model_;
};

}  // namespace torsor
