// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "torsor/generator/base/natural_language.hpp"
#include "torsor/generator/cli/simulate.hpp"

namespace torsor {

/// Whether the scene has contacts that open and close, stops or dry friction.
bool has_contacts(const Scene& scene);

/// The motion of such a scene from event to event, by `runtime/contacts`: its columns are those of `simulate` and of
/// each contact the gap and the reactions; its notes tell of events. Throws as `simulate`, and UsageError for a scene
/// that is too large.
Simulation simulate_contacts(const Scene& scene, const SimulationOptions& options);

/// The same motion with its parts apart, for those who show it.
struct ContactRecord {
  /// One letter for each contact: o open, c closed without friction, s sticks, d slides.
  using Regimes = std::string;
  struct Contact {
    std::string name;
    bool normal = true;                  ///< it has a gap
    std::vector<std::string> reactions;  ///< "N", "T", "T1"
    std::string gap_unit, unit;          ///< of the gap and of the reactions
  };
  enum class EventKind { impact, opens, slips, slip_ends, accumulation };
  struct Event {
    EventKind kind;
    double time;
    std::size_t contact;
    double energy_lost;
    Regimes after;
  };
  Simulation motion;        ///< its last columns are each contact's gap and reactions
  std::size_t numbers = 0;  ///< of a state: columns behind the time
  std::vector<std::string> inputs;
  std::vector<Contact> contacts;
  std::vector<Event> events;
  std::vector<Regimes> regimes;  ///< of each row
};
/// Its status and remarks are said in a language.
ContactRecord record_contacts(const Scene& scene, const SimulationOptions& options, const NaturalLanguage& say = {});

}  // namespace torsor
