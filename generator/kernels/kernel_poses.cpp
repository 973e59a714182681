// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/kernels/kernel_poses.hpp"

#include <array>

#include "torsor/generator/dynamics/forces/contacts.hpp"
#include "torsor/generator/dynamics/motion/ground_motion.hpp"
#include "torsor/generator/kernels/kernel_parts.hpp"

namespace torsor {
namespace {

class PosesBuilder {
 public:
  explicit PosesBuilder(const Equations& equations)
      : model_(equations.model()), scene_(model_.scene()), program_(model_.program()), motion_(model_) {}

  Kernel build() {
    frames();
    points();
    bodies();
    forms();
    reactions();
    contacts();
    result_.member("gravity", 3, {"acceleration of gravity", "m/s^2"});
    result_.vector("gravity", 0, lower(program_, scene_.gravity));
    return result_.take(
        "What a picture of the mechanism needs, in ground axes: one column for each frame, point and body of the scene, "
        "in\nthe order of their declaration, the ground first.");
  }

 private:
  void frames() {
    const std::size_t count = scene_.frames.size();
    result_.member("origins", 3, count, {"origins of the frames", "m"});
    result_.member("rotations", 9, count, "from the axes of each frame to the ground's, column by column");
    result_.member("anchors", 3, count, {"places of the joints in the frames' parents", "m"});
    result_.member("axes", 3, count, "axes of turning and sliding joints; 0 elsewhere");
    for (std::size_t k = 0; k < count; ++k) {
      const FrameContent& frame = scene_.frames[k];
      const FramePlace& at = model_.place(FrameHandle{static_cast<int>(k)}, "frame '" + frame.name + "'");
      const Vector origin = place(at.link, at.origin);
      result_.vector("origins", k, origin);
      const Matrix turn = bound(program_, motion_.rotation(at.link) * constant_matrix(program_, at.rotation));
      result_.matrix("rotations", k, turn);
      result_.vector("anchors", k, frame.parent ? anchor(frame) : origin);
      const bool has_axis = frame.joint == JointKind::revolute || frame.joint == JointKind::prismatic;
      const Link& link = model_.links()[static_cast<std::size_t>(at.link)];
      result_.vector("axes", k, has_axis ? bound(program_, motion_.rotation(at.link) * link.axis) : Vector());
    }
  }

  void points() {
    const std::size_t count = scene_.points.size();
    if (count == 0) return;
    result_.member("points", 3, count, {"named points", "m"});
    result_.member("rims", 3, count, "axes of the discs whose lowest point is meant; 0 for other points");
    result_.member("radii", 1, count, {"radii of the discs and spheres whose lowest point is meant; 0 for other points", "m"});
    for (std::size_t k = 0; k < count; ++k) {
      const PointContent& point = scene_.points[k];
      const std::string user = name_of(point);
      const FramePlace& at = model_.place(point.frame, user);
      result_.vector("points", k, place(at.link, model_.locate(PointHandle{static_cast<int>(k)}, at.link, user)));
      const bool rim = point.lowest && point.lowest->axis;
      result_.vector("rims", k, rim ? turned(at, lower(program_, *point.lowest->axis)) : Vector());
      const bool round = point.lowest && !point.lowest->support;
      result_.assign("radii", k, round ? program_.lower(point.lowest->radius) : Value());
    }
  }

  void bodies() {
    const std::size_t count = scene_.bodies.size();
    if (count == 0) return;
    result_.member("centres", 3, count, {"centres of mass", "m"});
    result_.member("masses", 1, count, {"masses", "kg"});
    result_.member("inertias", 6, count, {"xx, yy, zz, xy, xz, yz about the centre of mass along the axes of its frame", "kg m^2"});
    for (std::size_t k = 0; k < count; ++k) {
      const BodyContent& body = scene_.bodies[k];
      const FramePlace& at = model_.place(body.frame, "body '" + body.name + "'");
      const Inertia& inertia = body.inertia;
      result_.vector("centres", k, place(at.link, bound(program_, at.origin + at.rotation * lower(program_, inertia.center))));
      result_.assign("masses", k, program_.lower(inertia.mass));
      std::size_t entry = 6 * k;
      for (const Expression& moment :
           {inertia.xx, inertia.yy, inertia.zz, inertia.xy, inertia.xz, inertia.yz}) {
        result_.assign("inertias", entry++, program_.lower(moment));
      }
    }
  }

  /// What is shown stays where it is in its frame: its lengths are all that a picture cannot know by itself.
  void forms() {
    const std::size_t count = scene_.shown.size();
    if (count == 0) return;
    result_.member("form_origins", 3, count, {"origins of the forms that are shown, in their frames", "m"});
    result_.member("form_lengths", 4, count, {"edges; radius, length; radius; a segment's vector, radius; a ring's radius, its tube's", "m"});
    for (std::size_t k = 0; k < count; ++k) {
      const auto [origin, lengths] = std::visit([](const auto& form) { return measures(form); }, scene_.shown[k].form);
      const Placement& placement = scene_.shown[k].placement;
      const Matrix turn = constant_matrix(program_, placement.rotation);
      result_.vector("form_origins", k, lower(program_, placement.origin) + bound(program_, turn * lower(program_, origin)));
      for (std::size_t i = 0; i < 4; ++i) result_.assign("form_lengths", 4 * k + i, program_.lower(lengths[i]));
    }
  }

