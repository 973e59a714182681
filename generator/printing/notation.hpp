// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

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
struct BrokenLines {
  std::string latex;
  double last = 0;  ///< how far the last line goes
};
/// For an align environment: lines of about `width` points of 10-point letters, broken between terms; a term that no line
/// can hold is broken inside its parentheses, a root as a power 1/2 of them.
BrokenLines latex_lines(const Written& written, double width);
/// left &= right in such lines: the right side begins on the last line of the left one where it has room there.
std::string latex_equation(const Written& left, const Written& right, double width);

/// theta_1' as \dot{\theta}_{1}: Greek letters by name, underscores and trailing digits as subscripts, primes as dots;
/// M[1,2], an entry of a matrix, as \mathbf{M}_{1,2}.
std::string latex_name(const std::string& name);
/// The name inside running text.
std::string latex_escaped(const std::string& text);
/// What was escaped so.
std::string latex_unescaped(std::string_view text);
/// A unit as a person writes it, \mathrm{N\,m}; that of a symbol, \mathrm{rad} of an angle.
std::string latex_unit(const Unit& unit);
std::string latex_unit(const Symbol& symbol);
/// Names of the field that plain ASCII cannot spell, with their accents (UTF-8).
std::string accented(std::string sentence);

/// As a person writes it: 0.05 where the decimal ends within 24 places, else the fraction or surd. A fraction of more than
/// 17 digits is cut after as many as a double has: 0.96802767481536424...
std::string decimal_text(const Number& number);
/// Such a decimal of a rational number in LaTeX.
std::string dots_in_latex(const std::string& decimal);
/// The value of a parameter: a decimal; with a power of ten where that has many zeros, 5e-9 or 5 \cdot 10^{-9}.
std::string value_text(const Number& number);
std::string value_latex(const Number& number);
/// Whether a decimal is read sooner than a fraction: 0.01 and 0.0005, but 1/2, 3/80 and 1/12. Hundredths, thousandths and
/// what is finer are written alike. So is a fraction of more than 17 digits.
bool is_read_as_decimal(const cln::cl_RA& number);
/// A number before a formula: a fraction unless it is read as a decimal, where that ends.
std::string coefficient_text(const Number& number);

}  // namespace torsor::printing
