// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <type_traits>

#include "torsor/runtime/contacts/careful_steps.hpp"
#include "torsor/runtime/contacts/contact_automaton.hpp"
#include "torsor/runtime/integration/dormand_prince_853.hpp"
#include "torsor/runtime/integration/events.hpp"

namespace torsor::runtime {

/// Event-driven motion of a mechanism with contacts, which may be taken from time to time: `start` at t0, then `advance`
/// to later and later times. What it knows of regimes, slips and bounces is kept in between. The state has room for
/// `size` numbers, of which the mechanism's coordinates and velocities are the first, and for `contacts` contacts.
template <std::size_t size, std::size_t contacts, class Method, class Observer>
class ContactRun {
 public:
  using Vector = std::array<double, size>;

  /// The mechanism, the state and the observer must live as long.
  ContactRun(const ContactMechanism& mechanism, Vector& y, const Method& method, const ContactOptions& options,
             Observer& observer)
      : automaton_(mechanism, options), y_(y), method_(method), observer_(observer) {
    tolerate();
  }
  ContactRun(const ContactRun&) = delete;
  ContactRun& operator=(const ContactRun&) = delete;

  /// Goes on by this one, from the next start on.
  void use(const Method& method) {
    method_ = method;
    run_.reset();
    tolerate();
  }

  /// Puts the state on its constraints and decides the first regimes; false where the motion cannot begin. It may be
  /// called again: a motion then begins anew, in the same memory, with the coefficients that the mechanism has now.
  bool start(double t0) {
    pieces_ = 0;
    pace_ = {};
    run_.reset();
    careful_ = {};
    const ContactSizes& sizes = automaton_.motion().sizes();
    if (static_cast<std::size_t>(sizes.coordinates + sizes.velocities) > size ||
        static_cast<std::size_t>(sizes.contacts) > contacts) {
      return automaton_.end(ContactStatus::no_room, std::nullopt);
    }
    const bool began = automaton_.start(t0, y_) && told();
    last_ = y_;
    return began;
  }

  /// Goes on to t1, which is not before, with the coefficients that the mechanism has now; false where the motion ends earlier.
  bool advance(double t1) {
    ContactResult& result = automaton_.result();
    if (result.status != ContactStatus::reached_end) return false;
    if (!(t1 >= result.time)) return automaton_.end(ContactStatus::invalid_options, std::nullopt);
    if (y_ != last_) return automaton_.end(ContactStatus::not_started, std::nullopt);
    if (!automaton_.renew(y_)) return false;
    if (y_ != last_) run_.reset();
    int stuck = 0;
    while (result.status == ContactStatus::reached_end && result.time < t1) {
      const double before = result.time;
      if (!advance_to_event(t1)) break;
      // Regimes that alternate at one time come to no end.
      stuck = result.time > before ? 0 : stuck + 1;
      if (result.time < t1) ++pieces_;  // some end without an event
      const bool too_many = stuck > 100 || pieces_ > automaton_.options().event_limit || leads_nowhere(t1);
      if (too_many) result.status = ContactStatus::too_many_events;
    }
    last_ = y_;
    return result.status == ContactStatus::reached_end;
  }

  [[nodiscard]] const ContactResult& result() const noexcept { return automaton_.result(); }
  [[nodiscard]] ContactMotion& motion() noexcept { return automaton_.motion(); }

 private:
  struct Smooth {
    ContactMotion& motion;
    [[nodiscard]] Evaluation operator()(double t, const Vector& y, Vector& dydt) const {
      dydt.fill(0);
      return motion.slope(t, y, dydt);
    }
    [[nodiscard]] Evaluation project(double t, Vector& y) const { return motion.hold(t, y); }
  };
  using Run = RunOf<Method, Smooth, double, size>;
  struct Value {
    ContactAutomaton* automaton;
    std::size_t index;
    double operator()(double t, const Vector& y) const { return automaton->guard(index, t, y); }
  };
  struct End {
    bool operator()(double, Vector&) const noexcept { return false; }
  };
  using Watch = Guard<Value, End>;
  using Watches = EventArray<Watch, contacts * ContactAutomaton::guards + 1>;
  struct Steps {
    ContactMotion& motion;
    Observer& observer;
    double& last;  ///< time that it was told of
    bool operator()(const double& t, const Vector& y) const {
      last = t;
      motion.follow_slips(t, y);
      if constexpr (std::is_invocable_v<Observer&, const double&, const Vector&>) return notify(observer, t, y);
      return true;
    }
  };

  void tolerate() {
    if constexpr (requires { method_.absolute_tolerance, method_.relative_tolerance; }) {
      automaton_.motion().tolerate(method_.absolute_tolerance, method_.relative_tolerance);
    }
  }

  /// Whether the two-thousandth part of the events that are allowed has taken so little time that a hundred times all of them
  /// would not reach the end, and no less than the part before, as bounces do that accumulate: regimes alternate then, and it
  /// would take hours to count to the limit.
  bool leads_nowhere(double t1) noexcept {
    const long long many = std::max(100LL, automaton_.options().event_limit / 2000);
    if (pieces_ < pace_.pieces + many) return false;
    const double time = automaton_.result().time, gone = time - pace_.time;
    const bool fades = gone < 0.999 * pace_.gone, first = pace_.pieces == 0;
    pace_ = {pieces_, time, gone};
    return !first && !fades && 100 * 2000 * gone < t1 - time;
  }