  using Measures = std::pair<Triple, std::array<Expression, 4>>;
  static Measures measures(const form::Box& box) { return {none(), {box.edges[0], box.edges[1], box.edges[2], 0}}; }
  static Measures measures(const form::Cylinder& cylinder) { return {none(), {cylinder.radius, cylinder.length, 0, 0}}; }
  static Measures measures(const form::Cone& cone) { return {none(), {cone.radius, cone.length, 0, 0}}; }
  static Measures measures(const form::Sphere& sphere) { return {none(), {sphere.radius, 0, 0, 0}}; }
  static Measures measures(const form::Segment& segment) {
    const Triple &a = segment.from, &b = segment.to;
    return {a, {b[0] - a[0], b[1] - a[1], b[2] - a[2], segment.radius}};
  }
  static Measures measures(const form::Torus& torus) { return {none(), {torus.radius, torus.tube, 0, 0}}; }
  static Measures measures(const form::Mesh&) { return {none(), {0, 0, 0, 0}}; }
  static Triple none() { return {Expression(0), Expression(0), Expression(0)}; }

  /// Forces of constraints: where they act, and what they are for a unit multiplier. Couples, and constraints that say of no
  /// force where it acts, have none.
  void reactions() {
    const std::size_t count = scene_.constraints.size();
    if (count == 0) return;
    result_.member("reaction_points", 3, count, {"points where forces of constraints act on the bodies that they are named on", "m"});
    result_.member("reaction_forces", 3, count, "these forces for a unit multiplier; 0 for a couple and where none is said");
    for (std::size_t k = 0; k < count; ++k) {
      const ConstraintContent& constraint = scene_.constraints[k];
      const std::string user = "constraint '" + constraint.name + "'";
      Vector at, force;
      const auto act = [&](const PointReference& point, const Triple& direction, const FrameReference& axes) {
        const int link = model_.place(scene_.points[static_cast<std::size_t>(scene_.point_index(point, user))].frame, user).link;
        at = place(link, model_.locate(point, link, user));
        force = turned(model_.place(axes, user), lower(program_, direction));
      };
      if (constraint.reaction) {
        act(constraint.reaction->contact, constraint.reaction->direction, constraint.reaction->axes);
      } else if (const auto* no_slip = std::get_if<NoSlip>(&constraint.law)) {
        act(no_slip->contact, no_slip->direction, no_slip->axes);
      } else if (const auto* in_plane = std::get_if<PointInPlane>(&constraint.law)) {
        act(in_plane->point, axis::z, in_plane->plane);
      } else if (const auto* closure = std::get_if<Closure>(&constraint.law)) {
        act(closure->b, closure->direction, "ground");
      } else if (const auto* joint = std::get_if<JointClosure>(&constraint.law); joint && joint->kind == JointClosure::Kind::offset) {
        static const std::array<const Triple*, 3> axes{&axis::x, &axis::y, &axis::z};
        const FramePlace& end = model_.place(joint->b, user);
        at = place(end.link, end.origin);
        force = turned(model_.place(joint->a, user), lower(program_, *axes.at(static_cast<std::size_t>(joint->i))));
        if (joint->sign < 0) force = -force;
      }
      result_.vector("reaction_points", k, at);
      result_.vector("reaction_forces", k, force);
    }
  }

  /// Where contacts that open and close act, and along what.
  void contacts() {
    const std::size_t count = scene_.contacts.size();
    if (count == 0) return;
    const std::vector<ContactPlace> places = contact_places(model_);
    std::size_t rows = 0;
    for (const ContactPlace& each : places) rows += each.directions.size();
    result_.member("contact_points", 3, count, "points of contact [m]; 0 of what acts along a coordinate");
    result_.member("contact_directions", 3, rows,
                   "forces on the first bodies for unit reactions, N before T; 0 of what acts along a coordinate and of moments");
    result_.member("contact_radii", 2, count, {"radii of the two spheres of a contact; 0 elsewhere", "m"});
    std::size_t row = 0;
    for (std::size_t k = 0; k < count; ++k) {
      result_.vector("contact_points", k, places[k].point);
      for (const Vector& direction : places[k].directions) result_.vector("contact_directions", row++, direction);
      const auto* spheres = std::get_if<SphereOnSphere>(&scene_.contacts[k].geometry);
      result_.assign("contact_radii", 2 * k, spheres != nullptr ? program_.lower(spheres->radius_a) : Value());
      result_.assign("contact_radii", 2 * k + 1, spheres != nullptr ? program_.lower(spheres->radius_b) : Value());
    }
  }

  Vector anchor(const FrameContent& frame) {
    const FramePlace& parent = model_.place(*frame.parent, "frame '" + frame.name + "'");
    return place(parent.link,
                 bound(program_, parent.origin + parent.rotation * lower(program_, frame.placement.origin)));
  }

  /// A point at `arm` from the link's origin, in the link's axes.
  Vector place(int link, const Vector& arm) {
    const Vector along = bound(program_, motion_.rotation(link) * arm);
    return bound(program_, motion_.origin(link) + along);
  }
  Vector turned(const FramePlace& at, const Vector& v) {
    const Vector in_link = bound(program_, at.rotation * v);
    return bound(program_, motion_.rotation(at.link) * in_link);
  }

  const Model& model_;
  const SceneContent& scene_;
  Program& program_;
  GroundMotion motion_;
  StructureBuilder result_{"Poses", "Places and axes in ground axes."};
};

}  // namespace

Kernel make_poses(const Equations& equations) { return PosesBuilder(equations).build(); }

}  // namespace torsor
