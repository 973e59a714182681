// SPDX-License-Identifier: MIT
// Impacts of a contact motion, the accumulations that they end in, and edges that are left without one.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "torsor/runtime/contacts/contact_automaton.hpp"

namespace torsor::runtime {

// No regimes exist while one contact slips (Painlevé): its impulse grows until the slip has ended, and the contact opens
// or sticks.
bool ContactAutomaton::impact_of_slip(int contact) {
  if (!has_event_) std::copy_n(y_.begin(), before_.size(), before_.begin());
  has_event_ = true;
  contact_ = contact;
  told_ = result_.time;
  kind_ = ContactEventKind::impact;
  for (int i = 0; i < count(); ++i) touching_[as(i)] = i == contact;
  return collide(contact, false, ImpactLaw::energetic);
}

// When the bounces of one contact end: each is ρ times as long as the one before, ρ the ratio of the last two speeds of
// approach, and the next one lasts 2 ρ w/a, a the acceleration towards the contact. Rounding of late impacts counts once
// here, and their intervals need not shrink evenly before.
double ContactAutomaton::end_of_bounces(int i, double speed, double a) const noexcept {
  const double last = bounces_[as(i)].speed, ratio = last > 0 ? speed / last : 1;
  if (!(a > 0 && ratio < 1)) return result_.time;
  return result_.time + 2 * ratio * speed / (a * (1 - ratio));
}

// Whether a contact takes part in the accumulation: of one contact, or of those of the last seventeen impacts. Two that
// strike in turn, each impact some hundred times weaker, get to flights within rounding after few impacts.
bool ContactAutomaton::accumulating(int i) const noexcept {
  if (joins_[as(i)]) return true;
  const bool recent = bounces_[as(i)].last > 0 && bounces_[as(i)].last + 17 > impact_number_;
  if (!alone_) return recent;
  if (i == cause_) return true;
  if (!buried_ || !recent) return false;
  const double w = motion_.reading().w(motion_.first_row(i));
  return w * w <= 2 * motion_.acceleration_terms(i) * motion_.rounding_of_gap(i);
}

// Three corners of a face that have come to rest hold the fourth: it has neither a gap nor a velocity, and would be left open
// without an event that closes it. So has a body in a groove, drawn to one wall as its slip along the other ends: no gap would fall
// through zero. What is left of velocities counts as none up to these sizes.
bool ContactAutomaton::close_what_rests(const PerContact<bool>& among, const PerContact<double>& approach,
                                        const PerContact<double>& slip) {
  bool any = false;
  for (int i = 0; i < count(); ++i) {
    ContactState& state = motion_.states[as(i)];
    if (!among[as(i)] || !motion_.rule(i).normal || state.touches) continue;
    const bool closed = motion_.reading().gap[as(i)] <= 16 * motion_.rounding_of_gap(i);
    if (!closed || std::abs(motion_.reading().w(motion_.first_row(i))) > approach[as(i)]) continue;
    state.touches = any = true;
    set_by_slip(i, slip[as(i)]);
  }
  return !any || settle(contact_);
}

// An impact of all contacts that touch; `rests` makes it completely inelastic, the end of an accumulation.
bool ContactAutomaton::collide(int cause, bool rests, ImpactLaw impact_law) {
  if (!motion_.read(result_.time, y_)) return end(ContactStatus::integration_failed, cause);
  if (!have_points()) return false;
  ContactSelection chosen;
  PerContact<double> restitution{};
  for (int i = 0; i < count(); ++i) {
    if (!touching_[as(i)] || (!motion_.carrier(i) && motion_.rule(i).bearing == 0)) continue;
    ContactLaw law = motion_.rule(i).law();
    law.static_friction = law.friction;
    law.bound = law.static_bound = 0;  // bounded forces give no impulse
    restitution[as(chosen.problem.count)] = rests && accumulating(i) ? 0 : motion_.rule(i).restitution;
    chosen.add(i, law, motion_.first_row(i), motion_.first_bearing(i));
  }
  // One that stuck has no slip: what is left of its velocity gets no direction by an impact that does not move it.
  PerContact<double> residue{};
  for (int i = 0; i < count(); ++i) {
    const ContactState& state = motion_.states[as(i)];
    if (state.touches && state.regime == ContactRegime::sticks) residue[as(i)] = motion_.slip_speed(i);
  }
  const Eigen::MatrixXd& W = motion_.W();  // asked for first: `rounding_of` takes what loops answer from it
  ContactVector before = motion_.reading().w;
  for (int k = 0; k < chosen.problem.count; ++k) {
    const int i = chosen.who[as(k)], n = motion_.first_row(i);
    // One that rests does not strike by what rounding leaves of its velocity, whatever moved a moment ago.
    const bool rests_already = motion_.states[as(i)].touches || std::abs(before(n)) <= 64 * motion_.rounding_of(n);
    if (chosen.problem.law(k).normal && rests_already) before(n) = 0;
  }
  chosen.fill(W, before, motion_.dynamics().S, Eigen::VectorXd::Zero(motion_.first_bearing(count())));
  const ContactProblem& problem = chosen.problem;
  const ImpactResult shock = impact(problem, restitution, impact_law);
  result_.verdict = shock.verdict;
  if (!shock.applies) return end(ContactStatus::law_of_one_contact, cause);
  if (shock.verdict == ContactVerdict::none) return end(ContactStatus::no_impact, cause);
  if (without_solution(shock.verdict)) return end(ContactStatus::not_found, cause);
  note_struck(chosen, shock);
  order_matters_ = shock.order_matters;
  if (order_matters_) ++result_.order_matters;
  residual_ = shock.residual;
  result_.worst_residual = std::max(result_.worst_residual, residual_);
  impulses_ = chosen.spread(shock.P, motion_.rows());
  energy_lost_ = shock.lost;
  if (shock.gains) return end(ContactStatus::energy_gained, cause);
  // What rounding leaves of a velocity that the impact ends is a part of the velocities before.
  const auto rounding_after = [&](int row) {
    const double change = W.row(row).cwiseAbs().dot(impulses_.cwiseAbs());
    return motion_.rounding_of(row) + std::numeric_limits<double>::epsilon() * change;
  };
  PerContact<double> rounding{}, rounding_of_opening{};
  PerContact<bool> rests_on{};
  for (int k = 0; k < problem.count; ++k) {
    const int i = chosen.who[as(k)], n = problem.first_row(k);
    // A contact that rested and is not pressed by the impact has what rounding leaves of its velocity: it has not opened.
    rounding_of_opening[as(i)] = rounding_after(motion_.first_row(i));
    rests_on[as(i)] = problem.law(k).normal && problem.q(n) == 0 && shock.w(n) <= 64 * rounding_of_opening[as(i)];
  }
  for (int i = 0; i < count(); ++i) {
    if (motion_.rule(i).tangents > 0) rounding[as(i)] = rounding_after(motion_.tangent_row(i)) + residue[as(i)] / 64;
  }
  motion_.add_answer(impulses_, y_);
  ++result_.impacts;
  if (!motion_.read(result_.time, y_)) return end(ContactStatus::integration_failed, cause);
  PerContact<bool> held{};  // joints that stick
  for (int k = 0; k < problem.count; ++k) {
    const int i = chosen.who[as(k)];
    const std::optional<int> by = motion_.carrier(i);
    held[as(i)] = shock.sticks[as(k)];
    if (!by) continue;
    // What is left of an accumulation's velocity is rounding: projection takes it away.
    motion_.states[as(i)].touches =
        by != i ? motion_.states[as(*by)].touches : shock.closed[as(k)] || rests_on[as(i)] || (rests && accumulating(i));
    // A slip of that size has no direction: one that the impact leaves alone would get the direction of its rounding.
    set_by_slip(i, shock.sticks[as(k)] ? std::numeric_limits<double>::infinity() : 64 * rounding[as(i)]);
  }
  if (rests) {
    // That velocity leaves with it what slip it makes of contacts that do not stick.
    PerContact<bool> among{};
    PerContact<double> slip{};
    for (int k = 0; k < problem.count; ++k) among[as(chosen.who[as(k)])] = true;
    for (int i = 0; i < count(); ++i) {
      rounding_of_opening[as(i)] *= 64;
      slip[as(i)] = 64 * rounding[as(i)];
    }
    if (!settle(cause) || !close_what_rests(among, rounding_of_opening, slip)) return false;
    for (int k = 0; k < problem.count; ++k) {
      const int i = chosen.who[as(k)];
      if (motion_.carrier(i) && !shock.sticks[as(k)]) set_by_slip(i, 64 * rounding[as(i)]);
    }
  }
  for (int i = 0; i < count(); ++i) {
    if (motion_.carrier(i)) continue;
    motion_.states[as(i)].touches = true;
    set_by_slip(i, held[as(i)] ? std::numeric_limits<double>::infinity() : 64 * rounding[as(i)]);
  }
  return settle(cause) && decide(std::nullopt, Cause::none);
}

// Whether a flight that begins with this speed rises above the rounding of the gap.
bool ContactAutomaton::leaves_rounding(int contact, double speed) const noexcept {
  return speed * speed > 32 * motion_.acceleration_terms(contact) * motion_.rounding_of_gap(contact);
}

// A gap has fallen to zero: an impact, or the last one of bounces that accumulate.
bool ContactAutomaton::strike(int contact) {
  if (motion_.solve(result_.time, y_) != Evaluation::ok) return end(ContactStatus::integration_failed, contact);
  if (motion_.gap_jumps(contact)) return end(ContactStatus::no_point, contact);
  Bounces& bounces = bounces_[as(contact)];
  // Late bounces end by the rounding of the gap, whose lengths may have grown since the start.
  if (bounces.slower > 3 && (bounces.slower & (bounces.slower - 1)) == 0) (void)motion_.gaps_are_rougher();
  const double speed = std::abs(motion_.reading().w(motion_.first_row(contact)));
  const double rounding = motion_.rounding_of_gap(contact);
  // A floor may fall faster than a body on it for so short a time that the gap opens by less than its rounding: it strikes
  // where it opened, and would open again without end. It is closed until it is drawn away twice as fast.
  const bool rose = speed * (result_.time - bounces.left) > 16 * rounding || leaves_rounding(contact, speed);
  bounces.doubt = rose ? 1 : std::min(2 * bounces.doubt, most_doubt);
  const double last_flight = result_.time - bounces.left;
  bounces.left = result_.time;
  // Where the flights left rise by less than 1e6 roundings of the gap, the next impacts are known less well.
  const double unresolved = speed > 0 ? 1e6 * rounding / speed : 0;
  const double a = -motion_.gap_acceleration(contact), limit = end_of_bounces(contact, speed, a);
  // The next flight would not leave the rounding of the gap.
  const bool buried = a > 0 && speed * speed <= 2 * a * rounding;
  bounces.slower = limit > result_.time ? bounces.slower + 1 : 0;
  bounces.limit(result_.time, speed, rounding);
  const bool fades = bounces.slower >= 3 && limit - result_.time <= unresolved;
  const bool alone = bounces.watch(result_.time, options_.accumulation) || fades || buried;
  const double remaining = std::max(options_.accumulation, unresolved);
  const bool together = all_(result_.time, remaining), follows = result_.time <= bounces.ends_by;
  const bool rests = alone || together || follows;
  bounces.ends_by = std::numeric_limits<double>::lowest();
  bounces.last = ++impact_number_;
  alone_ = alone || follows;
  buried_ = buried;
  cause_ = contact;
  kind_ = ContactEventKind::impact;
  if (rests) {
    kind_ = ContactEventKind::accumulation;
    ++result_.accumulations;
    // The contact is closed from now on: until the limit the impulses of all bounces and of rest are the same.
    told_ = follows ? result_.time : bounces.limit(std::max(result_.time, alone ? limit : all_.limit()), result_.time);
    // Contacts that strike in turn at speeds that hardly fade tell no limit by their speeds.
    if (together && !alone && told_ > result_.time + 2 * remaining) told_ = std::max(result_.time, all_.limit());
  }
  for (int i = 0; i < count(); ++i) {
    touching_[as(i)] = motion_.carrier(i) == contact || motion_.states[as(i)].touches || near(i);
  }
  bounces.speed = speed;
  // Corners of a face that land together end their bounces together, and so does what flies for some roundings of the time.
  // Bodies that the impact does not move have their own end.
  const double unseen = 64 * std::numeric_limits<double>::epsilon() * std::abs(result_.time);
  const int cause = motion_.first_row(contact);
  for (int i = 0; i < count(); ++i) {
    joins_[as(i)] = false;
    if (!motion_.rule(i).normal) continue;
    const int n = motion_.first_row(i);
    const Eigen::MatrixXd& W = motion_.W();
    const bool moved = std::abs(W(n, cause)) > 1e-8 * std::sqrt(W(n, n) * W(cause, cause));
    if (!touching_[as(i)]) {
      // What struck since the last impact of this one is on its way back, sooner than from its last: its bounces end with that.
      const double flight = result_.time - bounces_[as(i)].left;
      if (rests && !alone_ && moved && flight <= last_flight) bounces_[as(i)].ends_by = result_.time + flight;
      continue;
    }
    const double approach = -motion_.reading().w(n);
    joins_[as(i)] = rests && moved && std::abs(approach) <= unseen * motion_.acceleration_terms(i);
    if (!(approach > 64 * motion_.rounding_of(n))) continue;
    Bounces& own = bounces_[as(i)];
    if (rests && moved && approach <= 2 * speed && own.struck > 0 && own.struck + 17 > impact_number_) joins_[as(i)] = true;
    own.struck = impact_number_;
  }
  const bool done = collide(contact, rests, rests ? ImpactLaw::newton_moreau : options_.law);
  if (rests) {
    for (int i = 0; i < count(); ++i) {
      if (!accumulating(i)) continue;
      bounces_[as(i)].begin_anew();
    }
    all_ = {};
  }
  joins_.fill(false);
  return done;
}

// What leaves an edge has nothing under it, and neither has what rides over a ridge: no law is asked. What would fall below a
// surface there, or meets a wall, ends the motion.
bool ContactAutomaton::pass_edge(int contact, double t, std::span<double> y) {
  result_.time = t;
  y_ = y;
  motion_.leave_change_point();
  ends_too_.fill(false);
  std::copy_n(y.begin(), before_.size(), before_.begin());
  std::optional<double> later = motion_.pass_edge(contact, t, y);
  if (!later) later = motion_.pass_ridge(contact, t, y);
  if (!later) return pass_jump_of_slip(contact, t);
  result_.time = told_ = t + *later;
  for (int i = 0; i < count(); ++i) {
    const bool touches = motion_.rule(i).normal && motion_.states[as(i)].touches;
    const bool off = touches && motion_.off_by_a_jump(i, *later), turned = touches && motion_.normal_has_jumped(i);
    if (i == contact || !(off || turned)) continue;
    if (off ? motion_.reading().gap[as(i)] < 0 : !motion_.parts_by_a_jump(i)) return end(ContactStatus::no_point, i);
    ends_too_[as(i)] = true;
    ++result_.events;
  }
  for (int i = 0; i < count(); ++i) {
    const std::optional<int> by = motion_.carrier(i);
    if (!by || !(by == contact || ends_too_[as(*by)])) continue;
    motion_.states[as(i)] = {};
    bounces_[as(i)].left = result_.time;
  }
  motion_.changed();
  has_event_ = true;
  contact_ = contact;
  kind_ = ContactEventKind::opens;
  without_impact();
  ++result_.events;
  return decide(contact, Cause::opens);
}

// A surface jumps along itself: what stuck to it slides from there on, with the velocities that it has. No impulse acts.
bool ContactAutomaton::pass_jump_of_slip(int contact, double t) {
  const std::optional<double> later = motion_.pass_jump_of_slip(contact, t, y_);
  if (!later || !motion_.read(t + *later, y_)) return end(ContactStatus::no_point, contact);
  result_.time = told_ = t + *later;
  for (int i = 0; i < count(); ++i) {
    if (!motion_.slip_has_jumped(i)) continue;
    set_by_slip(i, 0);
    ends_too_[as(i)] = i != contact;
    ++result_.events;
  }
  motion_.changed();
  has_event_ = true;
  contact_ = contact;
  kind_ = ContactEventKind::slips;
  without_impact();
  return settle(contact) && decide(std::nullopt, Cause::none);
}

}  // namespace torsor::runtime
