// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "torsor/runtime/contacts/contact_automaton.hpp"

namespace torsor::runtime {

/// A motion with contacts that somebody else integrates, as an importer of FMI does in model exchange: slopes of the present
/// regimes and indicators, of which one falls to zero or below where these regimes end. `update` then decides which
/// regimes follow. All indicators are above zero after `start` and `update`, also of a gap that has just opened.
class ContactExchange {
 public:
  /// The mechanism must live as long; `tolerance` is that of the integration, absolute and relative.
  ContactExchange(const ContactMechanism& mechanism, const ContactOptions& options, double tolerance);

  [[nodiscard]] std::size_t indicator_count() const noexcept { return lifts_.size(); }

  /// Puts the state on its constraints and decides the first regimes, with an impact where contacts approach; false where
  /// the motion cannot begin. `again`: in the middle of a motion, as after a parameter was set: a gap below zero is then
  /// that of an event that was found late.
  bool start(double t, std::span<double> y, bool again = false);
  /// Whether the present regimes are those of a start that began with an impact, and nothing has happened since.
  [[nodiscard]] bool begins_with_impact() const noexcept { return begins_with_impact_; }
  /// Of the integration, absolute and relative, from the next start on.
  void tolerate(double tolerance) noexcept { automaton_.motion().tolerate(tolerance, tolerance); }
  /// What the mechanism says at a state has changed, as forces by its inputs do.
  void renew() noexcept { automaton_.motion().renew(); }

  [[nodiscard]] Evaluation slope(double t, std::span<const double> y, std::span<double> dydt);
  /// Of each contact three: its gap, or the force that presses it; what is left of the bound of its friction while it
  /// sticks, or its slip; and what a slip that begins or ends asks for. 1 where nothing is watched.
  [[nodiscard]] Evaluation indicators(double t, std::span<const double> y, std::span<double> z);
  /// After a step: constraints, gaps and velocities of closed contacts, and norms of quaternions. Refused where the normal of
  /// a contact jumps within the step; the result then says `no_point`, and a shorter step may end before that place.
  [[nodiscard]] Evaluation complete(double t, std::span<double> y);
  /// At an event: passes all that have fallen; false where the motion ends.
  bool update(double t, std::span<double> y);

  /// The present regimes, at the state of the last call.
  [[nodiscard]] const ContactMotion& motion() const noexcept { return automaton_.motion(); }
  [[nodiscard]] const ContactResult& result() const noexcept { return automaton_.result(); }

 private:
  [[nodiscard]] bool falls(std::size_t index, double t, std::span<const double> y);
  void lift(double t, std::span<const double> y);

  ContactAutomaton automaton_;
  std::vector<double> lifts_;  ///< what makes each indicator start above zero
  bool begins_with_impact_ = false;
};

}  // namespace torsor::runtime
