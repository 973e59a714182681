// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/dynamics/motion/point_motion.hpp"

namespace torsor {

/// Motion of a body S1 on a body S2 at their contact I with the unit normal n from S2 to S1, split along n:
/// V(I ∈ S1/S2) = sliding + separation n, Ω(S1/S2) = rolling + spinning n.
struct ContactMotion {
  Vector normal;     ///< n
  Vector sliding;    ///< orthogonal to n [m/s]; null for rolling without slip
  Value separation;  ///< n·V(I ∈ S1/S2) [m/s]: positive opens the contact, 0 while it lasts
  Vector rolling;    ///< orthogonal to n [rad/s]
  Value spinning;    ///< n·Ω(S1/S2) [rad/s]
};

/// Bodies by their frames, and a normal of any length along the axes of a frame.
struct ContactBetween {
  FrameReference body_1, body_2;
  PointReference contact;
  Triple normal;
  FrameReference normal_axes;
};

/// In the axes of the ground. Throws SceneError when the normal is null.
ContactMotion contact_motion(const Model& model, const ContactBetween& between);

}  // namespace torsor
