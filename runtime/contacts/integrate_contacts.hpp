// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "runtime/contacts/bounce_limit.hpp"
#include "runtime/contacts/contact_motion.hpp"
#include "runtime/contacts/contact_result.hpp"
#include "runtime/contacts/impact_laws.hpp"
#include "runtime/integration/dormand_prince_853.hpp"
#include "runtime/integration/events.hpp"

namespace torsor::runtime {

/// Event-driven motion of a mechanism with contacts, which may be taken from time to time: `start` at t0, then `advance`
/// to later and later times. What it knows of regimes, slips and bounces is kept in between.
template <ContactSystem S, class Method, class Observer>
class ContactRun {
 public:
  using Motion = ContactMotion<S>;
  using Vector = typename Motion::Vector;
  static constexpr int contacts = Motion::contacts;

  ContactRun(const S& system, Vector& y, const Method& method, const ContactOptions& options, Observer& observer)
      : motion_(system), y_(y), method_(method), options_(options), observer_(observer) {}

  /// Puts the state on its constraints and decides the first regimes; false where the motion cannot begin.
  bool start(double t0) {
    result_.time = t0;
    return valid_rules() && begin(t0);
  }

  /// Goes on to t1, which is not before; false where the motion ends earlier.
  bool advance(double t1) {
    if (!(t1 >= result_.time)) return end(ContactStatus::integration_failed, -1);
    int stuck = 0;
    while (result_.status == ContactStatus::reached_end && result_.time < t1) {
      const double before = result_.time;
      if (!advance_to_event(t1)) break;
      // Regimes that alternate at one time come to no end.
      stuck = result_.time > before ? 0 : stuck + 1;
      if (stuck > 100 || result_.events > options_.event_limit) result_.status = ContactStatus::too_many_events;
    }
    return result_.status == ContactStatus::reached_end;
  }

  [[nodiscard]] const ContactResult& result() const noexcept { return result_; }
  [[nodiscard]] Motion& motion() noexcept { return motion_; }

 private:
  enum class Watched { gap_or_pressure, slip_or_margin, youth };
  struct Value {
    Motion* motion;
    int contact;
    Watched watched;
    double operator()(double t, const Vector& y) const {
      const ContactState& state = motion->states[as(contact)];
      const ContactRule rule = motion->system().rule(contact);
      if (!motion->read(t, y)) return std::numeric_limits<double>::quiet_NaN();
      if (watched == Watched::gap_or_pressure) {
        if (!rule.normal) return 1;
        if (!state.touches) return motion->reading().gap[as(contact)];
        if (motion->solve(t, y) != Evaluation::ok) return std::numeric_limits<double>::quiet_NaN();
        return motion->reactions()(motion->normal_row(contact)) + state.force_slack;
      }
      if (!state.touches || rule.tangents == 0 || state.regime == ContactRegime::open) return 1;
      if (watched == Watched::youth) {
        if (state.regime != ContactRegime::slides) return 1;
        if (!state.begins && (state.fades || rule.tangents < 2)) return 1;
        if (state.begins && motion->solve(t, y) != Evaluation::ok) return std::numeric_limits<double>::quiet_NaN();
        return motion->youth(contact, t);
      }
      // What starts from zero is watched from a little above, so that it is seen to fall.
      if (state.regime == ContactRegime::slides) {
        return motion->slip(contact) + (state.begins && !state.fades ? motion->least_slip(contact) : 0);
      }
      if (motion->solve(t, y) != Evaluation::ok) return std::numeric_limits<double>::quiet_NaN();
      return motion->margin(contact) + state.force_slack;
    }
  };
  struct End {
    bool operator()(double, Vector&) const noexcept { return false; }
  };
  using Watch = Guard<Value, End>;

  static constexpr std::size_t as(int i) noexcept { return static_cast<std::size_t>(i); }

  [[nodiscard]] bool valid_rules() noexcept {
    for (int i = 0; i < contacts; ++i) {
      if (!valid_rule(motion_.system(), i)) return end(ContactStatus::invalid_rule, i);
    }
    return true;
  }

