// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "torsor/generator/emission/mechanism_listing.hpp"

namespace torsor {

/// The generated header of a scene: one C++17 file that includes <array> and <cmath> only, with
/// `<scene>::Mechanism<Scalar>`, its structures and the kernels, in the order given. Kernels that are absent are named in
/// the head comment only. The same scene gives the same bytes; the member `fingerprint` tells headers apart that differ
/// in more than the head comment. With `support`, the header includes a file of that name, which holds shared_support(),
/// and has no such text itself. Throws SceneError for a name that cannot stand in C++.
std::string emit_header(const MechanismListing& mechanism, const std::string& support = {});

/// The same of a scene: kernels by their names (kernel.hpp).
std::string emit_header(const Scene& scene, const std::vector<std::string>& kernels, const ModelOptions& options = {});

/// The member `fingerprint` of the header that has its own support.
std::uint64_t header_fingerprint(const MechanismListing& mechanism);

}  // namespace torsor
