// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/cli/simulate.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "generator/base/error.hpp"
#include "generator/dynamics/equations/contact_checks.hpp"
#include "generator/program/written_unit.hpp"
#include "generator/verification/dormand_prince_853.hpp"

namespace torsor {
namespace {

void check_options(const SimulationOptions& options) {
  const auto require = [](bool holds, const char* sentence) {
    if (!holds) throw UsageError(sentence);
  };
  require(options.duration > 0 && std::isfinite(options.duration), "--to must be a time above 0");
  require(options.step > 0 && options.duration / options.step <= 1e7,
          "--step must be a time above 0 that gives at most ten million rows");
  require(options.tolerance >= 1e-14 && options.tolerance <= 0.1, "--tolerance must lie between 1e-14 and 0.1");
}

}  // namespace

Simulation simulate(const Scene& scene, const SimulationOptions& options) {
  check_options(options);
  refuse_contacts(scene, "a simulation");
  EvaluatedMotion motion(scene, options.model, options.parameters, options.inputs);
  Simulation result;
  result.names = {"time"};
  result.units = {"s"};
  for (const SymbolPointer& symbol : motion.symbols()) {
    result.names.push_back(symbol->name);
    result.units.push_back(written_unit(*symbol));
  }
  for (const std::string& name : motion.observed_names()) {
    result.names.push_back(name);
    result.units.emplace_back(result.names.size() <= motion.symbols().size() + 4 ? "J" : "SI");
  }
  std::vector<double> y = motion.start(options.initial);
  if (motion.needs_settling() && !motion.settle(0.0, y)) {
    throw Error(fmt::format("the constraints of '{}' cannot be closed near the initial state: give other values by --initial",
                            scene.name()));
  }
  DormandPrince853::Settle settle;
  if (motion.needs_settling() && options.project) {
    settle = [&motion](double t, std::vector<double>& at) { return motion.settle(t, at); };
  }
  DormandPrince853 integrator(
      [&motion](double t, const std::vector<double>& at, std::vector<double>& rates) { return motion.slope(t, at, rates); },
      settle, y, options.tolerance);
  const auto write = [&](double t) {
    std::vector<double> row{t};
    row.insert(row.end(), integrator.state().begin(), integrator.state().end());
    const std::vector<double> observed = motion.observe(t, integrator.state());
    row.insert(row.end(), observed.begin(), observed.end());
    result.rows.push_back(std::move(row));
  };
  write(0.0);
  const auto last = static_cast<long>(std::ceil(options.duration / options.step * (1 - 1e-12)));
  for (long k = 1; k <= last && integrator.status().empty(); ++k) {
    const double t = k == last ? options.duration : static_cast<double>(k) * options.step;
    if (!integrator.advance(t)) break;
    write(t);
    if (options.progress) options.progress(t / options.duration);
  }
  result.steps = integrator.steps();
  if (!integrator.status().empty()) {
    result.status = fmt::format("{} at t = {:.9g} s", integrator.status(), integrator.time());
  }
  return result;
}

std::string simulation_csv(const Scene& scene, const SimulationOptions& options, const Simulation& motion) {
  std::string text = fmt::format(
      "# Motion of the scene {} by Dormand and Prince's method of order 8, tolerance {:g}, {} steps.\n# Units: {}\n",
      scene.name(), options.tolerance, motion.steps, fmt::join(motion.units, ", "));
  if (!motion.status.empty()) text += fmt::format("# It ends before {:g} s: {}\n", options.duration, motion.status);
  text += fmt::format("{}\n", fmt::join(motion.names, ","));
  for (const std::vector<double>& row : motion.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) text += fmt::format("{}{}", i == 0 ? "" : ",", row[i]);
    text += '\n';
  }
  return text;
}

}  // namespace torsor
