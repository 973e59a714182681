// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/kernels/kernel_contacts.hpp"

#include <algorithm>
#include <variant>

#include <fmt/format.h>

#include "torsor/generator/dynamics/forces/contacts.hpp"
#include "torsor/generator/dynamics/theorems/bearing_reactions.hpp"
#include "torsor/generator/kernels/kernel_parts.hpp"

namespace torsor {
namespace {

/// "ball_on_cloth, ball_on_ball".
std::string names_of(const Equations& equations) {
  std::vector<std::string> names;
  for (const ContactContent& contact : equations.scene().content().contacts) names.push_back(contact.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

/// R = B a + C r + D λ + R0 of joints whose friction is in proportion to it.
void add_bearings(const Equations& equations, std::size_t rows, Kernel& kernel) {
  const std::size_t n = unknowns(equations), m = equations.constraints().size();
  std::vector<std::size_t> counts;
  std::vector<BearingReaction> all;
  for (std::vector<BearingReaction>& components : bearing_reactions(equations)) {
    counts.push_back(components.size());
    for (BearingReaction& component : components) all.push_back(std::move(component));
  }
  if (all.empty()) return;
  Structure& structure = kernel.structures[0];
  structure.members.push_back(vector_member("bearing", all.size(), {"R0", "N"}));
  structure.members.push_back(matrix_member("bearing_by_accelerations", all.size(), n, "B, stored column by column"));
  structure.members.push_back(matrix_member("bearing_by_reactions", all.size(), rows, "C, stored column by column"));
  if (m > 0) structure.members.push_back(matrix_member("bearing_by_multipliers", all.size(), m, "D, stored column by column"));
  structure.tables.push_back({"contact_bearings", counts,
                              "How many components of a joint's reaction each contact has, by which its friction is bounded."});
  ValueMatrix by_accelerations, by_reactions, by_multipliers;
  for (std::size_t k = 0; k < all.size(); ++k) {
    kernel.assignments.push_back({{"result", "bearing", k}, all[k].rest});
    by_accelerations.push_back(std::move(all[k].by_accelerations));
    by_reactions.push_back(std::move(all[k].by_reactions));
    by_multipliers.push_back(std::move(all[k].by_multipliers));
  }
  assign_matrix(kernel, {"result", "bearing_by_accelerations"}, by_accelerations, n);
  assign_matrix(kernel, {"result", "bearing_by_reactions"}, by_reactions, rows);
  if (m > 0) assign_matrix(kernel, {"result", "bearing_by_multipliers"}, by_multipliers, m);
  kernel.documentation +=
      "\nWhat joints with friction in proportion to it transmit across their axes: R = B a + C r + D lambda + R0.";
}

}  // namespace

std::string no_contacts(const Equations& equations) {
  return equations.scene().content().contacts.empty() ? "the scene has no contacts that open and close" : "";
}

Kernel make_contacts(const Equations& equations) {
  const std::vector<ContactRows> contacts = contact_rows(equations.model());
  const std::size_t n = unknowns(equations);
  Kernel kernel;
  kernel.results = {{"Contacts", "result"}};
  std::vector<std::size_t> normals, tangents, pressed_by;
  bool turns = false;
  ValueMatrix jacobian;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const ContactRows& contact = contacts[k];
    normals.push_back(contact.normal ? 1 : 0);
    tangents.push_back(contact.tangents());
    pressed_by.push_back(contact.pressed_by ? *contact.pressed_by + 1 : 0);
    turns = turns || contact.pressed_by;
    kernel.assignments.push_back({{"result", "gap", k}, contact.gap});
    for (const ContactRow& row : contact.rows) {
      kernel.assignments.push_back({{"result", "rate", jacobian.size()}, row.rate});
      kernel.assignments.push_back({{"result", "drift", jacobian.size()}, row.drift});
      jacobian.push_back(row.jacobian);
    }
  }
  const std::size_t rows = jacobian.size();
  kernel.documentation =
      "Contacts that open and close, in the order " + names_of(equations) +
      ".\nRows are contact by contact, the normal first (n from the second body to the first, so that w > 0 opens), then\n"
      "the tangents: w = J v + b, dw/dt = J a + drift. M a + h = E u + A' lambda + J' r with the reactions r.";
  kernel.structures = {
      {"Contacts",
       "Gaps of contacts, and what they may do along their normals and tangents.",
       {vector_member("gap", contacts.size(), "of each contact, falls to 0 where it closes; 0 of dry friction"),
        vector_member("rate", rows, "w, of normals d(gap)/dt, of tangents the slip"),
        matrix_member("jacobian", rows, n, "J, stored column by column"),
        vector_member("drift", rows, "dw/dt at zero accelerations")},
       {{"contact_count", contacts.size(), "Contacts, and their rows."},
        {"contact_row_count", rows},
        {"contact_normals", normals, "How many normals and tangents each contact has: dry friction has no normal."},
        {"contact_tangents", tangents}}}};
  if (turns) {
    kernel.structures[0].tables.push_back(
        {"contact_pressed_by", pressed_by, "Of a turn that is resisted the contact whose N bounds the moment, from 1; else 0."});
  }
  assign_matrix(kernel, {"result", "jacobian"}, jacobian, n);
  add_bearings(equations, rows, kernel);
  return kernel;
}

Kernel make_contact_coefficients(const Equations& equations) {
  const std::vector<ContactCoefficients> contacts = contact_coefficients(equations.model());
  const std::size_t count = contacts.size();
  const auto& geometries = equations.scene().content().contacts;
  const bool turns = std::any_of(geometries.begin(), geometries.end(), [](const ContactContent& contact) {
    const auto* joint = std::get_if<FrictionInJoint>(&contact.geometry);
    return std::holds_alternative<TurnOnContact>(contact.geometry) || (joint != nullptr && !joint->radius.is_zero());
  });
  Kernel kernel;
  kernel.documentation = "What the surfaces of each contact are made of, in the order " + names_of(equations) +
                         ":\n|T| <= f N + b while it slides, f_s and b_s while it sticks.";
  kernel.results = {{"ContactCoefficients", "result"}};
  kernel.structures = {{"ContactCoefficients",
                        "Coefficients of contacts.",
                        {vector_member("friction", count, turns ? "f [1]; of turns h [m]" : Meaning{"f", "1"}),
                         vector_member("static_friction", count, turns ? "f_s [1]; of turns h [m]" : Meaning{"f_s", "1"}),
                         vector_member("restitution", count, {"e", "1"}),
                         vector_member("bound", count, "b of dry friction, 0 of others"),
                         vector_member("static_bound", count, "b_s of dry friction, 0 of others")}}};
  for (std::size_t k = 0; k < count; ++k) {
    kernel.assignments.push_back({{"result", "friction", k}, contacts[k].friction});
    kernel.assignments.push_back({{"result", "static_friction", k}, contacts[k].static_friction});
    kernel.assignments.push_back({{"result", "restitution", k}, contacts[k].restitution});
    kernel.assignments.push_back({{"result", "bound", k}, contacts[k].bound});
    kernel.assignments.push_back({{"result", "static_bound", k}, contacts[k].static_bound});
  }
  return kernel;
}

}  // namespace torsor
