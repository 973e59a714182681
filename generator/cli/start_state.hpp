// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "torsor/generator/verification/evaluated_motion.hpp"

namespace torsor {

/// The scene with other start values: coordinates, components of quaternions, rates NAME'. Names that it does not have are
/// left to the command that was given them.
Scene with_start(Scene scene, const NamedNumbers& values);

/// Given values of parameters, with the defaults of other run-time parameters whose formulas need these: as in a header, a
/// default is a number that no other parameter changes.
NamedNumbers with_defaults(const Scene& scene, NamedNumbers given);

/// Throws UsageError where a number given to a parameter makes something that cannot be: a negative mass, a lower stop above
/// the upper one. It says what, and which numbers do.
void require_possible(const Scene& scene, const NamedNumbers& given);

/// Where a command starts that was given values of its own: for coordinates and rates, and for parameters.
struct GivenStart {
  NamedNumbers values, parameters;
  ModelOptions model;
};

/// The same, put on the constraints as they are with these parameters. Throws Error where they cannot be closed near there.
Scene with_closed_start(const Scene& scene, const GivenStart& start);

/// The start of a motion with some numbers replaced, put on the constraints. What is replaced stays as it is given where the
/// others can close the constraints. Throws Error naming the constraint that stays open, and UsageError for an unknown name.
std::vector<double> closed_start(EvaluatedMotion& motion, const NamedNumbers& replaced);

/// The state nearest to the start (NearestState) that fulfils the constraints and contacts of a scene whose start does not, in
/// words that can be pasted: into the scene, or behind --initial. Empty where none is found.
std::string nearest_closed_start(const Scene& scene, bool for_command_line);

/// What a row of constraints keeps beside the others near a change point: accelerations then lose half of their digits.
constexpr double change_point_is_near = 1e-3;

/// Coordinates that the constraints hardly let move there, and do elsewhere, as the slider of a crank at its dead centres.
std::vector<std::string> at_dead_centre(EvaluatedMotion& motion, double t, const std::vector<double>& y);

/// Constraints that repeat others and are left out, where those that are kept may lose rank and all together do not; else none.
std::vector<std::string> left_out_that_count(EvaluatedMotion& motion, double t, const std::vector<double>& y);

/// What to say of a motion that ends at, or near, a change point of its constraints; empty elsewhere.
std::string near_change_point(EvaluatedMotion& motion, double t, const std::vector<double>& y);

}  // namespace torsor
