// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "torsor/generator/geometry/vector.hpp"
#include "torsor/generator/mechanics/scene_content.hpp"
#include "torsor/generator/mechanics/screw.hpp"
#include "torsor/generator/program/program.hpp"

namespace torsor {

/// Inertia of what is attached to one link: mass [kg], first moment h = m OG [kg m] and operator about the link's
/// origin [kg m²], in the link's axes.
struct MassProperties {
  Value mass;
  Vector first_moment;
  Matrix inertia;  ///< symmetric
};

/// Where a part is in a link.
struct PartPlace {
  Rotation rotation;  ///< components in the link's axes from those in the part's
  Vector origin;      ///< of the part's frame, from the link's
};

/// Adds the mass properties of a part placed in the link (generalised Huygens).
void add_placed(Program& program, MassProperties& sum, const MassProperties& part, const PartPlace& at);

/// How the axes of a link turn in those of its parent.
enum class Turn {
  none,     ///< not at all
  aligned,  ///< by an angle about ± x, y or z
  general,  ///< by an array of nine entries
};

/// Where a frame of the scene is: a constant placement in a link.
struct FramePlace {
  int link = 0;
  Rotation rotation;
  Vector origin;
};

/// A geometric point, given by its components in the axes of a link from its origin. It may move there (a contact point
/// belongs to no body) and then its velocity is not that of the link's material point.
struct GeometricPoint {
  int link = 0;
  Vector place;  ///< OP [m], a function of time, coordinates and velocities
};

/// A frame that moves relative to its parent; everything welded to it is gathered in it. Link 0 is the ground.
///
/// A rotation by a unit quaternion is three links that share their axes: the first carries the whole turn R(e), and each
/// has one component of the relative angular velocity ω as the rate of its own axis. Those axes turn with the last of
/// the three, so that d(ω_i n_i)/dt = ω̇_i n_i + ω_i Ω_p ∧ n_i with Ω_p of the parent of all three (`in_group` counts them).
struct Link {
  std::string name;
  int parent = 0;               ///< of the ground the ground itself
  Rotation placement_rotation;  ///< from the joint's fixed axes to the parent link's
  /// Turns about axes whose product, first to last, it is, where they are to be done one after the other; else none.
  std::vector<Rotation> placement_factors;
  Vector placement_origin;      ///< of the joint, in the parent link's axes
  JointKind joint = JointKind::weld;
  Vector axis;                  ///< unit vector, the same components on both sides of the joint
  std::optional<int> aligned;   ///< 0, 1, 2: the axis is ± x, y, z
  Turn turn = Turn::none;
  int in_group = 0;             ///< 0, 1, 2 among the links of a quaternion, 0 of any other
  Value displacement, rate, acceleration;  ///< s [rad or m], ds/dt, d²s/dt²
  Value angle;                             ///< about +x, +y or +z when the axis is aligned
  Value sine, cosine;                      ///< of that angle; of the displacement when the axis is not aligned
  Matrix rotation;                         ///< child to parent, of a general turn
  std::vector<std::pair<int, Value>> partials;  ///< (i, ∂s/∂q_i), not zero
  MassProperties mass;          ///< the tree says which: of the bodies attached, or other numbers of the same effect
  std::optional<int> without_line;  ///< 0, 1, 2: an axis along which ∫ n n dm is zero
  /// The frame that the scene gives to this link, in the link's own axes: the link itself in the tree of a Model.
  Rotation scene_rotation;
  Vector scene_origin;
};

/// Links, coordinates and inertia in one choice of frames, of the inertia's place and of the unit of length. A tree is a
/// value; the functions below make another one with the same equations of motion. Recursions take one tree and need not
/// know which.
///
/// A link is not a frame of the scene. What a person gives or gets is along frames of the scene: `place` tells where
/// those are in this tree's links, and `applied` brings in wrenches.
class BodyTree {
 public:
  const SceneContent& scene() const { return *scene_; }
  Program& program() const { return *program_; }
  const std::vector<Link>& links() const { return links_; }
  const FramePlace& place(const FrameReference& frame, const std::string& user) const;

  /// The unknowns q_i, in order of declaration, then the released coordinates.
  const std::vector<CoordinateContent>& coordinates() const { return coordinates_; }
  int unknown_count() const { return unknown_count_; }
  int released_count() const { return static_cast<int>(coordinates_.size()) - unknown_count_; }
  Value q(int i) const { return program_->symbol(coordinates_[static_cast<std::size_t>(i)].q); }
  Value v(int i) const { return program_->symbol(coordinates_[static_cast<std::size_t>(i)].v); }
  Value a(int i) const { return program_->symbol(coordinates_[static_cast<std::size_t>(i)].a); }

