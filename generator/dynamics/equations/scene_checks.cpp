// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/equations/scene_checks.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "torsor/generator/base/as_index.hpp"
#include "torsor/generator/base/error.hpp"
#include "torsor/generator/dynamics/equations/start_error.hpp"
#include "torsor/generator/mechanics/parameter_value.hpp"
#include "torsor/generator/mechanics/triple_algebra.hpp"
#include "torsor/generator/program/evaluation.hpp"

namespace torsor {
namespace {

/// Axes of frame a that a closing joint keeps along the same ones of frame b.
std::vector<std::size_t> axes_kept_along(JointType type) {
  switch (type) {
    case JointType::weld:
    case JointType::prismatic:
      return {0, 1, 2};
    case JointType::revolute:
    case JointType::helical:
    case JointType::cylindrical:
      return {0};
    case JointType::planar:
      return {2};
    case JointType::universal:
    case JointType::spherical:
    case JointType::line_contact:
    case JointType::sphere_in_cylinder:
    case JointType::point_contact:
    case JointType::free:
      return {};
  }
  return {};
}

std::string name_of_frame(const SceneContent& scene, const FrameReference& frame, const std::string& user) {
  return scene.frames[as_index(scene.frame_index(frame, user))].name;
}

}  // namespace

void check_shown_forms(const SceneContent& scene) {
  for (const Shown& shown : scene.shown) {
    const std::string frame = name_of_frame(scene, shown.frame, "what is shown");
    std::vector<std::pair<const char*, const Expression*>> lengths;
    if (const auto* box = std::get_if<form::Box>(&shown.form)) {
      for (const Expression& edge : box->edges) lengths.emplace_back("edge of the box", &edge);
    } else if (const auto* cylinder = std::get_if<form::Cylinder>(&shown.form)) {
      lengths = {{"radius of the cylinder", &cylinder->radius}, {"length of the cylinder", &cylinder->length}};
    } else if (const auto* cone = std::get_if<form::Cone>(&shown.form)) {
      lengths = {{"radius of the cone", &cone->radius}, {"length of the cone", &cone->length}};
    } else if (const auto* sphere = std::get_if<form::Sphere>(&shown.form)) {
      lengths = {{"radius of the sphere", &sphere->radius}};
    } else if (const auto* segment = std::get_if<form::Segment>(&shown.form)) {
      lengths = {{"radius of the segment", &segment->radius}};
    } else if (const auto* torus = std::get_if<form::Torus>(&shown.form)) {
      lengths = {{"radius of the torus", &torus->radius}, {"radius of the torus's tube", &torus->tube}};
    }
    for (const auto& [what, length] : lengths) {
      const std::optional<Real> value = known_value(scene, *length);
      if (!value || *value > Real(0)) continue;
      throw SceneError(fmt::format("the {} that is shown on frame '{}' is {} = {:.6g} m and must be above 0", what, frame,
                                   length->to_string(), value->to_double()));
    }
  }
}

void check_slipping_bodies(const Model& model) {
  const SceneContent& scene = model.scene();
  for (const ConstraintContent& constraint : scene.constraints) {
    const auto* law = std::get_if<NoSlip>(&constraint.law);
    if (law == nullptr) continue;
    const std::string user = "constraint '" + constraint.name + "'";
    if (model.place(law->body, user).link != model.place(law->on, user).link) continue;
    throw SceneError(
        fmt::format("constraint '{}': frame '{}' cannot slip on frame '{}', for both are of one body; name "
                    "the other body in contact",
                    constraint.name, name_of_frame(scene, law->body, user), name_of_frame(scene, law->on, user)));
  }
}

void check_closing_joints(const Equations& equations) {
  const Model& model = equations.model();
  const SceneContent& scene = model.scene();
  Program& program = equations.program();
  static const std::array<const Triple*, 3> axes{&axis::x, &axis::y, &axis::z};
  for (const JointContent& joint : scene.joints) {
    if (joint.of_tree) continue;
    const std::string user = "joint '" + joint.name + "'";
    for (const std::size_t i : axes_kept_along(joint.type)) {
      const Vector of_a = bound(program, model.express(*axes[i], joint.a, 0, user));
      const Vector of_b = bound(program, model.express(*axes[i], joint.b, 0, user));
      const Value cosine = program.bind(dot(of_a, of_b));
      Evaluator<Real> start(program, [&scene](const SymbolPointer& symbol) { return initial_value(scene, symbol); });
      const double value = start(cosine).to_double();
      if (value > 0.5) continue;  // 1 when assembled as it is meant to be
      throw StartError(fmt::format(
          "joint '{}' is assembled the wrong way round: at the start axis {} of frame '{}' and "
          "that of frame '{}' have a cosine of {:.6g} and must have 1; {} of "
          "the coordinates it ties, or correct the placement of one frame",
          joint.name, "xyz"[i], name_of_frame(scene, joint.a, user), name_of_frame(scene, joint.b, user), value,
          another_start(scene)));
    }
  }
}

}  // namespace torsor
