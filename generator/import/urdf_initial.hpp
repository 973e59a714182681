// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "torsor/generator/import/urdf_robot.hpp"
#include "torsor/generator/mechanics/scene.hpp"

namespace torsor {

/// Sets the state of a scene at t = 0 by names and decimals: coordinates ("elbow"), their rates ("elbow'"), components
/// of unit quaternions ("base_attitude_w"; those that are not given are 0, w is 1 when none is) and of angular
/// velocities
/// ("base_attitude_omega_x"). Throws UsageError for an unknown name, which lists the known ones, and for a text that is
/// no number.
void set_initial(Scene& scene, const std::vector<std::pair<std::string, std::string>>& values);

/// These values, and behind them those of a floating base of that name that begins at a placement, but for what is given
/// already: each place by itself, the quaternion as a whole.
std::vector<std::pair<std::string, std::string>> with_start(std::vector<std::pair<std::string, std::string>> given,
                                                            const std::string& base, const UrdfPlacement& start);

}  // namespace torsor
