// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/kernels/kernel_outputs.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/dynamics/derivatives/parameter_sensitivities.hpp"
#include "torsor/generator/dynamics/motion/ground_motion.hpp"
#include "torsor/generator/kernels/kernel_energy.hpp"
#include "torsor/generator/kernels/kernel_parts.hpp"
#include "torsor/generator/kernels/kernel_reactions.hpp"
#include "torsor/generator/program/derivative.hpp"

namespace torsor {
namespace {

using Symbols = std::vector<SymbolPointer>;

Symbols unknown_velocities(const Equations& equations) {
  Symbols symbols;
  for (std::size_t i = 0; i < unknowns(equations); ++i) symbols.push_back(equations.model().coordinates()[i].v);
  return symbols;
}

Symbols unknown_accelerations(const Equations& equations) {
  Symbols symbols;
  for (std::size_t i = 0; i < unknowns(equations); ++i) symbols.push_back(equations.model().coordinates()[i].a);
  return symbols;
}

Symbols multipliers(const Equations& equations) {
  Symbols symbols;
  for (const ConstraintContent& constraint : equations.scene().content().constraints)
    symbols.push_back(constraint.multiplier);
  return symbols;
}

/// One row for each value, by reverse sweeps: few values depend on much.
ValueMatrix slopes_of(const Equations& equations, const std::vector<Value>& values, const Symbols& by,
                      std::vector<Value> (*sweep)(const Value&, const Symbols&)) {
  ValueMatrix rows;
  for (const Value& value : values) {
    rows.emplace_back(by.size());
    if (value.is_constant()) continue;
    const std::vector<Value> slopes = sweep(value, by);
    for (std::size_t j = 0; j < by.size(); ++j) rows.back()[j] = equations.program().bind(slopes[j]);
  }
  return rows;
}

Kernel array_of(const std::vector<Value>& values, std::string documentation) {
  Kernel kernel;
  kernel.documentation = std::move(documentation);
  kernel.results = {{"", "outputs", values.size()}};
  assign_vector(kernel, {"outputs"}, values, values.size());
  return kernel;
}

std::vector<Value> output_reactions(const Equations& equations, const OutputNames& names) {
  const auto& coordinates = equations.model().coordinates();
  std::vector<Value> values;
  for (const std::string& name : names.reactions) {
    std::size_t i = unknowns(equations);
    while (i < coordinates.size() && coordinates[i].q->name != name) ++i;
    if (i == coordinates.size())
      throw SceneError(fmt::format("the scene '{}' releases no coordinate '{}'", equations.scene().name(), name));
    values.push_back(released_reaction(equations, i));
  }
  return values;
}

}  // namespace

std::vector<Value> output_places(const Equations& equations, const OutputNames& names) {
  const Model& model = equations.model();
  Program& program = model.program();
  const GroundMotion motion(model);
  std::vector<Value> values;
  const auto add_place = [&](int link, const Vector& in_link) {
    const Vector arm = bound(program, motion.rotation(link) * in_link);
    const Vector place = bound(program, motion.origin(link) + arm);
    for (int i = 0; i < 3; ++i) values.push_back(place[i]);
  };
  for (const std::string& name : names.points) {
    const std::string user = "output '" + name + "'";
    const PointHandle point{model.scene().point_index(PointReference(name), user)};
    const int link = model.place(model.scene().points[static_cast<std::size_t>(point.index)].frame, user).link;
    add_place(link, bound(program, model.locate(point, link, user)));
  }
  for (const std::string& name : names.frames) {
    const FramePlace& at = model.place(name, "output '" + name + "'");
    add_place(at.link, at.origin);
    const Matrix turn = bound(program, motion.rotation(at.link) * constant_matrix(program, at.rotation));
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) values.push_back(turn(i, j));
    }
  }
  return values;
}

