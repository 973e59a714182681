// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <nlohmann/json.hpp>

#include "torsor/generator/cli/report.hpp"
#include "torsor/generator/mechanics/parameter_value.hpp"
#include "torsor/generator/program/derivative.hpp"
#include "torsor/generator/program/evaluation.hpp"

namespace torsor {
namespace {

constexpr int rows = 17, columns = 24;  ///< of directions from pole to pole, and around

/// Value of a parameter; of one without a value 1, as the page has it.
double number_of(const SceneContent& scene, const SymbolPointer& symbol) {
  const auto known = std::find_if(scene.parameters.begin(), scene.parameters.end(),
                                  [&symbol](const ParameterContent& each) { return each.symbol == symbol; });
  if (known == scene.parameters.end()) return parameter_value(scene, symbol).to_double();
  if (!known->value) return 1.0;
  Program program;
  return Evaluator<double>(program, [&scene](const SymbolPointer& other) { return number_of(scene, other); })(program.lower(*known->value));
}

/// Points ∇h(u) of a convex body, u the direction that is normal there; rounded to what a picture can tell.
std::vector<double> places_of(const SceneContent& scene, const SupportFunction& support) {
  Program program;
  const Value h = program.lower(support.h);
  std::vector<Value> place;
  for (const SymbolPointer& u : support.direction) place.push_back(program.bind(partial_derivation(program, u)(h)));
  std::array<double, 3> direction{};
  const auto value_of = [&](const SymbolPointer& symbol) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (support.direction[i] == symbol) return direction[i];
    }
    return number_of(scene, symbol);
  };
  Evaluator<double> here(program, value_of);
  std::vector<double> places;
  for (int row = 0; row < rows; ++row) {
    const double latitude = std::numbers::pi * (static_cast<double>(row) / (rows - 1) - 0.5);
    for (int k = 0; k < columns; ++k) {
      const double longitude = 2 * std::numbers::pi * k / columns;
      direction = {std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude), std::sin(latitude)};
      here.move_to(value_of);
      for (const double component : here(place)) places.push_back(component);
    }
  }
  double largest = 0;
  for (const double each : places) largest = std::max(largest, std::abs(each));
  const double grain = largest > 0 ? std::pow(10.0, std::ceil(std::log10(largest)) - 5) : 1;
  for (double& each : places) each = std::round(each / grain) * grain + 0.0;  // no -0
  return places;
}

}  // namespace

nlohmann::ordered_json report_surfaces(const SceneContent& scene) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (std::size_t k = 0; k < scene.points.size(); ++k) {
    const auto& lowest = scene.points[k].lowest;
    if (lowest && lowest->support) {
      list.push_back({{"point", k}, {"rows", rows}, {"columns", columns}, {"places", places_of(scene, *lowest->support)}});
    } else if (lowest && !lowest->tube.is_zero()) {
      Program program;
      Evaluator<double> here(program, [&scene](const SymbolPointer& symbol) { return number_of(scene, symbol); });
      list.push_back({{"point", k}, {"tube", here(program.lower(lowest->tube))}});
    }
  }
  return list;
}

}  // namespace torsor
