// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/dynamics/equations/scene_checks.hpp"
#include "torsor/generator/mechanics/parameter_value.hpp"
#include "torsor/generator/program/evaluation.hpp"
#include "torsor/generator/program/identically_zero.hpp"

namespace torsor {
namespace {

constexpr int directions = 48;

/// Directions spread evenly over the sphere: a spiral that turns by the golden angle.
std::array<double, 3> direction(int k) {
  const double along = 1 - (2 * k + 1.0) / directions, across = std::sqrt(1 - along * along);
  const double angle = k * std::acos(-1.0) * (3 - std::sqrt(5.0));
  return {across * std::cos(angle), across * std::sin(angle), along};
}

/// The smaller principal radius of curvature where u is normal: of the derivatives of second order of h at a unit vector,
/// one eigenvalue is 0, along u, and the others are these radii.
double least_radius(const std::array<std::array<double, 3>, 3>& second) {
  const double sum = second[0][0] + second[1][1] + second[2][2];
  double product = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    product += second[i][i] * second[j][j] - second[i][j] * second[j][i];
  }
  return sum / 2 - std::sqrt(std::max(0.0, sum * sum / 4 - product));
}

std::string written(const PointContent& point) { return point.contact.empty() ? "'" + point.name + "'" : name_of(point); }

bool has_values(const SceneContent& scene) {
  return std::all_of(scene.parameters.begin(), scene.parameters.end(), [](const auto& p) { return p.value.has_value(); });
}

void check_convex(const Model& model, const PointContent& point, const Value& h, const std::vector<Value>& slopes) {
  const SupportFunction& support = *point.lowest->support;
  Program& program = model.program();
  std::vector<Value> second;
  for (const Value& slope : slopes) {
    for (const SymbolPointer& u : support.direction) second.push_back(partial_derivation(program, u)(slope));
  }
  Evaluator<Real> evaluate(program, {});
  for (int k = 0; k < directions; ++k) {
    const std::array<double, 3> u = direction(k);
    evaluate.move_to([&](const SymbolPointer& symbol) {
      if (symbol->kind == SymbolKind::pi) return Real::pi();
      for (std::size_t i = 0; i < 3; ++i) {
        if (support.direction[i] == symbol) return Real::from_double(u[i]);
      }
      return parameter_value(model.scene(), symbol);
    });
    std::array<std::array<double, 3>, 3> matrix{};
    for (std::size_t i = 0; i < 9; ++i) matrix[i / 3][i % 3] = evaluate(second[i]).to_double();
    const double radius = least_radius(matrix), size = std::abs(evaluate(h).to_double());
    // Directions are rounded to doubles; what has no curvature there, such as a flat face, is no number.
    if (!(radius < -1e-9 * size)) continue;
    throw SceneError(fmt::format("the body of {} is not convex: where ({:.3g}, {:.3g}, {:.3g}) is normal to it, its "
                                 "support function has a radius of curvature of {:.6g} m; give max u · CP over its points",
                                 written(point), u[0], u[1], u[2], radius));
  }
}

}  // namespace

void check_support_functions(const Model& model) {
  Program& program = model.program();
  for (const PointContent& point : model.scene().points) {
    if (!point.lowest || !point.lowest->support) continue;
    const SupportFunction& support = *point.lowest->support;
    const std::string user = "the support function of " + written(point);
    const Value h = program.bind(program.lower(support.h));
    if (program.stage(h) > Stage::parameters) {
      throw SceneError(fmt::format("{} depends on more than a direction and parameters: a body keeps its shape", user));
    }
    std::vector<Value> slopes;
    Value difference = -h;
    for (const SymbolPointer& u : support.direction) {
      slopes.push_back(program.bind(partial_derivation(program, u)(h)));
      const Value product = program.symbol(u) * slopes.back();
      difference += Value(program, product.polynomial(), h.unit());
    }
    if (!identically_zero(difference)) {  // Euler's theorem
      throw SceneError(fmt::format("{} is not homogeneous of degree 1: it must grow with its argument, h(k u) = k h(u) for "
                                   "k > 0; multiply by the length of u where that is missing",
                                   user));
    }
    if (has_values(model.scene())) check_convex(model, point, h, slopes);
  }
}

}  // namespace torsor