  bool advance_to_event(double t1) {
    std::array<Watch, Watches::count> watches;
    for (std::size_t i = 0; i < watches.size(); ++i) {
      const Response response = automaton_.barrier(i) ? Response::barrier : Response::stop;
      watches[i] = {Value{&automaton_, i}, Crossing::falling, response, End{}, true};
    }
    Watches events(watches);
    events.options.by_stepping = true;
    ContactResult& result = automaton_.result();
    automaton_.motion().head_for(t1);
    IgnoreSteps ignore;
    double step_start = result.time;
    Steps steps{automaton_.motion(), observer_, step_start};
    const bool careful = careful_.lasts(result.time);
    const Method method = careful ? careful_.limit(method_) : method_;
    const double end = careful ? careful_.end(t1) : t1;
    const auto run = [&](double t) -> Run& { return run_from(t, method); };
    const auto piece = integrate_pieces(run, smooth_, y_, result.time, end, method, events, ignore, steps);
    // Behind an event equations are others, or have been for a while.
    if (piece.status != EventStatus::reached_end || careful) run_.reset();
    const bool stopped = piece.status == EventStatus::stopped_at_event;
    const bool repeats = has_longest_step && stopped && automaton_.does_not_fall(piece.guard, piece.time, y_) &&
                         careful_.repeat(piece.time, step_start, piece.integration.time);
    if (stopped && !repeats) careful_ = {};
    result.time = piece.time;
    Statistics all = result.integration.statistics;
    all += piece.integration.statistics;
    result.integration = piece.integration;
    result.integration.statistics = all;
    result.integration_event = piece.status;
    if (piece.status == EventStatus::reached_end || repeats) return true;
    if (piece.status == EventStatus::stopped_by_observer) {
      return automaton_.end(ContactStatus::stopped_by_observer, std::nullopt);
    }
    const bool here = piece.status == EventStatus::guard_not_followed &&
                      automaton_.ends_unfollowed(piece.guard, piece.time, y_);
    if (piece.status == EventStatus::guard_not_followed && !here) {
      if (automaton_.holds_on(piece.guard, piece.time, y_)) return true;
      if (has_longest_step && careful_.repeat(piece.time, step_start, piece.integration.time)) return true;
    }
    if (piece.status != EventStatus::stopped_at_event && !here) {
      if (piece.integration.status == IntegrationStatus::step_too_small) {
        if (automaton_.jams_nearly(piece.time, y_)) return false;
        const std::optional<bool> passed = automaton_.pass_jump_of_forces(piece.time, y_);
        if (passed) return *passed && told();
      }
      const std::optional<int> jumping = automaton_.motion().jumping(piece.time);
      if (piece.status == EventStatus::integration_failed && jumping) {
        return automaton_.pass_edge(*jumping, piece.time, y_) && told();
      }
      if (piece.integration.status != IntegrationStatus::too_many_steps) {
        const std::optional<int> flat = automaton_.motion().without_point(piece.time, y_);
        if (flat) return automaton_.end(ContactStatus::no_point, flat);
        const bool lost = piece.status == EventStatus::integration_failed;
        std::optional<bool> passed = lost ? automaton_.pass_end_of_reaction(piece.time, y_) : std::nullopt;
        if (lost && !passed) passed = automaton_.pass_loss_of_rank(piece.time, y_);
        if (passed) {
          careful_ = {};  // these ended just here
          return *passed && told();
        }
      }
      const bool of_a_guard = piece.status == EventStatus::guard_not_followed || piece.status == EventStatus::beyond_barrier;
      const auto contact = static_cast<int>(piece.guard / ContactAutomaton::guards);
      const bool of_a_contact = of_a_guard && contact < automaton_.motion().count();
      return automaton_.end(ContactStatus::integration_failed, of_a_contact ? std::optional(contact) : std::nullopt);
    }
    return automaton_.pass(piece.guard, piece.time, y_) && told();
  }

  bool told() {
    if constexpr (std::is_invocable_v<Observer&, const ContactEvent&>) {
      for (; automaton_.has_event(); automaton_.next_event()) {
        if (notify(observer_, automaton_.event())) continue;
        return automaton_.end(ContactStatus::stopped_by_observer, automaton_.event().contact);
      }
    }
    return true;
  }

  // The run of the method that came to here goes on, with what the mechanism says now, or another one begins.
  Run& run_from(double t, const Method& method) {
    constexpr bool goes_on = requires(Run& run) { run.renew(); };
    if (!goes_on || !run_) return run_.emplace(method.start(smooth_, y_, t));
    if constexpr (goes_on) run_->renew();
    return *run_;
  }

  ContactAutomaton automaton_;
  Smooth smooth_{automaton_.motion()};
  Vector& y_;
  Vector last_{};  ///< what this motion left in the state: another one has regimes that it knows nothing of
  Method method_;
  Observer& observer_;
  static constexpr bool has_longest_step = requires(Method method) { method.largest_step; };
  CarefulSteps careful_;
  std::optional<Run> run_;  ///< that reached the present time, while its equations last
  long long pieces_ = 0;
  struct {
    long long pieces = 0;
    double time = 0, gone = 0;
  } pace_;  ///< looked at last
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
  if (!(t1 >= t0)) return {.status = ContactStatus::invalid_options, .time = t0};  // what is no number too
  const ContactMechanismOf<S> mechanism(system);
  ContactRun<S::nq + S::nv, S::contacts, Method, std::remove_reference_t<Observer>> run(mechanism, y, method, options,
                                                                                        observer);
  if (run.start(t0)) run.advance(t1);
  return run.result();
}

}  // namespace torsor::runtime
