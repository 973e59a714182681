// SPDX-License-Identifier: MIT
#include "runtime/contacts/slip_direction.hpp"

#include <Eigen/LU>
#include <cmath>
#include <cstddef>

namespace torsor::runtime {

bool align_slips(const ContactProblem& problem, RegimeSystem::Regimes& regimes, const PerContact<bool>& begins,
                 const PerContact<double>& across_wanted) noexcept {
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  PerContact<int> who{};
  int sought = 0;
  for (int i = 0; i < problem.count; ++i) {
    if (begins[at(i)]) who[at(sought++)] = i;
  }
  double last = INFINITY, size = 0;
  for (int step = 0; step < 30; ++step) {
    RegimeSystem system(problem, regimes);
    if (!system.solve() || system.kernel().cols() > 0) return false;
    const auto r = system.reactions();
    const ContactVector u = problem.W * r + problem.q;
    size = (problem.W.cwiseAbs() * r.cwiseAbs() + problem.q.cwiseAbs()).maxCoeff();
    ContactVector across(sought);
    ContactMatrix slopes(sought, sought);
    for (int j = 0; j < sought; ++j) {
      const auto du = system.motion_by_turning(who[at(j)]);
      for (int k = 0; k < sought; ++k) {
        const int t = problem.tangent_row(who[at(k)]);
        const auto& d = regimes[at(who[at(k)])].direction;
        if (j == 0) across(k) = d[0] * u(t + 1) - d[1] * u(t) - across_wanted[at(who[at(k)])];
        slopes(k, j) = d[0] * du(t + 1) - d[1] * du(t) - (j == k ? d[0] * u(t) + d[1] * u(t + 1) : 0);
      }
    }
    const double off = across.cwiseAbs().maxCoeff();
    if (off <= 1e-16 * size || (off <= 1e-13 * size && off >= last)) return true;
    last = off;
    ContactVector turn = -slopes.partialPivLu().solve(across);
    double largest = 0;
    for (int k = 0; k < sought; ++k) {
      if (!(std::abs(turn(k)) <= largest)) largest = std::abs(turn(k));  // what is no number too
    }
    if (!std::isfinite(largest)) return false;
    if (largest > 0.5) turn *= 0.5 / largest;
    for (int k = 0; k < sought; ++k) {
      auto& d = regimes[at(who[at(k)])].direction;
      const double c = std::cos(turn(k)), s = std::sin(turn(k));
      const double x = d[0] * c - d[1] * s, y = d[0] * s + d[1] * c, length = std::hypot(x, y);
      d = {x / length, y / length};
    }
  }
  return last <= 1e-9 * size;
}

}  // namespace torsor::runtime
