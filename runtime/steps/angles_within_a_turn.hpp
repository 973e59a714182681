// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

#include "torsor/runtime/numerics/jacobian.hpp"
#include "torsor/runtime/steps/second_order.hpp"
#include "torsor/runtime/steps/taylor_step.hpp"
#include "torsor/runtime/system.hpp"

namespace torsor::runtime {

/// A system whose equations do not change when some of its angles turn by 2π: after each step these are taken back into
/// [-π, π]. An angle that winds up loses digits: after 100 turns it is known to 1e-13 rad only, and so are its sines.
///   auto within = angles_within_a_turn(motion, std::array<std::size_t, 2>{0, 1});
/// Turns taken back are lost; observers see angles within a turn at the starts of steps, and steps run on to the end
/// that the angle reached without the jump. A guard of events must take the turn for nothing (a sine, not the angle).
/// The 2π taken is that of the scalar, whose error of 2.4e-16 (double) shifts the phase once a turn.
template <class S, std::size_t count>
class AnglesWithinATurn {
 public:
  static constexpr bool second_order = is_second_order<S>;

  AnglesWithinATurn(S system, const std::array<std::size_t, count>& angles) noexcept
      : system_(std::move(system)), angles_(angles) {}

  template <class Scalar, std::size_t size>
  [[nodiscard]] auto operator()(const Scalar& t, const std::array<Scalar, size>& y,
                                std::array<Scalar, size>& dydt) const
      noexcept(noexcept(std::declval<const S&>()(t, y, dydt))) {
    return system_(t, y, dydt);
  }

  template <class Scalar, std::size_t size>
  requires HasTaylorCoefficients<const S, Scalar, size>
  [[nodiscard]] auto jets(const Scalar& t, const std::array<Scalar, size>& y,
                          std::span<std::array<Scalar, size>> c) const noexcept {
    return system_.jets(t, y, c);
  }

  template <class Scalar, std::size_t size>
  requires HasJacobian<S, Scalar, size>
  [[nodiscard]] auto jacobian(const Scalar& t, const std::array<Scalar, size>& y,
                              JacobianMatrix<Scalar, size>& J) const noexcept {
    return system_.jacobian(t, y, J);
  }

  template <class Scalar, std::size_t size>
  requires StartsFrom<S, Scalar, size>
  [[nodiscard]] Evaluation settle_start(std::array<Scalar, size>& y) const noexcept {
    return to_evaluation(system_.settle_start(y));
  }

  template <class Scalar, std::size_t size>
  [[nodiscard]] Evaluation project(const Scalar& t, std::array<Scalar, size>& y) const noexcept {
    CheckedSystem<const S, Scalar, size> system(system_);
    if (!system.settle(t, y)) return system.evaluation;
    constexpr Scalar pi = static_cast<Scalar>(3.14159265358979323846264338327950288L);
    for (const std::size_t i : angles_) {
      if (std::abs(y[i]) > pi) y[i] = std::remainder(y[i], Scalar(2) * pi);  // exact
    }
    return Evaluation::ok;
  }

  /// The state with its angles next to those before they were taken back.
  template <class Scalar, std::size_t size>
  [[nodiscard]] std::array<Scalar, size> unwound(std::array<Scalar, size> y,
                                                 const std::array<Scalar, size>& before) const noexcept {
    constexpr Scalar turn = static_cast<Scalar>(6.28318530717958647692528676655900577L);
    for (const std::size_t i : angles_) y[i] += turn * std::round((before[i] - y[i]) / turn);
    return y;
  }

  [[nodiscard]] const S& system() const noexcept { return system_; }

 private:
  S system_;
  std::array<std::size_t, count> angles_;
};

template <class S, std::size_t count>
[[nodiscard]] AnglesWithinATurn<S, count> angles_within_a_turn(S system, const std::array<std::size_t, count>& angles) {
  return AnglesWithinATurn<S, count>(std::move(system), angles);
}

/// Angles are taken back in the state's scalar; derivatives stay those of the system inside.
template <class S, std::size_t count, class Scalar>
struct PrecisionOf<AnglesWithinATurn<S, count>, Scalar> : PrecisionOf<S, Scalar> {};
template <class S, std::size_t count, class Scalar>
struct PrecisionOf<const AnglesWithinATurn<S, count>, Scalar> : PrecisionOf<S, Scalar> {};

}  // namespace torsor::runtime
