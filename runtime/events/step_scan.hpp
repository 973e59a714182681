// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "torsor/runtime/numerics/narrow_bracket.hpp"
#include "torsor/runtime/steps/step_polynomial.hpp"

namespace torsor::runtime {

/// What a guard does within a step, seen from the side of zero it was on.
template <class Scalar>
struct Departure {
  bool found = false;    ///< it goes beyond zero by more than the band
  bool finite = true;    ///< every value was a number
  Scalar before, after;  ///< neighbouring times around the crossing; equal if it was beyond zero from the start
  Scalar nearest;        ///< least value of side · g without a departure
  Scalar nearest_time;   ///< when, to some ten digits of the step
};

/// Where between two nodes the polynomial turns from falling to rising. 0: nowhere.
template <class Scalar>
[[nodiscard]] Scalar minimum_between(const StepPolynomial<Scalar>& polynomial, std::size_t left, std::size_t right) {
  const auto place = [](std::size_t node) { return static_cast<Scalar>(StepPolynomial<Scalar>::places[node]); };
  const auto fall = [&](Scalar part) { return -polynomial.slope(part); };
  Bracket<Scalar> bracket{place(left), place(right), fall(place(left)), fall(place(right))};
  if (!(bracket.value_before > Scalar(0) && bracket.value_after < Scalar(0))) return Scalar(0);
  narrow(bracket, fall);
  return bracket.before;
}

/// The same beside the least of the nodes.
template <class Scalar>
[[nodiscard]] Scalar minimum_of(const StepPolynomial<Scalar>& polynomial,
                                const typename StepPolynomial<Scalar>::Values& values) {
  using Polynomial = StepPolynomial<Scalar>;
  const auto least =
      static_cast<std::size_t>(std::min_element(values.begin(), values.begin() + Polynomial::nodes) - values.begin());
  return minimum_between(polynomial, least == 0 ? 0 : least - 1, std::min(least + 1, Polynomial::degree));
}

/// Where a guard is followed, and what is known of it.
template <class Scalar>
struct GuardOnStep {
  Scalar start, end;                               ///< in either order
  Scalar band;                                     ///< values up to it are as good as zero
  typename StepPolynomial<Scalar>::Values values;  ///< of side · g at `StepPolynomial::places` of the whole interval
};

/// Follows side · g(t) to its first value below -band, and locates the last zero before it. The interval is halved
/// until the polynomial of each part proves by its coefficients that there is no such value, or just one passage.
template <class Scalar, class Function>
[[nodiscard]] Departure<Scalar> first_departure(const Function& function, const GuardOnStep<Scalar>& guard) {
  const Scalar start = guard.start, end = guard.end, band = guard.band;
  auto values = guard.values;
  using Polynomial = StepPolynomial<Scalar>;
  constexpr Scalar epsilon = std::numeric_limits<Scalar>::epsilon();
  Departure<Scalar> result{false, true, start, start, values[0], start};
  bool seen_positive = false;
  Scalar last_positive = start, value_last_positive = Scalar(0);
  std::array<Scalar, 64> right_ends;  // of the parts still to be looked at, the next one last
  std::size_t waiting = 0;
  Scalar a = start, b = end;
  Scalar turn = start, turn_width = Scalar(0);  // a minimum, and the width of the part in which it was found
  const Scalar shortest = Scalar(16) * epsilon * std::max(std::abs(start), std::abs(end));

  const auto time_at = [&](std::size_t node) { return Polynomial::time(node, a, b); };
  // Looks through the values up to a node, which exists for most parts.
  const auto take_positive = [&](std::size_t count) {
    for (std::size_t j = 0; j < count; ++j) {
      if (values[j] > Scalar(0)) {
        seen_positive = true;
        last_positive = time_at(j);
        value_last_positive = values[j];
      }
      if (values[j] < result.nearest) {
        result.nearest = values[j];
        result.nearest_time = time_at(j);
      }
    }
  };
  const auto cross_before = [&](std::size_t node) {
    take_positive(node);
    result.found = true;
    if (!seen_positive) return;  // beyond zero from the start: crossing at the start
    Bracket<Scalar> bracket{last_positive, time_at(node), value_last_positive, values[node]};
    narrow(bracket, function);
    result.before = bracket.before;
    result.after = bracket.after;
    result.finite = std::isfinite(bracket.value_before) && std::isfinite(bracket.value_after);
  };

  for (int part = 0; part < 2048; ++part) {
    for (const Scalar& value : values) result.finite = result.finite && std::isfinite(value);
    if (!result.finite) return result;
    const Polynomial polynomial(values);
    std::size_t beyond = 0;
    while (beyond < Polynomial::nodes && !(values[beyond] < -band)) ++beyond;
    const bool shortest_part = waiting == right_ends.size() || std::abs(b - a) <= shortest;
    const bool proven = polynomial.error() <= band / Scalar(4) || polynomial.resolved();
    const bool clear = polynomial.stays_above(Scalar(1), band);
    const bool one = proven && polynomial.sign_changes(Scalar(1), band) == 1;
    // A way out and back through zero may lie between the start and the first node beyond.
    bool positive = seen_positive;
    for (std::size_t j = 0; j < beyond && j < Polynomial::nodes; ++j) positive = positive || values[j] > Scalar(0);
    // Nothing above the band up to there: it falls from the start, and where it leaves the band is not asked.
    const bool falls = proven && !positive && polynomial.stays_above(Scalar(-1), band);
    if (beyond < Polynomial::nodes && ((one && positive) || falls || shortest_part || beyond == 0)) {
      cross_before(beyond);
      return result;
    }
    if (clear || shortest_part || (proven && polynomial.sign_changes(Scalar(1), band) == 0)) {
      take_positive(Polynomial::nodes);
      if (waiting == 0) {
        if (std::abs(turn - result.nearest_time) <= Scalar(0.01) * turn_width) result.nearest_time = turn;
        return result;
      }
      a = b;
      b = right_ends[--waiting];
    } else {
      // Where a minimum lies is known best from the widest part that shows it: values of narrow ones are all rounding.
      const bool known = turn_width > Scalar(0) && std::min(a, b) <= turn && turn <= std::max(a, b);
      if (proven && !known) {
        const Scalar place = minimum_of(polynomial, values);
        if (place > Scalar(0)) {
          turn = a + place * (b - a);
          turn_width = std::abs(b - a);
        }
      }
      right_ends[waiting++] = b;
      b = a + (b - a) / Scalar(2);
    }
    for (std::size_t j = 0; j < Polynomial::samples; ++j) values[j] = function(time_at(j));
  }
  // Too many oscillations to be followed: the signs at the nodes decide.
  result.finite = false;
  return result;
}

}  // namespace torsor::runtime
