// SPDX-License-Identifier: MIT
#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>

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
/// own, `pressed_by` the contact that rolls: T is a moment, u_T a part of the angular velocity, f a length.
struct ContactLaw {
  bool normal = true;                ///< false: dry friction alone, whose T is bounded by f N + b; it never opens
  int pressed_by = -1;               ///< without a normal: the contact, earlier in order, whose N it is; -1: N = 0
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

/// u = W r + q for up to `most` contacts, rows contact by contact, N first: the problem of one instant.
template <int most>
struct ContactProblem {
  static constexpr int capacity = 3 * most;
  using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, capacity, 1>;
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, capacity, capacity>;

  int count = 0;
  std::array<ContactLaw, static_cast<std::size_t>(most)> laws{};
  Matrix W;  ///< Delassus' matrix J M^-1 J^T, symmetric, positive semidefinite
  Vector q;  ///< u without reactions

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
  /// Row of the normal force that presses a contact; -1 where there is none.
  [[nodiscard]] int pressing_row(int contact) const noexcept {
    const int by = law(contact).normal ? contact : law(contact).pressed_by;
    return by < 0 ? -1 : first_row(by);
  }
  /// That force.
  [[nodiscard]] double pressing(int contact, const Vector& r) const noexcept {
    const int row = pressing_row(contact);
    return row < 0 ? 0 : r(row);
  }
};

/// Reactions and motion that fulfil all laws.
template <int most>
struct ContactSolution {
  typename ContactProblem<most>::Vector r, u;
  std::array<ContactRegime, static_cast<std::size_t>(most)> regimes{};
  double residual = 0;         ///< of the natural map, see below
  bool indeterminate = false;  ///< other reactions give the same motion
};

/// How many solutions a problem has.
enum class ContactVerdict { unique, indeterminate, several, none };

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
  }
  return "unknown verdict";
}

/// Certificate: the largest defect of the fixed points N = max(0, N - ρ u_N) and T = projection of T - ρ u_T on the
/// disc of radius f N + b, with ρ = 1/W_ii, over the largest |r| + ρ |u|: 0 for a solution, a number without unit. A
/// contact that slips in a given direction has the defect of T = -(f N + b) d. Source: Alart & Curnier 1991; Acary &
/// Brogliato 2008.
template <int most>
[[nodiscard]] double natural_map_residual(const ContactProblem<most>& problem,
                                          const ContactSolution<most>& s) noexcept {
  double defect = 0, size = 0;
  for (int i = 0; i < problem.count; ++i) {
    const ContactLaw& law = problem.law(i);
    const int n = problem.first_row(i), t = problem.tangent_row(i);
    const double N = problem.pressing(i, s.r);
    const auto rate = [&](int row) { return problem.W(row, row) > 0 ? 1 / problem.W(row, row) : 1.0; };
    if (law.normal) {
      const double rho = rate(n);
      defect = std::max(defect, std::abs(N - std::max(0.0, N - rho * s.u(n))));
      size = std::max(size, std::abs(N) + rho * std::abs(s.u(n)));
    }
    const bool sticks = s.regimes[static_cast<std::size_t>(i)] == ContactRegime::sticks;
    const double radius =
        std::max(0.0, sticks ? law.static_friction * N + law.static_bound : law.friction * N + law.bound);
    if (law.tangents == 0) continue;
    double rho = rate(t);
    if (law.tangents == 2) rho = std::min(rho, rate(t + 1));
    double length = 0, off = 0;
    for (int k = 0; k < law.tangents; ++k) length = std::hypot(length, s.r(t + k) - rho * s.u(t + k));
    for (int k = 0; k < law.tangents; ++k) {
      const double trial = s.r(t + k) - rho * s.u(t + k);
      const double given = -radius * law.slip[static_cast<std::size_t>(k)];
      const double shrunk = length > radius ? radius / length * trial : trial;
      off = std::hypot(off, s.r(t + k) - (law.slips ? given : shrunk));
      size = std::max(size, std::abs(s.r(t + k)) + (law.slips ? 0 : rho * std::abs(s.u(t + k))));
    }
    defect = std::max(defect, off);
  }
  return size > 0 ? defect / size : defect;
}

}  // namespace torsor::runtime
