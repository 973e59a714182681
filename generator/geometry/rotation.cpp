// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/geometry/rotation.hpp"

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/geometry/triple.hpp"

namespace torsor {

Triple operator-(const Triple& v) { return {-v[0], -v[1], -v[2]}; }

Rotation::Rotation() {
  for (std::size_t i = 0; i < 3; ++i) entries_[4 * i] = Number(1);
}

Rotation Rotation::matrix(const std::array<Number, 9>& row_major) {
  Rotation rotation;
  rotation.entries_ = row_major;
  const Rotation product = rotation.transpose() * rotation;
  const Rotation& r = rotation;
  const Number determinant = r(0, 0) * (r(1, 1) * r(2, 2) - r(1, 2) * r(2, 1)) -
                             r(0, 1) * (r(1, 0) * r(2, 2) - r(1, 2) * r(2, 0)) +
                             r(0, 2) * (r(1, 0) * r(2, 1) - r(1, 1) * r(2, 0));
  if (!product.is_identity() || !determinant.is_one()) {
    throw SceneError(fmt::format("the matrix with first row ({}, {}, {}) is not a rotation: its columns must be "
                                 "orthonormal and its determinant 1, exactly",
                                 r(0, 0).to_string(), r(0, 1).to_string(), r(0, 2).to_string()));
  }
  return rotation;
}

Rotation Rotation::about(int axis, int twelfths_of_pi) {
  if (axis < 0 || axis > 2) {
    throw SceneError(fmt::format("there is no axis {} to rotate about: give 0, 1 or 2 for x, y or z", axis));
  }
  const auto [sine, cosine] = *sin_cos_of_pi_twelfths(Number(twelfths_of_pi));
  Rotation rotation;
  const auto at = [&rotation](int row, int column) -> Number& {
    return rotation.entries_[static_cast<std::size_t>(3 * row + column)];
  };
  const int a = (axis + 1) % 3;
  const int b = (axis + 2) % 3;
  at(a, a) = cosine;
  at(a, b) = -sine;
  at(b, a) = sine;
  at(b, b) = cosine;
  return rotation;
}

bool Rotation::is_identity() const {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (!((*this)(i, j) == Number(i == j ? 1 : 0))) return false;
    }
  }
  return true;
}

Rotation Rotation::transpose() const {
  Rotation result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) result.entries_[3 * i + j] = entries_[3 * j + i];
  }
  return result;
}

Rotation operator*(const Rotation& a, const Rotation& b) {
  Rotation result;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      Number sum;
      for (int k = 0; k < 3; ++k) sum += a(i, k) * b(k, j);
      result.entries_[static_cast<std::size_t>(3 * i + j)] = sum;
    }
  }
  return result;
}

}  // namespace torsor
