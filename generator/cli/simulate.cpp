// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/cli/simulate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "torsor/generator/base/did_you_mean.hpp"
#include "torsor/generator/base/error.hpp"
#include "torsor/generator/cli/contact_simulation.hpp"
#include "torsor/generator/cli/friction_regime.hpp"
#include "torsor/generator/cli/start_state.hpp"
#include "torsor/generator/program/written_unit.hpp"
#include "torsor/generator/verification/dormand_prince_853.hpp"
#include "torsor/generator/verification/gauss_collocation.hpp"
#include "torsor/generator/verification/radau_iia_5.hpp"

namespace torsor {
namespace {

double method_step(const SimulationOptions& options) { return options.method_step.value_or(options.step); }

void check_options(const SimulationOptions& options) {
  const auto require = [](bool holds, const char* sentence) {
    if (!holds) throw UsageError(sentence);
  };
  require(options.duration > 0 && std::isfinite(options.duration), "--to must be a time above 0");
  require(options.step > 0 && std::isfinite(options.step) && options.duration / options.step <= 1e7,
          "--step must be a time above 0 that gives at most ten million rows");
  require(!options.method_step || options.method == "gauss",
          "--method-step is for --method gauss; the other methods choose their steps by --tolerance");
  const double fixed = method_step(options);
  require(fixed > 0 && std::isfinite(fixed) && options.duration / fixed <= 1e9,
          "--method-step must be a time above 0 that gives at most 1e9 steps");
  require(options.tolerance >= 1e-14 && options.tolerance <= 0.1, "--tolerance must lie between 1e-14 and 0.1");
}

struct Method {
  const char* name;
  const char* words;
};
constexpr std::array<Method, 3> methods{{{"dp853", "Dormand and Prince's method of order 8"},
                                         {"radau", "Radau's method IIA of order 5"},
                                         {"gauss", "Gauss collocation of order 6"}}};

const Method& method_named(const std::string& name) {
  std::vector<std::string> known;
  for (const Method& method : methods) {
    if (name == method.name) return method;
    known.emplace_back(method.name);
  }
  throw UsageError(fmt::format("unknown method '{}' in --method: {}use {}", name, did_you_mean(name, known), fmt::join(known, ", ")));
}

std::unique_ptr<MotionIntegrator> make_integrator(const SimulationOptions& options, MotionIntegrator::Slope slope,
                                                  MotionIntegrator::Settle settle, std::vector<double> y) {
  const std::string method = method_named(options.method).name;
  if (method == "radau") return std::make_unique<RadauIia5>(std::move(slope), std::move(settle), std::move(y), options.tolerance);
  if (method == "gauss") {
    return std::make_unique<GaussCollocation6>(std::move(slope), std::move(settle), std::move(y), method_step(options));
  }
  return std::make_unique<DormandPrince853>(std::move(slope), std::move(settle), std::move(y), options.tolerance);
}

std::string method_text(const SimulationOptions& options) {
  const Method& method = method_named(options.method);
  return method.name == std::string("gauss") ? fmt::format("{}, steps of {:g} s", method.words, method_step(options))
                                             : fmt::format("{}, tolerance {:g}", method.words, options.tolerance);
}

std::string state_in_words(const EvaluatedMotion& motion, const std::vector<double>& y) {
  std::vector<std::string> numbers;
  for (std::size_t i = 0; i < y.size(); ++i) numbers.push_back(fmt::format("{} = {:.9g}", motion.symbols()[i]->name, y[i]));
  return fmt::format("; state: {}", fmt::join(numbers, ", "));
}

/// Lengths, or angles, all of which are so small that the 1 of 1 + |y| is all that their tolerance knows; empty: none are.
/// What does not move, but for rounding, has no size.
std::vector<std::string> remarks_of_small_coordinates(const Scene& scene, const SimulationOptions& options,
                                                      const Simulation& motion) {
  constexpr double rounding = 1e-12, coarse = 1e-6;
  std::map<std::string, double> largest;  // by unit
  for (std::size_t column = 0; column < motion.names.size(); ++column) {
    for (const CoordinateContent& coordinate : scene.content().coordinates) {
      if (!coordinate.unknown() || coordinate.q->name != motion.names[column]) continue;
      double& size = largest[motion.units[column]];
      for (const std::vector<double>& row : motion.rows) size = std::max(size, std::abs(row[column]));
    }
  }
  std::vector<std::string> remarks;
  for (const auto& [unit, size] : largest) {
    if (options.method == "gauss" || size <= rounding || options.tolerance <= coarse * size) continue;
    const double finer = std::max(1e-14, 1e-8 * size);
    const std::string remedy = options.tolerance > 2 * finer ? fmt::format("give --tolerance {:.0e}", finer)
                               : has_contacts(scene)         ? "no --tolerance is finer"
                                                             : "give --method gauss and a --method-step";
    remarks.push_back(fmt::format("coordinates in {} stay below {:.1e}, and a step may err by {:g} (1 + |y|), {:.0e} of that: {}",
                                  unit, size, options.tolerance, options.tolerance / size, remedy));
  }
  return remarks;
}

}  // namespace

void require_distinct_columns(const Simulation& motion) {
  std::set<std::string> met;
  for (const std::string& name : motion.names) {
    if (met.insert(name).second) continue;
    throw UsageError(fmt::format("the motion has two columns '{}': a coordinate or a contact of the scene has the name of what "
                                 "stands beside it; rename it",
                                 name));
  }
}

Simulation simulate(const Scene& scene, const SimulationOptions& options) {
  check_options(options);
  const auto with_remarks = [&](Simulation motion) {
    const std::vector<std::string> remarks = remarks_of_small_coordinates(scene, options, motion);
    motion.remarks.insert(motion.remarks.end(), remarks.begin(), remarks.end());
    return motion;
  };
  (void)method_named(options.method);
  if (has_contacts(scene)) return with_remarks(simulate_contacts(scene, options));
  if (options.impact_law != impact_law_names[0] || options.impact_without_collision) {
    throw UsageError(fmt::format("--impact-law and --impact-without-collision are for contacts, and the scene '{}' has none",
                                 scene.name()));
  }
  EvaluatedMotion motion(scene, options.model, options.parameters, options.inputs);
  Simulation result;
  result.names = {"time"};
  result.units = {"s"};
  for (const SymbolPointer& symbol : motion.symbols()) {
    result.names.push_back(symbol->name);
    result.units.push_back(written_unit(*symbol));
  }
  for (const EvaluatedMotion::Observed& each : motion.observed()) {
    result.names.push_back(each.name);
    result.units.push_back(each.unit);
  }
  require_distinct_columns(result);
  const std::vector<double> y = closed_start(motion, options.initial);
  MotionIntegrator::Settle settle;
  if (motion.needs_settling() && options.project) {
    settle = [&motion](double t, std::vector<double>& at) { return motion.settle(t, at); };
  }
  std::unique_ptr<MotionIntegrator> integrator = make_integrator(
      options,
      [&motion](double t, const std::vector<double>& at, std::vector<double>& rates) { return motion.slope(t, at, rates); },
      settle, y);
  integrator->expect(options.duration);
  WatchedEvents watched(scene, motion, options.events);
  FrictionRegime friction(motion);
  const auto write = [&] {
    const double t = integrator->time();
    std::vector<double> row{t};
    row.insert(row.end(), integrator->state().begin(), integrator->state().end());
    friction.look(t, integrator->state());
    const std::vector<double> observed = motion.observe(t, integrator->state());
    row.insert(row.end(), observed.begin(), observed.end());
    result.rows.push_back(std::move(row));
  };
  /// Rows at the events since the row before; true where one of them ends the motion.
  const auto meet = [&](const MotionIntegrator& before) {
    const std::unique_ptr<MotionIntegrator> after = integrator->copy();
    for (MetEvent& event : watched.between(before, *after)) {
      result.events.push_back(fmt::format("{} at t = {:.15g} s", event.name, event.time));
      integrator = std::move(event.motion);
      if (event.ends) return true;
      if (event.time < after->time()) write();
    }
    integrator = after->copy();
    return false;
  };
  write();
  const auto last = static_cast<long>(std::ceil(options.duration / options.step * (1 - 1e-12)));
  for (long k = 1; k <= last && integrator->status().empty(); ++k) {
    const double t = k == last ? options.duration : static_cast<double>(k) * options.step;
    const std::unique_ptr<MotionIntegrator> before = watched.empty() ? nullptr : integrator->copy();
    const bool reached = integrator->advance(t);  // if not, events may lie before the end of the motion
    const bool ends = before && meet(*before);
    if (reached || ends) write();
    if (!reached || ends) break;
    if (options.progress) options.progress(t / options.duration);
  }
  result.steps = integrator->steps();
  result.remarks = friction.remarks();
  if (!integrator->status().empty()) {
    result.status = fmt::format("{} at t = {:.9g} s", integrator->status(), integrator->time());
    const ConstraintRow* lost = motion.lost();
    // Steps become too short there, too, and nothing jumps.
    const std::string near = near_change_point(motion, integrator->time(), integrator->state());
    result.status += near.empty() ? integrator->because() : near;
    if (!integrator->because().empty()) result.status += state_in_words(motion, integrator->state());
    if (near.empty() && lost != nullptr) {
      result.status += fmt::format(": the constraint '{}' vanishes there or repeats others", lost->name);
    }
  }
  return with_remarks(std::move(result));
}

std::string simulation_csv(const Scene& scene, const SimulationOptions& options, const Simulation& motion) {
  std::string text = fmt::format(
      "# Motion of the scene {} by {}, {} steps.\n# Units: {}\n", scene.name(), method_text(options), motion.steps,
      fmt::join(motion.units, ", "));
  for (const std::string& event : motion.events) text += fmt::format("# Event: {}\n", event);
  for (const std::string& remark : motion.remarks) text += fmt::format("# Note: {}\n", remark);
  if (!motion.status.empty()) text += fmt::format("# It ends before {:g} s: {}\n", options.duration, motion.status);
  text += fmt::format("{}\n", fmt::join(motion.names, ","));
  for (const std::vector<double>& row : motion.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) text += fmt::format("{}{}", i == 0 ? "" : ",", row[i]);
    text += '\n';
  }
  return text;
}

}  // namespace torsor
