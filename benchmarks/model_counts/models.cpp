// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/model_counts/models.hpp"

#include <algorithm>
#include <array>
#include <fstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "torsor/generator/base/decimal.hpp"
#include "torsor/generator/base/error.hpp"

namespace torsor {
namespace {

using Json = nlohmann::json;

Expression quantity(const Json& number, const Unit& unit) {
  return Expression::quantity(from_double(number.get<double>()), unit);
}

Triple triple(const Json& numbers, const Unit& unit) {
  return {quantity(numbers.at(0), unit), quantity(numbers.at(1), unit), quantity(numbers.at(2), unit)};
}

const Triple& axis_of(const std::string& name) {
  if (name == "x") return axis::x;
  if (name == "y") return axis::y;
  if (name == "z") return axis::z;
  throw SceneError(fmt::format("unknown joint axis '{}': use x, y or z", name));
}

Scene chain(const Json& model, const Json& gravity) {
  Scene scene(model.at("name").get<std::string>());
  scene.gravity(triple(gravity, units::metre_per_second_squared));
  FrameHandle parent = scene.ground();
  int number = 0;
  for (const Json& joint : model.at("joints")) {
    const std::string index = std::to_string(++number);
    Placement placement;
    std::array<Number, 9> entries;
    for (std::size_t k = 0; k < 9; ++k) entries[k] = from_double(joint.at("R").at(k).get<double>());
    placement.rotation = Rotation::matrix(entries);
    placement.origin = triple(joint.at("p"), units::metre);
    const Expression q = scene.coordinate("q" + index, "rad");
    parent = scene.revolute("link" + index, parent, axis_of(joint.at("axis").get<std::string>()), q, placement);
    const auto entry = [&](std::size_t k) { return quantity(joint.at("inertia").at(k), units::kilogram_metre_squared); };
    const Inertia central = Inertia::general({.mass = quantity(joint.at("mass"), units::kilogram), .xx = entry(0),
                                              .yy = entry(3), .zz = entry(5), .xy = entry(1), .xz = entry(2),
                                              .yz = entry(4)});
    scene.body("link" + index, parent, central.at(triple(joint.at("com"), units::metre)));
  }
  return scene;
}

}  // namespace

std::vector<Scene> read_models(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw FileError(fmt::format("cannot read '{}': does the file exist?", path));
  std::vector<Scene> scenes;
  std::string name;
  const auto where = [&] { return name.empty() ? fmt::format("'{}'", path) : fmt::format("'{}', model '{}'", path, name); };
  try {
    const Json json = Json::parse(file);
    if (!json.is_object() || !json.contains("gravity") || !json.contains("models")) {
      throw FileError(fmt::format("'{}' needs an object with 'gravity' and 'models'", path));
    }
    for (const Json& model : json.at("models")) {
      name = model.at("name").get<std::string>();
      scenes.push_back(chain(model, json.at("gravity")));
    }
  } catch (const Json::exception& error) {
    const std::string text = error.what();  // "[json.exception.kind.number] what"
    throw FileError(fmt::format("{}: {}", where(), text.substr(std::min(text.size(), text.find(']') + 2))));
  } catch (const SceneError& error) {
    throw SceneError(fmt::format("{}: {}", where(), error.what()));
  }
  return scenes;
}

}  // namespace torsor
