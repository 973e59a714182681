// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/import/urdf_visuals.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "torsor/generator/base/decimal.hpp"
#include "torsor/generator/base/did_you_mean.hpp"
#include "torsor/generator/import/exact_direction.hpp"
#include "torsor/generator/import/exact_rotation.hpp"

namespace torsor {
namespace {

std::optional<XmlElement> first(const XmlElement& element, const char* name) {
  const std::vector<XmlElement> found = element.children(name);
  return found.empty() ? std::nullopt : std::optional<XmlElement>(found.front());
}

/// That many numbers of a moderate size; none where the attribute holds anything else.
template <std::size_t count>
std::optional<std::array<double, count>> numbers(const XmlElement& element, const char* attribute) {
  if (!element.has(attribute)) return std::nullopt;
  std::istringstream stream(element.value(attribute));
  stream.imbue(std::locale::classic());
  std::array<double, count> values{};
  for (double& value : values) {
    if (!(stream >> value) || !(std::abs(value) < 1e6)) return std::nullopt;
  }
  std::string rest;
  if (stream >> rest) return std::nullopt;
  return values;
}

Expression metres(double value) { return Expression::quantity(from_double(value), units::metre); }
Triple metres(const std::array<double, 3>& v) { return {metres(v[0]), metres(v[1]), metres(v[2])}; }

/// Rz(yaw) Ry(pitch) Rx(roll), exactly a rotation: shapes may touch, and zeros are to be zeros.
Rotation rotation(const std::array<double, 3>& rpy, const Number& tolerance) {
  Rotation turned;
  for (std::size_t i = 0; i < rpy.size(); ++i) {
    turned = rotation_about(static_cast<int>(i), exact_angle(from_double(rpy[i]), tolerance)) * turned;
  }
  return turned;
}

/// The rotation of quat_xyzw, of any length but zero, as exact as the decimals.
std::optional<Rotation> rotation_of_quaternion(const XmlElement& origin) {
  const auto e = numbers<4>(origin, "quat_xyzw");
  if (!e || std::all_of(e->begin(), e->end(), [](double x) { return x == 0; })) return std::nullopt;
  const auto exact = origin.numbers<4>("quat_xyzw");
  return quaternion_rotation({exact[3].value, exact[0].value, exact[1].value, exact[2].value});
}

std::optional<Placement> placement(const XmlElement& visual, const Number& tolerance) {
  Placement placement;
  const auto origin = first(visual, "origin");
  if (!origin) return placement;
  if (origin->has("xyz")) {
    const auto xyz = numbers<3>(*origin, "xyz");
    if (!xyz) return std::nullopt;
    placement.origin = metres(*xyz);
  }
  if (origin->has("quat_xyzw")) {
    const auto turned = origin->has("rpy") ? std::nullopt : rotation_of_quaternion(*origin);
    if (!turned) return std::nullopt;
    placement.rotation = *turned;
  } else if (origin->has("rpy")) {
    const auto rpy = numbers<3>(*origin, "rpy");
    if (!rpy) return std::nullopt;
    placement.rotation = rotation(*rpy, tolerance);
  }
  return placement;
}

std::optional<double> length(const XmlElement& element, const char* attribute) {
  const auto value = numbers<1>(element, attribute);
  return value && (*value)[0] > 0 ? std::optional<double>((*value)[0]) : std::nullopt;
}

std::optional<Form> form_of(const XmlElement& geometry) {
  if (const auto box = first(geometry, "box")) {
    const auto size = numbers<3>(*box, "size");
    if (size && std::all_of(size->begin(), size->end(), [](double edge) { return edge > 0; })) return form::Box{metres(*size)};
  } else if (const auto cylinder = first(geometry, "cylinder")) {
    const auto radius = length(*cylinder, "radius"), height = length(*cylinder, "length");
    if (radius && height) return form::Cylinder{metres(*radius), metres(*height)};
  } else if (const auto sphere = first(geometry, "sphere")) {
    if (const auto radius = length(*sphere, "radius")) return form::Sphere{metres(*radius)};
  } else if (const auto mesh = first(geometry, "mesh")) {
    if (!mesh->has("filename") || mesh->value("filename").empty()) return std::nullopt;
    if (!mesh->has("scale")) return form::Mesh{mesh->value("filename")};
    if (const auto scale = numbers<3>(*mesh, "scale")) return form::Mesh{mesh->value("filename"), *scale};
  }
  return std::nullopt;
}

std::optional<Colour> colour_of(const XmlElement& material) {
  const auto colour = first(material, "color");
  const auto rgba = colour ? numbers<4>(*colour, "rgba") : std::nullopt;
  if (!rgba) return std::nullopt;
  const auto share = [&rgba](std::size_t i) { return std::clamp((*rgba)[i], 0.0, 1.0); };
  return Colour{share(0), share(1), share(2)};
}

/// Whether an element that acts holds a word that looks like one of these and is not.
bool misspells(const std::vector<std::string>& words, const std::vector<std::string>& known) {
  return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
    return std::find(known.begin(), known.end(), word) == known.end() && !did_you_mean(word, known).empty();
  });
}

