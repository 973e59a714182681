// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/emission/mechanism_listing.hpp"

namespace torsor {

/// The generated header of a scene: one C++17 file that includes <array> and <cmath> only, with
/// `<scene>::Mechanism<Scalar>`, its structures and the kernels, in the order given. Kernels that are absent are named in
/// the head comment only. The same scene gives the same bytes; the member `fingerprint` tells headers apart that differ
/// in more than the head comment. Throws SceneError for a name that cannot stand in C++.
std::string emit_header(const MechanismListing& mechanism);

/// The same of a scene: kernels by their names (kernel.hpp).
std::string emit_header(const Scene& scene, const std::vector<std::string>& kernels, const ModelOptions& options = {});

}  // namespace torsor
