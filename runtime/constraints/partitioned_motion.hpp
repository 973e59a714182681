// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>

#include "torsor/runtime/constraints/constraint_kinds.hpp"
#include "torsor/runtime/constraints/constraint_reading.hpp"
#include "torsor/runtime/constraints/independent_constraints.hpp"
#include "torsor/runtime/mechanism.hpp"
#include "torsor/runtime/status.hpp"
#include "torsor/runtime/system.hpp"

namespace torsor::runtime {

/// Which of nv coordinates (or velocities) are taken as independent under constraints A: those that elimination with
/// exchange of rows and columns leaves without a pivot, so that the others are determined well.
/// Source: Wehage & Haug, Journal of Mechanical Design 104 (1982) 247-255.
template <class Scalar, std::size_t nv>
struct Partition {
  static constexpr std::size_t any = nv + 1;

  std::array<std::size_t, nv> independent{}, dependent{};  ///< the first `freedoms`, and nv - freedoms
  std::size_t freedoms = nv;
  bool complete = false;  ///< there are as many independent constraints as dependent coordinates

  /// A is m x nv, column by column, its entries without units (see `unitless`); `freedoms` of them, or as many as the
  /// rank of A leaves.
  template <std::size_t m>
  static Partition of(const std::array<Scalar, m * nv>& jacobian, std::size_t freedoms = any) noexcept {
    auto A = jacobian;
    const auto entry = [&](std::size_t i, std::size_t j) -> Scalar& { return A[j * m + i]; };
    const Scalar repeated = std::cbrt(std::numeric_limits<Scalar>::epsilon());
    const std::size_t wanted = freedoms == any ? std::min(m, nv) : nv - freedoms;
    Partition result;
    std::array<bool, nv> taken{};
    Scalar first = Scalar(0), pivot = Scalar(0);
    std::size_t step = 0;
    for (; step <= wanted && step < m; ++step) {
      std::size_t row = step, column = nv;
      pivot = Scalar(0);
      for (std::size_t j = 0; j < nv; ++j) {
        for (std::size_t i = step; i < m && !taken[j]; ++i) {
          if (std::abs(entry(i, j)) > pivot) {
            pivot = std::abs(entry(i, j));
            row = i;
            column = j;
          }
        }
      }
      first = std::max(first, pivot);
      if (step == wanted || (freedoms == any && !(pivot > repeated * first))) break;  // what is left repeats others
      if (column == nv || !(pivot > usual_rank_tolerance<Scalar>() * first)) return result;
      taken[column] = true;
      result.dependent[step] = column;
      for (std::size_t j = 0; j < nv; ++j) std::swap(entry(row, j), entry(step, j));
      for (std::size_t i = step + 1; i < m; ++i) {
        const Scalar factor = entry(i, column) / entry(step, column);
        for (std::size_t j = 0; j < nv; ++j) entry(i, j) -= factor * entry(step, j);
      }
    }
    result.freedoms = nv - step;
    std::size_t count = 0;
    for (std::size_t j = 0; j < nv; ++j) {
      if (!taken[j]) result.independent[count++] = j;
    }
    result.complete = (freedoms == any || step == wanted) && (step == m || pivot <= repeated * first);
    return result;
  }
};

/// The motion of a mechanism in independent coordinates: z = [q_P; v_I], z' = [v_P; a_I]. The other coordinates follow
/// from the holonomic constraints at every evaluation, f(q_P, q_D) = 0 by Newton's method, the other velocities from all
/// constraints, A_D v_D = b - A_I v_I, so that these hold to rounding at all times. Rolling ties velocities only: of
/// such mechanisms more coordinates than velocities are independent, each of which is integrated. `places` is for them,
/// as many as velocities or all; places beyond those in use stay 0. Only where q' = v. The partitions are those of the
/// state they were made at; see `integrate_partitioned`, which changes them where they become ill-conditioned.
template <class Motion, std::size_t freedoms, std::size_t places = velocities_of<typename Motion::Mechanism>>
class PartitionedMotion {
 public:
  using M = typename Motion::Mechanism;
  using Scalar = ScalarOf<M>;
  static constexpr std::size_t nv = velocities_of<M>, m = static_cast<std::size_t>(M::multiplier_count);
  using Full = StateVector<M>;
  using Vector = std::array<Scalar, places + freedoms>;
  using Choice = Partition<Scalar, nv>;
  using Kinds = ConstraintKinds<M>;
  using Factor = IndependentConstraints<Scalar, nv, m>;
  static_assert(!HasCoordinateRates<M> && coordinates_of<M> == nv, "partitioned coordinates need q' = v");
  static_assert(freedoms > 0 && freedoms < nv && places <= nv);

