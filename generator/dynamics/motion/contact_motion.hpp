// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "generator/dynamics/motion/point_motion.hpp"

namespace torsor {

/// Motion of a body S1 on a body S2 at their contact I with the unit normal n from S2 to S1, split along n:
/// V(I ∈ S1/S2) = sliding + separation n, Ω(S1/S2) = rolling + spinning n. Vectors in the axes asked for.
struct ContactMotion {
  Vector normal;     ///< n
  Vector sliding;    ///< orthogonal to n [m/s]; null for rolling without slip
  Value separation;  ///< n·V(I ∈ S1/S2) [m/s]: positive opens the contact, 0 while it lasts
  Vector rolling;    ///< orthogonal to n [rad/s]
  Value spinning;    ///< n·Ω(S1/S2) [rad/s]
};

/// `body_1` and `body_2` are links, `contact` is given in any link; `normal` in the same link's axes, normalised here.
/// Throws SceneError when the normal is null.
ContactMotion contact_motion(const Model& model, int body_1, int body_2, const GeometricPoint& contact,
                             const Vector& normal, int axes);

/// For bodies' frames and a point of the scene, the normal along the axes of `normal_axes`, in the axes of the ground.
ContactMotion contact_motion(const Model& model, const FrameReference& body_1, const FrameReference& body_2,
                             const PointReference& contact, const Triple& normal, const FrameReference& normal_axes);

}  // namespace torsor
