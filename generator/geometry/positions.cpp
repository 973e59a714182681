// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/geometry/positions.hpp"

namespace torsor {

LocalPosition cartesian(const Expression& x, const Expression& y, const Expression& z) {
  LocalPosition p;
  p.position = {x, y, z};
  p.base = {axis::x, axis::y, axis::z};
  for (std::size_t i = 0; i < 3; ++i) {
    p.velocity[i] = rate(p.position[i]);
    p.acceleration[i] = rate(p.velocity[i]);
  }
  return p;
}

LocalPosition cylindrical(const Expression& r, const Expression& theta, const Expression& z) {
  const Expression r1 = rate(r);
  const Expression theta1 = rate(theta);
  const Expression z1 = rate(z);
  LocalPosition p;
  p.position = {r * cos(theta), r * sin(theta), z};
  p.base = {Triple{cos(theta), sin(theta), 0}, Triple{-sin(theta), cos(theta), 0}, axis::z};
  p.velocity = {r1, r * theta1, z1};
  p.acceleration = {rate(r1) - r * pow(theta1, 2), r * rate(theta1) + 2 * r1 * theta1, rate(z1)};
  return p;
}

LocalPosition spherical(const Expression& rho, const Expression& theta, const Expression& phi) {
  const Expression rho1 = rate(rho);
  const Expression theta1 = rate(theta);
  const Expression phi1 = rate(phi);
  const Triple u{cos(theta), sin(theta), 0};
  LocalPosition p;
  p.position = {rho * sin(phi) * u[0], rho * sin(phi) * u[1], rho * cos(phi)};
  p.base = {Triple{cos(phi) * u[0], cos(phi) * u[1], -sin(phi)}, Triple{-sin(theta), cos(theta), 0},
            Triple{sin(phi) * u[0], sin(phi) * u[1], cos(phi)}};
  p.velocity = {rho * phi1, rho * sin(phi) * theta1, rho1};
  p.acceleration = {rho * rate(phi1) + 2 * rho1 * phi1 - rho * sin(phi) * cos(phi) * pow(theta1, 2),
                    rho * sin(phi) * rate(theta1) + 2 * rho1 * theta1 * sin(phi) + 2 * rho * phi1 * theta1 * cos(phi),
                    rate(rho1) - rho * pow(phi1, 2) - rho * pow(sin(phi), 2) * pow(theta1, 2)};
  return p;
}

}  // namespace torsor
