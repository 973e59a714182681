// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>

#include "runtime/contacts/contact_solver.hpp"

namespace torsor::runtime {

/// How the velocity after an impact follows from that before; w+ = w- + W P, friction by Coulomb's disc on impulses.
enum class ImpactLaw {
  newton_moreau,  ///< all contacts at once: 0 <= w_N+ + e w_N-, P_N >= 0, one of them zero
  poisson,        ///< compression to w_N = 0 with the impulse P_c, then P_N >= e P_c of restitution
  sequential,     ///< one contact after the other by Newton's law, in the order of declaration, until none closes
};

[[nodiscard]] constexpr std::string_view describe(ImpactLaw law) noexcept {
  switch (law) {
    case ImpactLaw::newton_moreau:
      return "Newton-Moreau";
    case ImpactLaw::poisson:
      return "Poisson";
    case ImpactLaw::sequential:
      return "sequential";
  }
  return "unknown impact law";
}

/// The impulses of an impact and what is known of them.
template <int most>
struct ImpactResult {
  typename ContactProblem<most>::Vector P, w;                 ///< impulses and velocities after
  std::array<bool, static_cast<std::size_t>(most)> closed{};  ///< w_N = 0 after
  std::array<bool, static_cast<std::size_t>(most)> sticks{};  ///< w_T = 0 after
  ContactVerdict verdict = ContactVerdict::none;
  double residual = 0;
  int collisions = 0;  ///< of the sequential law
};

/// Solves an impact. `problem` holds W, the laws with f, and in q the velocities w-; e is the restitution of each
/// contact. Sources: Moreau 1988; Glocker & Pfeiffer 1995 (Poisson); Pommier §7.6 (percussions).
template <int most>
[[nodiscard]] ImpactResult<most> impact(const ContactProblem<most>& problem,
                                        const std::array<double, static_cast<std::size_t>(most)>& restitution,
                                        ImpactLaw law = ImpactLaw::newton_moreau) noexcept {
  using Vector = typename ContactProblem<most>::Vector;
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  ImpactResult<most> result;
  result.P = Vector::Zero(problem.rows());
  result.w = problem.q;
  // After one solve: which contacts are left closed and sticking, the worst certificate and verdict.
  const auto take = [&](const ContactAnswer<most>& answer, const ContactProblem<most>& solved) {
    result.verdict = std::max(result.verdict, answer.verdict);
    if (!answer) return false;
    const ContactSolution<most>& s = answer.best();
    result.residual = std::max(result.residual, s.residual);
    for (int i = 0; i < solved.count; ++i) {
      const int n = solved.first_row(i);
      result.closed[at(i)] = solved.law(i).normal && s.u(n) == 0;
      result.sticks[at(i)] = s.regimes[at(i)] == ContactRegime::sticks;
    }
    return true;
  };
  if (law == ImpactLaw::newton_moreau) {
    ContactProblem<most> shifted = problem;
    for (int i = 0; i < problem.count; ++i) {
      const int n = problem.first_row(i);
      if (problem.law(i).normal && problem.q(n) < 0) shifted.q(n) *= 1 + restitution[at(i)];
    }
    result.verdict = ContactVerdict::unique;
    const ContactAnswer<most> answer = solve_contacts(shifted);
    if (!take(answer, shifted)) return result;
    result.P = answer.best().r;
    result.w = answer.best().u;
    for (int i = 0; i < problem.count; ++i) {
      const int n = problem.first_row(i);
      if (!problem.law(i).normal || !(problem.q(n) < 0)) continue;
      result.w(n) -= restitution[at(i)] * problem.q(n);
      if (restitution[at(i)] > 0) result.closed[at(i)] = false;
    }
    return result;
  }
  if (law == ImpactLaw::poisson) {
    result.verdict = ContactVerdict::unique;
    const ContactAnswer<most> compression = solve_contacts(problem);
    if (!take(compression, problem)) return result;
    const Vector& Pc = compression.best().r;
    // P_N = e P_c + N with N >= 0, so that the disc's radius is f N + f e P_c.
    ContactProblem<most> expansion = problem;
    Vector given = Vector::Zero(problem.rows());
    for (int i = 0; i < problem.count; ++i) {
      const int n = problem.first_row(i);
      if (problem.law(i).normal) given(n) = restitution[at(i)] * Pc(n);
      expansion.laws[at(i)].bound += problem.law(i).friction * problem.pressing(i, given);
      expansion.laws[at(i)].static_bound += problem.law(i).static_friction * problem.pressing(i, given);
    }
    expansion.q = compression.best().u + problem.W * given;
    const ContactAnswer<most> answer = solve_contacts(expansion);
    if (!take(answer, expansion)) return result;
    result.P = Pc + given + answer.best().r;
    result.w = answer.best().u;
    return result;
  }
  result.verdict = ContactVerdict::unique;
  for (; result.collisions < 100000; ++result.collisions) {
    int next = -1;
    for (int i = 0; next < 0 && i < problem.count; ++i) {
      const int n = problem.first_row(i);
      const double size = problem.q.cwiseAbs().maxCoeff();
      if (problem.law(i).normal && result.w(n) < -1e-15 * size) next = i;
    }
    if (next < 0) break;
    // That contact, and what resists to its rolling and spinning.
    ContactProblem<most> one;
    std::array<int, static_cast<std::size_t>(most)> who{};
    std::array<int, static_cast<std::size_t>(3 * most)> row{};
    int rows = 0;
    for (int i = next; i < problem.count; ++i) {
      if (i != next && problem.law(i).pressed_by != next) continue;
      for (int k = 0; k < problem.law(i).rows(); ++k) row[at(rows++)] = problem.first_row(i) + k;
      who[at(one.count)] = i;
      one.laws[at(one.count)] = problem.law(i);
      if (i != next) one.laws[at(one.count)].pressed_by = 0;
      ++one.count;
    }
    one.W.resize(rows, rows);
    one.q.resize(rows);
    for (int i = 0; i < rows; ++i) {
      one.q(i) = result.w(row[at(i)]);
      for (int j = 0; j < rows; ++j) one.W(i, j) = problem.W(row[at(i)], row[at(j)]);
    }
    std::array<double, static_cast<std::size_t>(most)> e{};
    e[0] = restitution[at(next)];
    const ImpactResult<most> alone = impact<most>(one, e);
    if (alone.verdict == ContactVerdict::none) {
      result.verdict = ContactVerdict::none;
      return result;
    }
    for (int i = 0; i < rows; ++i) {
      result.P(row[at(i)]) += alone.P(i);
      result.w += problem.W.col(row[at(i)]) * alone.P(i);
    }
    for (int i = 0; i < rows; ++i) result.w(row[at(i)]) = alone.w(i);
    result.residual = std::max(result.residual, alone.residual);
    for (int k = 0; k < one.count; ++k) result.sticks[at(who[at(k)])] = alone.sticks[at(k)];
  }
  for (int i = 0; i < problem.count; ++i) {
    result.closed[at(i)] = problem.law(i).normal && std::abs(result.w(problem.first_row(i))) <= 1e-15;
  }
  return result;
}

}  // namespace torsor::runtime
