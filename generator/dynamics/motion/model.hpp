// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "generator/geometry/vector.hpp"
#include "generator/mechanics/scene.hpp"
#include "generator/mechanics/screw.hpp"
#include "generator/program/derivative.hpp"
#include "generator/program/program.hpp"

namespace torsor {

/// How forward dynamics is solved.
enum class ForwardMethod {
  cheapest,          ///< the cheapest of those below that keeps the digits
  factorisation,     ///< L D Lᵀ of the mass matrix
  articulated_body,  ///< articulated bodies by the differences of their inertias
  sums_of_squares,   ///< articulated bodies as sums of squares (dynamics/recursions/factored_bodies.hpp)
};

/// How a scene's symbols enter a program.
struct ModelOptions {
  bool symbolic_parameters = false;       ///< keep every parameter as a symbol (printed equations)
  bool all_run_time = false;              ///< the same for kernels: `--run-time all`
  std::set<std::string> run_time;         ///< further parameters that stay symbols
  bool hold_released = true;              ///< released coordinates and their rates are zero; off: they are coordinates
  std::optional<std::set<std::string>> sensitive_to;  ///< parameters of sensitivities; without: those that stay symbols
  ForwardMethod forward = ForwardMethod::cheapest;
  Passes passes{};                        ///< what makes kernels cheap
};

/// Parameters that stay symbols in kernels, in the scene's order: declared run-time, without a value, or asked for by the
/// options. They are what the header's `Parameters` lists.
std::vector<SymbolPointer> run_time_parameters(const Scene& scene, const ModelOptions& options);

/// The same options with inertia and lengths left as the scene has them, and products where they stand.
ModelOptions as_given(ModelOptions options);

/// Inertia of what is attached to one link: mass [kg], first moment h = m OG [kg m] and operator about the link's
/// origin [kg m²], in the link's axes.
struct MassProperties {
  Value mass;
  Vector first_moment;
  Matrix inertia;  ///< symmetric
};

/// How the axes of a link turn in those of its parent.
enum class Turn {
  none,     ///< not at all
  aligned,  ///< by an angle about ± x, y or z
  general,  ///< by an array of nine entries
};

/// A frame that moves relative to its parent; everything welded to it is gathered in it. Link 0 is the ground.
///
/// A rotation by a unit quaternion is three links that share their axes: the first carries the whole turn R(e), and each
/// has one component of the relative angular velocity ω as the rate of its own axis. Those axes turn with the last of
/// the three, so that d(ω_i n_i)/dt = ω̇_i n_i + ω_i Ω_p ∧ n_i with Ω_p of the parent of all three (`in_group` counts them).
struct Link {
  std::string name;
  int parent = -1;
  Rotation placement_rotation;  ///< from the joint's fixed axes to the parent link's
  Vector placement_origin;      ///< of the joint, in the parent link's axes
  JointKind joint = JointKind::weld;
  Vector axis;                  ///< unit vector, the same components on both sides of the joint
  int aligned = -1;             ///< 0, 1, 2 when the axis is ± x, y, z, else -1
  Turn turn = Turn::none;
  int in_group = 0;             ///< 0, 1, 2 among the links of a quaternion, 0 of any other
  Value displacement, rate, acceleration;  ///< s [rad or m], ds/dt, d²s/dt²
  Value angle;                             ///< about +x, +y or +z when the axis is aligned
  Value sine, cosine;                      ///< of that angle; of the displacement when the axis is not aligned
  Matrix rotation;                         ///< child to parent, of a general turn
  std::vector<std::pair<int, Value>> partials;  ///< (i, ∂s/∂q_i), not zero
  MassProperties mass;       ///< of the bodies attached
  MassProperties effective;  ///< after regrouping: other numbers, same equations of motion
  MassProperties off_axis;   ///< the same for inverse dynamics, where ∫ n n dm along the axis n costs most
  int without_line = -1;     ///< 0, 1, 2: the axis along which off_axis has no ∫ n n dm
};

/// Where a frame of the scene went: a constant placement in a link.
struct FramePlace {
  int link = 0;
  Rotation rotation;
  Vector origin;
};

/// A scene in a program: links, coordinates and what they need. The base of every derivation.
class Model {
 public:
  Model(const Scene& scene, Program& program, const ModelOptions& options = {});
  ~Model() { program_->set_measurer({}); }
  Model(const Model&) = delete;  // its program asks it for what formulas measure
  Model& operator=(const Model&) = delete;

  /// The resolver a program for this scene must be made with.
  static Program::Resolver resolver(const Scene& scene, const ModelOptions& options);

  const SceneContent& scene() const { return *scene_; }
  Program& program() const { return *program_; }
  const ModelOptions& options() const { return options_; }
  const std::vector<Link>& links() const { return links_; }
  const FramePlace& place(const FrameReference& frame, const std::string& user) const;

  /// The unknowns q_i, in order of declaration, then the released coordinates.
  const std::vector<CoordinateContent>& coordinates() const { return coordinates_; }
  int unknown_count() const { return unknown_count_; }
  int released_count() const { return static_cast<int>(coordinates_.size()) - unknown_count_; }
  std::vector<SymbolPointer> inputs() const;
  /// What positions are functions of: the unknown coordinates, and the four components of each unit quaternion.
  std::vector<SymbolPointer> positions() const;

