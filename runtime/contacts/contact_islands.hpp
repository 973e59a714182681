// SPDX-License-Identifier: MIT
#pragma once
#include "torsor/runtime/contacts/contact_solver.hpp"

namespace torsor::runtime {

/// Solves one problem from reactions that are a first guess.
using ContactSolve = ContactAnswer (*)(const ContactProblem&, const ContactVector& start, const ContactSolverOptions&);

/// Solves each group of contacts that act on each other by itself, by `solve`: whether one rests does not depend on what moves
/// elsewhere. The first solution is that of the first ones of all groups; the others differ from it in one group.
[[nodiscard]] ContactAnswer solve_islands(const ContactProblem& problem, const ContactVector& start,
                                          const ContactSolverOptions& options, ContactSolve solve) noexcept;

}  // namespace torsor::runtime
