// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "torsor/generator/dynamics/recursions/forward_dynamics.hpp"
#include "torsor/generator/program/program.hpp"

namespace torsor {

/// det(M s² + C s + K) of a small system, multiplied out: coefficients from that of s^{2n} down to s⁰. Its roots are
/// those of the linearised equations (Pommier, §7.3.2). M, C and K may hold symbols (about a rest: AtState). Throws
/// UsageError for shapes that do not fit.
std::vector<Value> characteristic_polynomial(Program& program, const ValueMatrix& M, const ValueMatrix& C,
                                             const ValueMatrix& K);

/// How a row of the table came about; see RouthTable.
enum class RouthRowKind { regular, zero_pivot, zero_row };

struct RouthRow {
  int power = 0;  ///< of s, of its first entry
  RouthRowKind kind = RouthRowKind::regular;
  std::vector<Value> entries;
};

/// Numbers of roots by the sign of their real parts.
struct RootCount {
  int right = 0, imaginary = 0, zero = 0, left = 0;  ///< imaginary: ± iω with ω > 0, both counted
};

/// Routh's table of a_n sⁿ + ... + a_0 in formulas (Pommier, §7.3.2, corrected: a_n > 0, third column a_{n−4}).
struct RouthTable {
  std::vector<RouthRow> rows;  ///< from sⁿ to s⁰, roots at zero divided out
  int zero_roots = 0;
  std::optional<RootCount> count;  ///< when every coefficient is a number: exact
};

/// `coefficients` from a_n down to a_0. Numbers stay exact, also √2 and √3; an entry that vanishes identically in its
/// symbols counts as zero. A row that begins with p zeros gets itself added, turned p places and times (−1)^p; a row
/// that vanishes is replaced by the derivative of the polynomial of the row above (the runtime's routh.hpp says why).
/// Numbers with a_n < 0 are all turned round. Throws UsageError when there are no coefficients or a_n vanishes.
RouthTable routh_table(Program& program, const std::vector<Value>& coefficients);

/// What must be positive for all roots to have Re < 0, multiplied out: a_n, then Hurwitz's determinants Δ_1 ... Δ_n.
/// The first column of the table is a_n, Δ_1, Δ_2/Δ_1, ..., so that it has no change of sign exactly then; determinants
/// are free of quotients. For degrees up to 8. A condition that is a positive number is left out of
/// `readable_conditions`.
std::vector<Value> hurwitz_conditions(Program& program, const std::vector<Value>& coefficients);

/// One line a condition: "7 k m - 2 P l > 0"; powers of single symbols that stand in every term are kept.
std::string readable_conditions(const std::vector<Value>& conditions);

}  // namespace torsor
