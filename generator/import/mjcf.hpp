// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "torsor/generator/base/number.hpp"
#include "torsor/generator/import/mjcf_model.hpp"
#include "torsor/generator/import/surfaces.hpp"
#include "torsor/generator/mechanics/scene.hpp"

namespace torsor {

/// How an MJCF model becomes a scene.
struct MjcfOptions {
  std::optional<std::array<Number, 3>> gravity;  ///< [m/s²]; that of the file when there is none
  /// Angles this near to a multiple of π/12 are that multiple [rad]; axes likewise.
  Number angle_tolerance = Number::rational(1, 1000000000);
  bool dampers = true;  ///< damping of joints and tendons acts
  bool motors = true;   ///< actuators are inputs; where the file has none, every hinge and slide has a motor
  /// Dry friction in hinges and slides, {joint, the largest effort} [N m, N]: kernels `contacts` and `contact_coefficients`.
  std::vector<std::pair<std::string, Number>> friction;
  bool friction_of_file = false;  ///< frictionloss acts so too, where `friction` says nothing else
  bool limits = false;            ///< ranges of hinges and slides are stops, without restitution
  /// Bodies whose geoms touch the planes of the file that stand still; where it has none, the plane z = 0. The run-time
  /// parameters are ground_friction and ground_restitution.
  Surfaces ground;
  bool strict = false;  ///< refuses what cannot act instead of noting it
  std::string name;     ///< of the scene; the model's when empty
  std::vector<std::string> points;  ///< bodies and sites whose origins become points <name>_origin
  std::vector<std::pair<std::string, std::string>> initial;  ///< as of a URDF file
};

struct ImportedMjcf {
  Scene scene;
  std::vector<std::string> notes;  ///< what the file says and does not act, a line each; in the scene's origin too
  std::vector<MjcfGeom> contact_geometry;
};

/// Makes a scene of a model in MuJoCo's form.
///
/// A body becomes a frame of its name, with a body of its mass and inertia J = R diag(A, B, C) Rᵀ. Its joints follow
/// one another, each at its place in the body:
///  * hinge, slide: a coordinate of the joint's name that is MuJoCo's qpos: the joint turns or slides by q − ref.
///    Spring (stiffness, springref), damping and limits are the scene's; frictionloss is dry friction, on request.
///  * ball: the attitude <joint>_attitude, MuJoCo's quaternion, and components of the angular velocity in the child's
///  axes.
///  * free: position <joint>_x, _y, _z and <joint>_attitude. The start is qpos0.
/// Armature a is the rotor <joint>_rotor: ½ a q̇². Of a free joint it is that along its axes and ½ a Ω²; of a ball joint
/// whose parent moves it cannot act. Damping of ball and free joints is −c Ω and −c v; their springs are −½ k θ² of the
/// angle from the attitude of rest, of free joints −½ k x² of each place too.
///
/// Actuators are inputs: the scalar force of the actuator, which works with gear · q, with the length of a tendon or a
/// slider-crank, or acts as a wrench along a site's axes. Tendons with stiffness or damping are springs and dampers on
/// their length, which is known where they do not run around geoms. Equality constraints are ideal here: connect is a
/// spherical closure, weld a closure of six conditions, a joint that is a polynomial of another follows it (no
/// coordinate of its own) where it can, otherwise a holonomic constraint.
///
/// Numbers are MuJoCo's doubles as the shortest decimals that read back. Throws FileError for what contradicts itself,
/// UsageError for names in options that do not exist.
ImportedMjcf mjcf_scene(const MjcfModel& model, const MjcfOptions& options = {});

}  // namespace torsor