  /// Components of a vector in the axes of another link.
  Vector express(const Vector& v, int from, int to) const;
  /// Components of a point (from one link's origin) seen from another link's origin, in that link's axes.
  Vector locate(const Vector& p, int from, int to) const;
  /// AB in the axes of a link, from places that start at a joint that turns both points, or at a link between them: what
  /// slides both does not enter, where a difference of their places would lose digits to it.
  Vector between(const GeometricPoint& a, const GeometricPoint& b, int axes) const;

  /// Components in the parent link's axes of a vector given in the link's own, and the way back.
  Vector to_parent(const Link& link, const Vector& v) const;
  Vector from_parent(const Link& link, const Vector& v) const;
  /// R J Rᵀ, any 3 x 3 array of components, and Rᵀ J R.
  Matrix to_parent(const Link& link, const Matrix& j) const;
  Matrix from_parent(const Link& link, const Matrix& j) const;
  /// The same without the joint's turn: between the parent's axes and the joint's fixed ones.
  Vector to_joint(const Link& link, const Vector& v) const;
  Vector from_joint(const Link& link, const Vector& v) const;
  /// Origin of the link in its parent, in the parent's axes.
  Vector origin_in_parent(const Link& link) const;
  /// Axis of the joint in the parent link's axes.
  Vector axis_in_parent(const Link& link) const;
  /// Of the links of a unit quaternion, which share place and axes, the last: it has the twist of those axes. Any other
  /// link is its own.
  std::size_t turning_link(std::size_t link) const;
  /// Chain of links from the first after the ground down to `link`.
  std::vector<int> chain(int link) const;

  /// What the recursions of dynamics put in the place of lengths where all joints turn: lengths over one length L that
  /// occurs in the mechanism, so that its multiplications vanish, with masses m L² and first moments m OG L, so that
  /// moments and inertias stay what they are. L is 1 without a unit elsewhere.
  const std::optional<Number>& length_unit() const { return length_unit_; }
  Value length() const;                ///< L where there is one
  Vector arm(const Link& link) const;  ///< origin_in_parent over L
  Vector upward_gravity() const;       ///< −g over L
  /// A wrench on a link, given at the origin of the link's frame in the scene, along its axes: at the link's own origin,
  /// along its own axes, the resultant times L.
  Wrench applied(std::size_t link, const Wrench& wrench) const;
  /// What names of such quantities end with.
  std::string length_note(const char* relation = ", over") const;

  /// Whether links have other frames than the scene gives them.
  bool is_reframed() const { return rounded_directions_.has_value(); }
  /// Directions and angles that those frames round; see direction_digits.
  int rounded_directions() const { return rounded_directions_.value_or(0); }

  friend BodyTree regrouped(const BodyTree& tree);
  friend BodyTree without_lines(const BodyTree& tree);
  friend BodyTree in_length_unit(const BodyTree& tree);
  friend BodyTree reframed(const BodyTree& tree);

 protected:
  BodyTree(const SceneContent& scene, Program& program) : scene_(&scene), program_(&program) {}
  /// The inertia of every link from the bodies that are placed in it.
  void gather_bodies();

  const SceneContent* scene_;
  Program* program_;
  std::vector<CoordinateContent> coordinates_;
  int unknown_count_ = 0;
  std::vector<Link> links_;
  std::vector<FramePlace> places_;     ///< by frame of the scene
  std::optional<Number> length_unit_;  ///< [m]
  std::optional<int> rounded_directions_;

 private:
  std::vector<Link> runs(int link, int top) const;
};

/// Moves to the parent the part of each link's inertia that a turn about its axis leaves alone (a mass distributed on
/// the axis), and for a prismatic joint the whole operator: the equations of motion stay the same and lose operations
/// (Gautier & Khalil, Direct calculation of minimum set of inertial parameters of serial robots, 1990). Of a line of
/// mass on the axis as much goes to the parent as leaves one moment of inertia zero.
BodyTree regrouped(const BodyTree& tree);

/// The same, but all of a line of mass on the axis goes to the parent, which leaves ∫ n n dm = 0 along the axis n: in
/// inverse dynamics that costs most. A line whose move would ask for an angular acceleration stays: its moment of zero
/// saves one.
BodyTree without_lines(const BodyTree& tree);

/// Lengths over the constant that stands most often among the places of joints; the same where a joint slides.
BodyTree in_length_unit(const BodyTree& tree);

/// The bodies in links whose frames make placements of joints cheap (reframing.hpp); the same where that gains nothing.
/// `tree` has the inertia of its bodies, neither regrouped nor in another unit.
BodyTree reframed(const BodyTree& tree);

}  // namespace torsor