  bool end(ContactStatus status, int contact) noexcept {
    result_.status = status;
    result_.contact = contact;
    return false;
  }

  bool begin(double t) {
    if (motion_.project(t, y_) != Evaluation::ok || !motion_.read(t, y_)) {
      return end(ContactStatus::integration_failed, -1);
    }
    bool approaches = false;
    int first = 0;
    for (int i = contacts; i-- > 0;) {
      const ContactRule rule = motion_.system().rule(i);
      if (rule.normal && motion_.reading().gap[as(i)] < -options_.touch) return end(ContactStatus::penetrates, i);
      touching_[as(i)] = near(i);
      if (rule.normal && touching_[as(i)] && motion_.reading().w(motion_.normal_row(i)) < -options_.at_rest) {
        approaches = true;
        first = i;
      }
    }
    if (approaches) return collide(first, false);
    for (int i = 0; i < contacts; ++i) {
      ContactState& state = motion_.states[as(i)];
      const int by = motion_.carrier(i);
      state.touches =
          touching_[as(i)] && (by < 0 || motion_.reading().w(motion_.normal_row(by)) <= options_.at_rest);
      set_by_slip(i, options_.at_rest);
    }
    return decide(-1, Cause::none);
  }

  // Whether the gap is closed, as near as other contacts ask.
  [[nodiscard]] bool near(int i) const noexcept {
    const int by = motion_.carrier(i);
    return by < 0 || motion_.reading().gap[as(by)] <= options_.touch;
  }

  // Sticking or sliding by the velocity of slip; one that sticks is free to begin to slide.
  void set_by_slip(int i, double at_rest) noexcept {
    ContactState& state = motion_.states[as(i)];
    state.regime = ContactRegime::open;
    state.fastest = 0;
    state.begins = state.fades = false;
    if (!state.touches) return;
    const ContactRule rule = motion_.system().rule(i);
    state.regime = ContactRegime::slides;
    if (rule.tangents == 0) return;
    const int t = motion_.tangent_row(i);
    double length = 0;
    for (int k = 0; k < rule.tangents; ++k) length = std::hypot(length, motion_.reading().w(t + k));
    if (length <= at_rest) {
      state.regime = ContactRegime::sticks;
      return;
    }
    for (int k = 0; k < rule.tangents; ++k) state.direction[as(k)] = motion_.reading().w(t + k) / length;
  }

  enum class Cause { none, opens, slips };

