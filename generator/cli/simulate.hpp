// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "torsor/generator/cli/watched_events.hpp"
#include "torsor/generator/verification/evaluated_motion.hpp"

namespace torsor {

struct SimulationOptions {
  ModelOptions model;
  double duration = 10.0, step = 0.01;  ///< [s]; a row for each multiple of the step, and one for the end
  double tolerance = 1e-10;             ///< errors of a step stay below tolerance · (1 + |y_i|)
  bool project = true;                  ///< onto the constraints, after each step
  std::string method = "dp853";         ///< dp853, radau or gauss
  std::optional<double> method_step;    ///< of gauss [s]; `step` when absent
  std::vector<EventRequest> events;
  std::string impact_law = "newton_moreau";  ///< of contacts, one of `impact_law_names`
  bool impact_without_collision = false;     ///< of contacts: where one slips and no regimes exist
  NamedNumbers initial, parameters, inputs;
  std::function<void(double share)> progress = {};
};

/// In the order of runtime::ImpactLaw.
inline constexpr std::array<const char*, 4> impact_law_names{"newton_moreau", "poisson", "energetic", "sequential"};

/// A motion as a table.
struct Simulation {
  std::vector<std::string> names, units;  ///< of the columns: time, positions, velocities, energies, first integrals
  std::vector<std::vector<double>> rows;
  std::vector<double> before;             ///< an impact at the start: the row of the state that it struck, without energies
  std::string status;                     ///< empty: the end was reached, or an event that ends the motion
  std::vector<std::string> events;        ///< what was met, a line each
  std::vector<std::string> remarks;       ///< of the whole motion
  long steps = 0;
};

/// The motion of a scene, evaluated from its program; with contacts it goes from event to event of theirs. Throws UsageError for names and numbers that make no sense, Error
/// where the constraints cannot be closed at the start.
Simulation simulate(const Scene& scene, const SimulationOptions& options);

/// Throws UsageError where two columns have one name: a coordinate has that of what stands beside it.
void require_distinct_columns(const Simulation& motion);

/// Comment lines, names, rows; each number by the shortest decimal that reads back as the same.
std::string simulation_csv(const Scene& scene, const SimulationOptions& options, const Simulation& motion);

/// Curves of some columns over time. Throws UsageError for a name that is no column.
std::string simulation_svg(const Scene& scene, const Simulation& motion, const std::vector<std::string>& columns);

}  // namespace torsor
