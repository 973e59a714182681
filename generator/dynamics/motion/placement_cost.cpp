// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/motion/placement_cost.hpp"

#include <algorithm>
#include <cmath>

#include "torsor/generator/dynamics/motion/nominal_number.hpp"

namespace torsor {
namespace {

constexpr double negligible_entry = 1e-12;  ///< what roundings of the sums below leave of a zero

/// Mass, first moment and operator in doubles.
struct NominalInertia {
  double mass = 0;
  std::array<double, 3> h{};
  std::array<std::array<double, 3>, 3> j{};
};

std::optional<NominalInertia> nominal(const SceneContent& scene, const MassProperties& body) {
  NominalInertia result;
  bool all = true;
  const auto number = [&](const Value& value) {
    const std::optional<double> known = nominal_number(scene, value);
    all = all && known.has_value();
    return known.value_or(0);
  };
  result.mass = number(body.mass);
  for (int a = 0; a < 3; ++a) {
    const auto row = static_cast<std::size_t>(a);
    result.h[row] = number(body.first_moment[a]);
    for (int b = 0; b < 3; ++b) result.j[row][static_cast<std::size_t>(b)] = number(body.inertia(a, b));
  }
  if (!all) return std::nullopt;
  return result;
}

/// About another origin (generalised Huygens).
NominalInertia moved(NominalInertia body, const std::array<double, 3>& c) {
  const double along = c[0] * body.h[0] + c[1] * body.h[1] + c[2] * body.h[2];
  const double square = c[0] * c[0] + c[1] * c[1] + c[2] * c[2];
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t b = 0; b < 3; ++b) {
      body.j[a][b] += c[a] * body.h[b] + body.h[a] * c[b] - body.mass * c[a] * c[b];
      if (a == b) body.j[a][b] += body.mass * square - 2 * along;
    }
  }
  for (std::size_t a = 0; a < 3; ++a) body.h[a] -= body.mass * c[a];
  return body;
}

}  // namespace

int cost_of_turning(const Rotation& r) {
  const auto factors = plane_factors(r);
  if (factors && factors->size() == 2) return cost_of_turning(factors->front()) + cost_of_turning(factors->back());
  int cost = 0;
  for (int i = 0; i < 3; ++i) {
    int terms = 0;
    for (int j = 0; j < 3; ++j) {
      const Number& entry = r(i, j);
      if (entry.is_zero()) continue;
      ++terms;
      if (!entry.abs().is_one()) ++cost;
    }
    cost += terms - 1;
  }
  return cost;
}

int cost_of_shift(const ExactTurn& turn) {
  if (turn.cosine.is_zero() || turn.sine.is_zero()) return 0;
  for (int k = 1; k < 24; ++k) {
    const auto [sine, cosine] = *sin_cos_of_pi_twelfths(Number(k > 12 ? k - 24 : k));
    if (turn.cosine == cosine && turn.sine == sine) return 6;
  }
  return 1;
}

int inertia_entries(const SceneContent& scene, const MassProperties& body, const OtherFrame& frame) {
  const auto& [rotation, origin, axis] = frame;
  const std::optional<NominalInertia> given = nominal(scene, body);
  if (!given) return 0;
  const auto [mass, h, j] = moved(*given, {origin[0].to_double(), origin[1].to_double(), origin[2].to_double()});
  std::array<std::array<double, 3>, 3> r{};
  double size = 0;
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t b = 0; b < 3; ++b) {
      r[a][b] = rotation(static_cast<int>(a), static_cast<int>(b)).to_double();
      size = std::max(size, std::abs(j[a][b]));
    }
  }
  const double moment = std::abs(h[0]) + std::abs(h[1]) + std::abs(h[2]);
  int count = 0;
  for (std::size_t a = 0; a < 3; ++a) {
    double first = 0;
    for (std::size_t b = 0; b < 3; ++b) first += r[b][a] * h[b];
    if (static_cast<int>(a) != axis && std::abs(first) > negligible_entry * moment) count += 2;
    for (std::size_t b = 0; b < a; ++b) {
      double product = 0;
      for (std::size_t m = 0; m < 3; ++m) {
        for (std::size_t n = 0; n < 3; ++n) product += r[m][a] * j[m][n] * r[n][b];
      }
      if (std::abs(product) > negligible_entry * size) ++count;
    }
  }
  return count;
}

}  // namespace torsor