Kernel make_output_places(const Equations& equations, const OutputNames& names) {
  return array_of(
      output_places(equations, names),
      "Positions of points; of frames the position of the origin, then row by row the rotation from their axes to\n"
      "the ground's; all in ground axes.");
}

Kernel make_output_place_derivatives(const Equations& equations, const OutputNames& names) {
  const std::vector<Value> values = output_places(equations, names);
  ValueMatrix rows(values.size());
  for (std::size_t j = 0; j < unknowns(equations); ++j) {
    Derivation along = equations.model().along(static_cast<int>(j));
    for (std::size_t i = 0; i < values.size(); ++i) {
      const Value slope = along(values[i]);
      rows[i].push_back(equations.program().bind(slope));
    }
  }
  SlopesBuilder slopes("OutputPlaceDerivatives", "Derivatives of positions and rotations, stored column by column.");
  slopes.add("by_position", rows, "d_i/dq_j");
  slopes.add("by_parameter", slopes_of(equations, values, sensitivity_parameters(equations), gradient), "d_i/dp_k");
  return slopes.take("Derivatives of output_places. Along an attitude q_j is a turn about its moving axis j.");
}

Kernel make_energy_derivatives(const Equations& equations) {
  const Energies energies = energies_of(equations);
  const Symbols velocities = unknown_velocities(equations);
  SlopesBuilder slopes("EnergyDerivatives", "Derivatives of the kinetic energy T and of the force function U.");
  slopes.add("kinetic_by_position", slopes_of(equations, {energies.kinetic}, velocities, gradient_along), "dT/dq_j");
  slopes.add("kinetic_by_velocity", slopes_of(equations, {energies.kinetic}, velocities, gradient), "dT/dv_j");
  slopes.add("force_function_by_position", slopes_of(equations, {energies.force_function}, velocities, gradient_along),
             "dU/dq_j");
  const Symbols parameters = sensitivity_parameters(equations);
  slopes.add("kinetic_by_parameter", slopes_of(equations, {energies.kinetic}, parameters, gradient), "dT/dp_k");
  slopes.add("force_function_by_parameter", slopes_of(equations, {energies.force_function}, parameters, gradient),
             "dU/dp_k");
  return slopes.take("Derivatives of energy. Along an attitude q_j is a turn about its moving axis j.");
}

Kernel make_output_reactions(const Equations& equations, const OutputNames& names) {
  Kernel kernel =
      array_of(output_reactions(equations, names),
               "Reactions against released coordinates, at accelerations, multipliers and inputs that belong to the\n"
               "motion.");
  kernel.arguments = {Argument::accelerations, Argument::multipliers, Argument::inputs};
  return kernel;
}

Kernel make_output_reaction_derivatives(const Equations& equations, const OutputNames& names) {
  const std::vector<Value> values = output_reactions(equations, names);
  SlopesBuilder slopes(
      "OutputReactionDerivatives",
      "Partial derivatives of reactions, stored column by column; accelerations and multipliers count as\n"
      "independent.");
  slopes.add("by_position", slopes_of(equations, values, unknown_velocities(equations), gradient_along), "dR_i/dq_j");
  slopes.add("by_velocity", slopes_of(equations, values, unknown_velocities(equations), gradient), "dR_i/dv_j");
  slopes.add("by_acceleration", slopes_of(equations, values, unknown_accelerations(equations), gradient), "dR_i/da_j");
  slopes.add("by_multiplier", slopes_of(equations, values, multipliers(equations), gradient), "dR_i/dlambda_j");
  slopes.add("by_input", slopes_of(equations, values, equations.model().inputs(), gradient), "dR_i/du_j");
  slopes.add("by_parameter", slopes_of(equations, values, sensitivity_parameters(equations), gradient), "dR_i/dp_k");
  return slopes.take("Partial derivatives of output_reactions. Along an attitude q_j is a turn about its moving axis j.",
                     {Argument::accelerations, Argument::multipliers, Argument::inputs});
}

}  // namespace torsor
