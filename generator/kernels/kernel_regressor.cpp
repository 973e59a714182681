// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/kernels/kernel_regressor.hpp"

#include <fmt/format.h>

#include "torsor/generator/dynamics/motion/body_set.hpp"
#include "torsor/generator/dynamics/recursions/base_parameters.hpp"
#include "torsor/generator/dynamics/recursions/regressor.hpp"
#include "torsor/generator/kernels/kernel_parts.hpp"

namespace torsor {
namespace {

/// Which index belongs to which link and its bodies, a line each.
ConstantTable list_of_parameters(const Model& model, const std::vector<std::size_t>& links) {
  std::string text = "Standard inertial parameters of the links, ten each about the link's origin in its axes:\n ";
  for (const char* name : inertial_parameter_names) text += fmt::format(" {}", name);
  text += " (J_xy = minus the integral of x y dm).";
  const std::vector<bool> rotor = rotor_links(model);
  for (std::size_t l = 0; l < links.size(); ++l) {
    std::string bodies;
    for (const BodyContent* body : model.scene().inertias()) {
      if (static_cast<std::size_t>(model.place(body->frame, "body '" + body->name + "'").link) != links[l]) continue;
      bodies += (bodies.empty() ? "" : ", ") + body->name;
    }
    text += fmt::format("\n{} to {}: ", 10 * l, 10 * l + 9);
    text += rotor[links[l]] ? fmt::format("reflected inertia {}, J_zz", bodies)
                            : fmt::format("frame {} with body {}", model.links()[links[l]].name, bodies);
  }
  return {"inertial_parameter_count", 10 * links.size(), text};
}

void add_base(std::vector<ConstantTable>& tables, const BaseParameters& base) {
  tables.push_back({"base_parameter_count", base.independent.size(),
                    "Base parameters pi_b, by their place in the list above; of the others those that have an effect are\n"
                    "combined with them. First link to last: what a joint cannot tell apart goes towards the ground\n"
                    "(Gautier & Khalil, 1990)."});
  tables.push_back({"base_parameters", base.independent});
}

/// K without its zeros.
void add_regrouping(std::vector<ConstantTable>& tables, const BaseParameters& base) {
  ConstantTable::Indices from, to;
  ConstantTable::Factors by;
  for (std::size_t d = 0; d < base.dependent.size(); ++d) {
    for (std::size_t b = 0; b < base.independent.size(); ++b) {
      const Real& k = base.combination[b][d];
      if (k.is_zero()) continue;
      from.push_back(base.dependent[d]);
      to.push_back(b);
      by.push_back(k.to_double());
    }
  }
  tables.push_back({"regrouping_count", by.size(),
                    "pi_base = pi_b + K pi_d: each pi_base[regrouped_to[k]], from pi[base_parameters[...]], gains\n"
                    "regrouping_factors[k] * pi[regrouped_from[k]]."});
  tables.push_back({"regrouped_from", from});
  tables.push_back({"regrouped_to", to});
  tables.push_back({"regrouping_factors", by});
}

}  // namespace

std::string no_regressor(const Equations& equations) {
  const Model& model = equations.model();
  const std::vector<std::size_t> links = links_with_inertia(model);
  if (links.empty()) return "no body moves";
  if (unknowns(equations) == 0) return "the scene has no unknown coordinates";
  for (const std::size_t link : links) {
    for (const int k : model.chain(static_cast<int>(link))) {
      for (const auto& [i, partial] : model.links()[static_cast<std::size_t>(k)].partials) {
        if (i < model.unknown_count()) return "";
      }
    }
  }
  return "the inertia of no body has an effect";
}

Kernel make_regressor(const Equations& equations) {
  Kernel kernel;
  const Model& model = equations.model();
  const std::vector<std::size_t> links = links_with_inertia(model);
  const ValueMatrix y = regressor(model);
  const BaseParameters base = base_parameters(model, y);
  kernel.documentation =
      "Regressor: Y pi_base are the generalised forces of inertia and gravity at (q, v, a), inverse_dynamics without\n"
      "other actions and multipliers. Y has the columns of base_parameters only: those of the other inertial\n"
      "parameters are combinations of them, no measurement tells them apart, and least squares with them are singular.";
  if (!equations.constraints().empty()) {
    kernel.documentation += "\nConstraints are not used: motions that respect them may tell fewer parameters apart.";
  }
  if (!base.at_any_parameters) {
    kernel.documentation +=
        "\nThe base parameters are those at the values that run-time parameters have in the scene; how the others\n"
        "combine with them depends on these values, so that no table says it.";
  }
  Structure structure{"Regressor", "What the generalised forces are linear in, stored column by column.", {}};
  structure.tables = {list_of_parameters(model, links)};
  add_base(structure.tables, base);
  if (base.at_any_parameters) add_regrouping(structure.tables, base);
  kernel.arguments = {Argument::accelerations};
  kernel.results = {{"Regressor", "result"}};
  ValueMatrix columns;
  for (const std::vector<Value>& row : y) {
    columns.emplace_back();
    for (const std::size_t c : base.independent) columns.back().push_back(row[c]);
  }
  structure.members.push_back(matrix_member("Y", y.size(), base.independent.size(), "forces of unit base parameters"));
  assign_matrix(kernel, {"result", "Y"}, columns, base.independent.size());
  kernel.structures = {structure};
  return kernel;
}

}  // namespace torsor
