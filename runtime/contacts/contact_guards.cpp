// SPDX-License-Identifier: MIT
// What ends a smooth piece of a contact motion, and what of it is rounding.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "torsor/runtime/contacts/contact_automaton.hpp"

namespace torsor::runtime {

double ContactAutomaton::guard(std::size_t index, double t, std::span<const double> y) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (index == guards * bounces_.size()) {
    return motion_.solve(t, y) == Evaluation::ok ? side_ * motion_.regularity() - 1e-8 : none;
  }
  if (index > guards * bounces_.size()) return 1;
  const int contact = static_cast<int>(index / guards);
  const auto watched = static_cast<Watched>(index % guards);
  const ContactState& state = motion_.states[as(contact)];
  const ContactRule& rule = motion_.rule(contact);
  if (!motion_.read(t, y)) return none;
  if (watched == Watched::gap_or_pressure) {
    if (!rule.normal) return 1;
    if (!state.touches) return gap_above(contact);
    if (motion_.solve(t, y) != Evaluation::ok) return none;
    const int n = motion_.first_row(contact);
    return motion_.reactions()(n) + state.force_slack + idle_slack(contact, n);
  }
  // Where nothing rubs, a slip that passes zero has no end: a spin that stays zero but for rounding would end without end.
  if (!state.touches || !rule.law().rubs() || state.regime == ContactRegime::open) return 1;
  if (watched == Watched::youth) {
    if (state.regime != ContactRegime::slides) return 1;
    if (!state.begins && (state.fades || rule.tangents < 2)) return 1;
    if (state.begins && motion_.solve(t, y) != Evaluation::ok) return none;
    return motion_.youth(contact, t);
  }
  // What starts from zero is watched from a little above, so that it is seen to fall.
  if (state.regime == ContactRegime::slides) {
    return motion_.slip(contact) + (state.begins && !state.fades ? motion_.least_slip(contact) : 0);
  }
  if (motion_.solve(t, y) != Evaluation::ok) return none;
  return motion_.margin(contact) + state.force_slack + idle_slack(contact, motion_.tangent_row(contact));
}

// The gap of an open contact. One as good as closed that opens is above zero: the rounding of a sum of lengths, whose size no
// coordinate shows, would fall to zero again and again where the contact has left.
double ContactAutomaton::gap_above(int contact) const noexcept {
  const double gap = motion_.reading().gap[as(contact)];
  if (!(gap <= 0 && gap >= -reach(contact))) return gap;
  const double w = motion_.reading().w(motion_.first_row(contact));
  const bool opens = w > 0 && leaves_rounding(contact, w);
  return opens ? std::numeric_limits<double>::min() : gap;
}

// What rounding may make of a force in a row of a contact that has none.
double ContactAutomaton::idle_slack(int contact, int row) {
  if (!motion_.states[as(contact)].idle) return 0;
  const double own = motion_.W()(row, row);
  return own > 0 ? 4e-12 * bounces_[as(contact)].doubt * fastest_(row) / own : 0;
}

bool ContactAutomaton::barrier(std::size_t index) const {
  return index < guards * bounces_.size() && static_cast<Watched>(index % guards) == Watched::gap_or_pressure &&
         !motion_.states[index / guards].touches;
}

bool ContactAutomaton::ends_unfollowed(std::size_t index, double t, std::span<const double> y) {
  if (index >= guards * bounces_.size() || !motion_.read(t, y)) return false;
  const int i = static_cast<int>(index / guards);
  if (barrier(index)) {
    return motion_.reading().gap[as(i)] <= 16 * motion_.rounding_of_gap(i) &&
           motion_.reading().w(motion_.first_row(i)) < 0;
  }
  const ContactState& state = motion_.states[as(i)];
  const auto watched = static_cast<Watched>(index % guards);
  // A slip has got a speed: where, errors of the integration may say.
  if (watched == Watched::youth) return state.begins && !state.fades && motion_.slip(i) > 1e4 * motion_.least_slip(i);
  return watched == Watched::slip_or_margin && state.touches && state.fades && motion_.slip_speed(i) <= motion_.slow(i);
}

bool ContactAutomaton::does_not_fall(std::size_t index, double t, std::span<const double> y) {
  if (!barrier(index) || motion_.solve(t, y) != Evaluation::ok) return false;
  const int i = static_cast<int>(index / guards), n = motion_.first_row(i);
  return motion_.reading().w(n) >= -64 * motion_.rounding_of(n) &&
         motion_.gap_acceleration(i) >= -1e-12 * motion_.acceleration_terms(i);
}

// A force that comes to its bound and goes back, but for rounding, has no event: rest persists where it can.
bool ContactAutomaton::holds_on(std::size_t index, double t, std::span<const double> y) {
  if (index >= guards * bounces_.size()) return false;
  const int i = static_cast<int>(index / guards);
  ContactState& state = motion_.states[as(i)];
  const auto watched = static_cast<Watched>(index % guards);
  const bool of_a_force = watched == Watched::gap_or_pressure || state.regime == ContactRegime::sticks;
  if (!state.touches || watched == Watched::youth || !of_a_force || motion_.solve(t, y) != Evaluation::ok) return false;
  const double size = motion_.force_size(i), left = guard(index, t, y);
  if (!(std::abs(left) <= 4e-12 * size)) return false;
  state.force_slack += 8e-12 * size;
  return true;
}

