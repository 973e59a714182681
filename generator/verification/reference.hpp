// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/mechanics/scene.hpp"

namespace torsor {

struct ReferenceOptions {
  int digits = 40;                  ///< digits wanted at every time
  std::vector<std::string> times;   ///< exact decimals, increasing [s]
};

/// The motion of a scene from its initial state, inputs zero, by a road that shares nothing with the double kernels:
/// Lagrange's operator on T from positions, evaluated in CLN, a dense solve with the constraints, an extrapolation
/// integrator run at two orders. CSV text: comment lines, `time,<q>…,<q>'…`, one row per time with the digits on which
/// both runs agree. Throws Error when they agree on fewer digits than asked for.
std::string reference_csv(const Scene& scene, const ReferenceOptions& options);

}  // namespace torsor
