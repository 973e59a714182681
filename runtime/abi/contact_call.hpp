// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include "torsor/runtime/abi.h"
#include "torsor/runtime/abi/motion_numbers.hpp"
#include "torsor/runtime/contacts/integrate_contacts.hpp"
#include "torsor/runtime/contacts/mechanism_with_contacts.hpp"
#include "torsor/runtime/integration/dormand_prince_54.hpp"
#include "torsor/runtime/integration/dormand_prince_853.hpp"
#include "torsor/runtime/integration/radau_iia_5.hpp"

namespace torsor::runtime::abi {

/// In the order of the table of methods of a mechanism with contacts.
inline constexpr std::array<torsor_method, 3> contact_methods{
    {{"dormand_prince_54", 0}, {"dormand_prince_853", 0}, {"radau_iia_5", 0}}};

/// A mechanism with all the kernels that its motion from event to event asks for.
template <class M>
concept MovesContacts = HasContacts<M> && HasMassMatrixAndBias<M> &&
                        (M::multiplier_count == 0 || HasConstraints<M>) && (M::input_count == 0 || HasForwardDynamics<M>);

/// As the interface numbers them.
[[nodiscard]] constexpr std::int32_t regime_of(const ContactState& state) noexcept {
  return state.touches ? static_cast<std::int32_t>(state.regime) : torsor_contact_open;
}
static_assert(static_cast<int>(ContactRegime::open) == torsor_contact_open &&
              static_cast<int>(ContactRegime::sticks) == torsor_contact_sticks &&
              static_cast<int>(ContactRegime::slides) == torsor_contact_slides);
static_assert(static_cast<int>(ContactEventKind::impact) == torsor_event_impact &&
              static_cast<int>(ContactEventKind::opens) == torsor_event_opens &&
              static_cast<int>(ContactEventKind::slips) == torsor_event_slips &&
              static_cast<int>(ContactEventKind::slip_ends) == torsor_event_slip_ends &&
              static_cast<int>(ContactEventKind::accumulation) == torsor_event_accumulation);
static_assert(static_cast<int>(ImpactLaw::newton_moreau) == torsor_impact_newton_moreau &&
              static_cast<int>(ImpactLaw::poisson) == torsor_impact_poisson &&
              static_cast<int>(ImpactLaw::energetic) == torsor_impact_energetic &&
              static_cast<int>(ImpactLaw::sequential) == torsor_impact_sequential);

[[nodiscard]] constexpr std::int32_t status_of(const ContactResult& result) noexcept {
  switch (result.status) {
    case ContactStatus::reached_end: return torsor_motion_reached_end;
    case ContactStatus::stopped_by_observer: return torsor_motion_stopped;
    case ContactStatus::no_solution: return torsor_motion_no_regimes;
    case ContactStatus::jams: return torsor_motion_jams;
    case ContactStatus::energy_gained: return torsor_motion_energy_gained;
    case ContactStatus::penetrates: return torsor_motion_penetrates;
    case ContactStatus::open_loops: return torsor_motion_open_loops;
    case ContactStatus::invalid_rule: return torsor_motion_impossible_surface;
    case ContactStatus::too_many_events: return torsor_motion_too_many_events;
    case ContactStatus::law_of_one_contact: return torsor_motion_law_of_one_contact;
    case ContactStatus::no_room: return torsor_motion_unsuitable_model;
    case ContactStatus::not_started: return torsor_motion_invalid_options;
    case ContactStatus::invalid_options: return torsor_motion_invalid_options;
    case ContactStatus::change_point: return torsor_motion_change_point;
    case ContactStatus::no_point: return torsor_motion_no_point;
    case ContactStatus::zero_quaternion: return torsor_motion_zero_quaternion;
    case ContactStatus::no_impact: return torsor_motion_no_impact;
    case ContactStatus::not_found: return torsor_motion_regimes_not_found;
    case ContactStatus::integration_failed: break;
  }
  if (result.integration_event == EventStatus::integration_failed) {
    return static_cast<std::int32_t>(result.integration.status);
  }
  // What no integration says was the mechanism itself, at its start or at an event.
  return result.integration_event == EventStatus::reached_end || result.integration_event == EventStatus::stopped_at_event
             ? torsor_motion_model_failure
             : torsor_motion_event_not_followed;
}

/// Motions of a mechanism with contacts, as runtime/abi.h asks for them.
template <MovesContacts M>
class ContactCall {
  using Law = std::conditional_t<(M::input_count > 0), GivenInputs<M>, NoInputs<M>>;
  using System = MechanismWithContacts<M, Law>;
  using State = typename System::State;

 public:
  ContactCall(const typename M::Parameters& parameters, const torsor_contact_motion& call) noexcept
      : parameters_(parameters), call_(call) {}

