// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "torsor/generator/expression/expression.hpp"
#include "torsor/generator/expression/symbol.hpp"
#include "torsor/generator/geometry/rotation.hpp"
#include "torsor/generator/geometry/triple.hpp"
#include "torsor/generator/mechanics/inertia.hpp"
#include "torsor/generator/mechanics/joint.hpp"
#include "torsor/generator/mechanics/scene_arguments.hpp"
#include "torsor/generator/mechanics/scene_references.hpp"

namespace torsor {

// What a Scene holds, for those who derive from it. Users meet handles, references and arguments only.

/// How one frame of the tree moves in its parent. `attitude` is a rotation by a unit quaternion.
enum class JointKind { weld, revolute, prismatic, attitude };

struct FrameContent {
  std::string name;
  std::optional<FrameReference> parent;  ///< none for the ground
  Placement placement;
  JointKind joint = JointKind::weld;
  Triple axis{};
  Expression displacement;  ///< angle [rad] or distance [m] as a formula of coordinates and time
  std::optional<int> attitude = std::nullopt;  ///< index of the scene's attitude that turns the frame
};

/// Frames of a scene's tree by their indices, both included.
struct FrameRange { int first, last; };

/// A joint as its author named it: of the tree, or held by constraints where it closes a loop.
struct JointContent {
  std::string name;
  JointType type = JointType::free;
  FrameReference a, b;                ///< the frames it joins: parent and child in the tree
  Placement placement;                ///< of the joint's axes in a; the tree's only
  std::optional<FrameRange> of_tree;  ///< the frames that realise it; none: it closes a loop
  Expression pitch;                   ///< of a helical joint [m/rad]
};

/// h(u) = max u · CP over the points P of a convex body, C the origin of a frame, as a formula of the components of u
/// along that frame's axes; CP = ∇h(u) is the point where u is normal to the body.
struct SupportFunction { std::array<SymbolPointer, 3> direction; Expression h; };

/// The point of a disc's rim, of a sphere (no axis), of a torus (a rim with a tube around it) or of a convex body that
/// lies lowest along the normal z of a plane.
struct LowestPoint {
  std::optional<Triple> axis;
  Expression radius;
  FrameReference plane;
  Expression tube{};  ///< radius of the tube
  std::optional<SupportFunction> support = std::nullopt;
};

/// A point by its components in a frame, or (`lowest`) a point of contact around the frame's origin.
struct PointContent {
  std::string name;
  FrameReference frame;
  Triple components;
  std::optional<LowestPoint> lowest = std::nullopt;
  std::string contact = {};  ///< that made it; empty: its author did
  std::vector<StatedSize> sizes{};  ///< of an ellipsoid or a box, of which a support function or corners are kept
};

/// Whether the moments of inertia of a body must be such as matter can have.
enum class Moments {
  of_matter,  ///< none is larger than the sum of the others
  as_given,   ///< also what was identified or guessed; never negative
  as_read,    ///< whatever a file states, negative ones included: only sums along the axes of joints may matter
};
struct BodyContent { std::string name; FrameReference frame; Inertia inertia; Moments moments = Moments::of_matter; };

struct ParameterContent {
  SymbolPointer symbol;
  std::optional<Expression> value;
  bool run_time = false;
};

/// An orientation by a unit quaternion.
struct AttitudeContent {
  std::string name;
  std::shared_ptr<const AttitudeSymbols> symbols;
  std::string frame;  ///< the frame it turns
  std::optional<std::array<Expression, 4>> initial;  ///< normalised when it is used
};

/// Component k of the unit quaternion at t = 0.
Expression initial_component(const AttitudeContent& attitude, std::size_t k);

/// What a coordinate, its rate and the effort along it must not exceed, in SI: data for controllers and simulators.
struct CoordinateLimits { std::optional<Number> lower, upper, velocity, effort; };

/// A freedom of the mechanism: a coordinate q, or one of the three of an attitude, whose q is only a name.
struct CoordinateContent {
  SymbolPointer q, v, a;
  std::optional<int> attitude;              ///< of quasi-velocities: index of the attitude
  std::optional<Expression> law;            ///< imposed by time
  bool released = false;                    ///< held at zero, its reaction can be asked for
  std::optional<Expression> initial_value;  ///< at t = 0
  std::optional<Expression> initial_rate;
  std::optional<CoordinateLimits> limits;
  bool unknown() const { return !law && !released; }
};

/// Those of a freedom that a formula may name: q, v and a, but of an attitude's only v and a.
std::vector<SymbolPointer> symbols_of(const CoordinateContent& freedom);

struct ElongationSpring { std::string name; Expression elongation, stiffness, rest; };
struct ElongationDamper { std::string name; Expression elongation, damping; };
using PointSpring = Named<SpringBetween>;
struct PointDamper { std::string name; PointReference a, b; Expression damping; };
struct Motor { std::string name; SymbolPointer input; Expression displacement; };
using GivenForce = Named<PointForce>;
struct GivenTorque { std::string name; FrameReference body; Triple components; FrameReference axes; };
struct GivenForceFunction { std::string name; Expression force_function; };
struct GeneralisedForce {
  std::string name;
  Expression displacement, force;
};
struct Gravitation { std::string name; PointReference a, b; Expression strength; };
using GivenWrench = Named<PointWrench>;
using Drag = Named<PointDrag>;
struct RotationalDrag { std::string name; FrameReference body; Expression coefficient; FrameReference relative_to; };
/// Force at a point (none: a torque) of b on a, with the opposite of a on b.
struct MutualAction {
  std::string name;
  FrameReference a, b;
  std::optional<PointReference> point;
  Triple components;
  FrameReference axes;
};
using ActionContent =
    std::variant<ElongationSpring, ElongationDamper, PointSpring, PointDamper, Motor, GivenForce, GivenTorque,
                 GivenForceFunction, GeneralisedForce, Gravitation, GivenWrench, Drag, RotationalDrag, MutualAction>;

/// Coulomb's laws in an assumed regime, tied to the multiplier N of a normal constraint: the force −f N d at the point,
/// or without a point the moment −h N d, on `body`, and the opposite on `other`; d = direction/|direction|.
struct ContactFriction {
  std::string name;
  int constraint = 0;
  Expression coefficient;
  FrameReference body;
  std::optional<PointReference> point;
  Triple direction;
  FrameReference axes, other;
  Expression length{};  ///< in place of |direction|, where it is not zero
};

const std::string& name_of(const ActionContent& action);
/// What its author wrote, for messages: "point 'P'", "contact 'floor'".
std::string name_of(const PointContent& point);

struct HolonomicFormula { Expression f; };
struct NonholonomicFormula {
  Expression left_side;
};
struct Closure { PointReference a, b; Triple direction; };
/// The point stays in the plane x, y of a frame.
struct PointInPlane { PointReference point; FrameReference plane; };
/// One locked direction of a joint that closes a loop between frames a and b with origins A and B.
struct JointClosure {
  enum class Kind {
    offset,     ///< AB · a_i = 0
    alignment,  ///< a_i · b_j = 0
    screw,      ///< p sin(AB · a_x / p − θ) = 0, θ the turn of b about a_x
  };
  Kind kind = Kind::offset;
  FrameReference a, b;
  int i = 0, j = 0;
  int sign = 1;  ///< of the whole condition
  Expression pitch;
};

using ConstraintLaw = std::variant<HolonomicFormula, NonholonomicFormula, NoSlip, Closure, PointInPlane, JointClosure>;

// --- contacts that open and close: where the gap is, and along what there is friction ---
/// A point over the plane x, y of a frame.
struct PointOnPlane { PointReference point; FrameReference plane; std::array<Expression, 2> belt; };
/// Spheres around the origins of two frames; the first may lie inside the second, which is hollow then.
struct SphereOnSphere { FrameReference a, b; Expression radius_a, radius_b; bool hollow = false; };
/// The gap is sign · (displacement − at).
struct Stop { Expression displacement, at; int sign = 1; };
/// Dry friction that works with a displacement and is always there.
struct FrictionAlong { Expression displacement, bound, static_bound; };
/// Dry friction in the joint that carries a frame, of the coefficients times its reaction across the axis; times the radius
/// too where the joint turns.
struct FrictionInJoint { FrameReference frame; Expression radius; };
/// What resists a turn of the bodies of a contact, in proportion to its normal force: to rolling about its tangents, or
/// to spinning about its normal. `contact` is its place among the scene's.
struct TurnOnContact { std::size_t contact = 0; bool spinning = false; };
using ContactGeometry = std::variant<PointOnPlane, SphereOnSphere, Stop, FrictionAlong, FrictionInJoint, TurnOnContact>;
struct ContactContent {
  std::string name;
  ContactGeometry geometry;
  Expression friction{}, static_friction{}, restitution{};  ///< formulas of parameters; of turns lengths [m]
};

using ReactionContent = Named<PointReaction>;
struct ConstraintContent {
  std::string name;
  ConstraintLaw law;
  SymbolPointer multiplier;
  std::optional<ReactionContent> reaction;
};

/// Where a scene came from that was read from a file; all empty for one that is written in C++.
struct SceneOrigin {
  std::string file;                ///< its name, without any folder
  std::string arguments;           ///< of every command of the tool torsor: the file and how it was read
  std::vector<std::string> notes;  ///< what the reader of a header should know, a line each
  std::string path;                ///< of the file, as it was given
  std::vector<std::string> package_folders;  ///< where packages of ROS were looked for
};

struct SceneContent {
  std::string name, title;
  SceneOrigin origin;
  std::map<std::string, std::string> names;  ///< every name taken, and by what; looked up, and sorted by name
  int symbol_count = 0;
  int measured_count = 0;  ///< vectors that formulas measure on the motion
  SymbolPointer time;
  std::vector<ParameterContent> parameters;
  std::vector<CoordinateContent> coordinates;
  std::vector<AttitudeContent> attitudes;
  std::vector<JointContent> joints;
  std::vector<FrameContent> frames;  ///< parents may come later when they are named by text
  std::vector<PointContent> points;
  std::vector<BodyContent> bodies;
  /// Reflected inertias, each on a frame of its own. They have kinetic energy and no momentum: none is a body or a joint.
  std::vector<BodyContent> rotors;
  std::vector<ActionContent> actions;
  std::vector<ContactFriction> frictions;
  std::vector<ConstraintContent> constraints;
  std::vector<ContactContent> contacts;  ///< that open and close, stops and dry frictions
  std::vector<Shown> shown;
  std::vector<std::vector<PointHandle>> boxes;  ///< corners of each box that touches a plane: what a picture draws
  std::vector<SymbolPointer> independent;  ///< coordinates wanted independent, the most wanted first
  Triple gravity{Expression(0), Expression(0), Expression(0)};
  bool gravity_given = false;  ///< a second one is refused
  /// Coordinates that move no mass are kept: kernels that solve with the mass matrix are then absent. Otherwise they are
  /// refused.
  bool keeps_massless = false;

  /// Index of a frame or point; throws SceneError that names the unknown one and lists the known ones.
  int frame_index(const FrameReference& reference, const std::string& user) const;
  int point_index(const PointReference& reference, const std::string& user) const;
  /// All that has kinetic energy: bodies, then rotors.
  std::vector<const BodyContent*> inertias() const;
  /// Whether a frame is only there for a reflected inertia.
  bool is_rotor(const FrameContent& frame) const;
  bool is_rotor(const BodyContent& inertia) const;  ///< of those of `inertias`
  /// What the author wrote, for messages: "body 'arm'", "joint 'knee'", "reflected inertia 'motor'".
  std::string name_of(const BodyContent& inertia) const;
  std::string name_of(const FrameContent& frame) const;
  /// The attitude and the component that a symbol stands for; none for any other symbol.
  std::optional<std::pair<std::size_t, std::size_t>> quaternion_component(const SymbolPointer& symbol) const;
};

}  // namespace torsor
