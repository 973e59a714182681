// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/motion/body_screws.hpp"

namespace torsor {
namespace {

/// Everything in the axes of the observer's link, from its origin: rates of components are derivatives in R.
class FromPositions {
 public:
  FromPositions(const Model& model, const ScrewQuery& query)
      : model_(model), program_(model.program()), link_(model.place(query.observer, user_).link) {
    point_ = bound(program_, model.locate(query.point, link_, user_));
  }

  /// ∫ V(P/R) dm and ∫ AP ∧ V(P/R) dm with P = O + Σ x_i e_i, hence V = Ȯ + Σ x_i ė_i:
  /// {m Ȯ + ḣ, (O − A) ∧ (m Ȯ + ḣ) + h ∧ Ȯ + Σ_ij (∫ x_i x_j dm) e_i ∧ ė_j}.
  MomentumScrew momentum_of(int link, const MassProperties& mass) const {
    const Vector origin = bound(program_, model_.locate(Vector(), link, link_));
    const Vector velocity = bound(program_, time_derivative(origin));
    Vector axes[3], rates[3], h, h_rate;
    for (int i = 0; i < 3; ++i) {
      Vector unit;
      unit[i] = program_.number(Number(1));
      axes[i] = bound(program_, model_.express(unit, link, link_));
      rates[i] = bound(program_, time_derivative(axes[i]));
      h += mass.first_moment[i] * axes[i];
      h_rate += mass.first_moment[i] * rates[i];
    }
    MomentumScrew screw;
    screw.resultant = bound(program_, mass.mass * velocity + h_rate);
    screw.moment = cross(bound(program_, origin - point_), screw.resultant);
    screw.moment += cross(bound(program_, h), velocity);
    const Value half_trace =
        program_.bind(Number::rational(1, 2) * (mass.inertia(0, 0) + mass.inertia(1, 1) + mass.inertia(2, 2)));
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        Value second = -mass.inertia(i, j);  // ∫ x_i x_j dm = ½ tr(J) δ_ij − J_ij
        if (i == j) second += half_trace;
        if (!second.is_zero()) screw.moment += program_.bind(second) * cross(axes[i], rates[j]);
      }
    }
    return screw;
  }

  MomentumScrew momentum_of(const BodyNames& bodies) const {
    MomentumScrew sum;
    for (const auto& [link, mass] : mass_by_link(model_, bodies, user_)) sum = sum + momentum_of(link, mass);
    return {bound(program_, sum.resultant), bound(program_, sum.moment)};
  }

  /// V(A/R) of the geometric point.
  Vector velocity_of_point() const { return bound(program_, time_derivative(point_)); }

  template <class Kind>
  Screw<Kind> along(const Screw<Kind>& screw, const ScrewQuery& query) const {
    const FramePlace& axes = model_.place(query.axes, user_);
    const Vector resultant = axes.rotation.transpose() * model_.express(screw.resultant, link_, axes.link);
    const Vector moment = axes.rotation.transpose() * model_.express(screw.moment, link_, axes.link);
    return {bound(program_, resultant), bound(program_, moment)};
  }

 private:
  const std::string user_ = "a screw query";
  const Model& model_;
  Program& program_;
  int link_;
  Vector point_;
};

}  // namespace

MomentumScrew momentum_screw_from_positions(const Model& model, const BodyNames& bodies, const ScrewQuery& query) {
  const FromPositions seen(model, query);
  return seen.along(seen.momentum_of(bodies), query);
}

DynamicScrew dynamic_screw_from_positions(const Model& model, const BodyNames& bodies, const ScrewQuery& query) {
  const FromPositions seen(model, query);
  const MomentumScrew momentum = seen.momentum_of(bodies);
  const Vector velocity = seen.velocity_of_point();
  DynamicScrew screw;
  screw.resultant = bound(model.program(), time_derivative(momentum.resultant));
  screw.moment = time_derivative(momentum.moment);
  screw.moment += cross(velocity, momentum.resultant);
  return seen.along(screw, query);
}

}  // namespace torsor
