// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>

#include "torsor/runtime/numerics/narrow_bracket.hpp"

namespace torsor::runtime {

/// A time and the state at it.
template <class Scalar, std::size_t size>
struct Located {
  Scalar time;
  std::array<Scalar, size> y;
  bool crosses = true;  ///< false where the guard does not cross near the time given: the interpolant is wrong there
};

/// Where a guard falls through zero near a time, which an interpolant gave, on steps of the method itself: the last time
/// before, or the first one after.
template <class Step, class Guard, class Scalar>
[[nodiscard]] auto locate_near(const Step& step, const Guard& guard, Scalar time, bool stay_before)
    -> Located<Scalar, std::tuple_size_v<typename Step::Vector>> {
  const Scalar h = step.end - step.start;
  const auto [least, most] = std::minmax(step.start, step.end);
  for (Scalar reach = Scalar(1e-8); reach < Scalar(5); reach *= Scalar(10)) {
    Bracket<Scalar> bracket{std::clamp(time - reach * h, least, most), std::clamp(time + reach * h, least, most), Scalar(0),
                            Scalar(0)};
    bracket.value_before = guard(bracket.before);
    bracket.value_after = guard(bracket.after);
    if (!(bracket.value_before > Scalar(0) && bracket.value_after <= Scalar(0))) continue;
    narrow(bracket, guard);
    const Scalar found = stay_before ? bracket.before : bracket.after;
    return {found, step(found)};
  }
  return {time, step(time), false};
}

}  // namespace torsor::runtime
