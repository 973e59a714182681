// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/mechanics/inertia_symmetry.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/mechanics/triple_algebra.hpp"
#include "torsor/generator/program/identically_zero.hpp"

namespace torsor {
namespace {

/// The entries of a body named from one of its axes: x that axis, y and z those that follow.
struct Seen {
  Seen(Inertia& body, int axis) {
    if (axis < 0 || axis > 2) {
      throw SceneError(fmt::format("axis {} of an inertia does not exist: use 0, 1 or 2 for x, y or z", axis));
    }
    Expression* const moments[3] = {&body.xx, &body.yy, &body.zz};
    Expression* const products[3] = {&body.yz, &body.xz, &body.xy};  // by the axis that is not named
    const auto i = static_cast<std::size_t>(axis);
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    yy = moments[j];
    zz = moments[k];
    xy = products[k];
    xz = products[j];
    yz = products[i];
    x = &body.center[i];
    y = &body.center[j];
    z = &body.center[k];
  }
  Expression *yy, *zz, *xy, *xz, *yz, *x, *y, *z;
};

bool all_identically_zero(const std::vector<Expression>& formulas) {
  Program program;
  return std::all_of(formulas.begin(), formulas.end(),
                     [&program](const Expression& formula) { return identically_zero(program.lower(formula)); });
}

}  // namespace

bool allows(const Inertia& body, MaterialSymmetry symmetry, int axis) {
  Inertia copy = body;
  const Seen seen(copy, axis);
  std::vector<Expression> zeros{*seen.xy, *seen.xz};
  if (symmetry == MaterialSymmetry::plane) {
    zeros.push_back(*seen.x);
  } else {
    zeros.push_back(*seen.y);
    zeros.push_back(*seen.z);
  }
  if (symmetry == MaterialSymmetry::revolution) {
    zeros.push_back(*seen.yz);
    zeros.push_back(difference(*seen.yy, *seen.zz));
  }
  return all_identically_zero(zeros);
}

Inertia with_symmetry(const Inertia& body, MaterialSymmetry symmetry, int axis) {
  Inertia settled = body;
  const Seen seen(settled, axis);
  *seen.xy = 0;
  *seen.xz = 0;
  if (symmetry == MaterialSymmetry::plane) {
    *seen.x = 0;
  } else {
    *seen.y = 0;
    *seen.z = 0;
  }
  if (symmetry == MaterialSymmetry::revolution) {
    *seen.yz = 0;
    *seen.zz = *seen.yy;
  }
  return settled;
}

bool is_spherical(const Inertia& body) {
  return all_identically_zero({body.xy, body.xz, body.yz, difference(body.xx, body.yy), difference(body.yy, body.zz)});
}

bool is_of_revolution(const Inertia& body, int axis) {
  return allows(body.at({0, 0, 0}), MaterialSymmetry::revolution, axis);
}

bool is_principal(const Inertia& body, int axis) { return allows(body.at({0, 0, 0}), MaterialSymmetry::plane, axis); }

}  // namespace torsor
