// SPDX-License-Identifier: MIT
#include "torsor/runtime/contacts/slip_direction.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "torsor/runtime/contacts/contact_scale.hpp"

namespace torsor::runtime {

SlipsAcross::SlipsAcross(const ContactProblem& problem, const RegimeSystem& system, const ContactVector& motion,
                         std::span<const int> who) noexcept
    : across(static_cast<Eigen::Index>(who.size())), slopes(across.size(), across.size()), who_(who) {
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  const int count = static_cast<int>(who.size());
  for (int j = 0; j < count; ++j) {
    const ContactVector du = system.motion_by_turning(who[at(j)]);
    for (int k = 0; k < count; ++k) {
      const int t = problem.tangent_row(who[at(k)]);
      const auto& d = system.at(who[at(k)]).direction;
      across(k) = d[0] * motion(t + 1) - d[1] * motion(t);
      slopes(k, j) = d[0] * du(t + 1) - d[1] * du(t) - (j == k ? d[0] * motion(t) + d[1] * motion(t + 1) : 0);
    }
  }
}

double SlipsAcross::largest(const ContactProblem& problem, const ContactVector& sizes) const noexcept {
  ContactVector own(across.size());
  for (Eigen::Index k = 0; k < across.size(); ++k) {
    const int t = problem.tangent_row(who_[static_cast<std::size_t>(k)]);
    own(k) = std::max(sizes(t), sizes(t + 1));
  }
  return largest_part(across, own);
}

bool turn_slips(RegimeSystem::Regimes& regimes, const PerContact<int>& who, ContactVector angles, double most) noexcept {
  if (!angles.allFinite()) return false;
  const double largest = angles.cwiseAbs().maxCoeff();
  if (largest > most) angles *= most / largest;
  for (int k = 0; k < angles.size(); ++k) {
    auto& d = regimes[static_cast<std::size_t>(who[static_cast<std::size_t>(k)])].direction;
    const double c = std::cos(angles(k)), s = std::sin(angles(k));
    const double x = d[0] * c - d[1] * s, y = d[0] * s + d[1] * c, length = std::hypot(x, y);
    d = {x / length, y / length};
  }
  return true;
}

bool align_slips(const ContactProblem& problem, RegimeSystem::Regimes& regimes, const BeginningSlips& slips) noexcept {
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  PerContact<int> who{};
  int sought = 0;
  for (int i = 0; i < problem.count; ++i) {
    if (slips.begins[at(i)]) who[at(sought++)] = i;
  }
  const ContactScale scale(problem);
  double last = INFINITY;
  for (int step = 0; step < 30; ++step) {
    RegimeSystem system(problem, scale, regimes);
    if (!system.solve()) return false;
    system.approach(slips.held);
    const auto r = system.reactions();
    const ContactVector u = problem.W * r + problem.q;
    SlipsAcross here(problem, system, u, std::span(who).first(at(sought)));
    for (int k = 0; k < sought; ++k) here.across(k) -= slips.across[at(who[at(k)])];
    const double off = here.largest(problem, scale.motions(problem.W.cwiseAbs() * r.cwiseAbs() + problem.q.cwiseAbs()));
    if (off <= 1e-16 || (off <= 1e-13 && off >= last)) return true;
    last = off;
    if (!turn_slips(regimes, who, -here.slopes.partialPivLu().solve(here.across), 0.5)) return false;
  }
  return last <= 1e-9;
}

}  // namespace torsor::runtime