  PartitionedMotion(const Motion& motion, const Kinds& kinds) noexcept : motion_(motion), kinds_(kinds) {}

  /// Chooses the independent coordinates anew at a state; `singular` when it has not as many freedoms.
  [[nodiscard]] Evaluation choose(Scalar t, const Full& y) noexcept {
    Reading here;
    if (!here.read(motion_.precomputed(), kinds_, t, y)) return Evaluation::not_finite;
    velocities_ = Choice::template of<m>(unitless(here.constraints.jacobian), freedoms);
    const std::size_t known = kinds_.all_holonomic() ? freedoms : chosen_ ? positions_.freedoms : Choice::any;
    positions_ = Choice::template of<m>(unitless(holonomic(here)), known);
    lengths_ = Reading::lengths(motion_.precomputed(), kinds_, t, y);
    near_ = y;
    chosen_ = positions_.complete && velocities_.complete && positions_.freedoms <= places;
    return chosen_ ? Evaluation::ok : Evaluation::singular;
  }
  [[nodiscard]] const Choice& positions() const noexcept { return positions_; }
  [[nodiscard]] const Choice& velocities() const noexcept { return velocities_; }

  [[nodiscard]] Vector reduce(const Full& y) const noexcept {
    Vector z{};
    for (std::size_t k = 0; k < positions_.freedoms; ++k) z[k] = y[positions_.independent[k]];
    for (std::size_t k = 0; k < freedoms; ++k) z[places + k] = y[nv + velocities_.independent[k]];
    return z;
  }

  /// All coordinates and velocities for the independent ones, near those of the last step kept.
  [[nodiscard]] Evaluation complete(Scalar t, const Vector& z, Full& y) const noexcept {
    Contents contents;
    return complete(t, z, y, contents);
  }

  [[nodiscard]] Evaluation operator()(const Scalar& t, const Vector& z, Vector& dzdt) const noexcept {
    Full y, dydt;
    if (const Evaluation e = complete(t, z, y); e != Evaluation::ok) return e;
    const Evaluation evaluation = motion_(t, y, dydt);
    dzdt = {};
    for (std::size_t k = 0; k < positions_.freedoms; ++k) dzdt[k] = dydt[positions_.independent[k]];
    for (std::size_t k = 0; k < freedoms; ++k) dzdt[places + k] = dydt[nv + velocities_.independent[k]];
    return evaluation;
  }

  /// How many times better others may be determined before they are chosen.
  static constexpr Scalar worst = Scalar(4);

  /// A step was kept: its state is where the next ones look from. `loss` is how many times better, by the content of
  /// A_D, the dependent coordinates or velocities would be determined if they were chosen here. `singular` where none are
  /// that determine them: so near a change point that rounding of positions takes half of the digits of accelerations.
  [[nodiscard]] Evaluation keep(Scalar t, const Vector& z, Scalar& loss) noexcept {
    Full y;
    Contents now;
    if (const Evaluation e = complete(t, z, y, now); e != Evaluation::ok) return e;
    near_ = y;
    Reading here;
    if (!here.read(motion_.precomputed(), kinds_, t, y)) return Evaluation::not_finite;
    loss = Scalar(1);
    const auto compare = [&](const auto& jacobian, std::size_t count, Scalar content) {
      const Choice best = Choice::template of<m>(unitless(jacobian), count);
      Factor factor;
      // Others that cannot be determined here are no better.
      if (!best.complete || factorise(jacobian, best, factor) != Evaluation::ok) return;
      loss = std::max(loss, factor.content() / content);
    };
    compare(here.constraints.jacobian, freedoms, now.velocities);
    if (!kinds_.all_holonomic()) compare(holonomic(here), positions_.freedoms, now.positions);
    usual_share_ = std::max(usual_share_, now.least_share);
    const Scalar blind = std::sqrt(std::sqrt(std::numeric_limits<Scalar>::epsilon()));
    const Scalar part = std::min(Scalar(1), 10 * usual_share_);  // of a thin fork it is small everywhere
    return loss <= worst && now.least_share < blind * part ? Evaluation::singular : Evaluation::ok;
  }
  [[nodiscard]] const Full& state() const noexcept { return near_; }

 private:
  using Reading = ConstraintReading<M>;
  using Jacobian = std::array<Scalar, m * nv>;
  struct Contents {
    Scalar positions = Scalar(1), velocities = Scalar(1);
    Scalar least_share = Scalar(1);  ///< of the velocities' rows, see IndependentConstraints
  };

