// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <variant>

#include <nlohmann/json.hpp>

#include "torsor/generator/base/printable.hpp"
#include "torsor/generator/cli/report.hpp"
#include "torsor/generator/mechanics/structure_graph.hpp"

namespace torsor {
namespace {

using Json = nlohmann::ordered_json;

const char* word_of(JointKind kind) {
  switch (kind) {
    case JointKind::weld:
      return "weld";
    case JointKind::revolute:
      return "revolute";
    case JointKind::prismatic:
      return "prismatic";
    case JointKind::attitude:
      return "attitude";
  }
  return "";
}

Json frames_json(const Scene& scene) {
  const SceneContent& content = scene.content();
  const StructureGraph graph = structure_graph(scene);
  Json list = Json::array();
  for (std::size_t k = 0; k < content.frames.size(); ++k) {
    const FrameContent& frame = content.frames[k];
    const int parent = frame.parent ? content.frame_index(*frame.parent, "frame '" + frame.name + "'") : -1;
    list.push_back({{"name", printable(frame.name)},
                    {"parent", parent},
                    {"joint", content.is_rotor(frame) ? "weld" : word_of(frame.joint)},
                    {"body", graph.body_of_frame[k]}});
  }
  return list;
}

/// Lines between two points: springs, dampers, attractions.
Json links_json(const SceneContent& content) {
  Json list = Json::array();
  const auto add = [&](const char* kind, const auto& action) {
    const std::string user = "action '" + action.name + "'";
    list.push_back({{"kind", kind},
                    {"name", printable(action.name)},
                    {"a", content.point_index(action.a, user)},
                    {"b", content.point_index(action.b, user)}});
  };
  for (const ActionContent& action : content.actions) {
    if (const auto* spring = std::get_if<PointSpring>(&action)) add("spring", *spring);
    if (const auto* damper = std::get_if<PointDamper>(&action)) add("damper", *damper);
    if (const auto* gravitation = std::get_if<Gravitation>(&action)) add("attraction", *gravitation);
  }
  return list;
}

/// What contacts are between. Their points, forces and radii come from the kernel `poses`.
Json contacts_json(const SceneContent& content) {
  Json list = Json::array();
  for (const ContactContent& contact : content.contacts) {
    const std::string user = "contact '" + contact.name + "'";
    Json each{{"name", printable(contact.name)}};
    if (const auto* on = std::get_if<PointOnPlane>(&contact.geometry)) {
      each["plane"] = content.frame_index(on->plane, user);
    } else if (const auto* spheres = std::get_if<SphereOnSphere>(&contact.geometry)) {
      each["spheres"] = {content.frame_index(spheres->a, user), content.frame_index(spheres->b, user)};
      each["hollow"] = spheres->hollow;
    }
    list.push_back(std::move(each));
  }
  return list;
}

/// Boxes of which corners touch something.
Json boxes_json(const SceneContent& content) {
  Json list = Json::array();
  for (const std::vector<PointHandle>& corners : content.boxes) {
    Json points = Json::array();
    for (const PointHandle& corner : corners) points.push_back(corner.index);
    list.push_back(std::move(points));
  }
  return list;
}

const char* word_of(const Form& form) {
  static constexpr std::array<const char*, 7> words{"box", "cylinder", "cone", "sphere", "segment", "torus", "mesh"};
  return words[form.index()];
}

/// What the author of the scene shows; the kernel `poses` has the lengths.
Json forms_json(const SceneContent& content) {
  Json list = Json::array();
  for (const Shown& shown : content.shown) {
    Json each{{"kind", word_of(shown.form)}, {"frame", content.frame_index(shown.frame, "what is shown")}};
    if (shown.colour) each["colour"] = {shown.colour->red, shown.colour->green, shown.colour->blue};
    Json axes = Json::array();
    for (int j = 0; j < 3; ++j) {
      for (int i = 0; i < 3; ++i) axes.push_back(shown.placement.rotation(i, j).to_double());
    }
    each["rotation"] = std::move(axes);
    list.push_back(std::move(each));
  }
  return list;
}

}  // namespace

std::string report_data(const Scene& scene, double duration) {
  const SceneContent& content = scene.content();
  Json json{{"name", printable(content.name)},
            {"title", printable(content.title)},
            {"duration", duration},
            {"frames", frames_json(scene)},
            {"points", Json::array()},
            {"bodies", Json::array()},
            {"links", links_json(content)},
            {"forms", forms_json(content)},
            {"contacts", contacts_json(content)},
            {"boxes", boxes_json(content)},
            {"surfaces", report_surfaces(content)}};
  for (const PointContent& point : content.points) {
    Json each{{"name", printable(point.name)},
              {"frame", content.frame_index(point.frame, "point '" + point.name + "'")}};
    if (point.lowest) {
      each["lowest"] = true;
      each["plane"] = content.frame_index(point.lowest->plane, "point '" + point.name + "'");
    }
    json["points"].push_back(std::move(each));
  }
  for (const BodyContent& body : content.bodies) {
    json["bodies"].push_back({{"name", printable(body.name)},
                              {"frame", content.frame_index(body.frame, "body '" + body.name + "'")}});
  }
  return json.dump();
}

}  // namespace torsor
