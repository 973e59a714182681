// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/mechanics/inertia_operations.hpp"

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/mechanics/triple_algebra.hpp"
#include "torsor/generator/program/identically_zero.hpp"

namespace torsor {
namespace {

bool cancels(const Expression& formula) {
  Program program;
  return identically_zero(program.lower(formula));
}

}  // namespace

InertiaOperator operator_about(const Inertia& body, const Triple& point) {
  const Tableau j = operator_of_point(body.mass, body.center - point);
  return {body.xx + j[0][0], body.yy + j[1][1], body.zz + j[2][2],
          body.xy + j[0][1], body.xz + j[0][2], body.yz + j[1][2]};
}

Inertia from_operator_about(const Expression& mass, const Triple& center, const Triple& point,
                            const InertiaOperator& about_point) {
  const Tableau j = operator_of_point(mass, center - point);
  const InertiaOperator& given = about_point;
  return {mass,
          center,
          difference(given.xx, j[0][0]),
          difference(given.yy, j[1][1]),
          difference(given.zz, j[2][2]),
          difference(given.xy, j[0][1]),
          difference(given.xz, j[0][2]),
          difference(given.yz, j[1][2])};
}

Inertia operator-(const Inertia& body) {
  return {-body.mass, body.center, -body.xx, -body.yy, -body.zz, -body.xy, -body.xz, -body.yz, body.sizes};
}

Inertia operator+(const Inertia& a, const Inertia& b) {
  Inertia sum{a.mass + b.mass, a.center, a.xx + b.xx, a.yy + b.yy, a.zz + b.zz, a.xy + b.xy, a.xz + b.xz, a.yz + b.yz, a.sizes};
  sum.sizes.insert(sum.sizes.end(), b.sizes.begin(), b.sizes.end());
  if (b.mass.is_zero()) return sum;
  if (a.mass.is_zero()) {
    sum.center = b.center;
    return sum;
  }
  if (cancels(sum.mass)) {
    throw SceneError(
        fmt::format("the masses {} and {} of an assembly cancel: it has no centre of mass; a hole must be "
                    "lighter than what it is cut from",
                    a.mass.to_string(), b.mass.to_string()));
  }
  const Triple d = b.center - a.center;
  const Expression share = b.mass / sum.mass;
  sum.center = a.center + share * d;
  const Tableau j = operator_of_point(a.mass * share, d);
  sum.xx = sum.xx + j[0][0];
  sum.yy = sum.yy + j[1][1];
  sum.zz = sum.zz + j[2][2];
  sum.xy = sum.xy + j[0][1];
  sum.xz = sum.xz + j[0][2];
  sum.yz = sum.yz + j[1][2];
  return sum;
}

Inertia operator-(const Inertia& a, const Inertia& b) { return a + -b; }

Inertia assembly(const std::vector<Inertia>& parts) {
  if (parts.empty()) throw SceneError("an assembly of no bodies has no inertia: give at least one");
  Inertia sum = parts.front();
  for (std::size_t k = 1; k < parts.size(); ++k) sum = sum + parts[k];
  return sum;
}

}  // namespace torsor
