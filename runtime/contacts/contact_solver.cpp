// SPDX-License-Identifier: MIT
#include "torsor/runtime/contacts/contact_solver.hpp"

#include <algorithm>

#include "torsor/runtime/contacts/contact_islands.hpp"
#include "torsor/runtime/contacts/contact_iteration.hpp"
#include "torsor/runtime/contacts/regime_enumeration.hpp"

namespace torsor::runtime {
namespace {

// Whether every motion has one of the regimes that are tried one by one: where no direction is sought, which Newton's method
// may miss. Sweeps propose nothing else.
bool tries_all(const ContactProblem& problem) noexcept {
  for (int i = 0; i < problem.count; ++i) {
    const ContactLaw& law = problem.law(i);
    if (law.bearing > 0 || (law.tangents == 2 && law.rubs() && !law.slips)) return false;
  }
  return true;
}

// Contacts that act on each other, from no reactions: no start has a say.
ContactAnswer solve_island(const ContactProblem& problem, const ContactVector&, const ContactSolverOptions& options) noexcept {
  const ContactVector none = ContactVector::Zero(problem.rows());
  if (problem.count > options.enumerated) return ContactIteration(problem, none, options).solve();
  ContactAnswer answer = RegimeEnumeration(problem).run();
  if (answer || tries_all(problem)) return answer;
  answer = iterate_contacts(problem, none, options);
  // Where many slips begin together more starts take seconds.
  const bool few = problem.count <= std::min(options.enumerated, 4);
  return answer || !few ? answer : RegimeEnumeration(problem).run(true);
}

ContactAnswer go_on_with_island(const ContactProblem& problem, const ContactVector& start,
                                const ContactSolverOptions& options) noexcept {
  if (problem.count > options.enumerated) return iterate_contacts(problem, start, options);
  // Sweeps may take thousands to settle, or go round for ever, where to try all regimes takes as long as some ten.
  RegimeEnumeration regimes(problem);
  const bool few = tries_all(problem) && regimes.combinations() <= 256;
  if (few && ContactIteration(problem, start, options).holds(regimes)) return regimes.finish();
  ContactSolverOptions short_options = options;
  short_options.attempts = std::min(options.attempts, 4);
  const ContactAnswer answer = few ? ContactAnswer{} : iterate_contacts(problem, start, short_options);
  return answer ? answer : solve_island(problem, start, options);
}

}  // namespace

ContactAnswer iterate_contacts(const ContactProblem& problem, const ContactVector& start,
                               const ContactSolverOptions& options) noexcept {
  return ContactIteration(problem, start, options).run();
}

ContactAnswer go_on_contacts(const ContactProblem& problem, const ContactVector& start,
                             const ContactSolverOptions& options) noexcept {
  return problem.count > options.enumerated ? solve_islands(problem, start, options, go_on_with_island)
                                            : go_on_with_island(problem, start, options);
}

ContactAnswer solve_contacts(const ContactProblem& problem, const ContactSolverOptions& options) noexcept {
  const ContactVector none = ContactVector::Zero(problem.rows());
  return problem.count > options.enumerated ? solve_islands(problem, none, options, solve_island)
                                            : solve_island(problem, none, options);
}

}  // namespace torsor::runtime
