// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <variant>

#include "torsor/generator/expression/expression.hpp"
#include "torsor/generator/geometry/triple.hpp"
#include "torsor/generator/mechanics/joint.hpp"
#include "torsor/generator/mechanics/scene_references.hpp"

namespace torsor {

// Arguments of a scene's operations that have many, by name: `scene.force("push", {.body = arm, .point = tip,
// .components = {0, 0, F}, .axes = scene.ground()})`. What they mean stands with the operation in scene.hpp. A member
// without a default must be given.

/// What is given with the name of its own that the author chose.
template <class Given>
struct Named : Given {
  std::string name;
};

// --- joints ---------------------------------------------------------------------------------------------------------
struct HelicalMotion { Triple axis; Expression angle, pitch; };
struct CylindricalMotion { Triple axis; Expression displacement, angle; };
struct UniversalMotion { Triple first; Expression first_angle; Triple second; Expression second_angle; };
struct PlanarMotion { Expression x, y, angle; };
struct LineContactMotion { Expression x, y, yaw, roll; };
struct PlaneRotations { AngleSequence sequence; Triple angles; };
/// How a joint turns about a point: by three plane rotations or by a unit quaternion.
using SphericalMotion = std::variant<PlaneRotations, AttitudeHandle>;
struct SphereInCylinderMotion { Triple axis; Expression displacement; SphericalMotion turn; };
struct PointContactMotion { Expression x, y; SphericalMotion turn; };
/// A joint between two frames that closes a loop; `pitch` is a helical joint's [m/rad].
struct LoopJoint { JointType type; FrameReference a, b; Expression pitch = 0; };

// --- points of contact ----------------------------------------------------------------------------------------------
struct DiscContact { FrameReference frame; Triple axis; Expression radius; FrameReference plane; };
struct TorusContact { FrameReference frame; Triple axis; Expression circle_radius, tube_radius; FrameReference plane; };

// --- actions --------------------------------------------------------------------------------------------------------
struct SpringBetween { PointReference a, b; Expression stiffness, rest = 0; };
struct PointForce { FrameReference body; PointReference point; Triple components; FrameReference axes; };
struct PointWrench { FrameReference body; PointReference point; Triple force, moment; FrameReference axes; };
struct PointDrag {
  FrameReference body;
  PointReference point;
  Expression coefficient;
  FrameReference relative_to = "ground";
};
struct ForceBetween { FrameReference a, b; PointReference point; Triple components; FrameReference axes; };
struct TorqueBetween { FrameReference a, b; Triple components; FrameReference axes; };

// --- contact laws in an assumed regime ------------------------------------------------------------------------------
struct SlidingFriction {
  Expression coefficient;
  FrameReference body;
  PointReference point;
  Triple direction;
  FrameReference axes, other = "ground";
};
struct FrictionLaw {
  std::function<Expression(const Expression& speed)> law;
  FrameReference body;
  PointReference point;
  FrameReference plane, other = "ground";
  Expression smoothing = Expression::quantity("0.000001", "m/s");
};
/// Against rolling or spinning: a moment of `length` times the normal force.
struct RotationResistance {
  Expression length;
  FrameReference body;
  Triple direction;
  FrameReference axes, other = "ground";
};

// --- contacts that open and close -----------------------------------------------------------------------------------
/// What a body touches others with. In a plane mechanism a sphere is a circle, and a plane is a line.
namespace shape {
/// A point of a body, or a point of contact of a round body that was declared for the same plane.
struct Point { PointReference point; };
/// Centred at the origin of the frame.
struct Sphere { FrameReference frame; Expression radius; };
/// The inside of a hollow sphere (in the plane: a drum, or the hole of a joint with clearance) around the frame's origin.
struct HollowSphere { FrameReference frame; Expression radius; };
/// The rim of a thin disc centred at the origin of the frame.
struct Disc { FrameReference frame; Triple axis; Expression radius; };
/// A tube around a circle about `axis`, centred at the origin of the frame; its convex hull touches.
struct Torus { FrameReference frame; Triple axis; Expression circle_radius, tube_radius; };
/// Semi-axes [m] along those of the frame, centred at its origin.
struct Ellipsoid { FrameReference frame; Triple semi_axes; };
/// A smooth convex body by its support function h(u) = max u · CP [m], C the origin of the frame.
struct Convex { FrameReference frame; std::function<Expression(const Triple& u)> support; };
/// The corners at ± `half_edges` [m] along the axes of the frame, each a contact; a half edge 0 leaves its axis out.
struct Box { FrameReference frame; Triple half_edges; };
/// The plane x, y of the frame, of a body that lies below it, z < 0. `belt` is the velocity [m/s] along x and y of a
/// surface that runs over the body.
struct Plane { FrameReference frame; std::array<Expression, 2> belt{}; };
}  // namespace shape
using ContactShape = std::variant<shape::Point, shape::Sphere, shape::HollowSphere, shape::Disc, shape::Torus,
                                  shape::Ellipsoid, shape::Convex, shape::Box, shape::Plane>;
/// What two surfaces do to each other: formulas of parameters. Friction and restitution are plain numbers; without a
/// `static_friction` it is `friction`. Rolling and spinning are lengths h [m]: moments up to h N resist these turns.
struct SurfaceLaw {
  Expression friction = 0;
  std::optional<Expression> static_friction = std::nullopt;
  Expression restitution = 0;
  Expression rolling = 0;
  Expression spinning = 0;
};
struct StopLaw { Expression restitution = 0; };
/// Coulomb's bound of a joint's dry friction [J over the unit of its displacement]; without a `static_bound` it is `bound`.
struct DryFriction {
  Expression bound;
  std::optional<Expression> static_bound = std::nullopt;
};
/// Coulomb's friction of a joint in proportion to what it transmits. Of a revolute joint a `radius` [m] must be given, that of
/// its journal; a prismatic joint has none. Without a `static_friction` it is `friction`.
struct JointFriction {
  Expression friction;
  std::optional<Expression> static_friction = std::nullopt;
  Expression radius = 0;
};

// --- pictures -------------------------------------------------------------------------------------------------------
/// What a picture shows: lengths [m] along the axes of a placed frame.
namespace form {
/// Centred.
struct Box { Triple edges; };
/// Centred, about z.
struct Cylinder { Expression radius, length; };
/// About z, the centre of its base at the origin, its tip at z = length.
struct Cone { Expression radius, length; };
/// Centred.
struct Sphere { Expression radius; };
/// A round bar between two points.
struct Segment { Triple from, to; Expression radius; };
/// A ring about z, centred: a circle of the radius with a tube around it. Pictures keep the ratio of both that the scene
/// states.
struct Torus { Expression radius, tube; };
/// The triangles of a file (`report --meshes`), times the scale.
struct Mesh { std::string file; std::array<double, 3> scale{1, 1, 1}; };
}  // namespace form
using Form = std::variant<form::Box, form::Cylinder, form::Cone, form::Sphere, form::Segment, form::Torus, form::Mesh>;
/// Shares of light, each from 0 to 1.
struct Colour { double red, green, blue; };
struct Shown {
  FrameReference frame;
  Form form;
  Placement placement{};                        ///< in the frame
  std::optional<Colour> colour = std::nullopt;  ///< without one that of the body
};

// --- constraints ----------------------------------------------------------------------------------------------------
struct NoSlip {
  FrameReference body;
  PointReference contact;
  Triple direction;
  FrameReference axes;
  FrameReference on = "ground";  ///< the body it does not slip on
};
struct Rolling { FrameReference body, on; PointReference contact; FrameReference tangents; };
struct PointReaction {
  FrameReference body;
  PointReference contact;
  Triple direction;
  FrameReference axes;
  FrameReference other = "ground";  ///< the body that exerts it, and feels the opposite
};

}  // namespace torsor
