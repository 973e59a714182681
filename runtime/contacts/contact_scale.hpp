// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>

#include "torsor/runtime/contacts/contact_problem.hpp"

namespace torsor::runtime {

/// The power of two near sqrt(W_ii), the unit of a row: u over it and r times it are alike in every row, whatever its
/// mass and whether it is of a force or of a torque, and W over the units of its rows has about 1 in its diagonal. 1 where
/// W_ii is zero.
[[nodiscard]] double unit_of_row(double own) noexcept;
/// The same of a row of friction, of whose contact the normal row has W_nn = `normal`; 0: it has none. A row may vanish beside
/// that one: what touches moves along the normal only, whatever its velocities, as where a line comes over the pivots of both
/// bodies. What is left of such a row is rounding, and its unit that of the normal row: in its own one rounding would be as large
/// as forces and velocities are. A part ε of a row is ε² in W: there rounding is some 10⁻³⁰, while masses may be 10²⁰ apart.
[[nodiscard]] double unit_of_row(double own, double normal) noexcept;

/// What is small in a problem. Bodies of masses far apart have forces far apart: what rounds one of them may be all of
/// another. So sizes are those of a group, of rows that act on each other directly or through others, in the unit of each row.
class ContactScale {
 public:
  explicit ContactScale(const ContactProblem& problem) noexcept;

  [[nodiscard]] double unit(int row) const noexcept { return units_(row); }
  /// One of the rows of its group, the same for all of them.
  [[nodiscard]] int group(Eigen::Index row) const noexcept { return group_[static_cast<std::size_t>(row)]; }
  /// For each row, the largest of these forces in its group.
  [[nodiscard]] ContactVector forces(const ContactVector& r) const noexcept {
    return largest(r.cwiseProduct(units_)).cwiseQuotient(units_);
  }
  /// For each row, the largest of these motions in its group.
  [[nodiscard]] ContactVector motions(const ContactVector& u) const noexcept {
    return largest(u.cwiseQuotient(units_)).cwiseProduct(units_);
  }

  /// For each row, the sum over the rows of its group.
  [[nodiscard]] ContactVector sums(const ContactVector& parts) const noexcept;

 private:
  static std::size_t as(int i) noexcept { return static_cast<std::size_t>(i); }
  void join(int row, int other) noexcept;
  [[nodiscard]] ContactVector largest(const ContactVector& sizes) const noexcept;

  ContactVector units_;
  std::array<int, static_cast<std::size_t>(most_rows)> group_{};
};

/// Size of a vector's direction among the rows first, first + 1, ... that it has, of the sizes of all rows.
[[nodiscard]] double size_along(const ContactVector& sizes, const ContactVector& all, int first, int count) noexcept;

/// The largest of parts over wholes; what is a part of nothing is endless.
[[nodiscard]] double largest_part(const ContactVector& parts, const ContactVector& wholes) noexcept;

}  // namespace torsor::runtime
