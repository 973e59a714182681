// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "torsor/generator/dynamics/motion/body_tree.hpp"
#include "torsor/generator/geometry/exact_turn.hpp"

namespace torsor {

/// Where a link's new frame is in its old one, and where its joint then stands.
struct NewFrame {
  bool turns_about_z = false;    ///< the joint's axis is the new frame's z; otherwise the frame is the old one
  Rotation rotation;             ///< C: components in the old axes from those in the new ones
  std::array<Number, 3> origin;  ///< c, of the new frame in the old axes [m]
  Rotation placement_rotation;   ///< of the joint, in the parent's new axes
  Vector placement_origin;
  ExactTurn shift;  ///< what the joint's angle grows by
};

struct NewFrames {
  std::vector<NewFrame> of_links;
  int rounded = 0;  ///< directions and angles that are good to direction_digits only
};

/// Frames of links in which placements of joints cost least, after Denavit & Hartenberg (A kinematic notation for
/// lower-pair mechanisms, 1955), on trees too. A joint turns about the z of its link, whose frame may turn about that
/// axis by any angle and slide along it: the angle goes into the joint's, the origin and the inertia follow. Between
/// the axes of a link k and of a link m that it carries stands Rz(a) Rx(α) Rz(b): Rz(b) goes into the angle of m, and
/// the frame of k turns by the a of one of the links that it carries, whose placement is then Rx(α). The origin of m
/// slides to where one of its components in k vanishes; of a link that slides the origin goes to that of k.
///
/// Nothing where all placements are permutations of axes already, or where other frames would not cost less. Links of
/// unit quaternions, of constant angles and of axes that depend on parameters keep their frames. `links` hold the
/// masses of bodies.
std::optional<NewFrames> cheaper_frames(const SceneContent& scene, Program& program, const std::vector<Link>& links);

}  // namespace torsor
