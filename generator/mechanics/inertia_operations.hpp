// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "torsor/generator/mechanics/inertia.hpp"

namespace torsor {

/// An inertia operator about a stated point [kg m²], products with their minus sign as in `Inertia`.
struct InertiaOperator {
  Expression xx, yy, zz, xy, xz, yz;
};

/// J_A = J_G + m (AG² 1 − AG AGᵀ), Huygens' theorem from the centre of mass to any point A given in the body's frame
/// (Pommier, Dynamique des systèmes de solides, §4.2).
InertiaOperator operator_about(const Inertia& body, const Triple& point);

/// The body with that mass, centre of mass and operator about any point A of its frame: Huygens the way back,
/// J_G = J_A − m (AG² 1 − AG AGᵀ).
Inertia from_operator_about(const Expression& mass, const Triple& center, const Triple& point,
                            const InertiaOperator& about_point);

/// A body of negative mass, for a hole.
Inertia operator-(const Inertia& body);

/// Two bodies fixed to one another, both given in one frame: masses add, OG = (m1 OG1 + m2 OG2)/(m1 + m2) and
/// J = J1 + J2 + m1 m2/(m1 + m2) (d² 1 − d dᵀ) with d = G1G2. A hole is subtracted. Massless operators (a flywheel's)
/// are added too. Throws SceneError when the masses cancel identically and only then.
Inertia operator+(const Inertia& a, const Inertia& b);
Inertia operator-(const Inertia& a, const Inertia& b);

/// Any number of bodies fixed to one another, from the first to the last. Throws SceneError when there is none.
Inertia assembly(const std::vector<Inertia>& parts);

}  // namespace torsor