  // Which regimes follow: all that are consistent are sought, and the one of least motion is taken. The contact that
  // had an event is not left to rounding: what the event says of it is given.
  bool decide(int forced, Cause cause) {
    if (!motion_.read(result_.time, y_)) return end(ContactStatus::integration_failed, forced);
    const auto& reading = motion_.reading();
    const auto whole = motion_.problem_of(reading.J * motion_.dynamics().a0 + reading.drift);
    typename Motion::Problem problem;
    std::array<int, S::contacts> who{}, place{};
    std::array<int, static_cast<std::size_t>(3 * contacts)> row{};
    int rows = 0;
    for (int i = 0; i < contacts; ++i) {
      const ContactState& state = motion_.states[as(i)];
      if (!state.touches || (cause == Cause::opens && motion_.carrier(i) == forced)) continue;
      ContactLaw law = whole.law(i);
      place[as(i)] = problem.count;
      if (law.pressed_by >= 0) law.pressed_by = place[as(law.pressed_by)];
      const bool slid = state.regime == ContactRegime::slides && law.tangents > 0;
      const bool slides = slid && !(state.begins && motion_.slip(i) <= 16 * motion_.least_slip(i));
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
      for (int k = 0; k < law.rows(); ++k) row[as(rows++)] = whole.first_row(i) + k;
      who[as(problem.count)] = i;
      problem.laws[as(problem.count++)] = law;
    }
    problem.W.resize(rows, rows);
    problem.q.resize(rows);
    for (int i = 0; i < rows; ++i) {
      problem.q(i) = whole.q(row[as(i)]);
      for (int j = 0; j < rows; ++j) problem.W(i, j) = whole.W(row[as(i)], row[as(j)]);
    }
    const ContactAnswer<contacts> answer = solve_contacts(problem);
    result_.verdict = verdict_ = answer.verdict;
    if (!answer) return end(ContactStatus::no_solution, forced >= 0 ? forced : who[0]);
    if (answer.verdict == ContactVerdict::several) ++result_.ambiguous;
    if (answer.best().indeterminate) ++result_.indeterminate;
    residual_ = std::max(residual_, answer.best().residual);
    result_.worst_residual = std::max(result_.worst_residual, residual_);
    for (int i = 0; i < contacts && cause == Cause::opens; ++i) {
      if (motion_.carrier(i) == forced) motion_.states[as(i)] = {};
    }
    for (int k = 0; k < problem.count; ++k) {
      const int i = who[as(k)];
      ContactState& state = motion_.states[as(i)];
      const ContactSolution<contacts>& s = answer.best();
      const int n = problem.first_row(k), t = problem.tangent_row(k);
      const int by = motion_.carrier(i);
      const bool opens = problem.law(k).normal ? s.u(n) > 0 : by >= 0 && !motion_.states[as(by)].touches;
      if (opens) {
        state = {};
        continue;
      }
      const bool slid = state.regime == ContactRegime::slides && !state.begins;
      if (!slid) {
        state.fastest = 0;
        state.fades = false;
      }
      if (problem.law(k).slips) {
        state.regime = ContactRegime::slides;
        state.direction = problem.law(k).slip;
      } else if (s.regimes[as(k)] == ContactRegime::sticks) {
        state.regime = ContactRegime::sticks;
      } else {
        state.regime = ContactRegime::slides;
        double length = 0;
        for (int j = 0; j < problem.law(k).tangents; ++j) length = std::hypot(length, s.u(t + j));
        for (int j = 0; j < problem.law(k).tangents && length > 0; ++j) state.direction[as(j)] = s.u(t + j) / length;
      }
      state.begins = state.regime == ContactRegime::slides && !slid && problem.law(k).tangents > 0 &&
                     motion_.slip(i) <= 1e4 * motion_.least_slip(i);
      if (state.begins) state.begun = result_.time;
      // N, or what is left of the bound of T, that is zero to rounding may fall from there.
      const double force = s.r.cwiseAbs().maxCoeff(), N = problem.law(k).normal ? s.r(n) : force;
      double left = N;
      if (state.regime == ContactRegime::sticks) {
        double T = 0;
        for (int j = 0; j < problem.law(k).tangents; ++j) T = std::hypot(T, s.r(t + j));
        left = std::min(
            left, problem.law(k).static_friction * problem.pressing(k, s.r) + problem.law(k).static_bound - T);
      }
      state.force_slack = left <= 1e-10 * force ? 4e-12 * force : 0;
    }
    motion_.changed();
    return motion_.project(result_.time, y_) == Evaluation::ok || end(ContactStatus::integration_failed, forced);
  }

  // When the bounces of one contact end: each is ρ times as long as the one before, ρ the ratio of the last two speeds
  // of approach, and the next one lasts 2 ρ w/a, a the acceleration towards the contact. Rounding of late impacts
  // counts once here, and their intervals need not shrink evenly before.
  [[nodiscard]] double end_of_bounces(int i, double speed) const noexcept {
    const int n = motion_.normal_row(i);
    const double a = -(motion_.reading().J.row(n).dot(motion_.dynamics().a0) + motion_.reading().drift(n));
    const double ratio = last_speed_[as(i)] > 0 ? speed / last_speed_[as(i)] : 1;
    if (!(a > 0 && ratio < 1)) return result_.time;
    return result_.time + 2 * ratio * speed / (a * (1 - ratio));
  }

  // Whether a contact takes part in the accumulation: of one contact, or of those of the last seventeen impacts.
  [[nodiscard]] bool accumulating(int i) const noexcept {
    if (alone_) return i == cause_;
    return last_impact_[as(i)] > 0 && last_impact_[as(i)] + 17 > impact_number_;
  }

