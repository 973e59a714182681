// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "torsor/generator/mechanics/screw.hpp"

namespace torsor {

/// The line of the points where a screw's moment is along its resultant, and smallest.
struct CentralAxis {
  Vector ah;         ///< AH = R ∧ M_A / R²: its point nearest to the reduction point A [m]
  Vector direction;  ///< R / |R|
  Value pitch;       ///< R·M_A / R²: the moment on the axis is pitch · R [m]
};

/// Central axis of the screw {resultant, moment at A} (Pommier, Dynamique des systèmes de solides, §2.2.1), in the
/// screw's axes. Throws SceneError naming the screw when the resultant vanishes identically: a couple has no axis.
CentralAxis central_axis(const Vector& resultant, const Vector& moment, const std::string& name);

template <class Kind>
CentralAxis central_axis(const Screw<Kind>& screw, const std::string& name) {
  return central_axis(resultant_of(screw), moment_of(screw), name);
}

/// A screw as a sum of two, both reduced where the screw was.
template <class Kind>
struct ScrewParts {
  Screw<Kind> couple;   ///< without resultant
  Screw<Kind> sliding;  ///< the resultant as a sliding vector: its moment is orthogonal to it
};

/// {0, M_A} and {R, 0} at the reduction point A: the resultant slides through A. Always possible.
template <class Kind>
ScrewParts<Kind> split_at_point(const Screw<Kind>& screw) {
  return {{Vector(), moment_of(screw)}, {resultant_of(screw), Vector()}};
}

/// {0, pitch R} and {R, M_A − pitch R}: the resultant on the central axis and the smallest couple there is, along it.
/// Throws SceneError naming the screw when the resultant vanishes identically.
template <class Kind>
ScrewParts<Kind> split_on_central_axis(const Screw<Kind>& screw, const std::string& name) {
  const CentralAxis axis = central_axis(screw, name);
  const Vector couple = axis.pitch * resultant_of(screw);
  return {{Vector(), couple}, {resultant_of(screw), moment_of(screw) - couple}};
}

}  // namespace torsor
