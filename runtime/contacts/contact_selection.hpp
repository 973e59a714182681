// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>

#include "torsor/runtime/contacts/contact_problem.hpp"

namespace torsor::runtime {

/// The problem of some contacts out of many, and which contacts and rows of the many are in it.
struct ContactSelection {
  ContactProblem problem;
  PerContact<int> who{};                                   ///< each contact of the problem among the many
  std::array<int, static_cast<std::size_t>(most_rows)> row{};  ///< each row among theirs
  std::array<int, 2 * static_cast<std::size_t>(most_contacts)> bearing{};  ///< each row of reactions of joints
  int rows = 0, bearings = 0;

  /// A contact, the first of whose rows among the many is given, in their order, and that of its joint's reaction. What it
  /// is pressed by came before.
  void add(int contact, ContactLaw law, int first_row, int first_bearing = 0) noexcept {
    for (int k = 0; k < law.bearing; ++k) bearing[at(bearings++)] = first_bearing + k;
    if (law.pressed_by) law.pressed_by = place_[at(*law.pressed_by)];
    place_[at(contact)] = problem.count;
    who[at(problem.count)] = contact;
    for (int k = 0; k < law.rows(); ++k) row[at(rows++)] = first_row + k;
    problem.laws[at(problem.count++)] = law;
  }

  /// Takes W and q of the rows selected.
  template <class Square, class Right>
  void fill(const Square& W, const Right& q) noexcept {
    problem.W.resize(rows, rows);
    problem.q.resize(rows);
    for (int i = 0; i < rows; ++i) {
      problem.q(i) = q(row[at(i)]);
      for (int j = 0; j < rows; ++j) problem.W(i, j) = W(row[at(i)], row[at(j)]);
    }
  }
  /// S and c of reactions of joints too.
  template <class Square, class Right, class Bearings, class Free>
  void fill(const Square& W, const Right& q, const Bearings& S, const Free& c) noexcept {
    problem.S.resize(bearings, rows);
    problem.c.resize(bearings);
    for (int i = 0; i < bearings; ++i) {
      problem.c(i) = c(bearing[at(i)]);
      for (int j = 0; j < rows; ++j) problem.S(i, j) = S(bearing[at(i)], row[at(j)]);
    }
    fill(W, q);
  }

  /// Numbers of the rows selected among those of `count` rows, the others zero.
  [[nodiscard]] ContactVector spread(const ContactVector& some, int count) const noexcept {
    ContactVector all = ContactVector::Zero(count);
    for (int i = 0; i < rows; ++i) all(row[at(i)]) = some(i);
    return all;
  }
  /// Regimes of the problem's contacts among those of all, the others open.
  [[nodiscard]] PerContact<ContactRegime> spread(const PerContact<ContactRegime>& some) const noexcept {
    PerContact<ContactRegime> all;
    all.fill(ContactRegime::open);
    for (int k = 0; k < problem.count; ++k) all[at(who[at(k)])] = some[at(k)];
    return all;
  }
  /// Those of the rows selected.
  [[nodiscard]] ContactVector gather(const ContactVector& all) const noexcept {
    ContactVector some(rows);
    for (int i = 0; i < rows; ++i) some(i) = all(row[at(i)]);
    return some;
  }

 private:
  static constexpr std::size_t at(int i) noexcept { return static_cast<std::size_t>(i); }
  PerContact<std::optional<int>> place_{};
};

}  // namespace torsor::runtime
