// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "torsor/generator/base/decimal.hpp"
#include "torsor/generator/import/exact_direction.hpp"
#include "torsor/generator/import/exact_rotation.hpp"
#include "torsor/generator/import/identifiers.hpp"
#include "torsor/generator/import/mjcf.hpp"
#include "torsor/generator/import/surface_contacts.hpp"
#include "torsor/generator/import/urdf_robot.hpp"

namespace torsor {

/// Makes the scene, part by part; mjcf_scene says what of what. mjcf_scene.cpp holds the tree of bodies,
/// mjcf_actions.cpp what acts in joints and tendons, mjcf_contacts.cpp friction and contacts, mjcf_actuators.cpp what
/// drives, mjcf_tendons.cpp sites and lengths, mjcf_equalities.cpp the constraints.
class MjcfBuilder {
 public:
  MjcfBuilder(const MjcfModel& model, const MjcfOptions& options);
  ImportedMjcf build();

 private:
  /// What the scene has of a joint.
  struct JointParts {
    std::string name;
    Expression position = 0;  ///< q of a hinge or a slide, a formula where it follows another
    bool known = false;
    Triple place{Expression(0), Expression(0), Expression(0)};  ///< of a free joint
    AttitudeHandle attitude;
    std::string frame, parent_frame;  ///< of a ball joint: what it turns, and in what
  };

  std::string scene_name();
  /// Notes of one kind share a line, with the parts of the model that it concerns.
  void note(const std::string& kind, const std::string& part);
  std::vector<std::string> notes() const;

  // Exact numbers of doubles.
  std::optional<Number> as_twelfths(double angle) const;
  Expression position_value(const MjcfJoint& joint, double value, const std::string& what);
  Rotation rotation(const std::array<double, 4>& quaternion, const std::string& where);
  std::array<Number, 3> direction(const std::array<double, 3>& axis, const std::string& where);
  static Triple quantities(const std::array<Number, 3>& numbers, const Unit& unit);
  static Triple lengths(const std::array<double, 3>& numbers);
  Expression parameter(const std::string& name, const char* unit, const Number& value);

  // The tree.
  void name_frames();
  void declare(std::size_t joint);
  const Expression& position(std::size_t joint);
  Expression polynomial(const MjcfEquality& law, std::size_t first);
  void place(std::size_t body);
  std::string add_joint(std::size_t joint, const std::string& frame, const std::string& parent,
                        const Placement& placement);
  void add_inertia(std::size_t body);
  void add_points();
  void set_start();
  void note_geometry();

  // Actions.
  void add_joint_actions(std::size_t joint);
  void add_scalar_actions(std::size_t joint);
  void add_free_actions(std::size_t joint);
  void add_free_spring(std::size_t joint);
  void add_tendons();
  void add_motors();
  /// Whether equalities leave a joint no motion: where it is, does not depend on a coordinate.
  bool is_held(std::size_t joint) const;
  /// Whether a joint that is not held carries a body.
  bool moves(int body) const;

  // Contacts, on request.
  void check_frictions() const;
  /// The bound of a joint's dry friction, where there is any.
  std::optional<Number> friction_of(const MjcfJoint& joint) const;
  void add_dry_friction(std::size_t joint);
  void add_ground();
  /// The geoms of a body that --ground names.
  std::vector<std::size_t> touching_geoms(const std::string& body) const;
  void touch_plane(const SurfaceContacts& contacts, const std::string& name, const MjcfGeom& geom, const FrameReference& plane);

  // Actuators.
  void add_motor(const MjcfActuator& actuator);
  void drive(const MjcfActuator& actuator, const Expression& displacement);
  Expression open_force(const MjcfActuator& actuator, bool is_force);
  void drive_ball(const MjcfActuator& actuator);
  void drive_free(const MjcfActuator& actuator);
  void drive_at_site(const MjcfActuator& actuator);
  void drive_between_sites(const MjcfActuator& actuator);
  void drive_slider(const MjcfActuator& actuator);
  void does_not_act(const MjcfActuator& actuator, const std::string& why);

  // Sites and tendons.
  void weld_at(const MjcfSite& site, const std::string& name);
  const std::string& frame_of_site(int site);
  PointHandle point_of_site(int site);
  /// The last body that both hang on; of a body and what hangs on it, the former.
  int common_carrier(int body, int other) const;
  bool move_apart(int body, int other) const;
  /// Whether a formula depends on a coordinate.
  static bool varies(const Expression& f);
  std::optional<Expression> tendon_length(const MjcfTendon& tendon);

  // Constraints.
  void choose_followers();
  void add_equalities();
  void constrain(const MjcfEquality& equality, const Expression& f);
  void add_points_together(const MjcfEquality& equality, const std::string& name);
  /// A place in a body, exactly.
  struct ExactPlace {
    std::array<Number, 3> point;
    Rotation turned;
  };
  ExactPlace in_parent(int body, const ExactPlace& place) const;
  std::optional<ExactPlace> in_second_body(const MjcfEquality& equality, const ExactPlace& in_first) const;
  ExactPlace closing_place(const MjcfEquality& equality, const ExactPlace& in_first) const;
  std::string frame_at(int body, const std::string& name, const ExactPlace& place);

  const MjcfModel& model_;
  const MjcfOptions& options_;
  UrdfChanges changes_;
  FileIdentifiers identifiers_;  // before the scene, whose name is one
  Scene scene_;
  std::vector<std::pair<std::string, std::vector<std::string>>> notes_;  ///< kinds, and the parts of each
  std::vector<std::string> data_;  ///< what is stated of joints and actuators, for the head
  std::vector<std::string> frames_;  ///< by body
  std::map<int, std::string> site_frames_;
  std::map<int, PointHandle> site_points_;
  std::map<std::size_t, JointParts> joints_;
  std::set<std::size_t> touching_;  ///< geoms that act
  std::map<std::size_t, std::size_t> followed_;  ///< joints without a coordinate, and the equality that says why
};

}  // namespace torsor
