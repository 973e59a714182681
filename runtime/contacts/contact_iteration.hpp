// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>

#include "torsor/runtime/contacts/contact_scale.hpp"
#include "torsor/runtime/contacts/contact_solver.hpp"
#include "torsor/runtime/contacts/regime_enumeration.hpp"

namespace torsor::runtime {

/// Solutions of more contacts than those of which every regime is tried. Whatever proposes reactions, regimes are read from
/// them, Newton's method solves the equations of these, and their inequalities decide.
class ContactIteration {
 public:
  ContactIteration(const ContactProblem& problem, const ContactVector& start, const ContactSolverOptions& options) noexcept
      : problem_(problem), scale_(problem), options_(options), r_(start) {}

  /// Whether what the start proposes holds: what held in the step before holds in most.
  [[nodiscard]] bool holds(RegimeEnumeration& regimes) const noexcept { return !r_.isZero(0) && tries(problem_, regimes); }

  /// Goes on from the start to one solution.
  [[nodiscard]] ContactAnswer run() noexcept;

  /// Solutions whatever the start and the order of contacts: rest, where reactions exist that hold it, or else rest of a part,
  /// and a motion, where one is found. Sweeps follow where there is none of these.
  [[nodiscard]] ContactAnswer solve() noexcept;

 private:
  using Regimes = RegimeSystem::Regimes;
  using Friction = AssumedRegime::Friction;
  static std::size_t as(int i) noexcept { return static_cast<std::size_t>(i); }

  [[nodiscard]] bool rests(RegimeEnumeration& regimes) const noexcept;
  void hold_what_rests(RegimeEnumeration& proposals) noexcept;
  [[nodiscard]] bool step_together(const ContactProblem& problem, RegimeEnumeration& regimes, int longest) noexcept;
  void step_one(const ContactProblem& problem, int contact, int tangent, const ContactVector& u,
                const ContactVector& rho) noexcept;
  void sweep_until(RegimeEnumeration& regimes) noexcept;
  double sweep() noexcept;
  void mark() noexcept;
  bool stagnates() noexcept;
  [[nodiscard]] bool tries(const ContactProblem& problem, RegimeEnumeration& regimes) const noexcept;
  [[nodiscard]] Regimes proposed(const ContactProblem& problem) const noexcept;

  const ContactProblem& problem_;
  const ContactScale scale_;
  const ContactSolverOptions options_;
  ContactVector r_, marked_;
  int since_ = 0, distance_ = 1;  ///< attempts since the mark, and until the next one
};

}  // namespace torsor::runtime
