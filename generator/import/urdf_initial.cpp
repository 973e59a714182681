// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/import/urdf_initial.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "torsor/generator/base/decimal.hpp"
#include "torsor/generator/base/error.hpp"

namespace torsor {
namespace {

/// Everything that can be given, in the scene's order.
std::vector<std::string> names_of_state(const SceneContent& content) {
  std::vector<std::string> names;
  for (const CoordinateContent& c : content.coordinates) {
    names.push_back(c.q->name);
    if (!c.attitude) names.push_back(c.q->name + "'");
  }
  for (const AttitudeContent& attitude : content.attitudes) {
    for (const SymbolPointer& component : attitude.symbols->e) names.push_back(component->name);
  }
  return names;
}

}  // namespace

void set_initial(Scene& scene, const std::vector<std::pair<std::string, std::string>>& values) {
  if (values.empty()) return;
  const SceneContent& content = scene.content();
  const std::vector<std::string> known = names_of_state(content);
  std::map<std::string, Expression> given;
  for (const auto& [name, text] : values) {
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      throw UsageError(fmt::format("unknown name '{}' in --initial: the state of '{}' has {}", name, scene.name(),
                                   fmt::join(known, ", ")));
    }
    try {
      given[name] = Expression(parse_decimal(text));
    } catch (const Error& error) {
      throw UsageError(fmt::format("--initial {}: {}", name, error.what()));
    }
  }
  const auto value = [&given](const std::string& name) {
    const auto found = given.find(name);
    return found == given.end() ? Expression(0) : found->second;
  };
  for (std::size_t i = 0; i < content.coordinates.size(); ++i) {
    const CoordinateContent& c = content.coordinates[i];
    if (c.attitude) continue;
    const std::string& name = c.q->name;
    if (given.contains(name) || given.contains(name + "'")) scene.initial(c.q, value(name), value(name + "'"));
  }
  for (std::size_t i = 0; i < content.attitudes.size(); ++i) {
    const std::string& name = content.attitudes[i].name;
    std::array<Expression, 4> quaternion;
    bool any = false;
    for (std::size_t k = 0; k < 4; ++k) {
      const std::string& component = content.attitudes[i].symbols->e[k]->name;
      quaternion[k] = value(component);
      any = any || given.contains(component);
    }
    if (!any) quaternion[0] = 1;
    const Triple rates{value(name + "_omega_x"), value(name + "_omega_y"), value(name + "_omega_z")};
    scene.initial(AttitudeHandle{static_cast<int>(i)}, quaternion, rates);
  }
}

}  // namespace torsor