  Evaluation complete(Scalar t, const Vector& z, Full& y, Contents& contents) const noexcept {
    y = near_;
    for (std::size_t k = 0; k < positions_.freedoms; ++k) y[positions_.independent[k]] = z[k];
    for (std::size_t j = 0; j < nv; ++j) y[nv + j] = Scalar(0);
    for (std::size_t k = 0; k < freedoms; ++k) y[nv + velocities_.independent[k]] = z[places + k];
    Reading here;
    if (!here.read(motion_.precomputed(), kinds_, t, y)) return Evaluation::not_finite;
    Factor factor;
    if (const Evaluation e = close(t, y, here, factor); e != Evaluation::ok) return e;
    contents.positions = factor.content();
    if (!kinds_.all_holonomic()) {
      if (const Evaluation e = factorise(here.constraints.jacobian, velocities_, factor); e != Evaluation::ok) return e;
    }
    contents.velocities = factor.content();
    contents.least_share = factor.least_share();
    const auto change = factor.least_change(-read(here.constraints.rate));
    for (std::size_t j = 0; j < nv; ++j) y[nv + j] += change(static_cast<int>(j));
    return all_finite(change.entries) ? Evaluation::ok : Evaluation::not_finite;
  }

  // Newton's method along the dependent coordinates: one step more than to rounding of the terms of f, or until it is no
  // nearer for it.
  Evaluation close(Scalar t, Full& y, Reading& here, Factor& factor) const noexcept {
    if (positions_.freedoms == nv) return Evaluation::ok;
    for (int iteration = 0; iteration < 30; ++iteration) {
      const Jacobian jacobian = holonomic(here);
      if (const Evaluation e = factorise(jacobian, positions_, factor); e != Evaluation::ok) return e;
      const auto change = factor.least_change(-read(here.constraints.value));
      Full trial = y;
      for (std::size_t j = 0; j < nv; ++j) trial[j] += change(static_cast<int>(j));
      if (here.position_is_rounding(lengths_)) {
        y = trial;
        return all_finite(change.entries) ? Evaluation::ok : Evaluation::not_finite;
      }
      Reading there;
      if (!there.read(motion_.precomputed(), kinds_, t, trial)) return Evaluation::not_finite;
      const bool halves = there.open < here.open / Scalar(2);
      if (there.open < here.open) {
        y = trial;
        here = there;
      }
      if (!halves) break;
    }
    for (std::size_t i = 0; i < m; ++i) {
      if (!here.position_is_closed(i, lengths_, Scalar(1e6))) return Evaluation::singular;
    }
    return Evaluation::ok;
  }

  static typename Factor::Residual read(const std::array<Scalar, m>& values) noexcept {
    return {values};
  }

  // A without the rows of constraints on velocities alone.
  Jacobian holonomic(const Reading& here) const noexcept {
    Jacobian jacobian = here.constraints.jacobian;
    for (std::size_t i = 0; i < m; ++i) {
      for (std::size_t j = 0; j < nv && !kinds_.holonomic[i]; ++j) jacobian[j * m + i] = Scalar(0);
    }
    return jacobian;
  }

  // A_ij in the reaches of the velocities, over what the constraint usually moves by these.
  Jacobian unitless(const Jacobian& jacobian) const noexcept {
    Jacobian scaled{};
    for (std::size_t i = 0; i < m; ++i) {
      Scalar usual = Scalar(0);
      for (std::size_t j = 0; j < nv; ++j) usual = std::max(usual, kinds_.usual[j * m + i] * kinds_.reach[j]);
      for (std::size_t j = 0; j < nv && usual > Scalar(0); ++j) {
        scaled[j * m + i] = jacobian[j * m + i] * kinds_.reach[j] / usual;
      }
    }
    return scaled;
  }

  // Of the columns of the dependent ones, in their reaches; the others keep their place, as zeros.
  Evaluation factorise(const Jacobian& jacobian, const Choice& choice, Factor& factor) const noexcept {
    std::array<Scalar, nv * nv> unit{};
    Jacobian columns = jacobian;
    for (std::size_t j = 0; j < nv; ++j) unit[j * (nv + 1)] = Scalar(1) / (kinds_.reach[j] * kinds_.reach[j]);
    for (std::size_t k = 0; k < choice.freedoms; ++k) {
      for (std::size_t i = 0; i < m; ++i) columns[choice.independent[k] * m + i] = Scalar(0);
    }
    const Evaluation evaluation = factor.factorise(unit, columns, usual_rank_tolerance<Scalar>(), kinds_.usual);
    const bool determined = factor.rank() == static_cast<int>(nv - choice.freedoms);
    return evaluation == Evaluation::ok && !determined ? Evaluation::singular : evaluation;
  }

