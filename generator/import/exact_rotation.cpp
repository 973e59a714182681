// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/import/exact_rotation.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "torsor/generator/base/decimal.hpp"
#include "torsor/generator/import/exact_direction.hpp"

namespace torsor {
namespace {

using Sequence = std::array<int, 3>;

constexpr std::array<Sequence, 12> sequences{{{2, 1, 0},
                                              {0, 1, 2},
                                              {0, 2, 1},
                                              {1, 0, 2},
                                              {1, 2, 0},
                                              {2, 0, 1},
                                              {2, 0, 2},
                                              {2, 1, 2},
                                              {0, 1, 0},
                                              {0, 2, 0},
                                              {1, 0, 1},
                                              {1, 2, 1}}};

/// A turn that was found: its angle as a multiple of π/12 where it is one.
struct PlaneTurn {
  int axis = 0;
  ExactAngle angle;
};

/// The turn whose cosine and sine are these up to a positive factor; none at all when both are within the tolerance of
/// 0.
PlaneTurn turn(int axis, const Number& cosine, const Number& sine, const Number& tolerance) {
  if (cosine.abs() <= tolerance && sine.abs() <= tolerance) return {axis, {Number(0), Number(1), Number(0)}};
  const ExactDirection direction = exact_direction({cosine, sine, Number()}, tolerance);
  const Number& c = direction.components[0];
  const Number& s = direction.components[1];
  for (int k = 0; k < 24; ++k) {
    const auto exact = sin_cos_of_pi_twelfths(Number(k > 12 ? k - 24 : k));
    if (exact->first == s && exact->second == c) return {axis, {s, c, Number(k > 12 ? k - 24 : k)}};
  }
  return {axis, {s, c, std::nullopt}};
}

/// +1 when axes i, j, k follow one another cyclically.
int handedness(int i, int j) { return (i + 1) % 3 == j ? 1 : -1; }

/// R = R_i(α) R_j(β) R_k(γ), turn by turn from the left; each is exact before the next is looked for.
std::array<PlaneTurn, 3> turns(const Rotation& r, const Sequence& axes, const Number& tolerance) {
  const auto [i, j, k] = axes;
  const int other = 3 - i - j;
  const Number sign(handedness(i, j));
  // R_j(β) e_k leaves e_k towards e_i (three axes) or e_i towards the third (i = k); R_i(α) turns the rest of it.
  const PlaneTurn first =
      i != k ? turn(i, r(k, k), -sign * r(j, k), tolerance) : turn(i, -sign * r(other, i), r(j, i), tolerance);
  const Rotation without_first = rotation_about(i, first.angle).transpose() * r;
  const int a = (j + 1) % 3, b = (j + 2) % 3;
  const PlaneTurn second = k == a ? turn(j, without_first(a, k), without_first(b, k), tolerance)
                             : turn(j, without_first(b, k), -without_first(a, k), tolerance);
  const Rotation last = rotation_about(j, second.angle).transpose() * without_first;
  const int c = (k + 1) % 3, d = (k + 2) % 3;
  const PlaneTurn third = turn(k, last(c, c), last(d, c), tolerance);
  return {first, second, third};
}

/// Whether any of the three angles may be near a multiple of π/12, judged in doubles: most quaternions have none, and
/// exact turns take long.
bool worth_a_look(const std::array<double, 9>& r, const Sequence& axes, double slack) {
  const auto [i, j, k] = axes;
  const int other = 3 - i - j;
  const double sign = handedness(i, j);
  const auto at = [&r](int row, int column) { return r[static_cast<std::size_t>(3 * row + column)]; };
  const auto near = [slack](double sine, double cosine) {
    const double size = std::hypot(sine, cosine);
    const double twelfths = std::atan2(sine, cosine) / (std::acos(-1.0) / 12);
    return size < 1e-3 || std::abs(twelfths - std::round(twelfths)) * 0.27 < slack / size;
  };
  if (i != k) {
    return near(-sign * at(j, k), at(k, k)) || near(sign * at(i, k), std::hypot(at(k, k), at(j, k))) ||
           near(-sign * at(i, j), at(i, i));
  }
  return near(at(j, i), -sign * at(other, i)) || near(std::hypot(at(j, i), at(other, i)), at(i, i)) ||
         near(at(i, j), sign * at(i, other));
}

bool same(const Rotation& a, const Rotation& b, const Number& tolerance) {
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      if ((a(row, column) - b(row, column)).abs() > tolerance) return false;
    }
  }
  return true;
}

std::string angle_text(const ExactAngle& angle) {
  if (!angle.twelfths) {
    return fmt::format("{:.6g}", std::atan2(angle.sine.to_double(), angle.cosine.to_double()));
  }
  const std::string exact = (*angle.twelfths / Number(12)).abs().to_string();
  const std::size_t slash = exact.find('/');
  const std::string numerator = exact.substr(0, slash);
  return (angle.twelfths->sign() < 0 ? "-" : "") + (numerator == "1" ? std::string() : numerator + " ") + "pi" +
         (slash == std::string::npos ? "" : exact.substr(slash));
}

std::string text_of(const std::array<PlaneTurn, 3>& all) {
  std::string text;
  for (const PlaneTurn& each : all) {
    if (each.angle.twelfths && each.angle.twelfths->is_zero()) continue;
    text += fmt::format("{}R{}({})", text.empty() ? "" : " ", "xyz"[each.axis], angle_text(each.angle));
  }
  return text.empty() ? "no turn" : text;
}

}  // namespace

Rotation quaternion_rotation(const std::array<Number, 4>& quaternion) {
  const auto& [w, x, y, z] = quaternion;
  const Number square = w * w + x * x + y * y + z * z;
  const Number two = Number(2) / square;
  return Rotation::matrix({Number(1) - two * (y * y + z * z), two * (x * y - w * z), two * (x * z + w * y),
                           two * (x * y + w * z), Number(1) - two * (x * x + z * z), two * (y * z - w * x),
                           two * (x * z - w * y), two * (y * z + w * x), Number(1) - two * (x * x + y * y)});
}

ExactRotation exact_rotation(const std::array<Number, 4>& quaternion, const Number& tolerance) {
  const Rotation as_given = quaternion_rotation(quaternion);
  ExactRotation best{as_given, {}};
  int most = 0;
  std::array<double, 9> rounded{};
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      rounded[static_cast<std::size_t>(3 * row + column)] = as_given(row, column).to_double();
    }
  }
  const double slack = 10 * tolerance.to_double() + 1e-12;
  for (const Sequence& axes : sequences) {
    if (!worth_a_look(rounded, axes, slack)) continue;
    const std::array<PlaneTurn, 3> found = turns(as_given, axes, tolerance);
    const auto exact =
        std::count_if(found.begin(), found.end(), [](const PlaneTurn& t) { return t.angle.twelfths.has_value(); });
    if (exact <= most) continue;
    const Rotation product = rotation_about(axes[0], found[0].angle) * rotation_about(axes[1], found[1].angle) *
                             rotation_about(axes[2], found[2].angle);
    // Each angle moves by the tolerance at most, twice where the axes of two turns coincide.
    if (!same(product, as_given, Number(6) * tolerance)) continue;
    most = static_cast<int>(exact);
    best.rotation = product;
    best.taken_for = same(product, as_given, Number()) ? std::string() : text_of(found);
    if (most == 3) break;
  }
  return best;
}

}  // namespace torsor
