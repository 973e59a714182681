// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "torsor/generator/expression/symbol.hpp"
#include "torsor/generator/printing/print_equations.hpp"
#include "torsor/generator/printing/written.hpp"

// How the parts of a formula look in each format.

namespace torsor::printing {

/// A sum on one line; "0" when there is no term.
std::string text(const Written& written);
std::string latex(const Written& written);

/// A sum broken between terms so that no line is longer than `width` where that can be helped; lines after the first
/// begin with `indent`.
std::string text_lines(const Written& written, std::size_t first_column, const std::string& indent, std::size_t width);
/// For an align environment: lines of about `width` characters of plain text, broken between terms; a term that no line
/// can hold is broken inside its parentheses, a root as a power 1/2 of them.
std::string latex_lines(const Written& written, std::size_t width);

/// theta_1' as \dot{\theta}_{1}: Greek letters by name, underscores and trailing digits as subscripts, primes as dots;
/// M[1,2], an entry of a matrix, as \mathbf{M}_{1,2}.
std::string latex_name(const std::string& name);
/// The name inside running text.
std::string latex_escaped(const std::string& text);
/// A unit as a person writes it, \mathrm{N\,m}; that of a symbol, \mathrm{rad} of an angle.
std::string latex_unit(const Unit& unit);
std::string latex_unit(const Symbol& symbol);
/// Names of the field that plain ASCII cannot spell, with their accents (UTF-8).
std::string accented(std::string sentence);

/// As a person writes it: 0.05 where the decimal ends within 24 places, else the fraction or surd.
std::string decimal_text(const Number& number);
/// The same, but a fraction stays one up to a denominator of 1000.
std::string coefficient_text(const Number& number);

}  // namespace torsor::printing
