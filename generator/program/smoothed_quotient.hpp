// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "torsor/generator/program/program.hpp"

namespace torsor {

/// c A N/√(k N² + R), one term of a sum: R has a part that no motion changes, the ε² of a quotient that is smooth
/// through N = 0. The product rule gives its slope as a difference, 1/√… − k N²/√…³, in which R is all that is left:
/// where N² is large beside it, it has lost its digits.
struct SmoothedQuotient {
  Monomial numerator, others;  ///< N, A
  ValueNumber root = 0;        ///< √(k N² + R)
  Value rest;                  ///< R, bound; without unit
};
std::optional<SmoothedQuotient> smoothed_quotient(Program& program, const Monomial& monomial);

/// ∂term/∂z for the value numbers z that it depends on directly, without units; of a smoothed quotient, whose z are those
/// of N and R, in the form that cancels nothing:
///   d(N/√(k N² + R)) = (R dN − N dR/2)/√(k N² + R)³.
/// A quotient by a sum of exponentials is differentiated without powers of that sum.
std::vector<std::pair<ValueNumber, Value>> partials_of_term(Program& program, const Term& term);

}  // namespace torsor
