// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "torsor/generator/mechanics/scene.hpp"

namespace torsor {

struct ReferenceOptions {
  int digits = 40;                  ///< digits wanted at every time
  std::vector<std::string> times;   ///< exact decimals, increasing [s]
};

/// The motion of a scene from its initial state, inputs zero, by a derivation that shares nothing with the double kernels:
/// Lagrange's operator on T from positions, evaluated in CLN, a dense solve with the constraints, an extrapolation
/// integrator run at two orders.
struct ReferenceResult {
  /// CSV: comment lines, `time,<q>…,<q>'…`, one row per time. Of each number those digits that both runs share, as many as
  /// asked for at most; a number smaller than what they agree on is 0. A time at which they share no digit has no row.
  std::string text;
  /// A sentence for each time at which fewer digits converged than were asked for, |y| < 1 counting as 1; the comment
  /// lines hold them too. Empty when all is as it was asked for.
  std::vector<std::string> shortfalls;
};
/// Throws Error when not even the first time is reached.
ReferenceResult integrate_reference(const Scene& scene, const ReferenceOptions& options);

/// The text of a motion that converged to the digits asked for. Throws Error when one did not.
std::string reference_csv(const Scene& scene, const ReferenceOptions& options);

}  // namespace torsor
