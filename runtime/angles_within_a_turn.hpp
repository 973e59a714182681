// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

#include "runtime/system.hpp"
#include "runtime/taylor_step.hpp"

namespace torsor::runtime {

/// A system whose equations do not change when some of its angles turn by 2π: after each step these are taken back into
/// [-π, π]. An angle that winds up loses digits: after 100 turns it is known to 1e-13 rad only, and so are its sines.
///   auto within = angles_within_a_turn(motion, std::array<std::size_t, 2>{0, 1});
/// Turns taken back are lost; observers see angles within a turn at the ends of steps. Inside a step that ends with such
/// a jump the interpolants of Runge-Kutta and Radau methods run through it: only Taylor's may be asked there for angles
/// or events of angles. The 2π taken is that of the
/// scalar, whose error of 2.4e-16 (double) shifts the phase once a turn.
template <class S, std::size_t count>
class AnglesWithinATurn {
 public:
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
  [[nodiscard]] Evaluation project(const Scalar& t, std::array<Scalar, size>& y) const noexcept {
    CheckedSystem<const S, Scalar, size> system(system_);
    if (!system.settle(t, y)) return system.evaluation;
    constexpr Scalar pi = static_cast<Scalar>(3.14159265358979323846264338327950288L);
    for (const std::size_t i : angles_) {
      if (std::abs(y[i]) > pi) y[i] = std::remainder(y[i], Scalar(2) * pi);  // exact
    }
    return Evaluation::ok;
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

}  // namespace torsor::runtime
