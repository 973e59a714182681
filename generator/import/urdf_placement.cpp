// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/import/urdf_placement.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "torsor/generator/base/high_precision.hpp"
#include "torsor/generator/import/exact_rotation.hpp"

namespace torsor {
namespace {

/// Beyond this [rad] an angle was not meant to be a multiple of π/12.
const Number& suspicious() {
  static const Number angle = Number::rational(1, 10000);
  return angle;
}

/// 2π, with room for who writes it in few digits [rad].
const Number& whole_turn() {
  static const Number angle = Number::rational(63, 10);
  return angle;
}

/// "0", "pi/2", "-5 pi/12": k π/12.
std::string twelfths_text(const Number& k) {
  if (k.is_zero()) return "0";
  const Number part = k / Number(12);
  const std::string exact = part.abs().to_string();  // "1/2", "5/12", "1"
  const std::size_t slash = exact.find('/');
  const std::string numerator = exact.substr(0, slash);
  return (k.sign() < 0 ? "-" : "") + (numerator == "1" ? std::string() : numerator + " ") + "pi" +
         (slash == std::string::npos ? "" : exact.substr(slash));
}

/// |angle − k π/12|, of a small difference.
double distance_from_twelfths(const Number& angle, const Number& k) {
  constexpr int digits = 80;
  return std::abs((Real(angle, digits) - Real(k / Number(12), digits) * Real::pi(digits)).to_double());
}

/// The sine of the angle, of nearly equal directions.
double angle_between(const std::array<Number, 3>& given, const std::array<Number, 3>& exact) {
  double sine = 0, size = 0, unit = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    sine = std::hypot(sine, (given[j] * exact[k] - given[k] * exact[j]).to_double());
    size = std::hypot(size, given[i].to_double());
    unit = std::hypot(unit, exact[i].to_double());
  }
  return sine / (size * unit);
}

void require_angle(const XmlElement& element, const Number& angle) {
  if (angle.abs() > Number(1000000)) element.fail("an angle is beyond 10^6; give angles in radians");
}

}  // namespace

void UrdfPlacements::report(const XmlNumber& angle, const std::optional<Number>& twelfths,
                            const std::string& where) const {
  if (angle.value.is_zero()) return;
  if (twelfths) return robot_.changes.add(angle.text + " is " + twelfths_text(*twelfths), where);
  if (const auto near = twelfths_of_pi(angle.value, suspicious())) {
    robot_.almost.push_back(
        fmt::format("{} in {} is near {} but beyond the tolerance: sines and cosines that would "
                    "vanish do not; a larger --angle-tolerance takes it as that",
                    angle.text, where, twelfths_text(*near)));
  }
}

void UrdfPlacements::record(const std::string& where, double size, double moves) const {
  if (size > 0) robot_.exact_angles.push_back({where, size, moves});
}

std::optional<Number> UrdfPlacements::twelfths(const XmlElement& element, const XmlNumber& angle,
                                               const std::string& where) const {
  require_angle(element, angle.value);
  const std::optional<Number> k = twelfths_of_pi(angle.value, tolerance_);
  report(angle, k, where);
  if (k) {
    const double size = distance_from_twelfths(angle.value, *k);
    record(where, size, size);
  }
  return k;
}

UrdfPlacement UrdfPlacements::placement(const XmlElement& origin, const std::string& where) const {
  UrdfPlacement place;
  if (origin.has("xyz")) {
    const auto xyz = origin.numbers<3>("xyz");
    for (std::size_t i = 0; i < 3; ++i) place.xyz[i] = xyz[i].value;
  }
  if (origin.has("quat_xyzw")) {
    if (origin.has("rpy")) origin.fail("has both rpy and quat_xyzw, which say the same thing twice; keep one");
    place.rotation = by_quaternion(origin);
    return place;
  }
  if (!origin.has("rpy")) return place;
  const auto rpy = origin.numbers<3>("rpy");
  const bool beyond = std::any_of(rpy.begin(), rpy.end(), [](const XmlNumber& n) { return n.value.abs() > whole_turn(); });
  if (beyond) {
    robot_.notes.add("an angle of rpy is beyond a turn, which suggests degrees, and is taken in rad", where, origin.place(),
                     ReadingNotes::Parts::each);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    require_angle(origin, rpy[i].value);
    const ExactAngle angle = exact_angle(rpy[i].value, tolerance_);
    report(rpy[i], angle.twelfths, where + " (rpy)");
    if (angle.twelfths) {
      const double size = distance_from_twelfths(rpy[i].value, *angle.twelfths);
      record(where, size, size);
    }
    place.rotation = rotation_about(static_cast<int>(i), angle) * place.rotation;
  }
  return place;
}

Rotation UrdfPlacements::by_quaternion(const XmlElement& origin) {
  const auto e = origin.numbers<4>("quat_xyzw");
  if (std::all_of(e.begin(), e.end(), [](const XmlNumber& n) { return n.value.is_zero(); })) {
    origin.fail("quat_xyzw is the null quaternion, which is no orientation; write 0 0 0 1 for none");
  }
  return quaternion_rotation({e[3].value, e[0].value, e[1].value, e[2].value});
}

std::array<Number, 3> UrdfPlacements::direction(const XmlElement& axis, const std::string& where) const {
  const auto xyz = axis.numbers<3>("xyz");
  const std::array<Number, 3> given{xyz[0].value, xyz[1].value, xyz[2].value};
  if (std::all_of(given.begin(), given.end(), [](const Number& n) { return n.is_zero(); })) {
    axis.fail("xyz is the null vector; give the direction of the joint, e.g. xyz=\"0 0 1\"");
  }
  const ExactDirection exact = exact_direction(given, tolerance_);
  if (exact.changed) {
    const auto& n = exact.components;
    robot_.changes.add(fmt::format("{} {} {} is ({}, {}, {})", xyz[0].text, xyz[1].text, xyz[2].text, n[0].to_string(),
                                   n[1].to_string(), n[2].to_string()),
                       where + " (axis)");
    const double size = angle_between(given, n);
    record(where, size, 2 * size);
  }
  return exact.components;
}

}  // namespace torsor
