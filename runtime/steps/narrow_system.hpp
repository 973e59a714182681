// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <concepts>
#include <cstddef>
#include <span>
#include <utility>

#include "torsor/runtime/numerics/jacobian.hpp"
#include "torsor/runtime/steps/taylor_step.hpp"
#include "torsor/runtime/system.hpp"

namespace torsor::runtime {

/// A system evaluated in a narrower scalar than the state's: kernels in float, the state, its sums and the step control
/// in double. Rounding then enters with the length of a step, h |f| 6e-8, instead of with the state itself.
///   auto motion = narrow_system<float>(equations_of_motion<Mechanism<float>>());
///   std::array<double, 4> y = ...;  integrate(motion, y, 0, 10, DormandPrince54{1e-6, 1e-6});
/// Adaptive methods refuse relative tolerances below four roundings of the narrow scalar (`invalid_options`): what they
/// estimate there would be its noise.
template <std::floating_point Narrow, class S>
class NarrowSystem {
 public:
  /// What derivatives are computed in.
  using Precision = Narrow;

  explicit NarrowSystem(S system) noexcept : system_(std::move(system)) {}

  template <std::floating_point Scalar, std::size_t size>
  [[nodiscard]] Evaluation operator()(const Scalar& t, const std::array<Scalar, size>& y,
                                      std::array<Scalar, size>& dydt) const
      noexcept(noexcept(std::declval<const S&>()(Narrow(), std::declval<const std::array<Narrow, size>&>(),
                                                 std::declval<std::array<Narrow, size>&>()))) {
    std::array<Narrow, size> slope{};
    const Evaluation evaluation = to_evaluation(system_(static_cast<Narrow>(t), narrowed(y), slope));
    dydt = widened<Scalar>(slope);
    return evaluation;
  }

  template <std::floating_point Scalar, std::size_t size>
  requires HasTaylorCoefficients<const S, Narrow, size>
  [[nodiscard]] Evaluation jets(const Scalar& t, const std::array<Scalar, size>& y,
                                std::span<std::array<Scalar, size>> c) const noexcept {
    std::array<std::array<Narrow, size>, 31> narrow{};
    const Evaluation evaluation = to_evaluation(system_.jets(
        static_cast<Narrow>(t), narrowed(y), std::span<std::array<Narrow, size>>(narrow.data(), c.size())));
    for (std::size_t k = 1; k < c.size(); ++k) c[k] = widened<Scalar>(narrow[k]);
    c[0] = y;
    return evaluation;
  }

  template <std::floating_point Scalar, std::size_t size>
  requires HasJacobian<S, Narrow, size>
  [[nodiscard]] Evaluation jacobian(const Scalar& t, const std::array<Scalar, size>& y,
                                    JacobianMatrix<Scalar, size>& J) const noexcept {
    JacobianMatrix<Narrow, size> narrow{};
    const Evaluation evaluation = to_evaluation(system_.jacobian(static_cast<Narrow>(t), narrowed(y), narrow));
    J = widened<Scalar>(narrow);
    return evaluation;
  }

  template <std::floating_point Scalar, std::size_t size>
  requires StartsFrom<S, Scalar, size> || StartsFrom<S, Narrow, size>
  [[nodiscard]] Evaluation settle_start(std::array<Scalar, size>& y) const noexcept {
    if constexpr (StartsFrom<S, Scalar, size>) {
      return to_evaluation(system_.settle_start(y));
    } else {
      return changed_by(y, [this](std::array<Narrow, size>& start) { return to_evaluation(system_.settle_start(start)); });
    }
  }

  template <std::floating_point Scalar, std::size_t size>
  requires requires(const S& system, std::array<Scalar, size>& y) { system.project(y); }
  void project(std::array<Scalar, size>& y) const noexcept { system_.project(y); }

  /// A projection that takes the time is of the narrow scalar: what it changes is added to the state.
  template <std::floating_point Scalar, std::size_t size>
  requires requires(const S& system, const Narrow& t, std::array<Narrow, size>& y) { system.project(t, y); }
  [[nodiscard]] Evaluation project(const Scalar& t, std::array<Scalar, size>& y) const noexcept {
    return changed_by(y, [this, &t](std::array<Narrow, size>& state) {
      CheckedSystem<const S, Narrow, size> system(system_);
      return system.settle(static_cast<Narrow>(t), state) ? Evaluation::ok : system.evaluation;
    });
  }

 private:
  /// What a change in the narrow scalar does to the state is added to it, so that it keeps its digits.
  template <class Scalar, std::size_t size, class Change>
  [[nodiscard]] static Evaluation changed_by(std::array<Scalar, size>& y, const Change& change) noexcept {
    const std::array<Narrow, size> before = narrowed(y);
    std::array<Narrow, size> after = before;
    if (const Evaluation evaluation = change(after); evaluation != Evaluation::ok) return evaluation;
    for (std::size_t i = 0; i < size; ++i) y[i] += static_cast<Scalar>(after[i]) - static_cast<Scalar>(before[i]);
    return Evaluation::ok;
  }
  template <class Scalar, std::size_t size>
  [[nodiscard]] static std::array<Narrow, size> narrowed(const std::array<Scalar, size>& y) noexcept {
    std::array<Narrow, size> result;
    for (std::size_t i = 0; i < size; ++i) result[i] = static_cast<Narrow>(y[i]);
    return result;
  }
  template <class Scalar, std::size_t size>
  [[nodiscard]] static std::array<Scalar, size> widened(const std::array<Narrow, size>& y) noexcept {
    std::array<Scalar, size> result;
    for (std::size_t i = 0; i < size; ++i) result[i] = static_cast<Scalar>(y[i]);
    return result;
  }

  S system_;
};

template <std::floating_point Narrow, class S>
[[nodiscard]] NarrowSystem<Narrow, S> narrow_system(S system) noexcept {
  return NarrowSystem<Narrow, S>(std::move(system));
}

}  // namespace torsor::runtime
