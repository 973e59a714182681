// SPDX-License-Identifier: MIT
#include "torsor/runtime/contacts/impact_laws.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <span>

#include "torsor/runtime/contacts/contact_scale.hpp"
#include "torsor/runtime/contacts/contact_selection.hpp"
#include "torsor/runtime/contacts/contact_solver.hpp"
#include "torsor/runtime/contacts/energetic_impact.hpp"

namespace torsor::runtime {
namespace {

constexpr std::size_t at(int i) noexcept { return static_cast<std::size_t>(i); }

// After one solve: which contacts are left closed and sticking, the worst certificate and verdict.
bool take(const ContactAnswer& answer, const ContactProblem& solved, ImpactResult& result) noexcept {
  result.verdict = verdict_of_both(result.verdict, answer.verdict);
  if (!answer) return false;
  if (answer.verdict == ContactVerdict::several && result.found_count == 0) {
    result.found_count = answer.count;
    for (std::size_t k = 0; k < answer.count; ++k) result.found[k] = answer.solutions[k].regimes;
  }
  const ContactSolution& s = answer.best();
  result.residual = std::max(result.residual, s.residual);
  for (int i = 0; i < solved.count; ++i) {
    result.closed[at(i)] = solved.law(i).normal && s.u(solved.first_row(i)) == 0;
    result.sticks[at(i)] = s.regimes[at(i)] == ContactRegime::sticks;
  }
  return true;
}

void newton_moreau(const ContactProblem& problem, std::span<const double> restitution, ImpactResult& result) noexcept {
  ContactProblem shifted = problem;
  const auto approaches = [&](int i) { return problem.law(i).normal && problem.q(problem.first_row(i)) < 0; };
  for (int i = 0; i < problem.count; ++i) {
    if (approaches(i)) shifted.q(problem.first_row(i)) *= 1 + restitution[at(i)];
  }
  const ContactAnswer answer = solve_contacts(shifted);
  if (!take(answer, shifted, result)) return;
  result.P = answer.best().r;
  result.w = answer.best().u;
  for (int i = 0; i < problem.count; ++i) {
    if (!approaches(i)) continue;
    const int n = problem.first_row(i);
    result.w(n) -= restitution[at(i)] * problem.q(n);
    if (restitution[at(i)] > 0) result.closed[at(i)] = false;
  }
}

void poisson(const ContactProblem& problem, std::span<const double> restitution, ImpactResult& result) noexcept {
  const ContactAnswer compression = solve_contacts(problem);
  if (!take(compression, problem, result)) return;
  const ContactVector& Pc = compression.best().r;
  // P_N = e P_c + N with N >= 0, so that the disc's radius is f N + f e P_c.
  ContactProblem expansion = problem;
  ContactVector given = ContactVector::Zero(problem.rows());
  for (int i = 0; i < problem.count; ++i) {
    const int n = problem.first_row(i);
    if (problem.law(i).normal) given(n) = restitution[at(i)] * Pc(n);
  }
  if (problem.S.rows() > 0) expansion.c = problem.S * given;
  for (int i = 0; i < problem.count; ++i) {
    if (problem.law(i).bearing > 0) continue;
    expansion.laws[at(i)].bound += problem.law(i).friction * problem.pressing(i, given);
    expansion.laws[at(i)].static_bound += problem.law(i).static_friction * problem.pressing(i, given);
  }
  expansion.q = compression.best().u + problem.W * given;
  const ContactAnswer answer = solve_contacts(expansion);
  if (!take(answer, expansion, result)) return;
  result.P = Pc + given + answer.best().r;
  result.w = answer.best().u;
}

void energetic(const ContactProblem& problem, std::span<const double> restitution, ImpactResult& result) noexcept {
  result.applies = problem.count == 1 && problem.law(0).normal;
  if (!result.applies) {
    result.verdict = ContactVerdict::none;
    return;
  }
  const EnergeticImpact found = energetic_impact(problem, restitution[0]);
  if (!found.ended) {
    result.verdict = ContactVerdict::none;
    return;
  }
  result.P = found.P;
  result.w = found.w;
  result.closed[0] = found.w(0) == 0;
  result.sticks[0] = found.sticks;
}

using Order = std::span<const int>;

// The first contact in order that still closes, by more than the rounding of the terms that its velocity last was the sum of:
// collisions of three balls may be some hundred times weaker than the first one, each, and still tell what follows.
std::optional<int> next_to_close(const ContactProblem& problem, Order order, const ContactVector& terms,
                                 const ContactVector& w) noexcept {
  for (const int i : order) {
    const int n = problem.first_row(i);
    if (problem.law(i).normal && w(n) < -1e-15 * terms(n)) return i;
  }
  return std::nullopt;
}

void collide_in_turn(const ContactProblem& problem, std::span<const double> restitution, Order order,
                     ImpactResult& result) noexcept {
  const ContactVector sizes = ContactScale(problem).motions(problem.q);
  ContactVector terms = sizes;
  for (; result.collisions < 100000; ++result.collisions) {
    const std::optional<int> next = next_to_close(problem, order, terms, result.w);
    if (!next) break;
    // That contact, what resists to its rolling and spinning, and the joints.
    ContactSelection one;
    PerContact<double> e{};
    for (int i = 0; i < problem.count; ++i) {
      const ContactLaw& law = problem.law(i);
      if (i != next && law.pressed_by != next && law.bearing == 0) continue;
      if (i == next) e[at(one.problem.count)] = restitution[at(*next)];
      one.add(i, law, problem.first_row(i), problem.bearing_row(i));
    }
    one.fill(problem.W, result.w, problem.S, problem.c);
    ImpactResult alone;
    alone.verdict = ContactVerdict::unique;
    newton_moreau(one.problem, e, alone);
    result.verdict = verdict_of_both(result.verdict, alone.verdict);
    if (without_solution(alone.verdict)) return;
    const ContactVector P = one.spread(alone.P, problem.rows());
    const ContactVector change = problem.W * P;
    for (int row = 0; row < problem.rows(); ++row) {
      if (change(row) == 0) continue;
      terms(row) = std::max({std::abs(result.w(row)), std::abs(change(row)), 1e-235 * sizes(row)});
    }
    result.P += P;
    result.w += change;
    for (int i = 0; i < one.rows; ++i) result.w(one.row[at(i)]) = alone.w(i);
    result.residual = std::max(result.residual, alone.residual);
    for (int k = 0; k < one.problem.count; ++k) result.sticks[at(one.who[at(k)])] = alone.sticks[at(k)];
  }
  for (int i = 0; i < problem.count; ++i) {
    const int n = problem.first_row(i);
    const auto rests = [&](int row) { return std::abs(result.w(row)) <= 1e-15 * sizes(row); };
    result.closed[at(i)] = problem.law(i).normal && rests(n);
    // One that stuck may have got a slip by the collisions of others since.
    for (int k = 0, t = problem.tangent_row(i); k < problem.law(i).tangents; ++k) {
      result.sticks[at(i)] = result.sticks[at(i)] && rests(t + k);
    }
  }
  if (next_to_close(problem, order, terms, result.w)) result.verdict = ContactVerdict::none;  // no end of collisions
}

// Whether two orders of collisions end with velocities that are not the same.
bool differ(const ContactProblem& problem, const ImpactResult& one, const ImpactResult& other) noexcept {
  if (without_solution(one.verdict) || without_solution(other.verdict)) return one.verdict != other.verdict;
  return largest_part(one.w - other.w, ContactScale(problem).motions(problem.q)) > 1e-9;
}

// Whether more than one contact closes before the first collision.
bool several_close(const ContactProblem& problem, Order declared) noexcept {
  const ContactVector sizes = ContactScale(problem).motions(problem.q);
  const std::optional<int> first = next_to_close(problem, declared, sizes, problem.q);
  return first && next_to_close(problem, declared.subspan(at(*first) + 1), sizes, problem.q);
}

// In the order of declaration. Where a single contact closes and one collision ends it, there is no other order.
void sequential(const ContactProblem& problem, std::span<const double> restitution, ImpactResult& result) noexcept {
  constexpr int few = 4;  // contacts whose orders, 24, are all tried
  PerContact<int> places{};
  const std::span<int> order = std::span(places).first(at(problem.count));
  std::iota(order.begin(), order.end(), 0);
  const ImpactResult start = result;
  collide_in_turn(problem, restitution, order, result);
  if (without_solution(result.verdict) || (result.collisions <= 1 && !several_close(problem, order))) return;
  const auto differs = [&] {
    ImpactResult other = start;
    collide_in_turn(problem, restitution, order, other);
    return differ(problem, result, other);
  };
  if (problem.count > few) {
    std::reverse(order.begin(), order.end());
    result.order_matters = differs();
    return;
  }
  while (!result.order_matters && std::next_permutation(order.begin(), order.end())) result.order_matters = differs();
}

// T- - T+ = -P · (w- + w+)/2, known to what the solver asks of w+ = W P + w-. Bodies that do not act on each other have each
// their own: what one loses is no other's to gain.
void count_energy(const ContactProblem& problem, ImpactResult& result) noexcept {
  const ContactScale scale(problem);
  const ContactVector lost = -result.P.cwiseProduct(problem.q + result.w) / 2;
  const ContactVector terms = result.P.cwiseAbs().cwiseProduct(problem.W.cwiseAbs() * result.P.cwiseAbs() + problem.q.cwiseAbs());
  result.lost = lost.sum();
  result.gains = !(scale.sums(lost).array() >= -1e-12 * scale.sums(terms).array()).all();
}

}  // namespace

ImpactResult impact(const ContactProblem& problem, std::span<const double> restitution, ImpactLaw law) noexcept {
  ImpactResult result;
  result.P = ContactVector::Zero(problem.rows());
  result.w = problem.q;
  result.verdict = ContactVerdict::unique;
  switch (law) {
    case ImpactLaw::newton_moreau:
      newton_moreau(problem, restitution, result);
      break;
    case ImpactLaw::poisson:
      poisson(problem, restitution, result);
      break;
    case ImpactLaw::energetic:
      energetic(problem, restitution, result);
      break;
    case ImpactLaw::sequential:
      sequential(problem, restitution, result);
      break;
  }
  if (result.applies && !without_solution(result.verdict)) count_energy(problem, result);
  return result;
}

}  // namespace torsor::runtime
