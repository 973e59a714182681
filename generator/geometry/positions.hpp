// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "torsor/generator/geometry/triple.hpp"

namespace torsor {

/// A point OP given by three coordinates of time, with the base that follows it.
struct LocalPosition {
  Triple position;             ///< OP along the fixed axes x, y, z [m]
  std::array<Triple, 3> base;  ///< unit vectors of the direct local base, each along x, y, z
  Triple velocity;             ///< dOP/dt in the fixed frame, along the local base [m/s]
  Triple acceleration;         ///< d²OP/dt², along the local base [m/s²]
};

/// OP = x x + y y + z z; the local base is the fixed one.
LocalPosition cartesian(const Expression& x, const Expression& y, const Expression& z);

/// OP = r u + z z with θ = (x, u) in the plane of normal z; base (u, v, z), v = z ∧ u:
/// V = r' u + r θ' v + z' z, Γ = (r'' − r θ'²) u + (r θ'' + 2 r' θ') v + z'' z.
LocalPosition cylindrical(const Expression& r, const Expression& theta, const Expression& z);

/// OP = ρ w with θ = (x, u) about z and φ = (z, w) about v = z ∧ u, so that w = cosφ z + sinφ u; base (n, v, w) with
/// n = v ∧ w = cosφ u − sinφ z:
/// V = ρ φ' n + ρ sinφ θ' v + ρ' w,
/// Γ = (ρ φ'' + 2 ρ' φ' − ρ sinφ cosφ θ'²) n + (ρ sinφ θ'' + 2 ρ' θ' sinφ + 2 ρ φ' θ' cosφ) v
///   + (ρ'' − ρ φ'² − ρ sin²φ θ'²) w.
/// (Pommier, Dynamique des systèmes de solides, §3.3.1, whose printed V lacks the part of φ' along u.)
LocalPosition spherical(const Expression& rho, const Expression& theta, const Expression& phi);

}  // namespace torsor