/// Whether a shape that links touch with says one form at one place. What a picture may pass over decides a motion here.
bool is_plain(const XmlElement& collision) {
  std::vector<std::string> names;
  for (const XmlElement& each : collision.elements()) names.push_back(each.name());
  const auto once = [&names](const char* name) { return std::count(names.begin(), names.end(), name) <= 1; };
  if (!once("origin") || !once("geometry") || misspells(names, {"origin", "geometry"})) return false;
  if (const auto origin = first(collision, "origin")) {
    if (misspells(origin->attributes(), {"xyz", "rpy", "quat_xyzw"})) return false;
  }
  const auto geometry = first(collision, "geometry");
  return !geometry || geometry->elements().size() == 1;
}

std::string name_of(const XmlElement& element) { return element.has("name") ? element.value("name") : std::string(); }

}  // namespace

std::vector<UrdfVisual> read_visuals(const XmlElement& robot, const Number& angle_tolerance) {
  std::map<std::string, Colour> materials;  // a name may be declared in one link and used in another
  const auto declare = [&materials](const XmlElement& material) {
    if (const auto colour = colour_of(material)) materials.emplace(name_of(material), *colour);
  };
  for (const XmlElement& material : robot.children("material")) declare(material);
  for (const XmlElement& link : robot.children("link")) {
    for (const XmlElement& visual : link.children("visual")) {
      if (const auto material = first(visual, "material"); material && !name_of(*material).empty()) declare(*material);
    }
  }
  std::vector<UrdfVisual> visuals;
  for (const XmlElement& link : robot.children("link")) {
    for (const XmlElement& visual : link.children("visual")) {
      const auto geometry = first(visual, "geometry");
      const auto form = geometry ? form_of(*geometry) : std::nullopt;
      const auto place = placement(visual, angle_tolerance);
      if (!form || !place) continue;
      std::optional<Colour> colour;
      if (const auto material = first(visual, "material")) {
        colour = colour_of(*material);
        const auto named = materials.find(name_of(*material));
        if (!colour && named != materials.end()) colour = named->second;
      }
      visuals.push_back({name_of(link), *form, *place, colour});
    }
  }
  return visuals;
}

std::vector<UrdfCollision> read_collisions(const XmlElement& robot, const Number& angle_tolerance) {
  std::vector<UrdfCollision> collisions;
  for (const XmlElement& link : robot.children("link")) {
    for (const XmlElement& collision : link.children("collision")) {
      const auto geometry = first(collision, "geometry");
      collisions.push_back({collision.place(), name_of(link), geometry ? form_of(*geometry) : std::nullopt,
                            is_plain(collision) ? placement(collision, angle_tolerance) : std::nullopt});
    }
  }
  return collisions;
}

}  // namespace torsor
