// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/mechanics/scene_content.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "torsor/generator/base/did_you_mean.hpp"
#include "torsor/generator/base/error.hpp"

namespace torsor {
namespace {

template <class Content>
int find_index(const std::vector<Content>& all, const std::variant<int, std::string>& target, const std::string& kind,
               const std::string& user) {
  if (const int* index = std::get_if<int>(&target)) {
    if (*index >= 0 && *index < static_cast<int>(all.size())) return *index;
    throw SceneError(fmt::format("{} uses {} number {}, which belongs to another scene", user, kind, *index));
  }
  const std::string& name = std::get<std::string>(target);
  std::vector<std::string> known;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].name == name) return static_cast<int>(i);
  }
  for (const Content& each : all) known.push_back(each.name);
  throw SceneError(fmt::format("unknown {} '{}' in {}: {}the scene has {}", kind, name, user, did_you_mean(name, known),
                               known.empty() ? "none" : fmt::format("{}", fmt::join(known, ", "))));
}

}  // namespace

int SceneContent::frame_index(const FrameReference& reference, const std::string& user) const {
  const int index = find_index(frames, reference.target, "frame", user);
  const FrameContent& frame = frames[static_cast<std::size_t>(index)];
  if (std::holds_alternative<std::string>(reference.target) && is_rotor(frame)) {
    throw SceneError(fmt::format("{} names '{}', a reflected inertia, which has no place and no axes: name a frame", user,
                                 frame.name));
  }
  return index;
}
int SceneContent::point_index(const PointReference& reference, const std::string& user) const {
  return find_index(points, reference.target, "point", user);
}

const std::string& name_of(const ActionContent& action) {
  return std::visit([](const auto& any) -> const std::string& { return any.name; }, action);
}

std::vector<SymbolPointer> symbols_of(const CoordinateContent& freedom) {
  if (freedom.attitude) return {freedom.v, freedom.a};
  return {freedom.q, freedom.v, freedom.a};
}

Expression initial_component(const AttitudeContent& attitude, std::size_t k) {
  if (!attitude.initial) return k == 0 ? 1 : 0;
  Expression square = 0;
  for (const Expression& e : *attitude.initial) square = square + e * e;
  return (*attitude.initial)[k] / sqrt(square);
}

std::optional<std::pair<std::size_t, std::size_t>> SceneContent::quaternion_component(
    const SymbolPointer& symbol) const {
  for (std::size_t i = 0; i < attitudes.size(); ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      if (attitudes[i].symbols->e[k] == symbol) return std::pair(i, k);
    }
  }
  return std::nullopt;
}

std::string name_of(const PointContent& point) {
  return point.contact.empty() ? fmt::format("point '{}'", point.name) : fmt::format("contact '{}'", point.contact);
}

std::vector<const BodyContent*> SceneContent::inertias() const {
  std::vector<const BodyContent*> all;
  for (const std::vector<BodyContent>* some : {&bodies, &rotors}) {
    for (const BodyContent& each : *some) all.push_back(&each);
  }
  return all;
}

bool SceneContent::is_rotor(const BodyContent& inertia) const {  // a body may be its namesake
  return std::any_of(rotors.begin(), rotors.end(),
                     [&](const BodyContent& rotor) { return rotor.frame.target == inertia.frame.target; });
}

std::string SceneContent::name_of(const BodyContent& inertia) const {
  return fmt::format("{} '{}'", is_rotor(inertia) ? "reflected inertia" : "body", inertia.name);
}

std::string SceneContent::name_of(const FrameContent& frame) const {
  return fmt::format("{} '{}'", is_rotor(frame) ? "reflected inertia" : "joint", frame.name);
}

bool SceneContent::is_rotor(const FrameContent& frame) const {
  return std::any_of(rotors.begin(), rotors.end(), [&](const BodyContent& rotor) { return rotor.name == frame.name; });
}

}  // namespace torsor
