// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "torsor/generator/base/did_you_mean.hpp"
#include "torsor/generator/base/error.hpp"
#include "torsor/generator/import/command_words.hpp"
#include "torsor/generator/import/mjcf_builder.hpp"

namespace torsor {

/// Throws where --friction names a joint that does not turn or slide, or a negative number.
void MjcfBuilder::check_frictions() const {
  std::vector<std::string> known;
  for (const MjcfJoint& joint : model_.joints) {
    if (joint.is_scalar()) known.push_back(joint.name);
  }
  check_joint_numbers("--friction", options_.friction, known);
}

std::optional<Number> MjcfBuilder::friction_of(const MjcfJoint& joint) const {
  for (const auto& [name, value] : options_.friction) {
    if (name == joint.name) return value.is_zero() ? std::nullopt : std::optional(value);
  }
  if (!options_.friction_of_file || joint.friction_loss == 0) return std::nullopt;
  return from_double(joint.friction_loss);
}

void MjcfBuilder::add_dry_friction(std::size_t i) {
  const MjcfJoint& joint = model_.joints[i];
  const std::string stated = fmt::format("{} ({})", joint.name, shortest(joint.friction_loss));
  if (!joint.is_scalar()) {
    if (joint.friction_loss != 0) note("frictionloss of ball and free joints does not act", stated);
    return;
  }
  const std::optional<Number> bound = friction_of(joint);
  if (bound) {
    const std::string& name = joints_[i].name;
    const bool turns = joint.type == MjcfJointType::hinge;
    scene_.dry_friction(name + "_dry_friction", position(i), {parameter(name + "_friction", turns ? "N m" : "N", *bound)});
  } else if (joint.friction_loss != 0) {
    note("frictionloss of joints acts with --friction file only", stated);
  }
}

std::vector<std::size_t> MjcfBuilder::touching_geoms(const std::string& body) const {
  std::vector<std::string> able;
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < model_.geoms.size(); ++k) {
    const MjcfGeom& geom = model_.geoms[k];
    if (!moves(geom.body)) continue;
    const std::string& owner = model_.bodies[static_cast<std::size_t>(geom.body)].name;
    if (owner == body) found.push_back(k);
    if (std::find(able.begin(), able.end(), owner) == able.end()) able.push_back(owner);
  }
  if (found.empty()) {
    const bool known = std::any_of(model_.bodies.begin(), model_.bodies.end(),
                                   [&body](const MjcfBody& each) { return each.name == body; });
    throw UsageError(fmt::format("the body '{}' in --ground {}: {}those that move and have such a geom are {}", body,
                                 known ? "does not move, or has no geom that takes part in contacts" : "is unknown",
                                 did_you_mean(body, able), able.empty() ? "none" : fmt::format("{}", fmt::join(able, ", "))));
  }
  return found;
}

/// Geoms of bodies that --ground names, against every plane that stands still.
void MjcfBuilder::add_ground() {
  if (options_.ground.named.empty()) return;
  std::set<std::string> seen;
  for (const std::string& body : options_.ground.named) {
    if (!seen.insert(body).second) throw UsageError(fmt::format("--ground names the body '{}' twice: name it once", body));
  }
  const SurfaceContacts contacts(scene_, identifiers_, "ground", options_.ground);
  std::vector<FrameReference> planes;
  for (std::size_t k = 0; k < model_.geoms.size(); ++k) {
    const MjcfGeom& geom = model_.geoms[k];
    if (geom.type != "plane" || moves(geom.body)) continue;
    const std::string name = geom.name.empty() ? "plane" : geom.name;
    planes.emplace_back(contacts.at(name, frames_[static_cast<std::size_t>(geom.body)],
                                    {lengths(geom.position), rotation(geom.quaternion, "geom " + name)}));
    touching_.insert(k);
  }
  if (planes.empty()) planes.emplace_back(scene_.ground());
  for (const std::string& body : options_.ground.named) {
    const std::vector<std::size_t> geoms = touching_geoms(body);
    for (std::size_t g = 0; g < geoms.size(); ++g) {
      const MjcfGeom& geom = model_.geoms[geoms[g]];
      const std::string word = frames_[static_cast<std::size_t>(geom.body)] + "_ground";
      for (std::size_t p = 0; p < planes.size(); ++p) {
        const std::string one = geoms.size() == 1 ? word : fmt::format("{}_{}", word, g + 1);
        touch_plane(contacts, planes.size() == 1 ? one : fmt::format("{}_{}", one, p + 1), geom, planes[p]);
      }
      touching_.insert(geoms[g]);
    }
  }
}

/// MuJoCo states half lengths and semi-axes.
void MjcfBuilder::touch_plane(const SurfaceContacts& contacts, const std::string& name, const MjcfGeom& geom,
                              const FrameReference& plane) {
  const std::string stated = geom.name.empty() ? "a geom" : "the geom '" + geom.name + "'";
  const std::string& body = model_.bodies[static_cast<std::size_t>(geom.body)].name;
  const bool round = geom.type == "cylinder" || geom.type == "capsule";
  if (!round && geom.type != "sphere" && geom.type != "box" && geom.type != "ellipsoid") {
    throw UsageError(fmt::format("{} of the body '{}' in --ground is of the type {}: a sphere, box, cylinder, capsule or "
                                 "ellipsoid touches a plane; write one of these in its place",
                                 stated, body, geom.type));
  }
  const FrameHandle centre = contacts.at(name + "_centre", frames_[static_cast<std::size_t>(geom.body)],
                                         {lengths(geom.position), rotation(geom.quaternion, stated + " of the body " + body)});
  const Triple size = lengths(geom.size);
  if (round) {
    const form::Cylinder solid{size[0], 2 * size[1]};
    if (geom.type == "cylinder") return contacts.cylinder_on_plane(name, centre, solid, plane);
    return contacts.capsule_on_plane(name, centre, solid, plane);
  }
  const shape::Plane touched{.frame = plane};
  if (geom.type == "sphere") return contacts.touch(name, shape::Sphere{.frame = centre, .radius = size[0]}, touched);
  if (geom.type == "box") return contacts.touch(name, shape::Box{.frame = centre, .half_edges = size}, touched);
  contacts.touch(name, shape::Ellipsoid{.frame = centre, .semi_axes = size}, touched);
}

}  // namespace torsor
