// SPDX-License-Identifier: GPL-3.0-or-later
#include "work_precision_hoop.hpp"

#include <cmath>

#include "benchmarks/work_precision/ways.hpp"

namespace work_precision {
namespace {

using Hoop = work_precision_hoop::Mechanism<double>;

// From the centre's x, y, the angles psi, theta, phi and their rates: the contact's x, y, heading, lean, roll, and the
// angular velocities about the horizontal diameter, the other one, and the axis.
std::array<double, 8> contact_and_rotation(const std::array<double, 10>& y) {
  const double r = 0.5, psi = y[2], theta = y[3];
  return {y[0] + r * std::cos(theta) * std::sin(psi),
          y[1] - r * std::cos(theta) * std::cos(psi),
          psi,
          theta,
          y[4],
          y[8],
          y[7] * std::sin(theta),
          y[9] + y[7] * std::cos(theta)};
}

}  // namespace

Problem hoop() {
  const auto start = torsor::runtime::pack<Hoop>(Hoop::initial_state());
  const Case<Hoop, 8> motion{
      start,
      20,
      {1.517245501846176454418182552180e+00, 2.430335916513561688873236431743e-01, 1.289240563714880452852238863805e+01,
       1.198036500879284288077977611736e+00, -1.24822830259631902901322118097e+02, 4.940484549289880164914979029665e-02,
       5.239549401600928046307087132991e-01, -6.00050263180823492805499046475e+00},
      contact_and_rotation,
      4.905};
  return {"hoop", "hoop rolling at 6 rad/s, leaning 1.2, 20 s", all_ways(motion)};
}

}  // namespace work_precision
