// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/motion/body_set.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "torsor/generator/base/did_you_mean.hpp"
#include "torsor/generator/base/error.hpp"

namespace torsor {

BodyNames all_bodies(const Model& model) {
  BodyNames names;
  for (const BodyContent& body : model.scene().bodies) names.push_back(body.name);
  return names;
}

std::vector<bool> rotor_links(const Model& model) {
  std::vector<bool> is_rotor(model.links().size(), false);
  for (const BodyContent& rotor : model.scene().rotors) {
    is_rotor[static_cast<std::size_t>(model.place(rotor.frame, "reflected inertia '" + rotor.name + "'").link)] = true;
  }
  return is_rotor;
}

BodyNames moving_bodies(const Model& model) {
  BodyNames names;
  for (const BodyContent& body : model.scene().bodies) {
    if (model.place(body.frame, "body '" + body.name + "'").link != 0) names.push_back(body.name);
  }
  if (names.empty()) throw SceneError("no body of the scene moves: there is nothing to isolate; give a frame that moves a body");
  return names;
}

std::vector<int> body_indices(const Model& model, const BodyNames& names, const std::string& user) {
  const BodyNames known = all_bodies(model);
  if (names.empty()) {
    throw SceneError(fmt::format("{} is asked for no body: name at least one of {}", user, fmt::join(known, ", ")));
  }
  std::vector<int> indices;
  for (const std::string& name : names) {
    const auto place = std::find(known.begin(), known.end(), name);
    if (place == known.end()) {
      throw SceneError(fmt::format("unknown body '{}' in {}: {}the scene has {}", name, user,
                                   did_you_mean(name, known), fmt::join(known, ", ")));
    }
    indices.push_back(static_cast<int>(place - known.begin()));
  }
  std::sort(indices.begin(), indices.end());
  const auto twice = std::adjacent_find(indices.begin(), indices.end());
  if (twice != indices.end()) {
    throw SceneError(fmt::format("{} names the body '{}' twice", user, known[static_cast<std::size_t>(*twice)]));
  }
  return indices;
}

std::vector<std::pair<int, MassProperties>> mass_by_link(const Model& model, const BodyNames& names,
                                                         const std::string& user) {
  Program& program = model.program();
  std::map<int, MassProperties> by_link;
  for (const int index : body_indices(model, names, user)) {
    const BodyContent& body = model.scene().bodies[static_cast<std::size_t>(index)];
    const FramePlace& at = model.place(body.frame, "body '" + body.name + "'");
    const Inertia& given = body.inertia;
    MassProperties central;
    central.mass = program.lower(given.mass);
    const Expression* const entries[3][3] = {
        {&given.xx, &given.xy, &given.xz}, {&given.xy, &given.yy, &given.yz}, {&given.xz, &given.yz, &given.zz}};
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) central.inertia(i, j) = program.lower(*entries[i][j]);
    }
    const Vector center = lower(program, given.center);
    add_placed(program, by_link[at.link], central,
               {.rotation = at.rotation, .origin = at.origin + at.rotation * center});
  }
  return {by_link.begin(), by_link.end()};
}

}  // namespace torsor
