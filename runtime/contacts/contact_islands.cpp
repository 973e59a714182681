// SPDX-License-Identifier: MIT
#include "torsor/runtime/contacts/contact_islands.hpp"

#include <algorithm>
#include <cstddef>

#include "torsor/runtime/contacts/contact_scale.hpp"
#include "torsor/runtime/contacts/contact_selection.hpp"

namespace torsor::runtime {
namespace {

constexpr std::size_t place(int i) noexcept { return static_cast<std::size_t>(i); }

ContactSelection select(const ContactProblem& problem, const ContactScale& scale, int island) noexcept {
  ContactSelection part;
  for (int i = 0; i < problem.count; ++i) {
    if (problem.law(i).rows() == 0 || scale.group(problem.first_row(i)) != island) continue;
    part.add(i, problem.law(i), problem.first_row(i), problem.bearing_row(i));
  }
  part.fill(problem.W, problem.q, problem.S, problem.c);
  if (problem.noise.size() > 0) part.problem.noise = part.gather(problem.noise);
  return part;
}

// Puts what was found of some contacts in place.
void put(const ContactSelection& part, const ContactSolution& found, ContactSolution& all) noexcept {
  for (int k = 0; k < part.rows; ++k) {
    all.r(part.row[place(k)]) = found.r(k);
    all.u(part.row[place(k)]) = found.u(k);
  }
  for (int k = 0; k < part.problem.count; ++k) all.regimes[place(part.who[place(k)])] = found.regimes[place(k)];
  all.indeterminate = all.indeterminate || found.indeterminate;
  all.moves = all.moves || found.moves;
}

void join(const ContactSelection& part, const ContactAnswer& found, ContactAnswer& all) noexcept {
  const ContactSolution before = all.solutions[0];
  for (std::size_t j = 0; j < all.count; ++j) put(part, found.best(), all.solutions[j]);
  for (std::size_t j = 1; j < found.count && all.count < ContactAnswer::kept; ++j) {
    ContactSolution& other = all.solutions[all.count++];
    other = before;
    put(part, found.solutions[j], other);
  }
  all.verdict = verdict_of_both(all.verdict, found.verdict);
}

}  // namespace

ContactAnswer solve_islands(const ContactProblem& problem, const ContactVector& start, const ContactSolverOptions& options,
                            ContactSolve solve) noexcept {
  const ContactScale scale(problem);
  const int rows = problem.rows();
  bool one = true;
  for (int row = 1; row < rows; ++row) one = one && scale.group(row) == scale.group(0);
  if (one) return solve(problem, start, options);
  ContactAnswer all;
  all.count = 1;
  all.verdict = ContactVerdict::unique;
  all.solutions[0].r = all.solutions[0].u = ContactVector::Zero(rows);
  for (int row = 0; row < rows; ++row) {
    if (scale.group(row) != row) continue;
    const ContactSelection part = select(problem, scale, row);
    const ContactAnswer found = solve(part.problem, part.gather(start), options);
    if (!found) return found;
    join(part, found, all);
  }
  for (std::size_t j = 0; j < all.count; ++j) all.solutions[j].residual = natural_map_residual(problem, all.solutions[j]);
  return all;
}

}  // namespace torsor::runtime
