// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/equations/contact_checks.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/dynamics/equations/start_error.hpp"
#include "torsor/generator/dynamics/forces/contacts.hpp"
#include "torsor/generator/mechanics/parameter_value.hpp"
#include "torsor/generator/mechanics/size_bounds.hpp"
#include "torsor/generator/program/evaluation.hpp"

namespace torsor {
namespace {

void check_places_of_stops(const SceneContent& scene) {
  for (const ContactContent& contact : scene.contacts) {
    const auto* stop = std::get_if<Stop>(&contact.geometry);
    const auto place = stop == nullptr ? std::nullopt : known_value(scene, stop->at);
    if (!place || !place->is_nan()) continue;
    throw SceneError(fmt::format("the stop '{}' at {} has a place that is no number", contact.name, stop->at.to_string()));
  }
}

}  // namespace

void check_surfaces(const SceneContent& scene) {
  require_bounds(scene, bounds_of_surfaces(scene));
  check_places_of_stops(scene);
  if (!scene.contacts.empty() && !scene.frictions.empty()) {
    throw SceneError(fmt::format("friction '{}' assumes that its contact slides, and contact '{}' may open and close: give "
                                 "all frictions of the scene with contacts",
                                 scene.frictions[0].name, scene.contacts[0].name));
  }
}

void check_contacts(const Equations& equations) {
  const SceneContent& scene = equations.scene().content();
  if (scene.contacts.empty()) return;
  const std::vector<ContactRows> contacts = contact_rows(equations.model());
  const auto valued = [](const ParameterContent& parameter) { return parameter.value.has_value(); };
  if (!std::all_of(scene.parameters.begin(), scene.parameters.end(), valued)) return;
  Evaluator<Real> start(equations.program(), [&scene](const SymbolPointer& symbol) { return initial_value(scene, symbol); });
  for (const ContactRows& contact : contacts) {
    if (!contact.normal) continue;
    // Decimals given for irrational positions carry some twelve digits.
    constexpr double tolerance = 1e-9;
    const double gap = start(contact.gap).to_double();
    const Unit& unit = contact.gap.unit();
    if (std::isnan(gap)) {
      throw StartError(fmt::format("contact '{}' has no gap at t = 0: its point of contact is not defined there (a disc "
                                   "that lies flat); {}",
                                   contact.name, another_start(scene)));
    }
    if (gap >= -tolerance) continue;
    throw StartError(fmt::format("contact '{}' starts penetrating: its gap is {:.6g}{} at t = 0 and must not be negative; "
                                 "{} of the coordinates that it depends on",
                                 contact.name, gap, unit.is_dimensionless() ? "" : " " + unit.to_string(), another_start(scene)));
  }
}

void refuse_contacts(const Scene& scene, const std::string& user) {
  if (scene.content().contacts.empty()) return;
  throw SceneError(fmt::format("{} of the scene '{}' does not watch contacts and dry friction, as '{}' needs: the command "
                               "simulate moves it from event to event, and a program does so with the kernels mass_matrix, bias, "
                               "contacts and contact_coefficients and runtime/contacts (docs/contacts.md)",
                               user, scene.name(), scene.content().contacts[0].name));
}

}  // namespace torsor
