// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "torsor/generator/printing/written.hpp"

// Parts of formulas in LaTeX, for those who put lines together.

namespace torsor::printing {

/// The factor to the power halves/2, which is positive.
std::string factor_latex(const WrittenFactor& factor, int halves);
/// A term without its sign.
std::string term_latex(const WrittenTerm& term);
/// "- ", "+ ", or "-" and nothing before the first term.
std::string sign_latex(const WrittenTerm& term, bool first);

}  // namespace torsor::printing
