// SPDX-License-Identifier: MIT
#pragma once
#include <iosfwd>
#include <span>
#include <string>
#include <vector>

namespace torsor::runtime {

/// How a row of Routh's table came about.
enum class RouthRow {
  regular,     ///< from the two rows above
  zero_pivot,  ///< began with p zeros: itself turned p places to the left, times (−1)^p, was added to it
  zero_row,    ///< vanished: the derivative of the polynomial of the row above takes its place
};

/// Routh's table of a_n sⁿ + ... + a_0 and the count of its roots.
struct RouthTable {
  struct Row {
    int power = 0;  ///< of s, of the row's first entry
    RouthRow kind = RouthRow::regular;
    std::vector<double> entries;  ///< after the replacement, if there was one
  };
  std::vector<Row> rows;  ///< from sⁿ down to s⁰, roots at zero divided out
  int right = 0;          ///< roots with Re > 0: changes of sign in the first column
  int imaginary = 0;      ///< roots ± iω, ω > 0, counted with multiplicity: an even number
  int zero = 0;           ///< roots s = 0
  int left = 0;           ///< roots with Re < 0

  /// Whether all roots have Re < 0.
  [[nodiscard]] bool stable() const noexcept { return right == 0 && imaginary == 0 && zero == 0; }
};

/// Routh's table (Pommier, §7.3.2, corrected): coefficients from a_n down to a_0, premise a_n > 0 (all signs are turned
/// round otherwise). Row one is a_n, a_{n−2}, a_{n−4}, ..., row two a_{n−1}, a_{n−3}, ..., and then, r above and p the
/// row next above, entry j is r_{j+1} − (r_0/p_0) p_{j+1}.
///
/// A row that begins with p zeros is no end: adding it turned p places to the left, times (−1)^p, multiplies it on the
/// imaginary axis by the positive number 1 + ω^{2p}, which changes no count (Benidir & Picinbono, Extended table for
/// eliminating the singularities in Routh's array, IEEE Trans. Autom. Control 35 (1990)). A vanishing row shows a
/// factor that is even in s, the row above it; its derivative takes the place, and the changes of sign from there on
/// are the factor's roots with Re > 0, as many as it has with Re < 0; the others are imaginary (Gantmacher, Theory of
/// matrices II, XV §4).
///
/// An entry counts as zero when it is below its uncertainty: that of each coefficient (`uncertainties`, absolute; one
/// rounding when none are given) carried through the table to first order, with the roundings of the table itself.
/// Throws std::invalid_argument when a coefficient is not finite, a_n vanishes, or the sizes differ.
[[nodiscard]] RouthTable routh_table(std::span<const double> coefficients, std::span<const double> uncertainties = {});

/// The table as a person writes it, with what was done to a row that could not stand.
std::ostream& operator<<(std::ostream& stream, const RouthTable& table);

}  // namespace torsor::runtime
