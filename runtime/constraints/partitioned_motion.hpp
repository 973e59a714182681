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

#include "runtime/constraints/independent_constraints.hpp"
#include "runtime/mechanism.hpp"
#include "runtime/status.hpp"
#include "runtime/system.hpp"

namespace torsor::runtime {

/// Which coordinates of a mechanism with `freedoms` ways to move are taken as independent: those that elimination with
/// exchange of rows and columns leaves without a pivot, so that the others are determined well.
/// Source: Wehage & Haug, Journal of Mechanical Design 104 (1982) 247-255.
template <class Scalar, std::size_t nv, std::size_t freedoms>
struct Partition {
  static constexpr std::size_t dependents = nv - freedoms;
  std::array<std::size_t, freedoms> independent{};
  std::array<std::size_t, dependents> dependent{};
  bool complete = false;  ///< there are as many independent constraints as dependent coordinates

  /// A is m x nv, column by column.
  template <std::size_t m>
  static Partition of(const std::array<Scalar, m * nv>& jacobian) noexcept {
    auto A = jacobian;
    const auto entry = [&](std::size_t i, std::size_t j) -> Scalar& { return A[j * m + i]; };
    Partition result;
    std::array<bool, nv> taken{};
    Scalar first = Scalar(0), pivot = Scalar(0);
    for (std::size_t step = 0; step <= dependents && step < m; ++step) {
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
      if (step == dependents) break;  // what is left must be constraints that repeat others
      first = std::max(first, pivot);
      if (column == nv || !(pivot > usual_rank_tolerance<Scalar>() * first)) return result;
      taken[column] = true;
      result.dependent[step] = column;
      for (std::size_t j = 0; j < nv; ++j) std::swap(entry(row, j), entry(step, j));
      for (std::size_t i = step + 1; i < m; ++i) {
        const Scalar factor = entry(i, column) / entry(step, column);
        for (std::size_t j = 0; j < nv; ++j) entry(i, j) -= factor * entry(step, j);
      }
    }
    std::size_t count = 0;
    for (std::size_t j = 0; j < nv && count < freedoms; ++j) {
      if (!taken[j]) result.independent[count++] = j;
    }
    const bool repeated = m == dependents || pivot <= std::cbrt(std::numeric_limits<Scalar>::epsilon()) * first;
    result.complete = m >= dependents && count == freedoms && repeated;
    return result;
  }
};

/// The motion of a mechanism in independent coordinates: z = [q_I; v_I], z' = [v_I; a_I]. The others follow from the
/// constraints at every evaluation, f(q_I, q_D) = 0 by Newton's method and A_D v_D = b - A_I v_I, so that these hold to
/// rounding at all times. Only where q' = v. The partition is that of the state it was made at; see
/// `integrate_partitioned`, which changes it where it becomes ill-conditioned.
template <class Motion, std::size_t freedoms>
class PartitionedMotion {
 public:
  using M = typename Motion::Mechanism;
  using Scalar = ScalarOf<M>;
  static constexpr std::size_t nv = velocities_of<M>, m = static_cast<std::size_t>(M::multiplier_count);
  using Full = StateVector<M>;
  using Vector = std::array<Scalar, 2 * freedoms>;
  using Choice = Partition<Scalar, nv, freedoms>;
  static constexpr std::size_t nd = nv - freedoms;
  using Factor = IndependentConstraints<Scalar, nd, m>;
  static_assert(!HasCoordinateRates<M> && coordinates_of<M> == nv, "partitioned coordinates need q' = v");
  static_assert(freedoms > 0 && freedoms < nv);

  explicit PartitionedMotion(const Motion& motion) noexcept : motion_(motion) {}

  /// Chooses the independent coordinates anew at a state; `singular` when it has not as many freedoms.
  [[nodiscard]] Evaluation choose(Scalar t, const Full& y) noexcept {
    typename M::Constraints constraints{};
    M::constraints(motion_.precomputed(), unpack<M>(t, y), constraints);
    if (!all_finite(constraints.value) || !all_finite(constraints.jacobian)) return Evaluation::not_finite;
    choice_ = Choice::template of<m>(constraints.jacobian);
    near_ = y;
    return choice_.complete ? Evaluation::ok : Evaluation::singular;
  }
  [[nodiscard]] const Choice& partition() const noexcept { return choice_; }

  [[nodiscard]] Vector reduce(const Full& y) const noexcept {
    Vector z;
    for (std::size_t k = 0; k < freedoms; ++k) {
      z[k] = y[choice_.independent[k]];
      z[freedoms + k] = y[nv + choice_.independent[k]];
    }
    return z;
  }

  /// All coordinates and velocities for the independent ones, near those of the last step kept.
  [[nodiscard]] Evaluation complete(Scalar t, const Vector& z, Full& y) const noexcept {
    Factor factor;
    return complete(t, z, y, factor);
  }

  [[nodiscard]] Evaluation operator()(const Scalar& t, const Vector& z, Vector& dzdt) const noexcept {
    Full y, dydt;
    if (const Evaluation e = complete(t, z, y); e != Evaluation::ok) return e;
    const Evaluation evaluation = motion_(t, y, dydt);
    for (std::size_t k = 0; k < freedoms; ++k) {
      dzdt[k] = z[freedoms + k];
      dzdt[freedoms + k] = dydt[nv + choice_.independent[k]];
    }
    return evaluation;
  }

