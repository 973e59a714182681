// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

namespace torsor::runtime {

/// Two neighbouring times between which a function changes its sign, and its values there.
template <class Scalar>
struct Bracket {
  Scalar before, after;
  Scalar value_before, value_after;
};

/// Narrows a bracket of a sign change, in which the function is positive at `before` and not positive at `after` or the
/// other way round, until its ends are neighbouring numbers (or closer than epsilon² of its first width, near time 0).
/// `after` may be the smaller number. By Chandrupatla's rule: inverse quadratic interpolation where the last three
/// points admit it, bisection otherwise; the function is called some ten times, at most some hundred.
/// Source: T. R. Chandrupatla, Advances in Engineering Software 28 (1997) 145-149.
template <class Scalar, class Function>
void narrow(Bracket<Scalar>& bracket, Function&& function) {
  constexpr Scalar epsilon = std::numeric_limits<Scalar>::epsilon();
  const bool positive_before = bracket.value_before > Scalar(0);
  const Scalar floor = epsilon * epsilon * std::abs(bracket.after - bracket.before);
  Scalar a = bracket.after, fa = bracket.value_after;    // the last point
  Scalar b = bracket.before, fb = bracket.value_before;  // the other end of the bracket
  Scalar part = Scalar(0.5);
  for (int iteration = 0; iteration < 300; ++iteration) {
    const Scalar width = std::abs(b - a);
    if (std::nextafter(a, b) == b || a == b || width <= floor) break;
    // The first number strictly inside, for parts that round to an end.
    Scalar x = a + part * (b - a);
    if (!(std::min(a, b) < x && x < std::max(a, b))) {
      x = part < Scalar(0.5) ? std::nextafter(a, b) : std::nextafter(b, a);
    }
    const Scalar fx = function(x);
    Scalar c, fc;  // the point that leaves the bracket
    if ((fx > Scalar(0)) == (fa > Scalar(0))) {
      c = a;
      fc = fa;
    } else {
      c = b;
      fc = fb;
      b = a;
      fb = fa;
    }
    a = x;
    fa = fx;
    const Scalar xi = (a - b) / (c - b), phi = (fa - fb) / (fc - fb);
    const bool interpolates = phi * phi < xi && (Scalar(1) - phi) * (Scalar(1) - phi) < Scalar(1) - xi;
    part = Scalar(0.5);
    if (interpolates && fa != fb && fc != fa && fc != fb) {
      part = fa / (fb - fa) * fc / (fb - fc) + (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb);
      // A step beyond the root by some roundings brings the other end along.
      const Scalar least = Scalar(2) * epsilon * std::max(std::abs(a), std::abs(b)) / std::abs(b - a);
      part = std::isfinite(part)
                 ? std::clamp(part, std::min(least, Scalar(0.5)), Scalar(1) - std::min(least, Scalar(0.5)))
                 : Scalar(0.5);
    }
  }
  const bool a_is_before = (fa > Scalar(0)) == positive_before;
  bracket = a_is_before ? Bracket<Scalar>{a, b, fa, fb} : Bracket<Scalar>{b, a, fb, fa};
}

}  // namespace torsor::runtime
