// SPDX-License-Identifier: MIT
#include "runtime/contacts/contact_solver.hpp"

namespace torsor::runtime {

template ContactAnswer<library_room> solve_contacts(const ContactProblem<library_room>&,
                                                    const ContactSolverOptions&) noexcept;

}  // namespace torsor::runtime
