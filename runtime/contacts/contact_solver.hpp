// SPDX-License-Identifier: MIT
#pragma once
#include "torsor/runtime/contacts/contact_problem.hpp"

namespace torsor::runtime {

/// How the problem of one instant is solved.
struct ContactSolverOptions {
  int enumerated = 6;  ///< up to so many contacts every regime is tried, and the verdict is complete
  int sweeps = 200;    ///< of Gauss and Seidel between attempts of Newton's method
  int attempts = 40;
};

/// Solves a problem: by trying every regime up to `options.enumerated` contacts, by iteration where none of them fits. Of more
/// contacts each group that acts on itself alone is solved by itself. Beyond that number rest comes first, where reactions exist
/// that hold it, and one motion is looked for; the verdict does not depend on the order of contacts.
[[nodiscard]] ContactAnswer solve_contacts(const ContactProblem& problem,
                                           const ContactSolverOptions& options = {}) noexcept;

/// Finds one solution of any number of contacts from reactions of an earlier instant: what held then, or rest, or what sweeps of
/// Gauss and Seidel, each contact solved exactly with the others held, propose. The equations of regimes are solved by Newton's
/// method (the semismooth Newton method of Alart and Curnier), and their inequalities decide. Its verdict says
/// `not_examined` or `indeterminate` of what it found, since it did not look for other motions, and `not_found` where it found none.
[[nodiscard]] ContactAnswer iterate_contacts(const ContactProblem& problem, const ContactVector& start,
                                             const ContactSolverOptions& options = {}) noexcept;

/// The same from reactions of an earlier instant, in whichever way is shortest: what held then, all regimes where they are few,
/// sweeps, and all regimes where those find nothing.
[[nodiscard]] ContactAnswer go_on_contacts(const ContactProblem& problem, const ContactVector& start,
                                           const ContactSolverOptions& options = {}) noexcept;

}  // namespace torsor::runtime
