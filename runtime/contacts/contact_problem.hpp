// SPDX-License-Identifier: MIT
#pragma once
#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>

#include "torsor/runtime/library.hpp"

namespace torsor::runtime {

/// What a contact does. Without friction a closed contact slides.
enum class ContactRegime : unsigned char { open, sticks, slides };

[[nodiscard]] constexpr std::string_view describe(ContactRegime regime) noexcept {
  switch (regime) {
    case ContactRegime::open:
      return "open";
    case ContactRegime::sticks:
      return "sticks";
    case ContactRegime::slides:
      return "slides";
  }
  return "unknown regime";
}

/// Signorini's and Coulomb's laws of one contact, between its reaction r = (N, T) and its motion u = (u_N, u_T), which
/// are both velocities and impulses, or accelerations and forces:
///   0 <= N, 0 <= u_N, N u_N = 0;  sticks: u_T = 0, |T| <= f_s N + b_s;  slides: T = -(f N + b) d, u_T = s d, s >= 0.
/// In space T lies in a disc, in the plane between two signs. Sources: Pommier, Dynamique des systèmes de solides,
/// §6.2.3; Glocker, Set-Valued Force Laws. Resistance to rolling and to spinning is a contact without a normal of its
/// own, `pressed_by` the contact that rolls: T is a moment, u_T a part of the angular velocity, f a length. Friction of a
/// joint that its own reaction presses has a `bearing`: N stands for |R|, R what the joint transmits across its freedom.
struct ContactLaw {
  bool normal = true;                ///< false: dry friction alone, whose T is bounded by f N + b; it never opens
  std::optional<int> pressed_by{};   ///< without a normal: the contact, earlier in order, whose N it is; none: N = 0
  int bearing = 0;                   ///< without a normal: 1 or 2 components of a joint's reaction R, N = |R|; 0: none
  int tangents = 2;                  ///< 0: a stop, 1: in the plane, 2: in space
  double friction = 0;               ///< f, while it slides
  double static_friction = 0;        ///< f_s, while it sticks; at least f
  double bound = 0;                  ///< b [N or N s], while it slides
  double static_bound = 0;           ///< b_s, at least b
  bool slips = false;                ///< it slides already: T = -(f N + b) slip, whatever u_T is
  std::array<double, 2> slip{1, 0};  ///< unit direction of slip; one number in the plane

  [[nodiscard]] int rows() const noexcept { return (normal ? 1 : 0) + tangents; }
  [[nodiscard]] bool rubs() const noexcept {
    return tangents > 0 && (friction > 0 || static_friction > 0 || bound > 0 || static_bound > 0);
  }
};

/// A contact in the plane or in space with one coefficient for sticking and sliding.
[[nodiscard]] constexpr ContactLaw coulomb(int tangents, double friction) noexcept {
  return {.tangents = tangents, .friction = friction, .static_friction = friction};
}

/// Room for the contacts of one mechanism and for their rows. Vectors and matrices of a problem have it within, so that
/// nothing is allocated however many contacts take part. Where all that is linked is compiled for fewer, matrices on the
/// stack are as much smaller.
#ifndef TORSOR_MOST_CONTACTS
#define TORSOR_MOST_CONTACTS 32
#endif
inline constexpr int most_contacts = TORSOR_MOST_CONTACTS, most_rows = 3 * most_contacts;
static_assert(most_contacts > 0 && most_contacts <= 32, "TORSOR_MOST_CONTACTS is 1 to 32");
namespace detail {
/// The library defines this for its own room alone: a program compiled for another, whose matrices are not those of the
/// library, does not link.
template <int most>
void library_has_room_for_contacts() noexcept;
[[gnu::used]] inline void (*const needed_room)() noexcept = &library_has_room_for_contacts<most_contacts>;
}  // namespace detail
using ContactVector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, most_rows, 1>;
using ContactMatrix =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, most_rows, most_rows>;
template <class T>
using PerContact = std::array<T, static_cast<std::size_t>(most_contacts)>;
/// Reactions of joints, of which each contact has two components at most.
using BearingMatrix =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 2 * most_contacts, most_rows>;
using BearingVector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 2 * most_contacts, 1>;

/// u = W r + q, rows contact by contact, N first: the problem of one instant.
struct ContactProblem {
  int count = 0;
  PerContact<ContactLaw> laws{};
  ContactMatrix W;  ///< Delassus' matrix J M^-1 J^T, symmetric, positive semidefinite
  ContactVector q;  ///< u without reactions
  ContactVector noise;  ///< what of q rounding may be, or nothing: equations that depend on each other hold to no less
  BearingMatrix S;   ///< reactions of joints are R = S r + c, in the order of the contacts that have a bearing
  BearingVector c;

