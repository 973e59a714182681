// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/geometry/vector_division.hpp"

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/program/identically_zero.hpp"

namespace torsor {

VectorQuotient divide(const Vector& b, const Vector& a) {
  if (identically_zero(a)) {
    throw SceneError("A ∧ X = B: cannot divide by A, which is the null vector; every X gives 0");
  }
  const Value along = dot(a, b);
  if (!identically_zero(along)) {
    throw SceneError(
        fmt::format("A ∧ X = B has no solution: A·B = {} must vanish, since A ∧ X is orthogonal to A; take "
                    "the part of B along A away first",
                    to_string(along)));
  }
  const Value square = dot(a, a);
  const Vector turned = cross(b, a);
  return {pow(square, -1) * turned, a};
}

}  // namespace torsor
