// SPDX-License-Identifier: GPL-3.0-or-later
// The program of someone who integrates a motion of his own by CVODE.
#include "torsor/runtime/sundials/sundials.hpp"

#include <array>
#include <cmath>

int main() {
  const auto decay = [](double, const std::array<double, 1>& y, std::array<double, 1>& rate) {
    rate[0] = -y[0];
    return torsor::runtime::Evaluation::ok;
  };
  std::array<double, 1> y{1.0};
  const auto result = torsor::runtime::integrate(decay, y, 0.0, 1.0, torsor::runtime::Cvode{});
  return result && std::abs(y[0] - std::exp(-1.0)) < 1e-6 ? 0 : 1;
}
