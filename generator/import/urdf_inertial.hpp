// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "torsor/generator/import/urdf_placement.hpp"

namespace torsor {

/// Reads <inertial> of a link. What is negative by rounding is zero: a moment −x with x ≤ 10⁻¹² of the largest entry, or
/// x ≤ 10⁻¹⁴ m · 1 m², since moments that programs move to the centre of mass carry the rounding of m d². Notes name the
/// links whose moments no matter has (one is larger than the sum of the others by more than 10⁻⁵, or negative), which have
/// mass without inertia or inertia without mass, or a radius of gyration above 10 m.
UrdfInertial read_inertial(const XmlElement& element, const std::string& link, const UrdfPlacements& placements,
                           UrdfRobot& robot);

}  // namespace torsor
