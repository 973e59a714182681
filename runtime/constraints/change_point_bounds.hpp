// SPDX-License-Identifier: MIT
#pragma once

/// Distances d from a change point (see RankDistance), numbers without unit, between which a motion is read in other ways
/// (see ChangePoints).
namespace torsor::runtime::change_point_bounds {

/// From here on the equations are taken as they are: errors e off the constraints come out as e/d² in accelerations.
inline constexpr double plain = 0.3;
/// Nearer, no projection on the constraints is good enough either.
inline constexpr double near = 0.015;
/// Nearer, rounding of positions takes half of the digits: the fourth root of that of doubles.
inline constexpr double blind = 1.2e-4;

}  // namespace torsor::runtime::change_point_bounds
