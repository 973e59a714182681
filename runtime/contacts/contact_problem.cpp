// SPDX-License-Identifier: MIT
#include "torsor/runtime/contacts/contact_problem.hpp"

#include <algorithm>
#include <cmath>

#include "torsor/runtime/contacts/contact_scale.hpp"

namespace torsor::runtime {
namespace detail {

template <int most>
void library_has_room_for_contacts() noexcept {}

template void library_has_room_for_contacts<most_contacts>() noexcept;

}  // namespace detail

double natural_map_residual(const ContactProblem& problem, const ContactSolution& s) noexcept {
  ContactVector defect = ContactVector::Zero(problem.rows()), size = defect;
  for (int i = 0; i < problem.count; ++i) {
    const ContactLaw& law = problem.law(i);
    const int n = problem.first_row(i), t = problem.tangent_row(i);
    const double N = problem.pressing(i, s.r);
    const auto rate = [&](int row) { return problem.W(row, row) > 0 ? 1 / problem.W(row, row) : 1.0; };
    if (law.normal) {
      const double rho = rate(n);
      defect(n) = N - std::max(0.0, N - rho * s.u(n));
      size(n) = std::abs(N) + rho * std::abs(s.u(n));
    }
    const bool sticks = s.regimes[static_cast<std::size_t>(i)] == ContactRegime::sticks;
    const double radius =
        std::max(0.0, sticks ? law.static_friction * N + law.static_bound : law.friction * N + law.bound);
    if (law.tangents == 0) continue;
    double rho = rate(t);
    if (law.tangents == 2) rho = std::min(rho, rate(t + 1));
    double length = 0;
    for (int k = 0; k < law.tangents; ++k) length = std::hypot(length, s.r(t + k) - rho * s.u(t + k));
    for (int k = 0; k < law.tangents; ++k) {
      const double trial = s.r(t + k) - rho * s.u(t + k);
      const double given = -radius * law.slip[static_cast<std::size_t>(k)];
      const double shrunk = length > radius ? radius / length * trial : trial;
      defect(t) = std::hypot(defect(t), s.r(t + k) - (law.slips ? given : shrunk));
      size(t + k) = std::abs(s.r(t + k)) + (law.slips ? 0 : rho * std::abs(s.u(t + k)));
    }
  }
  return largest_part(defect, ContactScale(problem).forces(size));
}

}  // namespace torsor::runtime