  const Motion& motion_;
  Kinds kinds_;
  Choice positions_, velocities_;
  typename Reading::Rows lengths_{};
  bool chosen_ = false;
  Full near_{};
  Scalar usual_share_ = Scalar(0);  ///< the largest of the motion
};

/// The end of an integration in independent coordinates.
template <class Scalar>
struct PartitionedResult {
  Result<Scalar> integration;
  std::int64_t switches = 0;  ///< how often the independent coordinates were changed
  [[nodiscard]] explicit constexpr operator bool() const noexcept { return static_cast<bool>(integration); }
};

namespace detail {

template <class System, class Method, class Observer>
[[nodiscard]] PartitionedResult<typename System::Scalar> integrate_partitioned(System system, typename System::Full& y,
                                                                               typename System::Scalar t0,
                                                                               typename System::Scalar t1,
                                                                               const Method& method,
                                                                               Observer& observer) {
  using Scalar = typename System::Scalar;
  PartitionedResult<Scalar> result;
  result.integration.time = t0;
  Statistics total;
  for (;;) {
    if (const Evaluation e = system.choose(result.integration.time, y); e != Evaluation::ok) {
      result.integration.status =
          e == Evaluation::singular ? IntegrationStatus::unsuitable_model : IntegrationStatus::model_failure;
      result.integration.evaluation = e;
      break;
    }
    auto z = system.reduce(y);
    Scalar loss = Scalar(1);
    if (const Evaluation e = system.keep(result.integration.time, z, loss); e != Evaluation::ok) {
      result.integration.status = IntegrationStatus::model_failure;
      result.integration.evaluation = e;
      break;
    }
    bool ill = false, stopped = false;
    Evaluation failure = Evaluation::ok;
    Scalar reached = result.integration.time;  // by y
    const auto watch = [&](const Scalar& t, const typename System::Vector& kept) {
      failure = system.keep(t, kept, loss);
      if (failure != Evaluation::ok) return false;
      y = system.state();
      reached = t;
      stopped = !notify(observer, t, y);
      ill = loss > System::worst;
      return !stopped && !ill;
    };
    auto run = method.start(system, z, result.integration.time);
    run.advance(t1, watch);
    result.integration = run.result();
    total += result.integration.statistics;
    if (failure != Evaluation::ok) {
      result.integration.status = IntegrationStatus::model_failure;
      result.integration.evaluation = failure;
      result.integration.time = reached;
      break;
    }
    if (!ill || stopped || result.integration.time == t1) {
      if (ill && !stopped) result.integration.status = IntegrationStatus::reached_end;
      break;
    }
    ++result.switches;
  }
  result.integration.statistics = total;
  return result;
}

}  // namespace detail

/// Integrates a mechanism with constraints in `freedoms` of its own velocities, and in all coordinates that no
/// holonomic constraint determines, from y at t0 to t1, by any method (see PartitionedMotion). Where the dependent ones
/// are determined four times less well than others would be, the independent ones are chosen anew, and so starts the
/// method. `observer(t, y)` sees all coordinates at the start and after each step. y must satisfy the constraints.
/// `unsuitable_model`: the constraints leave another number of freedoms. A motion that comes to a change point ends there by
/// `singular`, but where a step goes over it.
template <std::size_t freedoms, class Motion, class Method, class Observer = IgnoreSteps>
[[nodiscard]] PartitionedResult<ScalarOf<typename Motion::Mechanism>> integrate_partitioned(
    const Motion& motion, StateVector<typename Motion::Mechanism>& y,
    std::type_identity_t<ScalarOf<typename Motion::Mechanism>> t0,
    std::type_identity_t<ScalarOf<typename Motion::Mechanism>> t1, const Method& method,
    Observer&& observer = Observer{}) {
  using M = typename Motion::Mechanism;
  PartitionedResult<ScalarOf<M>> result;
  result.integration.time = t0;
  if (!all_finite(y) || !std::isfinite(t0)) {
    result.integration.status = IntegrationStatus::invalid_options;
    return result;
  }
  if (!notify(observer, t0, y)) {
    result.integration.status = IntegrationStatus::stopped_by_observer;
    return result;
  }
  const auto kinds = ConstraintKinds<M>::at(motion.precomputed(), t0, y);
  // Without rolling as few places as velocities serve.
  if (kinds.all_holonomic()) {
    using System = PartitionedMotion<Motion, freedoms, freedoms>;
    return detail::integrate_partitioned(System(motion, kinds), y, t0, t1, method, observer);
  }
  using System = PartitionedMotion<Motion, freedoms>;
  return detail::integrate_partitioned(System(motion, kinds), y, t0, t1, method, observer);
}

}  // namespace torsor::runtime