  [[nodiscard]] const ContactLaw& law(int contact) const noexcept { return laws[static_cast<std::size_t>(contact)]; }
  [[nodiscard]] int rows() const noexcept { return first_row(count); }
  /// Row of the first component of a contact.
  [[nodiscard]] int first_row(int contact) const noexcept {
    int row = 0;
    for (int i = 0; i < contact; ++i) row += law(i).rows();
    return row;
  }
  /// Row of its first tangential component.
  [[nodiscard]] int tangent_row(int contact) const noexcept {
    return first_row(contact) + (law(contact).normal ? 1 : 0);
  }
  /// Row of the normal force that presses a contact, where there is one.
  [[nodiscard]] std::optional<int> pressing_row(int contact) const noexcept {
    const std::optional<int> by = law(contact).normal ? contact : law(contact).pressed_by;
    return by ? std::optional(first_row(*by)) : std::nullopt;
  }
  /// First row of S and c of a contact with a bearing.
  [[nodiscard]] int bearing_row(int contact) const noexcept {
    int row = 0;
    for (int i = 0; i < contact; ++i) row += law(i).bearing;
    return row;
  }
  /// The reaction of its joint.
  [[nodiscard]] std::array<double, 2> bearing(int contact, const ContactVector& r) const noexcept {
    std::array<double, 2> R{};
    for (int k = 0, row = bearing_row(contact); k < law(contact).bearing; ++k, ++row) {
      R[static_cast<std::size_t>(k)] = S.row(row).dot(r) + c(row);
    }
    return R;
  }
  /// That force, or |R| of a contact with a bearing.
  [[nodiscard]] double pressing(int contact, const ContactVector& r) const noexcept {
    if (law(contact).bearing > 0) {
      const auto R = bearing(contact, r);
      return std::hypot(R[0], R[1]);
    }
    const std::optional<int> row = pressing_row(contact);
    return row ? r(*row) : 0;
  }
};

/// Reactions and motion that fulfil all laws.
struct ContactSolution {
  ContactVector r, u;
  PerContact<ContactRegime> regimes{};
  double residual = 0;         ///< of the natural map, see below
  bool indeterminate = false;  ///< other reactions give the same motion
  bool moves = false;          ///< other reactions of these regimes give other motions
};

/// How many solutions a problem has. Where not all motions were looked for, one that was found may be one of several, and one
/// may have been missed where none was found.
enum class ContactVerdict { unique, indeterminate, several, none, not_examined, not_found };

/// What is known of two problems that are solved one after the other, or beside each other.
[[nodiscard]] constexpr ContactVerdict verdict_of_both(ContactVerdict a, ContactVerdict b) noexcept {
  constexpr std::array<int, 6> rank{0, 1, 3, 5, 2, 4};
  return rank[static_cast<std::size_t>(a)] < rank[static_cast<std::size_t>(b)] ? b : a;
}
/// Whether there is no solution, or none that was found.
[[nodiscard]] constexpr bool without_solution(ContactVerdict verdict) noexcept {
  return verdict == ContactVerdict::none || verdict == ContactVerdict::not_found;
}

[[nodiscard]] constexpr std::string_view describe(ContactVerdict verdict) noexcept {
  switch (verdict) {
    case ContactVerdict::unique:
      return "one motion and one set of reactions";
    case ContactVerdict::indeterminate:
      return "one motion, but the reactions are indeterminate";
    case ContactVerdict::several:
      return "several motions fulfil the laws of contact";
    case ContactVerdict::none:
      return "no motion fulfils the laws of contact";
    case ContactVerdict::not_examined:
      return "one motion was found, and others were not looked for";
    case ContactVerdict::not_found:
      return "no motion was found, and not all regimes were tried";
  }
  return "unknown verdict";
}

/// The solutions that were found, the one of least motion first: rest persists where it can.
struct ContactAnswer {
  static constexpr std::size_t kept = 8;
  ContactVerdict verdict = ContactVerdict::not_found;
  std::array<ContactSolution, kept> solutions{};
  std::size_t count = 0;
  [[nodiscard]] const ContactSolution& best() const noexcept { return solutions[0]; }
  [[nodiscard]] explicit operator bool() const noexcept { return count > 0; }
};

/// Certificate: the largest defect of the fixed points N = max(0, N - ρ u_N) and T = projection of T - ρ u_T on the
/// disc of radius f N + b, with ρ = 1/W_ii, over the largest |r| + ρ |u| of what acts on each other (ContactScale): 0 for a
/// solution, a number without unit. A contact that slips in a given direction has the defect of T = -(f N + b) d.
/// Source: Alart & Curnier 1991; Acary & Brogliato 2008.
[[nodiscard]] double natural_map_residual(const ContactProblem& problem, const ContactSolution& solution) noexcept;

}  // namespace torsor::runtime
