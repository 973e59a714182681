// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/import/urdf_ground.hpp"

#include <algorithm>
#include <set>
#include <vector>

#include <fmt/format.h>

#include "generator/base/decimal.hpp"
#include "generator/base/did_you_mean.hpp"
#include "generator/base/error.hpp"

namespace torsor {
namespace {

using Take = std::function<std::string(const std::string& name, const std::string& kind)>;

class GroundContacts {
 public:
  GroundContacts(Scene& scene, const UrdfOptions& options, const Take& take) : scene_(scene), take_(take) {
    const auto parameter = [&](const char* name, const Number& value) {
      return scene.run_time_parameter(take(name, "parameter"), "1", Expression(value));
    };
    law_ = {.friction = parameter("ground_friction", options.ground_friction),
            .restitution = parameter("ground_restitution", options.ground_restitution)};
  }

  void add(const std::string& link, const std::string& frame, const UrdfCollision& collision, std::size_t number) {
    const std::string name = number == 0 ? link + "_ground" : fmt::format("{}_ground_{}", link, number);
    const auto at = [&](const Placement& placement, const char* suffix) {
      return scene_.weld(take_(name + suffix, "frame"), frame, placement);
    };
    const Placement& placement = *collision.placement;
    if (const auto* sphere = std::get_if<form::Sphere>(&*collision.form)) {
      touches(name, shape::Sphere{.frame = at(placement, "_centre"), .radius = sphere->radius});
    } else if (const auto* box = std::get_if<form::Box>(&*collision.form)) {
      touches(name, shape::Box{.frame = at(placement, "_centre"),
                               .half_edges = {box->edges[0] / 2, box->edges[1] / 2, box->edges[2] / 2}});
    } else {
      const auto& cylinder = std::get<form::Cylinder>(*collision.form);
      const FrameHandle centre = at(placement, "_centre");
      for (const auto& [suffix, side] : {std::pair("_top", 1), std::pair("_base", -1)}) {
        const FrameHandle rim =
            scene_.weld(take_(name + suffix, "frame"), centre, {.origin = {0, 0, side * cylinder.length / 2}});
        touches(name + suffix, shape::Disc{.frame = rim, .axis = axis::z, .radius = cylinder.radius});
      }
    }
  }

 private:
  void touches(const std::string& name, const ContactShape& shape) {
    scene_.contact(take_(name, "contact"), shape, shape::Plane{.frame = scene_.ground()}, law_);
  }

  Scene& scene_;
  const Take& take_;
  SurfaceLaw law_;
};

}  // namespace

void add_ground(Scene& scene, const UrdfRobot& robot, const UrdfOptions& options,
                const std::map<std::string, std::string>& frames, const Take& take) {
  if (options.ground.empty()) return;
  GroundContacts ground(scene, options, take);
  std::vector<std::string> able;
  for (const UrdfCollision& each : robot.collisions) {
    if (std::find(able.begin(), able.end(), each.link) == able.end()) able.push_back(each.link);
  }
  std::set<std::string> seen;
  for (const std::string& link : options.ground) {
    if (!seen.insert(link).second) throw UsageError(fmt::format("--ground names the link '{}' twice: name it once", link));
    std::vector<const UrdfCollision*> of_link;
    for (const UrdfCollision& each : robot.collisions) {
      if (each.link == link) of_link.push_back(&each);
    }
    if (of_link.empty()) {
      throw UsageError(fmt::format("the link '{}' in --ground {}: {}those with a <collision> are {}", link,
                                   frames.contains(link) ? "has no <collision>" : "is unknown", did_you_mean(link, able),
                                   able.empty() ? "none" : fmt::format("{}", fmt::join(able, ", "))));
    }
    for (std::size_t k = 0; k < of_link.size(); ++k) {
      const UrdfCollision& collision = *of_link[k];
      if (!collision.form || !collision.placement || std::holds_alternative<form::Mesh>(*collision.form)) {
        collision.place.fail(fmt::format("the <collision> of the link '{}' is no sphere, box or cylinder with a size and an "
                                         "origin that can be read, as --ground asks: write one of these in its place",
                                         link));
      }
      ground.add(frames.at(link), frames.at(link), collision, of_link.size() == 1 ? 0 : k + 1);
    }
  }
}

}  // namespace torsor
