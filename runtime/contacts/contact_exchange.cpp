// SPDX-License-Identifier: MIT
#include "torsor/runtime/contacts/contact_exchange.hpp"

#include <cmath>
#include <limits>

namespace torsor::runtime {
namespace {

/// What makes a guard start above zero, by a rounding of it.
double lift_of(double guard) noexcept {
  constexpr double least = std::numeric_limits<double>::min(), above = 1 + 4 * std::numeric_limits<double>::epsilon();
  return guard < least ? least - above * guard : 0;
}

}  // namespace

ContactExchange::ContactExchange(const ContactMechanism& mechanism, const ContactOptions& options, double tolerance)
    : automaton_(mechanism, options),
      lifts_(ContactAutomaton::guards * static_cast<std::size_t>(mechanism.sizes().contacts)) {
  automaton_.motion().tolerate(tolerance, tolerance);
}

bool ContactExchange::start(double t, std::span<double> y, bool again) {
  using Gaps = ContactAutomaton::Gaps;
  begins_with_impact_ = false;
  if (!automaton_.start(t, y, again ? Gaps::of_a_late_event : Gaps::of_a_start)) return false;
  begins_with_impact_ = automaton_.has_event();
  lift(t, y);
  return true;
}

Evaluation ContactExchange::slope(double t, std::span<const double> y, std::span<double> dydt) {
  return automaton_.motion().slope(t, y, dydt);
}

Evaluation ContactExchange::indicators(double t, std::span<const double> y, std::span<double> z) {
  for (std::size_t i = 0; i < lifts_.size(); ++i) {
    z[i] = automaton_.guard(i, t, y) + lifts_[i];
    if (!std::isfinite(z[i])) return Evaluation::not_finite;
  }
  return Evaluation::ok;
}

Evaluation ContactExchange::complete(double t, std::span<double> y) {
  ContactMotion& motion = automaton_.motion();
  if (const std::optional<int> jumped = motion.falls_by_a_jump(t, y)) {
    automaton_.end(ContactStatus::no_point, jumped);
    return Evaluation::singular;
  }
  const Evaluation held = motion.hold(t, y);
  if (held == Evaluation::ok) {
    motion.follow_slips(t, y);
  } else if (const std::optional<int> contact = motion.jumping(t)) {
    automaton_.end(ContactStatus::no_point, contact);
  }
  return held;
}

// A gap below zero that opens has had its event.
bool ContactExchange::falls(std::size_t index, double t, std::span<const double> y) {
  if (!(automaton_.guard(index, t, y) + lifts_[index] <= 0)) return false;
  if (!automaton_.barrier(index)) return true;
  const int contact = static_cast<int>(index / ContactAutomaton::guards);
  const ContactMotion& motion = automaton_.motion();
  const int n = motion.first_row(contact);
  return motion.reading().w(n) < -64 * motion.rounding_of(n);  // what an impact would take for rest strikes nothing
}

bool ContactExchange::update(double t, std::span<double> y) {
  begins_with_impact_ = false;
  constexpr int most = 100;  // regimes that alternate at one time come to no end
  for (int passed = 0; passed < most; ++passed) {
    std::size_t index = 0;
    while (index < lifts_.size() && !falls(index, t, y)) ++index;
    if (index == lifts_.size()) {
      lift(t, y);
      return true;
    }
    lifts_[index] = 0;
    if (!automaton_.pass(index, t, y)) return false;
    // Regimes that begin are watched from above zero: rounding makes no event of its own.
    for (std::size_t i = 0; i < lifts_.size(); ++i) {
      if (!automaton_.barrier(i)) lifts_[i] = lift_of(automaton_.guard(i, t, y));
    }
  }
  return automaton_.end(ContactStatus::too_many_events, std::nullopt);
}

void ContactExchange::lift(double t, std::span<const double> y) {
  for (std::size_t i = 0; i < lifts_.size(); ++i) lifts_[i] = lift_of(automaton_.guard(i, t, y));
}

}  // namespace torsor::runtime
