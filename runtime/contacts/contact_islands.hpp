// SPDX-License-Identifier: MIT
#pragma once
#include "torsor/runtime/contacts/contact_solver.hpp"

namespace torsor::runtime {

/// Solves each group of contacts that act on each other by itself, by `solve`: whether one rests does not depend on what moves
/// elsewhere. The first solution is that of the first ones of all groups; the others differ from it in one group.
[[nodiscard]] ContactAnswer solve_islands(const ContactProblem& problem, const ContactSolverOptions& options,
                                          ContactAnswer (*solve)(const ContactProblem&, const ContactSolverOptions&)) noexcept;

}  // namespace torsor::runtime
