// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace torsor::contact_peers {

/// A ball dropped from 1 m that keeps 0.8 of its speed at an impact.
namespace bouncing {
constexpr double g = 9.81, restitution = 0.8, end = 3;
inline double height() {
  double t = std::sqrt(2 / g), v = g * t;
  for (v *= restitution; t + 2 * v / g <= end; v *= restitution) t += 2 * v / g;
  return (end - t) * (v - g * (end - t) / 2);
}
}  // namespace bouncing

/// A ball struck in its middle: it slides with -f g until its slip of V is used up, after 2 V/(7 f g), and rolls.
namespace billiard {
constexpr double g = 9.81, friction = 0.2, radius = 0.028575, mass = 0.17, speed = 2, end = 1;
inline double place() {
  const double slides = 2 * speed / (7 * friction * g);
  return speed * slides - friction * g * slides * slides / 2 + 5 * speed / 7 * (end - slides);
}
}  // namespace billiard

}  // namespace torsor::contact_peers