  /// A step was kept: its state is where the next ones look from. `loss` is how many times better, by the content of
  /// A_D, the dependent coordinates would be determined if they were chosen here.
  [[nodiscard]] Evaluation keep(Scalar t, const Vector& z, Scalar& loss) noexcept {
    Full y;
    Factor factor;
    if (const Evaluation e = complete(t, z, y, factor); e != Evaluation::ok) return e;
    near_ = y;
    typename M::Constraints constraints{};
    M::constraints(motion_.precomputed(), unpack<M>(t, y), constraints);
    const Choice best = Choice::template of<m>(constraints.jacobian);
    loss = Scalar(1);
    if (!best.complete) return Evaluation::ok;
    const Scalar content = factor.content();
    // Others that cannot be determined here are no better.
    if (factorise(constraints, best, factor) == Evaluation::ok) loss = factor.content() / content;
    return Evaluation::ok;
  }
  [[nodiscard]] const Full& state() const noexcept { return near_; }

 private:
  Evaluation complete(Scalar t, const Vector& z, Full& y, Factor& factor) const noexcept {
    y = near_;
    for (std::size_t k = 0; k < freedoms; ++k) {
      const std::size_t i = choice_.independent[k];
      y[i] = z[k];
      y[nv + i] = z[freedoms + k];
    }
    for (std::size_t i = 0; i < nd; ++i) y[nv + choice_.dependent[i]] = Scalar(0);
    typename M::Constraints constraints{};
    Scalar last = std::numeric_limits<Scalar>::infinity();
    for (int iteration = 0; iteration < 30; ++iteration) {
      M::constraints(motion_.precomputed(), unpack<M>(t, y), constraints);
      if (const Evaluation e = factorise(constraints, choice_, factor); e != Evaluation::ok) return e;
      const auto change = factor.least_change(-read(constraints.value));
      Scalar size = Scalar(0), largest = Scalar(0);
      for (std::size_t i = 0; i < nv; ++i) largest = std::max(largest, std::abs(y[i]));
      for (std::size_t i = 0; i < nd; ++i) size = std::max(size, std::abs(change(static_cast<int>(i))));
      if (!std::isfinite(size)) return Evaluation::not_finite;
      const Scalar rounding = Scalar(4) * std::numeric_limits<Scalar>::epsilon() * largest;
      // Down to rounding, or no nearer than before for it.
      if (size > rounding && size > last / Scalar(2) && size > Scalar(1e6) * rounding) return Evaluation::singular;
      if (size > last / Scalar(2)) break;
      for (std::size_t i = 0; i < nd; ++i) y[choice_.dependent[i]] += change(static_cast<int>(i));
      last = size;
      if (size <= rounding) break;
    }
    const auto velocities = factor.least_change(-read(constraints.rate));
    for (std::size_t i = 0; i < nd; ++i) y[nv + choice_.dependent[i]] = velocities(static_cast<int>(i));
    return velocities.allFinite() ? Evaluation::ok : Evaluation::not_finite;
  }

  static Evaluation factorise(const typename M::Constraints& constraints, const Choice& choice,
                              Factor& factor) noexcept {
    std::array<Scalar, nd * nd> unit{};
    std::array<Scalar, m * nd> columns;
    for (std::size_t i = 0; i < nd; ++i) {
      unit[i * (nd + 1)] = Scalar(1);
      for (std::size_t j = 0; j < m; ++j) columns[i * m + j] = constraints.jacobian[choice.dependent[i] * m + j];
    }
    const Evaluation evaluation = factor.factorise(unit, columns);
    return evaluation == Evaluation::ok && factor.rank() < static_cast<int>(nd) ? Evaluation::singular : evaluation;
  }
  static typename Factor::Residual read(const std::array<Scalar, m>& values) noexcept {
    return Eigen::Map<const typename Factor::Residual>(values.data());
  }

  const Motion& motion_;
  Choice choice_;
  Full near_{};
};

/// The end of an integration in independent coordinates.
template <class Scalar>
struct PartitionedResult {
  Result<Scalar> integration;
  std::int64_t switches = 0;  ///< how often the independent coordinates were changed
  [[nodiscard]] explicit constexpr operator bool() const noexcept { return static_cast<bool>(integration); }
};

/// Integrates a mechanism with constraints in `freedoms` of its own coordinates, from y at t0 to t1, by any method.
/// Where the dependent ones are determined `worst` times less well than others would be, the independent ones are
/// chosen anew, and so starts the method. `observer(t, y)` sees all coordinates at the start and after each step. y
/// must satisfy the constraints. `unsuitable_model`: the constraints leave another number of freedoms.
template <std::size_t freedoms, class Motion, class Method, class Observer = IgnoreSteps>
[[nodiscard]] PartitionedResult<ScalarOf<typename Motion::Mechanism>> integrate_partitioned(
    const Motion& motion, StateVector<typename Motion::Mechanism>& y,
    std::type_identity_t<ScalarOf<typename Motion::Mechanism>> t0,
    std::type_identity_t<ScalarOf<typename Motion::Mechanism>> t1, const Method& method,
    Observer&& observer = Observer{}, double worst = 4.0) {
  using System = PartitionedMotion<Motion, freedoms>;
  using Scalar = typename System::Scalar;
  System system(motion);
  PartitionedResult<Scalar> result;
  result.integration.time = t0;
  Statistics total;
  if (!all_finite(y) || !std::isfinite(t0)) {
    result.integration.status = IntegrationStatus::invalid_options;
    return result;
  }
  if (!notify(observer, t0, y)) {
    result.integration.status = IntegrationStatus::stopped_by_observer;
    return result;
  }
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
      ill = loss > static_cast<Scalar>(worst);
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

}  // namespace torsor::runtime
