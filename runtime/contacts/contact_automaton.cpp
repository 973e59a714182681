// SPDX-License-Identifier: MIT
#include "torsor/runtime/contacts/contact_automaton.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "torsor/runtime/contacts/contact_scale.hpp"
#include "torsor/runtime/contacts/contact_solver.hpp"

namespace torsor::runtime {

ContactAutomaton::ContactAutomaton(const ContactMechanism& mechanism, const ContactOptions& options)
    : motion_(mechanism), options_(options),
      before_(as(mechanism.sizes().coordinates + mechanism.sizes().velocities)), bounces_(as(mechanism.sizes().contacts)) {
  result_.status = ContactStatus::not_started;
  impulses_.setZero(motion_.rows());
}

bool ContactAutomaton::start(double t0, std::span<double> y, Gaps gaps) {
  result_ = {};
  result_.time = t0;
  y_ = y;
  motion_.forget();
  bounces_.assign(bounces_.size(), {});
  all_ = {};
  fastest_.setZero(motion_.rows());
  without_impact();
  impact_number_ = 0;
  has_event_ = false;
  ends_too_.fill(false);
  joins_.fill(false);
  if (!valid(options_)) return end(ContactStatus::invalid_options, std::nullopt);
  return valid_rules() && begin(t0, gaps);
}

bool ContactAutomaton::renew(std::span<double> y) {
  motion_.renew();
  y_ = y;
  has_event_ = false;
  PerContact<bool> rubbed{};
  bool any = false;
  for (int i = 0; i < count(); ++i) {
    rubbed[as(i)] = motion_.rule(i).law().rubs();
    any = motion_.take_rule(i) || any;
  }
  if (any && !valid_rules()) return false;
  if (!motion_.read(result_.time, y_)) return end(ContactStatus::integration_failed, std::nullopt);
  for (int i = 0; i < count(); ++i) {
    if (motion_.normal_has_jumped(i)) return end(ContactStatus::no_point, i);
    const bool slips = motion_.slip_has_jumped(i);  // a belt that was set to another speed
    if (slips || motion_.rule(i).law().rubs() != rubbed[as(i)]) set_by_slip(i, options_.at_rest);
    any = any || slips;
  }
  if (!any) return true;
  return settle(std::nullopt) && decide(std::nullopt, Cause::none);
}

ContactEvent ContactAutomaton::event() const noexcept {
  return {kind_,     told_,        contact_,  before_, y_, std::span(motion_.states).first(bounces_.size()),
          impulses_, energy_lost_, residual_, verdict_of_both(impact_verdict_, verdict_), std::span(found_).first(found_count_),
          std::span(struck_).first(struck_count_), order_matters_};
}

// What is told of an event with no impulses.
void ContactAutomaton::without_impact() noexcept {
  residual_ = energy_lost_ = 0;
  order_matters_ = false;
  impact_verdict_ = ContactVerdict::unique;
  struck_count_ = 0;
  impulses_.setZero(motion_.rows());
}

bool ContactAutomaton::end(ContactStatus status, std::optional<int> contact) noexcept {
  // A limit that the caller set is the caller's.
  const bool lost = status == ContactStatus::integration_failed && motion_.near_change_point() &&
                    result_.integration.status != IntegrationStatus::too_many_steps;
  result_.status = lost ? ContactStatus::change_point : status;
  result_.contact = contact;
  return false;
}

bool ContactAutomaton::valid_rules() noexcept {
  for (int i = 0; i < count(); ++i) {
    if (!valid_rule(motion_.rules(), i)) return end(ContactStatus::invalid_rule, i);
  }
  return true;
}

bool ContactAutomaton::begin(double t, Gaps gaps) {
  const bool finite = std::isfinite(t) && std::all_of(y_.begin(), y_.end(), [](double each) { return std::isfinite(each); });
  if (!finite) {
    result_.integration.status = IntegrationStatus::invalid_options;
    return end(ContactStatus::integration_failed, std::nullopt);
  }
  if (!motion_.settle_start(t, y_)) return end(ContactStatus::zero_quaternion, std::nullopt);
  if (!motion_.read(t, y_)) return end(ContactStatus::integration_failed, std::nullopt);
  const double off = motion_.loops_off();
  if (motion_.project(t, y_, 30) != Evaluation::ok || !motion_.read(t, y_)) {
    return have_points() && end(ContactStatus::integration_failed, std::nullopt);
  }
  if (!motion_.loops_closed(off)) return end(ContactStatus::open_loops, std::nullopt);
  for (int i = 0; i < count(); ++i) {
    if (std::isnan(motion_.reading().gap[as(i)])) return end(ContactStatus::no_point, i);
    const bool below = motion_.rule(i).normal && !(motion_.reading().gap[as(i)] >= -options_.touch);
    if (below && gaps == Gaps::of_a_start) return end(ContactStatus::penetrates, i);
    const bool has_struck = below && motion_.reading().w(motion_.first_row(i)) > options_.at_rest;
    touching_[as(i)] = motion_.states[as(i)].touches = near(i) && !has_struck;
  }
  // Gaps up to `touch` are closed: one that is left below zero would sink.
  if (motion_.project_positions(t, y_, 3) != Evaluation::ok || !motion_.read(t, y_)) {
    return end(ContactStatus::integration_failed, std::nullopt);
  }
  bool approaches = false;
  int first = 0;
  for (int i = count(); i-- > 0;) {
    if (!motion_.rule(i).normal || !touching_[as(i)]) continue;
    const double w = motion_.reading().w(motion_.first_row(i));
    motion_.states[as(i)].touches = std::abs(w) <= options_.at_rest;
    if (w < -options_.at_rest) {
      approaches = true;
      first = i;
    }
  }
  if (approaches) {
    std::copy_n(y_.begin(), before_.size(), before_.begin());
    kind_ = ContactEventKind::impact;
    contact_ = first;
    told_ = t;
    return has_event_ = collide(first, false, options_.law);
  }
  for (int i = 0; i < count(); ++i) {
    const std::optional<int> by = motion_.carrier(i);
    motion_.states[as(i)].touches =
        touching_[as(i)] && (!by || motion_.reading().w(motion_.first_row(*by)) <= options_.at_rest);
    set_by_slip(i, options_.at_rest);
  }
  return settle(std::nullopt) && decide(std::nullopt, Cause::none);
}

// Whether the gap is closed, as near as other contacts ask.
bool ContactAutomaton::near(int i) const noexcept {
  const std::optional<int> by = motion_.carrier(i);
  return !by || motion_.reading().gap[as(*by)] <= reach(*by);
}

// A gap that is as good as closed: events are located to roundings of the time, and of the gap.
double ContactAutomaton::reach(int i) const noexcept {
  const double unseen = 64 * std::numeric_limits<double>::epsilon() * std::abs(result_.time);
  const double way = unseen * std::abs(motion_.reading().w(motion_.first_row(i)));
  return std::max(options_.touch, 16 * motion_.rounding_of_gap(i) + way);
}

// Sticking or sliding by the velocity of slip; one that sticks is free to begin to slide.
void ContactAutomaton::set_by_slip(int i, double at_rest) noexcept {
  ContactState& state = motion_.states[as(i)];
  state.regime = ContactRegime::open;
  state.fastest = 0;
  state.begins = state.fades = false;
  state.residue = 0;
  if (!state.touches) return;
  state.regime = ContactRegime::slides;
  const int tangents = motion_.rule(i).tangents, t = motion_.tangent_row(i);
  if (tangents == 0) return;
  const double length = motion_.slip_speed(i);
  if (length <= at_rest && motion_.rule(i).law().rubs()) {
    state.regime = ContactRegime::sticks;
    return;
  }
  for (int k = 0; k < tangents && length > 0; ++k) state.direction[as(k)] = motion_.reading().w(t + k) / length;
}

// Contacts that stick have no velocity from now on: a slip that begins does so from rest.
bool ContactAutomaton::settle(std::optional<int> contact) {
  motion_.changed();
  if (motion_.project(result_.time, y_) != Evaluation::ok) return end(ContactStatus::integration_failed, contact);
  if (!raise_open()) return end(ContactStatus::integration_failed, contact);
  motion_.follow_slips(result_.time, y_);
  return true;
}

// Contacts up to `touch` from their surface are closed by the impact of another one: to close such a gap may put a contact below
// zero that the impact has opened. It is put on its surface with them.
bool ContactAutomaton::raise_open() {
  if (!motion_.read(result_.time, y_)) return true;  // whoever asks next says so
  PerContact<bool> below{};
  bool any = false;
  for (int i = 0; i < count(); ++i) {
    if (!motion_.rule(i).normal || motion_.states[as(i)].touches) continue;
    const double gap = motion_.reading().gap[as(i)];
    below[as(i)] = gap < -16 * motion_.rounding_of_gap(i) && gap >= -reach(i);
    any = any || below[as(i)];
  }
  if (!any) return true;
  const auto set = [&](bool touches) {
    for (int i = 0; i < count(); ++i) {
      if (below[as(i)]) motion_.states[as(i)].touches = touches;
    }
    motion_.changed();
  };
  set(true);
  const Evaluation raised = motion_.project_positions(result_.time, y_, 3);
  set(false);
  return raised == Evaluation::ok && motion_.project(result_.time, y_) == Evaluation::ok;
}

// The law by which the regime that follows is decided: a slip has its direction, one that begins has none yet.
ContactLaw ContactAutomaton::law_after(int i, std::optional<int> forced, Cause cause) const noexcept {
  const ContactState& state = motion_.states[as(i)];
  ContactLaw law = motion_.rule(i).law();
  const bool slid = state.regime == ContactRegime::slides && law.tangents > 0;
  const bool slides = slid && !(state.begins && motion_.slip(i) <= 16 * motion_.least_slip(i)) && !motion_.ends_too(i);
  const bool loose = cause == Cause::slips && i == forced;
  const bool falls = law.static_friction > law.friction || law.static_bound > law.bound;
  // Where friction falls as a slip begins, its direction is that of its acceleration; else that against T.
  if (slides || (loose && !falls)) {
    law.slips = true;
    law.slip = slides ? motion_.velocity_direction(i) : state.direction;
  } else if (slid || loose) {
    law.static_friction = law.friction;
    law.static_bound = law.bound;
  }
  return law;
}

// Of open contacts too: W, which is one for all, would not be numbers.
bool ContactAutomaton::have_points() noexcept {
  for (int i = 0; i < count(); ++i) {
    if (!motion_.has_point(i)) return end(ContactStatus::no_point, i);
  }
  return true;
}

// Which regimes follow: all that are consistent are sought, and the one of least motion is taken. The contact that had
// an event is not left to rounding: what the event says of it is given.
bool ContactAutomaton::decide(std::optional<int> forced, Cause cause) {
  if (!motion_.read(result_.time, y_)) return end(ContactStatus::integration_failed, forced);
  ContactSelection chosen;
  for (int i = 0; i < count(); ++i) {
    if (!motion_.states[as(i)].touches || (cause == Cause::opens && motion_.carrier(i) == forced)) continue;
    chosen.add(i, law_after(i, forced, cause), motion_.first_row(i), motion_.first_bearing(i));
  }
  if (chosen.problem.count > 0 && !have_points()) return false;
  ContactVector free = motion_.reading().drift;
  free.noalias() += motion_.reading().J * motion_.dynamics().a0;
  chosen.fill(motion_.W(), free, motion_.dynamics().S, motion_.dynamics().R_free);
  fastest_ = motion_.acceleration_sizes().cwiseMax(fastest_ / 2);  // a blow long ago says nothing of rounding now
  const ContactAnswer answer = solve_contacts(chosen.problem);
  result_.verdict = verdict_ = answer.verdict;
  note_found(chosen, answer);
  if (!answer && options_.impact_without_collision && chosen.problem.count == 1 && chosen.problem.law(0).normal &&
      chosen.problem.law(0).slips) {
    return impact_of_slip(chosen.who[0]);
  }
  if (!answer) return end(status_without_regimes(answer.verdict), forced.value_or(chosen.who[0]));
  if (answer.verdict == ContactVerdict::several) ++result_.ambiguous;
  if (answer.best().indeterminate) ++result_.indeterminate;
  residual_ = std::max(residual_, answer.best().residual);
  result_.worst_residual = std::max(result_.worst_residual, residual_);
  for (int i = 0; i < count() && cause == Cause::opens; ++i) {
    if (motion_.carrier(i) == forced) motion_.states[as(i)] = {};
  }
  PerContact<bool> moved{};  // slips already
  for (int k = 0; k < chosen.problem.count; ++k) moved[as(k)] = take_regime(chosen, k, answer.best());
  motion_.lean_on(chosen.spread(answer.best().r, motion_.rows()));
  if (!settle(forced)) return false;
  for (int k = 0; k < chosen.problem.count; ++k) {
    const int i = chosen.who[as(k)];
    ContactState& state = motion_.states[as(i)];
    if (state.begins && !moved[as(k)]) state.residue = motion_.slip_speed(i);
  }
  note_regularity();
  return true;
}

void ContactAutomaton::note_found(const ContactSelection& chosen, const ContactAnswer& answer) noexcept {
  found_count_ = answer.count;
  for (std::size_t j = 0; j < answer.count; ++j) found_[j] = chosen.spread(answer.solutions[j].regimes);
}

void ContactAutomaton::note_struck(const ContactSelection& chosen, const ImpactResult& shock) noexcept {
  impact_verdict_ = shock.verdict;
  if (shock.verdict == ContactVerdict::several) ++result_.ambiguous;
  struck_count_ = shock.found_count;
  for (std::size_t j = 0; j < struck_count_; ++j) struck_[j] = chosen.spread(shock.found[j]);
}

// On which side of zero the regimes that begin are.
void ContactAutomaton::note_regularity() {
  const bool known = motion_.solve(result_.time, y_) == Evaluation::ok;
  side_ = known && motion_.regularity() < 0 ? -1 : 1;
  began_regular_ = known ? std::abs(motion_.regularity()) : 1;
}

// The equations of the present regimes have become singular, to eight digits: beyond, steps shrink without end. Many
// motions run into such a state, and many leave it: no decision there is more than rounding (Génot & Brogliato 1999).
bool ContactAutomaton::pass_singular() {
  if (motion_.solve(result_.time, y_) != Evaluation::ok) return end(ContactStatus::integration_failed, std::nullopt);
  return end(ContactStatus::jams, motion_.busiest_slip());
}

// Whether the contact slips as it did before.
bool ContactAutomaton::take_regime(const ContactSelection& chosen, int k, const ContactSolution& s) {
  const ContactProblem& problem = chosen.problem;
  const ContactLaw& law = problem.law(k);
  const int i = chosen.who[as(k)], n = problem.first_row(k), t = problem.tangent_row(k);
  const std::optional<int> by = motion_.carrier(i);
  ContactState& state = motion_.states[as(i)];
  // Two that neither press nor part, as pendulums of one length side by side, would else part and strike without end.
  const double part = 1e-12 * bounces_[as(i)].doubt;
  const double none = law.normal ? part * (fastest_(chosen.row[as(n)]) + problem.W.row(n).cwiseAbs().dot(s.r.cwiseAbs())) : 0;
  const bool opens = law.normal ? s.u(n) > none : by && !motion_.states[as(*by)].touches;
  if (opens) {
    state = {};
    return false;
  }
  if (law.bearing > 0) motion_.press_along(i, problem.bearing(k, s.r));
  state.idle = law.normal && s.r(n) * problem.W(n, n) <= none;
  const bool moved = law.slips && state.regime == ContactRegime::slides, slid = moved && !state.begins;
  if (!slid) {
    state.fastest = 0;
    state.fades = false;
  }
  const auto length_of = [&](const ContactVector& rows) {
    double length = 0;
    for (int j = 0; j < law.tangents; ++j) length = std::hypot(length, rows(t + j));
    return length;
  };
  // One that opens too slowly to be let go does not slide by that, as a corner from which a box begins to tip.
  const bool rests = s.regimes[as(k)] == ContactRegime::open && law.rubs() &&
                     length_of(s.u) <= part * length_of(problem.W.cwiseAbs() * s.r.cwiseAbs() + problem.q.cwiseAbs());
  if (law.slips) {
    state.regime = ContactRegime::slides;
    state.direction = law.slip;
  } else if (s.regimes[as(k)] == ContactRegime::sticks || rests) {
    state.regime = ContactRegime::sticks;
  } else {
    state.regime = ContactRegime::slides;
    // T = -(f N + b) d; the acceleration may be rounding where the slip begins.
    const ContactVector against = length_of(s.r) > 0 ? ContactVector(-s.r) : s.u;
    const double length = length_of(against);
    for (int j = 0; j < law.tangents && length > 0; ++j) state.direction[as(j)] = against(t + j) / length;
  }
  // One that stuck has a slip from now on: what it has of a velocity, however small, has no direction of its own.
  state.begins = state.regime == ContactRegime::slides && !slid && law.rubs() &&
                 (!moved || motion_.slip(i) <= 1e4 * motion_.least_slip(i));
  if (state.begins) state.begun = result_.time;
  if (!moved) state.residue = 0;
  // N, or what is left of the bound of T, that is zero to rounding may fall from there.
  const ContactVector forces = ContactScale(problem).forces(s.r);
  const double force = std::max(law.normal ? forces(n) : 0, size_along(forces, s.r, t, law.tangents));
  double left = law.normal ? s.r(n) : force;
  if (state.regime == ContactRegime::sticks) {
    left = std::min(left, law.static_friction * problem.pressing(k, s.r) + law.static_bound - length_of(s.r));
  }
  state.force_slack = left <= 1e-10 * force ? 4e-12 * force : 0;
  return moved;
}

bool ContactAutomaton::pass(std::size_t index, double t, std::span<double> y) {
  const PerContact<ContactState> before = motion_.states;
  if (pass_event(index, t, y)) return true;
  motion_.states = before;  // what ends the motion is told with the regimes until then
  return false;
}

bool ContactAutomaton::pass_event(std::size_t index, double t, std::span<double> y) {
  result_.time = t;
  y_ = y;
  has_event_ = false;
  motion_.leave_change_point();
  motion_.follow_slips(t, y);
  ends_too_.fill(false);
  if (index == guards * bounces_.size()) return pass_singular();
  const int contact = static_cast<int>(index / guards);
  const auto watched = static_cast<Watched>(index % guards);
  if (watched != Watched::youth && !still_slips(contact, watched)) {
    has_event_ = true;
    return happened(contact, watched == Watched::gap_or_pressure);
  }
  // The slip goes on, with the direction that it has got: no event.
  if (!motion_.read(t, y)) return end(ContactStatus::integration_failed, contact);
  if (watched == Watched::youth && !motion_.states[as(contact)].begins) {
    motion_.fade(contact, t, y);
  } else {
    motion_.take_direction(contact);
  }
  note_regularity();
  return true;
}

// In space the slip may turn round quickly without an end: it passes zero at a distance, as where its surface jumps.
bool ContactAutomaton::still_slips(int contact, Watched watched) {
  const ContactState& state = motion_.states[as(contact)];
  return watched == Watched::slip_or_margin && state.touches && state.regime == ContactRegime::slides && !state.begins &&
         motion_.read(result_.time, y_) && motion_.slips_across(contact);
}

bool ContactAutomaton::happened(int contact, bool normal) {
  std::copy_n(y_.begin(), before_.size(), before_.begin());
  ContactState& state = motion_.states[as(contact)];
  without_impact();
  contact_ = contact;
  told_ = result_.time;
  if (normal && !state.touches) {
    ++result_.events;
    return strike(contact);
  }
  if (motion_.solve(result_.time, y_) != Evaluation::ok) return end(ContactStatus::integration_failed, contact);
  if (motion_.undetermined(contact) && (normal || state.regime == ContactRegime::sticks)) return pass_on(normal);
  ++result_.events;
  if (normal) {
    kind_ = ContactEventKind::opens;
    bounces_[as(contact)].left = result_.time;
    return decide(contact, Cause::opens);
  }
  return state.regime == ContactRegime::slides ? end_slips(contact) : begin_to_slide(contact);
}

// The slip of a contact has ended, and with it those of which errors of the integration are left: each is an event. What is
// left of them is taken away before the regimes that follow are decided: a slip that began with it against its direction would
// end at once, and begin again.
bool ContactAutomaton::end_slips(int contact) {
  kind_ = ContactEventKind::slip_ends;
  ends_too_[as(contact)] = true;
  bool more = true;
  while (more) {
    for (int i = 0; i < count(); ++i) {
      ContactState& state = motion_.states[as(i)];
      if (!ends_too_[as(i)]) continue;
      state.regime = ContactRegime::sticks;  // or whatever the laws say from rest
      state.begins = state.fades = false;
    }
    if (!settle(contact)) return false;
    if (!motion_.read(result_.time, y_)) return end(ContactStatus::integration_failed, contact);
    PerContact<bool> all;
    PerContact<double> approach{}, slip;
    all.fill(true);
    slip.fill(std::numeric_limits<double>::infinity());
    for (int i = 0; i < count(); ++i) {
      if (motion_.rule(i).normal) approach[as(i)] = 64 * motion_.rounding_of(motion_.first_row(i));
    }
    if (!close_what_rests(all, approach, slip)) return false;
    more = false;
    for (int i = 0; i < count(); ++i) {
      const ContactState& state = motion_.states[as(i)];
      if (!(state.touches && state.regime == ContactRegime::slides && motion_.ends_too(i))) continue;
      ends_too_[as(i)] = more = true;
      ++result_.events;
    }
  }
  ends_too_[as(contact)] = false;  // it is told of first
  return decide(contact, Cause::none);
}

void ContactAutomaton::next_event() noexcept {
  const auto next = std::find(ends_too_.begin(), ends_too_.end(), true);
  has_event_ = next != ends_too_.end();
  if (!has_event_) return;
  contact_ = static_cast<int>(next - ends_too_.begin());
  *next = false;
}

// The force of a contact has come to its bound, but reactions are not unique. As long as others hold the contacts as they
// are, nothing happens: rest persists where it can.
bool ContactAutomaton::pass_on(bool normal) {
  const PerContact<ContactState> before = motion_.states;
  kind_ = normal ? ContactEventKind::opens : ContactEventKind::slips;
  if (!decide(std::nullopt, Cause::none)) return false;
  has_event_ = false;
  for (int i = 0; i < count(); ++i) {
    const ContactState& now = motion_.states[as(i)];
    has_event_ = has_event_ || now.touches != before[as(i)].touches || now.regime != before[as(i)].regime;
  }
  if (has_event_) ++result_.events;
  return true;
}

// Friction has reached its bound: the slip begins against it.
bool ContactAutomaton::begin_to_slide(int contact) {
  kind_ = ContactEventKind::slips;
  if (motion_.solve(result_.time, y_) != Evaluation::ok) return end(ContactStatus::integration_failed, contact);
  const int t = motion_.tangent_row(contact);
  const double length = motion_.friction_force(contact);
  for (int k = 0; k < motion_.rule(contact).tangents; ++k) {
    motion_.states[as(contact)].direction[as(k)] = -motion_.reactions()(t + k) / length;
  }
  return decide(contact, Cause::slips);
}

}  // namespace torsor::runtime
