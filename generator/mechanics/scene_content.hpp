// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "generator/expression/expression.hpp"
#include "generator/expression/symbol.hpp"
#include "generator/geometry/rotation.hpp"
#include "generator/geometry/triple.hpp"
#include "generator/mechanics/inertia.hpp"

namespace torsor {

// What a Scene holds, for those who derive from it. Users meet the handles and references only.

struct FrameHandle { int index = 0; };
struct PointHandle { int index = 0; };
struct ConstraintHandle { int index = 0; };

/// A frame by handle or by name; names are looked up when the scene is validated.
struct FrameReference {
  FrameReference(FrameHandle handle) : target(handle.index) {}          // NOLINT(google-explicit-constructor)
  FrameReference(std::string name) : target(std::move(name)) {}         // NOLINT(google-explicit-constructor)
  FrameReference(const char* name) : target(std::string(name)) {}       // NOLINT(google-explicit-constructor)
  std::variant<int, std::string> target;
};
struct PointReference {
  PointReference(PointHandle handle) : target(handle.index) {}          // NOLINT(google-explicit-constructor)
  PointReference(std::string name) : target(std::move(name)) {}         // NOLINT(google-explicit-constructor)
  PointReference(const char* name) : target(std::string(name)) {}       // NOLINT(google-explicit-constructor)
  std::variant<int, std::string> target;
};

/// Where a joint sits in its parent: origin, then a constant rotation.
struct Placement {
  Triple origin{Expression(0), Expression(0), Expression(0)};
  Rotation rotation{};
};

/// Orders of three plane rotations, each about an axis of the frame that the one before has turned.
enum class AngleSequence {
  euler,   ///< ψ, θ, φ about z, x, z
  cardan,  ///< α, β, γ about x, y, z
};

enum class JointKind { weld, revolute, prismatic };

struct FrameContent {
  std::string name;
  std::optional<FrameReference> parent;  ///< none for the ground
  Placement placement;
  JointKind joint = JointKind::weld;
  Triple axis{};
  Expression displacement;  ///< angle [rad] or distance [m] as a formula of coordinates and time
};

struct PointContent { std::string name; FrameReference frame; Triple components; };
struct BodyContent { std::string name; FrameReference frame; Inertia inertia; };

struct ParameterContent { SymbolPointer symbol; std::optional<Expression> value; bool run_time = false; };

struct CoordinateContent {
  SymbolPointer q, v, a;
  std::optional<Expression> law;            ///< imposed by time
  bool released = false;                    ///< held at zero, its reaction can be asked for
  std::optional<Expression> initial_value;  ///< at t = 0
  std::optional<Expression> initial_rate;
  bool unknown() const { return !law && !released; }
};

struct ElongationSpring { std::string name; Expression elongation, stiffness, rest; };
struct ElongationDamper { std::string name; Expression elongation, damping; };
struct PointSpring { std::string name; PointReference a, b; Expression stiffness, rest; };
struct PointDamper { std::string name; PointReference a, b; Expression damping; };
struct Motor { std::string name; SymbolPointer input; Expression displacement; };
struct GivenForce { std::string name; FrameReference body; PointReference point; Triple components; FrameReference axes; };
struct GivenTorque { std::string name; FrameReference body; Triple components; FrameReference axes; };
struct GivenForceFunction { std::string name; Expression force_function; };
struct Effort { std::string name; Expression displacement, force; };
struct Gravitation { std::string name; PointReference a, b; Expression strength; };
struct GivenWrench { std::string name; FrameReference body; PointReference point; Triple force, moment; FrameReference axes; };
struct Drag { std::string name; FrameReference body; PointReference point; Expression coefficient; FrameReference relative_to; };
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
                 GivenForceFunction, Effort, Gravitation, GivenWrench, Drag, RotationalDrag, MutualAction>;

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
};

struct HolonomicFormula { Expression f; };
struct NonholonomicFormula { Expression left_side; };
struct NoSlip { FrameReference body; PointReference contact; Triple direction; FrameReference axes; };
struct Closure { PointReference a, b; Triple direction; };

struct ReactionContent {
  std::string name;
  FrameReference body;
  PointReference contact;
  Triple direction;
  FrameReference axes;
  FrameReference other = "ground";  ///< the body that exerts it, and feels the opposite
};
struct ConstraintContent {
  std::string name;
  std::variant<HolonomicFormula, NonholonomicFormula, NoSlip, Closure> law;
  SymbolPointer multiplier;
  std::optional<ReactionContent> reaction;
};

struct SceneContent {
  std::string name, title;
  std::map<std::string, std::string> names;  ///< every name taken, and by what; looked up, and sorted by name
  int symbol_count = 0;
  SymbolPointer time;
  std::vector<ParameterContent> parameters;
  std::vector<CoordinateContent> coordinates;
  std::vector<FrameContent> frames;  ///< parents may come later when they are named by text
  std::vector<PointContent> points;
  std::vector<BodyContent> bodies;
  std::vector<ActionContent> actions;
  std::vector<ContactFriction> frictions;
  std::vector<ConstraintContent> constraints;
  Triple gravity{Expression(0), Expression(0), Expression(0)};

  /// Index of a frame or point; throws SceneError that names the unknown one and lists the known ones.
  int frame_index(const FrameReference& reference, const std::string& user) const;
  int point_index(const PointReference& reference, const std::string& user) const;
};

}  // namespace torsor
