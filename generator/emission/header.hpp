// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/dynamics/equations/equations.hpp"
#include "generator/emission/kernel.hpp"

namespace torsor {

struct HeaderOptions {
  ModelOptions model;  ///< those the equations were made with: they tell which parameters stay symbols
};

/// The generated header of a scene: one C++17 file that includes <array> and <cmath> only, with
/// `<scene>::Mechanism<Scalar>`, its structures and the kernels, in the order given. Kernels with a reason to be
/// skipped are named in the head comment only. The same equations give the same bytes; the member `fingerprint` tells
/// headers apart that differ in more than the head comment. Throws SceneError for a name that cannot stand in C++.
std::string emit_header(const Equations& equations, const std::vector<Kernel>& kernels,
                        const HeaderOptions& options = {});

}  // namespace torsor
