// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/mechanics/central_axis.hpp"

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"

namespace torsor {

CentralAxis central_axis(const Vector& resultant, const Vector& moment, const std::string& name) {
  if (identically_zero(resultant)) {
    throw SceneError(
        fmt::format("the screw '{}' has no central axis: its resultant vanishes identically, it is a couple "
                    "(the same moment at every point)",
                    name));
  }
  const Value square = dot(resultant, resultant);
  const Value inverse = pow(square, -1);
  CentralAxis axis;
  axis.ah = inverse * cross(resultant, moment);
  axis.pitch = inverse * dot(resultant, moment);
  const Value norm = square.program()->sqrt(square);
  axis.direction = pow(norm, -1) * resultant;
  return axis;
}

}  // namespace torsor