  // An impact of all contacts that touch; `rests` makes it completely inelastic, the end of an accumulation.
  bool collide(int cause, bool rests) {
    if (!motion_.read(result_.time, y_)) return end(ContactStatus::integration_failed, cause);
    const auto& reading = motion_.reading();
    const auto whole = motion_.problem_of(reading.w);
    typename Motion::Problem problem;
    std::array<double, S::contacts> restitution{};
    std::array<int, S::contacts> who{}, place{};
    std::array<int, static_cast<std::size_t>(3 * contacts)> row{};
    int rows = 0;
    for (int i = 0; i < contacts; ++i) {
      const ContactRule rule = motion_.system().rule(i);
      if (!touching_[as(i)] || motion_.carrier(i) < 0) continue;
      ContactLaw law = whole.law(i);
      place[as(i)] = problem.count;
      if (law.pressed_by >= 0) law.pressed_by = place[as(law.pressed_by)];
      law.static_friction = law.friction;
      law.bound = law.static_bound = 0;  // bounded forces give no impulse
      for (int k = 0; k < law.rows(); ++k) row[as(rows++)] = whole.first_row(i) + k;
      who[as(problem.count)] = i;
      restitution[as(problem.count)] = rests ? 0 : rule.restitution;
      problem.laws[as(problem.count++)] = law;
    }
    problem.W.resize(rows, rows);
    problem.q.resize(rows);
    for (int i = 0; i < rows; ++i) {
      problem.q(i) = reading.w(row[as(i)]);
      for (int j = 0; j < rows; ++j) problem.W(i, j) = whole.W(row[as(i)], row[as(j)]);
    }
    const ImpactResult<contacts> shock = impact(problem, restitution, rests ? ImpactLaw::newton_moreau : options_.law);
    result_.verdict = shock.verdict;
    if (shock.verdict == ContactVerdict::none) return end(ContactStatus::no_solution, cause);
    residual_ = shock.residual;
    result_.worst_residual = std::max(result_.worst_residual, residual_);
    impulses_ = Motion::Forces::Zero(motion_.rows());
    for (int i = 0; i < rows; ++i) impulses_(row[as(i)]) = shock.P(i);
    // T- - T+ = -P · (w- + w+)/2.
    energy_lost_ = 0;
    double terms = 0;
    for (int i = 0; i < rows; ++i) {
      const double product = -shock.P(i) * (problem.q(i) + shock.w(i)) / 2;
      energy_lost_ += product;
      terms += std::abs(shock.P(i) * problem.q(i));
    }
    if (energy_lost_ < -1e-12 * terms) return end(ContactStatus::energy_gained, cause);
    const Eigen::Matrix<double, static_cast<int>(S::nv), 1> change = motion_.dynamics().KJ * impulses_;
    for (std::size_t i = 0; i < S::nv; ++i) y_[S::nq + i] += change(static_cast<Eigen::Index>(i));
    ++result_.impacts;
    if (!motion_.read(result_.time, y_)) return end(ContactStatus::integration_failed, cause);
    for (int k = 0; k < problem.count; ++k) {
      const int i = who[as(k)];
      ContactState& state = motion_.states[as(i)];
      // What is left of an accumulation's velocity is rounding: projection takes it away.
      const int by = motion_.carrier(i);
      state.touches = by != i ? motion_.states[as(by)].touches : shock.closed[as(k)] || (rests && accumulating(i));
      set_by_slip(i, shock.sticks[as(k)] ? std::numeric_limits<double>::infinity() : 0);
    }
    for (int i = 0; i < contacts; ++i) {
      if (motion_.carrier(i) >= 0) continue;
      motion_.states[as(i)].touches = true;
      set_by_slip(i, 64 * motion_.rounding_of(motion_.tangent_row(i)));
    }
    return decide(-1, Cause::none);
  }

