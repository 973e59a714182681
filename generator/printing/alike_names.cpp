// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/printing/alike_names.hpp"

#include <map>
#include <set>
#include <variant>

#include <fmt/ranges.h>

#include "torsor/generator/printing/notation.hpp"

namespace torsor::printing {

std::vector<std::string> alike_names(const SceneContent& scene, const NaturalLanguage& say) {
  std::map<std::string, std::set<std::string>> by_spelling;
  const auto add = [&](const std::string& name) { by_spelling[latex_name(name)].insert(name); };
  for (const ParameterContent& parameter : scene.parameters) add(parameter.symbol->name);
  for (const CoordinateContent& coordinate : scene.coordinates) add(coordinate.q->name);
  for (const ConstraintContent& constraint : scene.constraints) add(constraint.multiplier->name);
  for (const ActionContent& action : scene.actions) {
    if (const auto* motor = std::get_if<Motor>(&action)) add(motor->input->name);
  }
  std::vector<std::string> sentences;
  for (const auto& [spelling, names] : by_spelling) {
    if (names.size() < 2) continue;
    sentences.push_back(say("Formulas spell {} alike: rename all but one.", fmt::format("{}", fmt::join(names, ", "))));
  }
  return sentences;
}

}  // namespace torsor::printing