  std::int64_t operator()() const {
    return move_all(call_.motion, [this](std::size_t i) { return motion(i); });
  }

 private:
  /// Tells the caller's observer of events; without one nothing.
  struct Watch {
    const torsor_contact_motion& call;
    std::size_t motion;
    bool operator()(const ContactEvent& event) const {
      if (call.observer == nullptr) return true;
      std::array<std::int32_t, System::contacts> regimes;
      for (std::size_t k = 0; k < regimes.size(); ++k) regimes[k] = regime_of(event.contacts[k]);
      const torsor_contact_event told{motion,
                                      static_cast<std::int32_t>(event.kind),
                                      event.contact,
                                      event.time,
                                      event.before.data(),
                                      event.state.data(),
                                      regimes.data(),
                                      event.impulses.data(),
                                      event.energy_lost};
      return call.observer(call.observer_context, &told) == 0;
    }
  };

  /// How far a motion has come, whatever ends it.
  struct Progress {
    ContactResult result;
    std::size_t reached = 0;  ///< of the times asked for
  };

  std::int32_t motion(std::size_t i) const noexcept {
    const torsor_motion& of = call_.motion;
    Progress progress;
    progress.result.time = number_of(of.time, i, 0);
    std::int32_t status = torsor_motion_without_memory;
    try {
      status = moved(i, progress);
    } catch (...) {  // memory: nothing else is thrown, and nothing may be through C
    }
    const ContactResult& result = progress.result;
    write_nothing<M>(of, i, progress.reached);
    for (std::size_t row = progress.reached; call_.regimes != nullptr && row < of.time_count; ++row) {
      for (std::size_t k = 0; k < System::contacts; ++k) regimes(i, row)[k] = -1;
    }
    if (of.statuses != nullptr) of.statuses[i] = status;
    if (of.ends != nullptr) of.ends[i] = result.time;
    if (of.calls != nullptr) of.calls[i] = result.integration.statistics.calls;
    if (call_.contacts != nullptr) call_.contacts[i] = result.contact.value_or(-1);
    return status;
  }

  std::int32_t moved(std::size_t i, Progress& progress) const {
    Law law{};
    if constexpr (M::input_count > 0) law = inputs_of<M>(call_.motion, i);
    const System system(parameters_, law);
    const bool usable = call_.impact_law >= 0 && call_.impact_law <= torsor_impact_sequential && call_.touch >= 0 &&
                        call_.at_rest >= 0 && call_.accumulation >= 0 && call_.event_limit >= 0 && !call_.motion.unprojected;
    if (!usable) return torsor_motion_invalid_options;
    if (call_.motion.method == 0) return by(adaptive(call_.motion, DormandPrince54{}), system, i, progress);
    if (call_.motion.method == 1) return by(adaptive(call_.motion, DormandPrince853{}), system, i, progress);
    if (call_.motion.method == 2) return by(adaptive(call_.motion, RadauIia5{}), system, i, progress);
    return torsor_motion_unsuitable_model;
  }

  template <class Method>
  std::int32_t by(const Method& method, const System& system, std::size_t i, Progress& progress) const {
    auto& [result, reached] = progress;
    State y = start_of<M>(call_.motion, i);
    Watch watch{call_, i};
    const ContactMechanismOf<System> mechanism(system);
    ContactRun<std::tuple_size_v<State>, System::contacts, Method, Watch> run(mechanism, y, method, options(), watch);
    bool orderly = true;
    if (run.start(result.time)) {
      for (; reached < call_.motion.time_count; ++reached) {
        const double time = call_.motion.times[reached];
        orderly = time >= run.result().time;
        if (!orderly || !run.advance(time)) break;
        write_state(call_.motion, i, reached, y);
        if (call_.regimes == nullptr) continue;
        for (std::size_t k = 0; k < System::contacts; ++k) regimes(i, reached)[k] = regime_of(run.motion().states[k]);
      }
    }
    result = run.result();
    return orderly ? status_of(result) : torsor_motion_invalid_options;
  }

  [[nodiscard]] ContactOptions options() const noexcept {
    ContactOptions options;
    options.law = static_cast<ImpactLaw>(call_.impact_law);
    options.impact_without_collision = call_.impact_without_collision != 0;
    if (call_.touch > 0) options.touch = call_.touch;
    if (call_.at_rest > 0) options.at_rest = call_.at_rest;
    if (call_.accumulation > 0) options.accumulation = call_.accumulation;
    if (call_.event_limit > 0) options.event_limit = call_.event_limit;
    return options;
  }

  [[nodiscard]] std::int32_t* regimes(std::size_t motion, std::size_t row) const noexcept {
    return call_.regimes + (motion * call_.motion.time_count + row) * System::contacts;
  }

  const typename M::Parameters& parameters_;
  const torsor_contact_motion& call_;
};

}  // namespace torsor::runtime::abi
