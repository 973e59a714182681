// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/emission/cpp_structures.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/emission/cpp_names.hpp"
#include "torsor/generator/emission/formula_printer.hpp"
#include "torsor/generator/emission/text_template.hpp"
#include "torsor/generator/program/written_unit.hpp"

namespace torsor {
namespace {

Member scalar(const Symbol& symbol, const std::string& meaning, const std::string& unit) {
  return {member_name(symbol), 1, 1, {meaning, unit}};
}
Member scalar(const Symbol& symbol, const std::string& meaning) { return scalar(symbol, meaning, written_unit(symbol)); }

std::string element_access(const Structure& structure) {
  const std::string pointer = fmt::format("Scalar {}::*", structure.name);
  std::string table;
  for (const Member& member : structure.members) {
    table += fmt::format("{}&{}::{}", table.empty() ? "" : ", ", structure.name, member.name);
  }
  std::string text = fmt::format("  static constexpr int size = {};\n", structure.members.size());
  text += "  TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }\n";
  text += "  TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }\n";
  text += fmt::format("\n private:\n  TORSOR_DEVICE static constexpr {}member_(int i_) noexcept {{\n", pointer);
  const std::string declaration = fmt::format("constexpr {}members_[] = {{{}}};", pointer, table);
  text += indented(wrapped(declaration, 6), "    ");
  text += "    return members_[i_];\n  }\n";
  return text;
}

}  // namespace

std::vector<Structure> common_structures(const Equations& equations, const std::vector<SymbolPointer>& parameters) {
  const Model& model = equations.model();
  Structure given{"Parameters", "Parameters that are set at run time.", {}};
  for (const SymbolPointer& symbol : parameters) given.members.push_back(scalar(*symbol, "parameter"));
  Structure q{"Coordinates", "Generalised coordinates q.", {}};
  for (const SymbolPointer& symbol : model.positions()) {
    const bool quaternion = !symbol->attitude.expired();
    q.members.push_back(scalar(*symbol, "coordinate"));
    if (quaternion) q.members.back().meaning = {"component of a unit quaternion", "1"};
  }
  const bool quasi_velocities = model.positions().size() != static_cast<std::size_t>(model.unknown_count());
  Structure v{"Velocities",
              quasi_velocities ? "Generalised velocities v; coordinate_rates gives dq/dt."
                               : "Generalised velocities v = dq/dt.",
              {}};
  Structure a{"Accelerations", "Generalised accelerations dv/dt.", {}};
  Structure forces{"GeneralizedForces", "Generalised forces, one along each coordinate.", {}};
  for (int i = 0; i < model.unknown_count(); ++i) {
    const CoordinateContent& coordinate = model.coordinates()[static_cast<std::size_t>(i)];
    const std::string& name = coordinate.q->name;
    const bool quasi = coordinate.attitude.has_value();
    v.members.push_back(scalar(*coordinate.v, quasi ? "angular velocity, in moving axes" : "its rate"));
    a.members.push_back(scalar(*coordinate.a, quasi ? "its rate" : "its second rate"));
    forces.members.push_back(scalar(*coordinate.q, (quasi ? "works with " : "works with the rate of ") + name,
                                    written_unit(units::joule / coordinate.q->unit)));
  }
  Structure inputs{"Inputs", "Forces and torques of motors, set at each call.", {}};
  for (const SymbolPointer& symbol : model.inputs()) inputs.members.push_back(scalar(*symbol, "motor"));
  Structure multipliers{"Multipliers", "Multipliers of the constraints, or the reactions that enforce them.", {}};
  for (std::size_t j = 0; j < model.scene().constraints.size(); ++j) {
    const ConstraintContent& constraint = model.scene().constraints[j];
    const Symbol& symbol = *constraint.multiplier;
    const bool determinate = equations.redundancy().determinate[j];
    multipliers.members.push_back(scalar(
        symbol, (determinate ? "of the constraint " : "indeterminate, of the constraint ") + constraint.name));
  }
  return {given, q, v, a, forces, inputs, multipliers};
}

void check_names(const Structure& structure) {
  std::set<std::string> names;
  const std::string what = fmt::format("member of {}", structure.name);
  for (const Member& member : structure.members) {
    require_cpp_name(member.name, what);
    if (member.name == structure.name || !names.insert(member.name).second) {
      throw SceneError(
          fmt::format("two things would be called '{}' in the structure {} of the generated header: choose "
                      "another name for one",
                      member.name, structure.name));
    }
  }
}

std::string structure_text(const Structure& structure) {
  std::string text = fmt::format("/// {}\n", comment_text(structure.documentation));
  if (structure.members.empty()) {
    return text + fmt::format("struct {} : torsor::NoMembers<Scalar> {{}};\n", structure.name);
  }
  text += fmt::format("struct {} {{\n", structure.name);
  for (const Member& member : structure.members) {
    const std::string type =
        member.is_scalar() ? "Scalar" : fmt::format("std::array<Scalar, {}>", member.rows * member.columns);
    const std::string shape =
        member.is_scalar() || member.columns == 1 ? "" : fmt::format(" ({} x {})", member.rows, member.columns);
    text += fmt::format("  {} {};  ///< {}{}\n", type, member.name, comment_text(member.meaning.with_unit()), shape);
  }
  const bool indexed = std::all_of(structure.members.begin(), structure.members.end(),
                                   [](const Member& member) { return member.is_scalar(); });
  if (indexed) text += element_access(structure);
  return text + "};\n";
}

}  // namespace torsor