  Value q(int i) const { return program_->symbol(coordinates_[static_cast<std::size_t>(i)].q); }
  Value v(int i) const { return program_->symbol(coordinates_[static_cast<std::size_t>(i)].v); }
  Value a(int i) const { return program_->symbol(coordinates_[static_cast<std::size_t>(i)].a); }

  /// Derivative with respect to the configuration along freedom i.
  Derivation along(int i) const {
    return derivation_along(*program_, coordinates_[static_cast<std::size_t>(i)].v);
  }

  /// A formula of coordinates, time and parameters: what places are functions of. Throws SceneError naming `user` where
  /// it depends on velocities or more.
  Value of_configuration(const Expression& formula, const std::string& user) const;
  /// ∂e/∂q_i for every coordinate; a released one counts when e is that coordinate itself.
  std::vector<Value> partials(const Expression& e) const;

  /// Components of a vector in the axes of another link.
  Vector express(const Vector& v, int from, int to) const;
  /// Components of a point (from one link's origin) seen from another link's origin, in that link's axes.
  Vector locate(const Vector& p, int from, int to) const;
  /// A point of the scene in the axes of a link.
  Vector locate(const PointReference& point, int link, const std::string& user) const;
  /// Height of a point of contact (PointContent::lowest) over the plane it was found for: that of the centre C less
  /// r √(1 − (n·k)²), or r for a sphere, or h(−n); the point itself, whose own formula cancels where a disc lies flat, is
  /// not used.
  Value lowest_height(const PointContent& point, int link, const std::string& user) const;
  /// A direction given in a frame of the scene, in the axes of a link.
  Vector express(const Triple& direction, const FrameReference& axes, int link, const std::string& user) const;

  /// Components in the parent link's axes of a vector given in the link's own, and the way back.
  Vector to_parent(const Link& link, const Vector& v) const;
  Vector from_parent(const Link& link, const Vector& v) const;
  /// R J Rᵀ, any 3 x 3 array of components, and Rᵀ J R.
  Matrix to_parent(const Link& link, const Matrix& j) const;
  Matrix from_parent(const Link& link, const Matrix& j) const;
  /// The same without the joint's turn: between the parent's axes and the joint's fixed ones.
  Vector to_joint(const Link& link, const Vector& v) const;
  Vector from_joint(const Link& link, const Vector& v) const { return link.placement_rotation * v; }
  /// Origin of the link in its parent, in the parent's axes.
  Vector origin_in_parent(const Link& link) const;
  /// What the recursions of dynamics put in the place of lengths where all joints turn: lengths over one length L that
  /// occurs in the mechanism, so that its multiplications vanish, with masses m L² and first moments m OG L, so that
  /// moments and inertias stay what they are (`Link::effective` is in these units). L is 1 without a unit elsewhere.
  const std::optional<Number>& length_unit() const { return length_unit_; }
  Value length() const;                   ///< L where there is one
  Vector arm(const Link& link) const;     ///< origin_in_parent over L
  Vector upward_gravity() const;          ///< −g over L
  Wrench over_length(const Wrench& wrench) const;  ///< a wrench with its resultant times L
  /// What names of such quantities end with.
  std::string length_note(const char* relation = ", over") const;
  /// Axis of the joint in the parent link's axes.
  Vector axis_in_parent(const Link& link) const;
  /// Of the links of a unit quaternion, which share place and axes, the last: it has the twist of those axes. Any other
  /// link is its own.
  std::size_t turning_link(std::size_t link) const;
  /// Chain of links from the first after the ground down to `link`.
  std::vector<int> chain(int link) const;

 private:
  std::vector<Link> runs(int link, int top) const;
  void add_coordinates();
  void add_links();
  void set_motion(Link& link, const FrameContent& frame);
  void add_attitude(const FrameContent& frame, const FramePlace& at);
  Value measured(const Symbol& symbol);
  Vector measured(const MeasuredVector& wanted);
  bool is_placed(const Expression& formula, const std::vector<bool>& done) const;
  /// h(u) and ∇h(u) of a support function along the frame's axes, u the direction down in them.
  std::pair<Value, Vector> supported(const PointContent& point, const Vector& down) const;
  Vector down_in(const PointContent& point, const FramePlace& at, const std::string& user) const;
  Vector lowest(const PointContent& point, int link, const std::string& user) const;
  void add_bodies();
  void choose_length_unit();

  const SceneContent* scene_;
  Program* program_;
  ModelOptions options_;
  std::vector<CoordinateContent> coordinates_;
  int unknown_count_ = 0;
  std::vector<Link> links_;
  std::vector<FramePlace> places_;  ///< by frame of the scene
  std::map<int, Vector> measured_;  ///< by index of the measured vector
  std::optional<Number> length_unit_;  ///< [m]
};

/// Moves to the parent the part of each link's inertia that a turn about its axis leaves alone (a mass distributed on
/// the axis), and for a prismatic joint the whole operator: the equations of motion stay the same and lose operations
/// (Gautier & Khalil, Direct calculation of minimum set of inertial parameters of serial robots, 1990). How much of a
/// line of mass on the axis goes to the parent is free: for `effective` as much as leaves one moment of inertia zero,
/// for `off_axis` all of it, which leaves ∫ n n dm = 0 along the axis.
void regroup_inertia(const Model& model, std::vector<Link>& links);

/// Adds the mass properties of a part placed in the link by a constant rotation and origin (generalised Huygens).
void add_placed(Program& program, MassProperties& sum, const MassProperties& part, const Rotation& rotation,
                const Vector& origin);

}  // namespace torsor