// Where masses are far apart, rounding of forces that have grown a thousand times since the regimes began may stop the steps
// before the determinant is so small.
bool ContactAutomaton::jams_nearly(double t, std::span<const double> y) {
  if (motion_.solve(t, y) != Evaluation::ok) return false;
  const std::optional<int> contact = motion_.busiest_slip();
  if (!contact || !(side_ * motion_.regularity() < 1e-3 * began_regular_)) return false;
  end(ContactStatus::jams, contact);
  return true;
}

std::optional<bool> ContactAutomaton::pass_jump_of_forces(double t, std::span<double> y) {
  for (std::size_t index = 0; index < guards * bounces_.size(); ++index) {
    const ContactState& state = motion_.states[index / guards];
    const auto watched = static_cast<Watched>(index % guards);
    const bool holds = watched == Watched::gap_or_pressure ||
                       (watched == Watched::slip_or_margin && state.regime == ContactRegime::sticks);
    if (!state.touches || !holds || !(guard(index, t, y) >= 0)) continue;
    const auto later = motion_.pass_to(t, y, [&](double after, std::span<const double> there) {
      return guard(index, t + after, there) < 0;
    });
    if (later) return pass(index, t + *later, y);
  }
  return std::nullopt;
}

bool ContactAutomaton::is_singular(double t, std::span<const double> y) {
  return motion_.read(t, y) && motion_.solve(t, y) == Evaluation::singular;
}

// The state whose regimes are decided anew, and of which nothing has been told.
void ContactAutomaton::stand_undecided_at(double t, std::span<double> y) {
  result_.time = told_ = t;
  y_ = y;
  std::copy_n(y_.begin(), before_.size(), before_.begin());
  without_impact();
  ends_too_.fill(false);
  has_event_ = false;
}

// The reaction that presses a joint is R = R0 + s T with |T| = f |R|, other regimes held. Where f |s| > 1 and R0 comes to zero
// there is none behind it, of either sign.
std::optional<bool> ContactAutomaton::pass_end_of_reaction(double t, std::span<double> y) {
  if (motion_.near_change_point()) return std::nullopt;  // there loops lose rank, whatever rubs
  const auto lost = [&](double after, std::span<const double> there) { return is_singular(t + after, there); };
  for (int i = 0; i < count(); ++i) {
    const ContactState& state = motion_.states[as(i)];
    if (motion_.rule(i).bearing == 0 || !state.touches || state.regime != ContactRegime::slides) continue;
    const std::optional<double> later = motion_.pass_to(t, y, lost);
    if (!later) return std::nullopt;
    stand_undecided_at(t + *later, y);
    const PerContact<ContactState> before = motion_.states;
    if (!decide(i, Cause::none)) {
      motion_.states = before;
      return false;
    }
    return tell_changes(before) ? std::optional(true) : std::nullopt;
  }
  return std::nullopt;
}

// Regimes that are others than before, each as an event; the first one is told first.
bool ContactAutomaton::tell_changes(const PerContact<ContactState>& before) {
  for (int i = count(); i-- > 0;) {
    const ContactState& now = motion_.states[as(i)];
    if (now.touches == before[as(i)].touches && now.regime == before[as(i)].regime) continue;
    if (!now.touches) bounces_[as(i)].left = result_.time;
    if (has_event_) ends_too_[as(contact_)] = true;
    has_event_ = true;
    contact_ = i;
    kind_ = !now.touches ? ContactEventKind::opens
            : now.regime == ContactRegime::slides ? ContactEventKind::slips : ContactEventKind::slip_ends;
    ++result_.events;
  }
  return has_event_;
}

// Two that stick may hold a hinge that is all but on their line, as that of a leg on the side of a box that comes to rest on it.
// What they cannot hold grows beyond rounding as it comes down.
std::optional<bool> ContactAutomaton::pass_loss_of_rank(double t, std::span<double> y) {
  if (motion_.reading().A.rows() > 0) return std::nullopt;  // a dead centre of a loop is none of the contacts'
  const auto lost = [&](double after, std::span<const double> there) { return is_singular(t + after, there); };
  const bool here = lost(0, y);
  bool any = here;
  for (int i = 0; i < count() && !here && motion_.solve(t, y) == Evaluation::ok; ++i) any = any || motion_.undetermined(i);
  if (!any) return std::nullopt;
  const std::optional<double> later = here ? 0 : motion_.pass_to(t, y, lost);
  if (!later) return std::nullopt;
  stand_undecided_at(t + *later, y);
  const PerContact<ContactState> before = motion_.states;
  kind_ = ContactEventKind::slips;
  if (!decide(std::nullopt, Cause::none)) return result_.status == ContactStatus::reached_end ? std::nullopt : std::optional(false);
  for (int i = count(); i-- > 0;) {
    if (before[as(i)].regime != ContactRegime::sticks || motion_.states[as(i)].regime == ContactRegime::sticks) continue;
    if (!motion_.states[as(i)].touches) bounces_[as(i)].left = result_.time;
    if (has_event_) ends_too_[as(contact_)] = true;
    has_event_ = true;
    contact_ = i;
    ++result_.events;
  }
  if (has_event_ && !motion_.states[as(contact_)].touches) kind_ = ContactEventKind::opens;
  return has_event_ ? std::optional(true) : std::nullopt;
}

}  // namespace torsor::runtime