  bool advance_to_event(double t1) {
    const auto watch_all = [&]<std::size_t... k>(std::index_sequence<k...>) {
      return EventArray<Watch, 3 * S::contacts>({watch(static_cast<int>(k / 3), static_cast<Watched>(k % 3))...});
    };
    auto events = watch_all(std::make_index_sequence<3 * S::contacts>());
    events.options.by_stepping = true;
    const auto piece =
        integrate_with_events(motion_, y_, result_.time, t1, method_, events, IgnoreSteps{}, Steps{*this});
    result_.time = piece.time;
    result_.integration = piece.integration;
    result_.integration_event = piece.status;
    if (piece.status == EventStatus::reached_end) return true;
    if (piece.status == EventStatus::stopped_by_observer) return end(ContactStatus::stopped_by_observer, -1);
    const int contact = static_cast<int>(piece.guard / 3);
    if (piece.status != EventStatus::stopped_at_event) return end(ContactStatus::integration_failed, contact);
    const auto watched = static_cast<Watched>(piece.guard % 3);
    if (watched != Watched::youth && !still_slips(contact, watched)) {
      return happened(contact, watched == Watched::gap_or_pressure);
    }
    // The slip goes on, with the direction that it has got: no event.
    if (!motion_.read(result_.time, y_)) return end(ContactStatus::integration_failed, contact);
    ContactState& state = motion_.states[as(contact)];
    if (watched == Watched::youth && !state.begins) {
      motion_.fade(contact, result_.time, y_);
    } else {
      motion_.take_direction(contact);
    }
    return true;
  }

  // In space the slip may turn round quickly without an end: it passes zero at a distance.
  [[nodiscard]] bool still_slips(int contact, Watched watched) noexcept {
    const ContactState& state = motion_.states[as(contact)];
    return watched == Watched::slip_or_margin && state.touches && state.regime == ContactRegime::slides &&
           !state.begins && motion_.read(result_.time, y_) && motion_.slips_across(contact);
  }

  [[nodiscard]] Watch watch(int contact, Watched watched) noexcept {
    const bool barrier = watched == Watched::gap_or_pressure && !motion_.states[as(contact)].touches;
    return {Value{&motion_, contact, watched}, Crossing::falling, barrier ? Response::barrier : Response::stop, End{}};
  }

  struct Steps {
    ContactRun& run;
    bool operator()(const double& t, const Vector& y) const {
      if constexpr (std::is_invocable_v<Observer&, const double&, const Vector&>) return notify(run.observer_, t, y);
      return true;
    }
  };

