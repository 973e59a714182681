// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/mechanics/inertia_validity.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/mechanics/parameter_value.hpp"
#include "torsor/generator/mechanics/size_bounds.hpp"

namespace torsor {
namespace {

using Symmetric = std::array<std::array<double, 3>, 3>;

std::array<const Expression*, 10> entries(const Inertia& body) {
  return {&body.mass, &body.center[0], &body.center[1], &body.center[2], &body.xx,
          &body.yy,   &body.zz,        &body.xy,        &body.xz,        &body.yz};
}

void check_constant(const SceneContent& scene, const BodyContent& body) {
  for (const Expression* entry : entries(body.inertia)) {
    const auto refuse = [&](const SymbolPointer& symbol) {
      if (!symbol || !entry->depends_on(symbol)) return;
      throw SceneError(
          fmt::format("the inertia of {} depends on '{}', which changes in time: {}", scene.name_of(body), symbol->name,
                      scene.is_rotor(body) ? "it is that of a rotor behind a gear of constant ratio"
                                           : "a body's mass and shape are constant in its frame; use a joint for what moves"));
    };
    refuse(scene.time);
    for (const CoordinateContent& c : scene.coordinates) {
      refuse(c.q);
      refuse(c.v);
      refuse(c.a);
    }
  }
}

/// Eigenvalues by Jacobi's rotations, in increasing order.
std::array<double, 3> principal_moments(Symmetric j) {
  for (int sweep = 0; sweep < 30; ++sweep) {
    for (std::size_t p = 0; p < 3; ++p) {
      const std::size_t q = (p + 1) % 3;
      if (j[p][q] == 0) continue;
      // The smaller of the angles that clear the entry: larger ones may go round in circles.
      const double angle = j[p][p] == j[q][q] ? std::atan(1.0) : 0.5 * std::atan(2 * j[p][q] / (j[q][q] - j[p][p]));
      const double c = std::cos(angle);
      const double s = std::sin(angle);
      for (std::size_t k = 0; k < 3; ++k) {  // columns p and q
        const double a = j[k][p];
        const double b = j[k][q];
        j[k][p] = c * a - s * b;
        j[k][q] = s * a + c * b;
      }
      for (std::size_t k = 0; k < 3; ++k) {  // rows p and q
        const double a = j[p][k];
        const double b = j[q][k];
        j[p][k] = c * a - s * b;
        j[q][k] = s * a + c * b;
      }
    }
  }
  std::array<double, 3> moments{j[0][0], j[1][1], j[2][2]};
  std::sort(moments.begin(), moments.end());
  return moments;
}

bool depends_on_unknown_parameter(const SceneContent& scene, const Expression& formula) {
  return std::any_of(scene.parameters.begin(), scene.parameters.end(), [&](const ParameterContent& parameter) {
    if (!formula.depends_on(parameter.symbol)) return false;
    return !parameter.value || depends_on_unknown_parameter(scene, *parameter.value);
  });
}

}  // namespace

void check_inertia(const SceneContent& scene, const BodyContent& body) {
  check_constant(scene, body);
  const Inertia& inertia = body.inertia;
  const auto known = [&](const Expression* entry) { return !depends_on_unknown_parameter(scene, *entry); };
  const auto value = [&](const Expression& entry) { return parameter_value(scene, entry).to_double(); };
  require_bounds(scene, {bound_of_mass(scene, body)});
  if (scene.is_rotor(body)) return;
  if (body.moments == Moments::as_read) return;
  const auto all = entries(inertia);
  if (!std::all_of(all.begin() + 4, all.end(), known)) return;
  const double xy = value(inertia.xy);
  const double xz = value(inertia.xz);
  const double yz = value(inertia.yz);
  const std::array<double, 3> moments =
      principal_moments({{{value(inertia.xx), xy, xz}, {xy, value(inertia.yy), yz}, {xz, yz, value(inertia.zz)}}});
  constexpr double figures = 1e-5;
  const double slack = figures * std::max(std::abs(moments[0]), std::abs(moments[2]));
  // In plane motion only one moment matters, and the others are often left out: zeros as written are not values.
  const bool complete = !inertia.xx.is_zero() && !inertia.yy.is_zero() && !inertia.zz.is_zero();
  const bool negative = moments[0] < -slack;
  const bool as_they_are = !complete || body.moments == Moments::as_given;
  if (!negative && (as_they_are || moments[0] + moments[1] >= moments[2] - slack)) return;
  throw SceneError(
      fmt::format("body '{}' has the principal moments of inertia {:.6g}, {:.6g} and {:.6g} kg m^2 about its "
                  "centre of mass: of no matter is one larger than the sum of the others, or negative; "
                  "check the entries, the sign of the products (xy = -int x y dm) and that the operator "
                  "is about the centre of mass",
                  body.name, moments[0], moments[1], moments[2]));
}

}  // namespace torsor
