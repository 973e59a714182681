// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "runtime/contacts/regime_enumeration.hpp"
#ifndef TORSOR_CONTACTS_IN_PLACE
#include "runtime/library.hpp"
#endif

namespace torsor::runtime {

/// How the problem of one instant is solved.
struct ContactSolverOptions {
  int enumerated = 6;  ///< up to so many contacts every regime is tried, and the verdict is complete
  int sweeps = 200;    ///< of Gauss and Seidel between attempts of Newton's method
  int attempts = 40;
};

/// Finds one solution of any number of contacts: sweeps of Gauss and Seidel, each contact solved exactly with the
/// others held, propose regimes; the equations of these regimes are solved by Newton's method (the semismooth Newton
/// method of Alart and Curnier), and their inequalities decide. Its verdict says `unique` or `indeterminate` of what it
/// found and did not look for other motions; `none` that it found nothing.
template <int most>
class ContactIteration {
 public:
  using Problem = ContactProblem<most>;
  using Vector = typename Problem::Vector;
  using Regimes = typename RegimeSystem<most>::Regimes;
  using Friction = AssumedRegime::Friction;

  ContactIteration(const Problem& problem, const ContactSolverOptions& options) noexcept
      : problem_(problem), options_(options), r_(Vector::Zero(problem.rows())) {}

  /// Begins from reactions of an earlier instant.
  void start_from(const Vector& r) noexcept { r_ = r; }

  [[nodiscard]] ContactAnswer<most> run() noexcept {
    RegimeEnumeration<most> regimes(problem_);
    for (int attempt = 0; attempt < options_.attempts; ++attempt) {
      for (int sweep = 0; sweep < options_.sweeps; ++sweep) {
        if (!(this->sweep() > 1e-15)) break;
      }
      if (!r_.allFinite()) r_.setZero();
      if (regimes.try_from(proposed())) break;
    }
    return regimes.finish();
  }

 private:
  static std::size_t as(int i) noexcept { return static_cast<std::size_t>(i); }

  // Each contact in turn; the largest change over the largest reaction.
  double sweep() noexcept {
    double change = 0, size = 0;
    for (int i = 0; i < problem_.count; ++i) {
      const int first = problem_.first_row(i), rows = problem_.law(i).rows();
      ContactProblem<1> one;
      one.count = 1;
      one.laws[0] = problem_.law(i);
      if (one.laws[0].pressed_by >= 0) {  // by a force that is held, too
        const double N = problem_.pressing(i, r_);
        one.laws[0].pressed_by = -1;
        one.laws[0].bound += one.laws[0].friction * N;
        one.laws[0].static_bound += one.laws[0].static_friction * N;
        one.laws[0].friction = one.laws[0].static_friction = 0;
      }
      one.W = problem_.W.block(first, first, rows, rows);
      one.q =
          problem_.q.segment(first, rows) + problem_.W.middleRows(first, rows) * r_ - one.W * r_.segment(first, rows);
      const ContactAnswer<1> answer = RegimeEnumeration<1>(one).run();
      if (!answer) continue;
      const auto& r = answer.best().r;
      change = std::max(change, (r - r_.segment(first, rows)).cwiseAbs().maxCoeff());
      r_.segment(first, rows) = r;
      size = std::max(size, r.cwiseAbs().maxCoeff());
    }
    return size > 0 ? change / size : change;
  }

  // What the natural map says of each contact at the present reactions.
  [[nodiscard]] Regimes proposed() const noexcept {
    Regimes regimes{};
    const Vector u = problem_.W * r_ + problem_.q;
    for (int i = 0; i < problem_.count; ++i) {
      const ContactLaw& law = problem_.law(i);
      AssumedRegime& regime = regimes[as(i)];
      const int t = problem_.tangent_row(i);
      double N = 0;
      if (const int pressing = problem_.pressing_row(i); pressing >= 0) {
        const double W = problem_.W(pressing, pressing);
        N = std::max(0.0, W > 0 ? r_(pressing) - u(pressing) / W : r_(pressing));
        regime.pressed = law.normal && N > 0;
      }
      const double bound = std::max(law.friction * N + law.bound, law.static_friction * N + law.static_bound);
      if (!(law.tangents > 0 && bound > 0)) continue;
      if (law.slips) {
        regime.friction = Friction::slides;
        regime.direction = law.slip;
        regime.direction_given = true;
        continue;
      }
      double largest = problem_.W(t, t);
      if (law.tangents == 2) largest = std::max(largest, problem_.W(t + 1, t + 1));
      std::array<double, 2> trial{};
      for (int k = 0; k < law.tangents; ++k) trial[as(k)] = r_(t + k) - (largest > 0 ? u(t + k) / largest : 0);
      const double length = std::hypot(trial[0], trial[1]);
      if (length <= law.static_friction * N + law.static_bound || !(length > 0)) {
        regime.friction = Friction::sticks;
      } else {
        regime.friction = Friction::slides;
        regime.direction = {-trial[0] / length, -trial[1] / length};
        regime.direction_sought = law.tangents == 2;
      }
    }
    return regimes;
  }

  const Problem& problem_;
  const ContactSolverOptions options_;
  Vector r_;
};

/// The same problem with room for another number of contacts, not below `problem.count`.
template <int room, int most>
[[nodiscard]] ContactProblem<room> with_room(const ContactProblem<most>& problem) noexcept {
  ContactProblem<room> other;
  other.count = problem.count;
  std::copy_n(problem.laws.begin(), problem.count, other.laws.begin());
  other.W = problem.W;
  other.q = problem.q;
  return other;
}

template <int room, int most>
[[nodiscard]] ContactAnswer<room> with_room(const ContactAnswer<most>& answer, int contacts) noexcept {
  ContactAnswer<room> other;
  other.verdict = answer.verdict;
  other.count = answer.count;
  for (std::size_t k = 0; k < answer.count; ++k) {
    const ContactSolution<most>& from = answer.solutions[k];
    ContactSolution<room>& to = other.solutions[k];
    to.r = from.r;
    to.u = from.u;
    std::copy_n(from.regimes.begin(), contacts, to.regimes.begin());
    to.residual = from.residual;
    to.indeterminate = from.indeterminate;
  }
  return other;
}

/// The library has the solver for up to eight contacts: programs with no more need not compile it. One that does not link
/// the library defines TORSOR_CONTACTS_IN_PLACE.
inline constexpr int library_room = 8;

/// Solves a problem: by trying every regime up to `options.enumerated` contacts, by iteration beyond and where no
/// regime that was tried fits.
template <int most>
[[nodiscard]] ContactAnswer<most> solve_contacts(const ContactProblem<most>& problem,
                                                 const ContactSolverOptions& options = {}) noexcept {
  if constexpr (most < library_room) {
    return with_room<most>(solve_contacts(with_room<library_room>(problem), options), problem.count);
  } else {
    if (problem.count <= options.enumerated) {
      ContactAnswer<most> answer = RegimeEnumeration<most>(problem).run();
      if (answer) return answer;
    }
    return ContactIteration<most>(problem, options).run();
  }
}

#ifndef TORSOR_CONTACTS_IN_PLACE
extern template ContactAnswer<library_room> solve_contacts(const ContactProblem<library_room>&,
                                                           const ContactSolverOptions&) noexcept;
#endif

}  // namespace torsor::runtime
