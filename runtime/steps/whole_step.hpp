// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "torsor/runtime/status.hpp"
#include "torsor/runtime/system.hpp"

namespace torsor::runtime {

/// A step that gives the state at every time from `start` to `end`: what methods with an interpolant hand to observers.
template <class Step, class Scalar, std::size_t size>
concept DenseOutput = requires(const Step& step, const Scalar& time) {
  { step.start } -> std::convertible_to<Scalar>;
  { step.end } -> std::convertible_to<Scalar>;
  { step(time) } -> std::convertible_to<std::array<Scalar, size>>;
};

/// A step whose states inside are steps of the method itself from its start, of the same order as the motion: for
/// methods without an interpolant. Each state costs one step. A model that fails gives states that are no numbers.
template <class S, class Method, class Scalar, std::size_t size>
struct RepeatedStep {
  using Vector = std::array<Scalar, size>;
  S& system;
  const Method& method;
  Scalar start, end;
  const Vector &y_start, &y_end;
  std::int64_t& calls;

  [[nodiscard]] Vector operator()(Scalar time) const {
    // Shorter than any step: the clock resolves no less.
    const Scalar resolution =
        Scalar(2) * std::numeric_limits<Scalar>::epsilon() * std::max(std::abs(start), std::abs(end));
    if (std::abs(time - start) <= resolution) return y_start;
    if (time == end) return y_end;
    Vector y = y_start;
    auto run = method.start(system, y, start);
    const IgnoreSteps ignore;
    run.advance(time, ignore);
    const Result<Scalar> result = run.result();
    calls += result.statistics.calls;
    if (!result) y.fill(std::numeric_limits<Scalar>::quiet_NaN());
    return y;
  }
};

/// A step whose states inside are put where the system says that they belong, as those at its ends are: the norm of a
/// quaternion, the closure of a loop. Without the jumps of coordinates that settling may bring. Where it fails, states
/// that are no numbers.
template <class S, class Step, class Scalar, std::size_t size>
struct SettledStep {
  S& system;
  const Step& step;
  Scalar start, end;

  [[nodiscard]] std::array<Scalar, size> operator()(Scalar time) const {
    CheckedSystem<S, Scalar, size> f(system);
    const std::array<Scalar, size> inside = step(time);
    std::array<Scalar, size> y = inside;
    if (!f.settle(time, y)) y.fill(std::numeric_limits<Scalar>::quiet_NaN());
    return f.unwound(y, inside);
  }
};

/// The cubic through the states and slopes at both ends of a step; error h⁴/384 |y⁗|.
template <class Scalar, std::size_t size>
struct HermiteStep {
  using Vector = std::array<Scalar, size>;
  Scalar start, end;
  const Vector &y_start, &y_end, &slope_start, &slope_end;

  [[nodiscard]] Vector operator()(Scalar time) const noexcept {
    const Scalar h = end - start, part = (time - start) / h, rest = Scalar(1) - part;
    Vector y;
    for (std::size_t i = 0; i < size; ++i) {
      const Scalar change = y_end[i] - y_start[i];
      y[i] = y_start[i] +
             part * (change + rest * (rest * (h * slope_start[i] - change) - part * (h * slope_end[i] - change)));
    }
    return y;
  }
};

/// The part of a step up to an event.
template <class Step, class Scalar>
struct PartOfStep {
  const Step& step;
  Scalar start, end;
  [[nodiscard]] auto operator()(Scalar time) const { return step(time); }
};

}  // namespace torsor::runtime
