// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <variant>

#include "generator/expression/expression.hpp"
#include "generator/geometry/triple.hpp"
#include "generator/mechanics/joint.hpp"
#include "generator/mechanics/scene_references.hpp"

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
