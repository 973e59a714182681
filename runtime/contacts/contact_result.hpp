// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "torsor/runtime/contacts/contact_state.hpp"
#include "torsor/runtime/contacts/impact_laws.hpp"
#include "torsor/runtime/events/event_memory.hpp"
#include "torsor/runtime/integration/integrate.hpp"

namespace torsor::runtime {

/// Why a motion with contacts ended.
enum class ContactStatus : int {
  reached_end = 0,
  stopped_by_observer,
  no_solution,    ///< no regimes fulfil the laws (Painlevé)
  jams,           ///< the equations of a slip become singular (Painlevé)
  energy_gained,  ///< T+ > T- at an impact
  penetrates,     ///< a gap is below -touch at the start
  open_loops,     ///< constraints cannot be closed near the start
  invalid_rule,   ///< f < 0, f_s < f, b < 0, e outside [0, 1], or tangents and presser that cannot be
  too_many_events,
  integration_failed,
  not_started,  ///< ContactRun::start was not called, or the state was changed after it
  law_of_one_contact,  ///< the energetic law of impact, and several contacts struck at once
  no_room,      ///< ContactRun has room for fewer numbers or contacts than the mechanism has
  change_point,  ///< constraints of loops lose rank
  /// A contact has no single point or normal here, as a disc that lies flat, or its gap falls by a jump, or its rate does.
  no_point,
  invalid_options,  ///< an end before the start, or a step, theta, touch, at_rest, accumulation or law that cannot be
  zero_quaternion,  ///< the start has a quaternion of zeros
  no_impact,  ///< no impulses fulfil the law of impact, or its collisions have no end
  not_found,  ///< no regimes were found, and not all were tried
};

[[nodiscard]] constexpr std::string_view describe(ContactStatus status) noexcept {
  switch (status) {
    case ContactStatus::reached_end:
      return "reached the end time";
    case ContactStatus::stopped_by_observer:
      return "stopped because the observer returned false";
    case ContactStatus::no_solution:
      return "no regimes fulfil the laws of contact: the equations of rigid bodies have no solution here (Painlevé)";
    case ContactStatus::jams:
      return "a contact that slides jams: the equations of rigid bodies become singular here, and what follows is not "
             "determined (Painlevé)";
    case ContactStatus::energy_gained:
      return "the impact law gave energy: choose another, or a smaller restitution";
    case ContactStatus::penetrates:
      return "a contact starts below its surface: begin where every gap is at least zero";
    case ContactStatus::open_loops:
      return "the loops cannot be closed near the start: begin nearer to a state in which they are";
    case ContactStatus::invalid_rule:
      return "a contact's rule is impossible: friction and bounds finite and at least 0, static ones at least those of "
             "sliding, restitution from 0 to 1, at most two tangents, pressed by an earlier contact with a normal";
    case ContactStatus::too_many_events:
      return "there are too many events for their limit: raise it, or look for regimes that alternate without end";
    case ContactStatus::integration_failed:
      return "the integration between events failed, see its own status";
    case ContactStatus::law_of_one_contact:
      return "the energetic law of impact is one of a single contact, and several touch: choose another law";
    case ContactStatus::change_point:
      return "the constraints of loops lose rank here, a change point, where branches of a loop meet: the motion does not "
             "pass it";
    case ContactStatus::no_point:
      return "a contact has no single point or normal here, as the lowest point of a disc that lies flat, or its gap falls by "
             "a jump, as at a wall, or the rate of its gap does, as in a valley with a kink, for which no law gives an impulse: "
             "begin beside such a state, round the surface off, or describe it by points";
    case ContactStatus::invalid_options:
      return "the motion is asked for what cannot be: its end is not before its start, steps are above 0, theta is from 0 to 1, "
             "touch, at_rest and accumulation are at least 0, the law is one of the four, and none is NaN";
    case ContactStatus::zero_quaternion:
      return "the start has a quaternion of zeros, which is no attitude: give one of norm 1";
    case ContactStatus::no_impact:
      return "no impulses fulfil the law of impact, or its collisions have no end: choose another law, or a smaller restitution";
    case ContactStatus::not_found:
      return "no regimes were found that fulfil the laws of contact, and they are too many to try all: begin beside such a state, "
             "or change a coefficient of friction";
    case ContactStatus::no_room:
      return "the mechanism has more numbers or contacts than there is room for: give ContactRun more";
    case ContactStatus::not_started:
      return "the motion was not started, or its state was changed since: call start first";
  }
  return "unknown contact status";
}

/// Why a motion ends where a decision found no regimes.
[[nodiscard]] constexpr ContactStatus status_without_regimes(ContactVerdict verdict) noexcept {
  return verdict == ContactVerdict::none ? ContactStatus::no_solution : ContactStatus::not_found;
}

enum class ContactEventKind { impact, opens, slips, slip_ends, accumulation };

/// What the observer is told after it happened.
struct ContactEvent {
  ContactEventKind kind;
  double time;  ///< of an accumulation, the limit of its impacts
  int contact;  ///< the one that caused it
  std::span<const double> before, state;
  std::span<const ContactState> contacts;  ///< regimes after
  const ContactVector& impulses;           ///< of impacts and accumulations, all rows
  double energy_lost;                      ///< what contacts take: T- - T+ where no surface moves by itself
  double residual;                         ///< certificate, the larger of impact and regimes
  ContactVerdict verdict;                  ///< of the decision of regimes and, at an impact, of its impulses
  /// Regimes of all motions that it found, that taken first. A contact that did not take part is open.
  std::span<const PerContact<ContactRegime>> found{};
  /// Of an impact that several impulses fulfil: regimes of each in it, those taken first.
  std::span<const PerContact<ContactRegime>> struck{};
  bool order_matters = false;  ///< of an impact by the sequential law: another order of contacts gives other velocities
};

struct ContactOptions {
  ImpactLaw law = ImpactLaw::newton_moreau;
  bool impact_without_collision = false;  ///< where one contact slips and no regimes exist, by the energetic law
  double touch = 1e-10;     ///< [m] gaps up to it are closed when another contact has an event
  double at_rest = 1e-10;   ///< [m/s] velocities up to it are zero at the start
  double accumulation = 0;  ///< [s] impacts whose predicted remaining time is at most this are an accumulation
  long long event_limit = 1'000'000;  ///< of events, and of smooth pieces that end without one
};

/// Whether options say what is possible.
[[nodiscard]] constexpr bool valid(const ContactOptions& options) noexcept {
  const int law = static_cast<int>(options.law);
  return options.touch >= 0 && options.at_rest >= 0 && options.accumulation >= 0 && law >= 0 &&
         law <= static_cast<int>(ImpactLaw::sequential);
}

struct ContactResult {
  ContactStatus status = ContactStatus::reached_end;
  double time = 0;
  std::optional<int> contact{};  ///< the one that ended it, where one did
  ContactVerdict verdict = ContactVerdict::unique;
  std::int64_t events = 0, impacts = 0, accumulations = 0;
  /// Decisions for which there were several motions. Regimes are decided at the start, at events, and between them where a force
  /// of those that are not unique comes to its bound. Impulses of an impact count as a decision of their own.
  std::int64_t ambiguous = 0;
  std::int64_t indeterminate = 0;  ///< decisions of regimes that left reactions indeterminate
  std::int64_t order_matters = 0;  ///< impacts by the sequential law that another order of contacts makes other ones
  double worst_residual = 0;
  EventStatus integration_event = EventStatus::reached_end;
  Result<double> integration{};  ///< of the last smooth piece, its statistics those of all
  [[nodiscard]] explicit operator bool() const noexcept { return status == ContactStatus::reached_end; }
};

}  // namespace torsor::runtime
