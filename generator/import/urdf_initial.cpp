// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/import/urdf_initial.hpp"

#include <algorithm>
#include <cmath>
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

/// (w, x, y, z) of length 1. With s = 2 e_k of its largest component e_k, the others are differences or sums of entries
/// over s, so that none is lost by a small divisor (Shepperd, J. Guidance and Control 1 (1978) 223).
std::array<double, 4> unit_quaternion(const Rotation& rotation) {
  const auto r = [&rotation](int row, int column) { return rotation(row, column).to_double(); };
  const double trace = r(0, 0) + r(1, 1) + r(2, 2);
  const std::array<double, 4> squares{1 + trace, 1 + 2 * r(0, 0) - trace, 1 + 2 * r(1, 1) - trace,
                                      1 + 2 * r(2, 2) - trace};  // of 2 e_k
  const auto largest = static_cast<int>(std::max_element(squares.begin(), squares.end()) - squares.begin());
  const double s = std::sqrt(squares.at(static_cast<std::size_t>(largest)));
  std::array<double, 4> e{};
  e.at(static_cast<std::size_t>(largest)) = s / 2;
  if (largest == 0) {
    for (int k = 0; k < 3; ++k) {
      const int a = (k + 1) % 3, b = (k + 2) % 3;
      e.at(static_cast<std::size_t>(k + 1)) = (r(b, a) - r(a, b)) / (2 * s);
    }
    return e;
  }
  const int k = largest - 1, a = (k + 1) % 3, b = (k + 2) % 3;
  e[0] = (r(b, a) - r(a, b)) / (2 * s);
  e.at(static_cast<std::size_t>(a + 1)) = (r(a, k) + r(k, a)) / (2 * s);
  e.at(static_cast<std::size_t>(b + 1)) = (r(b, k) + r(k, b)) / (2 * s);
  return e;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> with_start(std::vector<std::pair<std::string, std::string>> given,
                                                            const std::string& base, const UrdfPlacement& start) {
  const auto is_given = [&given](const std::string& name) {
    return std::any_of(given.begin(), given.end(), [&name](const auto& each) { return each.first == name; });
  };
  static constexpr std::array<const char*, 3> places{"_x", "_y", "_z"};
  static constexpr std::array<const char*, 4> components{"_attitude_w", "_attitude_x", "_attitude_y", "_attitude_z"};
  const bool turned = std::any_of(components.begin(), components.end(), [&](const char* c) { return is_given(base + c); });
  std::vector<std::pair<std::string, std::string>> all = given;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!start.xyz[k].is_zero() && !is_given(base + places.at(k))) {
      all.emplace_back(base + places.at(k), shortest(start.xyz[k].to_double()));
    }
  }
  if (turned || start.rotation.is_identity()) return all;
  const std::array<double, 4> e = unit_quaternion(start.rotation);
  for (std::size_t k = 0; k < 4; ++k) all.emplace_back(base + components.at(k), shortest(e[k]));
  return all;
}

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