  bool happened(int contact, bool normal) {
    ++result_.events;
    const Vector before = y_;
    ContactState& state = motion_.states[as(contact)];
    residual_ = energy_lost_ = 0;
    impulses_ = Motion::Forces::Zero(motion_.rows());
    ContactEventKind kind = ContactEventKind::impact;
    double told = result_.time;
    bool done = false;
    if (normal && !state.touches) {
      if (!motion_.read(result_.time, y_)) return end(ContactStatus::integration_failed, contact);
      const double speed = std::abs(motion_.reading().w(motion_.normal_row(contact)));
      // Where the flights left rise by less than 1e6 roundings of the gap, the next impacts are known less well.
      const double unresolved = speed > 0 ? 1e6 * motion_.rounding_of_gap(contact) / speed : 0;
      const double limit = end_of_bounces(contact, speed);
      bounces_[as(contact)] = limit > result_.time ? bounces_[as(contact)] + 1 : 0;
      limits_[as(contact)](result_.time, speed, motion_.rounding_of_gap(contact));
      const bool fades = bounces_[as(contact)] >= 3 && limit - result_.time <= unresolved;
      const bool alone = watches_[as(contact)](result_.time, options_.accumulation) || fades;
      const bool together = all_(result_.time, std::max(options_.accumulation, unresolved));
      const bool rests = alone || together;
      last_impact_[as(contact)] = ++impact_number_;
      alone_ = alone;
      cause_ = contact;
      if (rests) {
        kind = ContactEventKind::accumulation;
        ++result_.accumulations;
        // The contact is closed from now on: until the limit the impulses of all bounces and of rest are the same.
        told = limits_[as(contact)](std::max(result_.time, alone ? limit : all_.limit()), result_.time);
      }
      for (int i = 0; i < contacts; ++i) {
        touching_[as(i)] = motion_.carrier(i) == contact || motion_.states[as(i)].touches || near(i);
      }
      last_speed_[as(contact)] = speed;
      done = collide(contact, rests);
      if (rests) {
        watches_.fill({});
        bounces_.fill(0);
        for (BounceLimit& bounces : limits_) bounces.clear();
        last_speed_.fill(0);
        all_ = {};
      }
    } else if (normal) {
      kind = ContactEventKind::opens;
      done = decide(contact, Cause::opens);
    } else if (state.regime == ContactRegime::slides) {
      kind = ContactEventKind::slip_ends;
      state.regime = ContactRegime::sticks;  // or whatever the laws say from rest
      state.begins = state.fades = false;
      motion_.changed();
      done = decide(contact, Cause::none);
    } else {
      kind = ContactEventKind::slips;
      if (motion_.solve(result_.time, y_) != Evaluation::ok) return end(ContactStatus::integration_failed, contact);
      const int t = motion_.tangent_row(contact);
      double length = 0;
      for (int k = 0; k < motion_.system().rule(contact).tangents; ++k)
        length = std::hypot(length, motion_.reactions()(t + k));
      for (int k = 0; k < motion_.system().rule(contact).tangents; ++k) {
        state.direction[as(k)] = -motion_.reactions()(t + k) / length;
      }
      done = decide(contact, Cause::slips);
    }
    if (!done) return false;
    if constexpr (std::is_invocable_v<Observer&, const ContactEvent<Motion>&>) {
      const ContactEvent<Motion> event{kind,           told,      contact,      before,    y_,
                                       motion_.states, impulses_, energy_lost_, residual_, verdict_};
      if (!notify(observer_, event)) return end(ContactStatus::stopped_by_observer, contact);
    }
    return true;
  }

  Motion motion_;
  Vector& y_;
  const Method& method_;
  const ContactOptions& options_;
  Observer& observer_;
  ContactResult result_;
  std::array<bool, S::contacts> touching_{};
  std::array<AccumulationWatch<double>, S::contacts> watches_{};
  AccumulationWatch<double> all_{};
  std::array<BounceLimit, S::contacts> limits_{};
  std::array<std::int64_t, S::contacts> last_impact_{};  ///< its number among all impacts; 0: none yet
  std::array<int, S::contacts> bounces_{};               ///< impacts in succession that were slower than the one before
  std::array<double, S::contacts> last_speed_{};         ///< of approach at its last impact [m/s]
  std::int64_t impact_number_ = 0;
  bool alone_ = false;  ///< the accumulation is that of one contact, `cause_`
  int cause_ = 0;
  typename Motion::Forces impulses_;
  double energy_lost_ = 0, residual_ = 0;
  ContactVerdict verdict_ = ContactVerdict::unique;
};

/// Integrates a mechanism with contacts from t0 to t1 >= t0: smooth pieces by a method, between events that are
/// located; at each event impacts and regimes are solved for all contacts together. Impacts that accumulate are passed
/// by a completely inelastic one at the time they tend to. `observer` is told of steps (t, y), of events
/// (ContactEvent), or of both. y is the state at `result.time`.
template <ContactSystem S, class Method = DormandPrince853, class Observer = IgnoreSteps>
ContactResult integrate_contacts(const S& system, std::array<double, S::nq + S::nv>& y, double t0, double t1,
                                 const Method& method = Method{.relative_tolerance = 1e-13,
                                                               .absolute_tolerance = 1e-13},
                                 const ContactOptions& options = {}, Observer&& observer = Observer{}) {
  if (!(t1 >= t0)) return {.status = ContactStatus::integration_failed, .time = t0};  // what is no number too
  ContactRun<S, Method, std::remove_reference_t<Observer>> run(system, y, method, options, observer);
  if (run.start(t0)) run.advance(t1);
  return run.result();
}

}  // namespace torsor::runtime
