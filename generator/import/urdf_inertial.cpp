// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/import/urdf_inertial.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "torsor/generator/import/urdf_vocabulary.hpp"

namespace torsor {
namespace {

using Moments3 = std::array<std::array<Number, 3>, 3>;

Number largest_entry(const Moments3& j) {
  Number largest;
  for (const auto& row : j) {
    for (const Number& entry : row) largest = std::max(largest, entry.abs());
  }
  return largest;
}

bool is_positive(const Moments3& j) {
  const Number two = j[0][0] * j[1][1] - j[0][1] * j[1][0];
  const Number three = j[0][0] * (j[1][1] * j[2][2] - j[1][2] * j[2][1]) -
                       j[0][1] * (j[1][0] * j[2][2] - j[1][2] * j[2][0]) +
                       j[0][2] * (j[1][0] * j[2][1] - j[1][1] * j[2][0]);
  return j[0][0].sign() > 0 && two.sign() > 0 && three.sign() > 0;
}

/// Whether matter can have these moments: ½ tr J − J = ∫ r rᵀ dm has no negative principal value, but for an error of 10⁻⁵
/// of the largest moment, since moments are given with some six figures. Then none of J is negative either.
bool is_of_matter(const Moments3& j) {
  const Number half_trace = (j[0][0] + j[1][1] + j[2][2]) / Number(2);
  const Number slack = largest_entry(j) * Number::rational(1, 100000);
  Moments3 second;
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t b = 0; b < 3; ++b) second[a][b] = (a == b ? half_trace + slack : Number()) - j[a][b];
  }
  return slack.is_zero() || is_positive(second);
}

Moments3 turned(const Moments3& j, const Rotation& r) {
  Moments3 result;
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b) {
      Number& sum = result[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)];
      for (int k = 0; k < 3; ++k) {
        for (int l = 0; l < 3; ++l) {
          sum += r(a, k) * j[static_cast<std::size_t>(k)][static_cast<std::size_t>(l)] * r(b, l);
        }
      }
    }
  }
  return result;
}

class InertialReader {
 public:
  InertialReader(const XmlElement& element, const std::string& link, const UrdfPlacements& placements, UrdfRobot& robot)
      : element_(element), where_("link " + link), placements_(placements), robot_(robot) {}

  UrdfInertial run() {
    check_vocabulary(element_, where_, robot_.notes);
    UrdfInertial inertial;
    inertial.place = element_.place();
    UrdfPlacement origin;
    if (const auto given = element_.child("origin")) {
      check_vocabulary(*given, where_, robot_.notes);
      origin = placements_.placement(*given, where_);
    }
    inertial.center = origin.xyz;
    for (const Number& component : origin.xyz) {
      if (component.abs() <= Number(10)) continue;
      note("a centre of mass is more than 10 m away, which suggests other units than m");
      break;
    }
    inertial.mass = mass();
    const Moments3 moments = read_moments(inertial.mass);
    judge(inertial.mass, moments);
    inertial.inertia = turned(moments, origin.rotation);
    return inertial;
  }

 private:
  Number mass() {
    const auto mass = element_.child("mass");
    if (!mass) return Number();
    check_vocabulary(*mass, where_, robot_.notes);
    const Number value = mass->number("value");
    if (value.sign() < 0 && value.abs() <= Number(10).pow(-12)) return zero(value, "mass");
    return value;
  }

  Number zero(const Number& value, const std::string& what) {
    robot_.changes.add(fmt::format("{} is 0", value.to_string()), fmt::format("{} ({})", where_, what));
    return Number();
  }

  Moments3 read_moments(const Number& mass) {
    const auto inertia = element_.child("inertia");
    if (!inertia) return {};
    check_vocabulary(*inertia, where_, robot_.notes);
    const auto product = [&](const char* name, const char* mirrored) {
      const Number value = inertia->optional_number(name).value_or(Number());
      check_mirrored(*inertia, name, value, mirrored);
      return value;
    };
    std::array<Number, 3> diagonal{inertia->number("ixx"), inertia->number("iyy"), inertia->number("izz")};
    const Number xy = product("ixy", "iyx"), xz = product("ixz", "izx"), yz = product("iyz", "izy");
    const Moments3 given{{{diagonal[0], xy, xz}, {xy, diagonal[1], yz}, {xz, yz, diagonal[2]}}};
    const Number rounding = std::max(largest_positive(given) * Number(10).pow(-12), mass * Number(10).pow(-14));
    Moments3 moments = given;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::array<const char*, 3> names{"ixx", "iyy", "izz"};
      if (given[i][i].sign() < 0 && given[i][i].abs() <= rounding) moments[i][i] = zero(given[i][i], names.at(i));
    }
    return moments;
  }

  /// Exporters write all nine entries of the matrix. Those below the diagonal are not read by URDF, and lose nothing
  /// where they repeat the others; zeros are what an exporter fills in that does not know them.
  void check_mirrored(const XmlElement& inertia, const char* name, const Number& value, const char* mirrored) {
    const std::optional<Number> below = inertia.optional_number(mirrored);
    if (!below || *below == value) return;
    if (!below->is_zero()) {
      const std::string other =
          inertia.has(name) ? fmt::format("{}=\"{}\"", name, inertia.value(name)) : fmt::format("no {}", name);
      inertia.fail(
          fmt::format("has {}=\"{}\" and {}, but a matrix of inertia is symmetric, and {} acts; correct one of them, "
                      "or remove {}",
                      mirrored, inertia.value(mirrored), other, name, mirrored));
    }
    robot_.notes.add("iyx, izx or izy of <inertia> is zero where ixy, ixz or iyz is not; the latter act", where_,
                     inertia.place());
  }

  static Number largest_positive(const Moments3& j) { return std::max({Number(), j[0][0], j[1][1], j[2][2]}); }

  void note(const std::string& kind) {
    robot_.notes.add(kind, where_, element_.place(), ReadingNotes::Parts::each);
  }

  void judge(const Number& mass, const Moments3& moments) {
    const Number largest = largest_entry(moments);
    if (!mass.is_zero() && largest.is_zero()) note("mass without moments of inertia is taken as a point");
    if (mass.is_zero() && !largest.is_zero()) note("moments of inertia without mass are taken as given");
    if (mass.sign() > 0 && largest > mass * Number(100)) {
      note("a radius of gyration is above 10 m, which suggests other units than kg m^2");
    }
    if (!is_of_matter(moments)) {
      note("moments of inertia that no matter has (one is negative, or larger than the sum of the others) are taken as "
           "given");
    }
  }

  const XmlElement& element_;
  std::string where_;
  const UrdfPlacements& placements_;
  UrdfRobot& robot_;
};

}  // namespace

UrdfInertial read_inertial(const XmlElement& element, const std::string& link, const UrdfPlacements& placements,
                           UrdfRobot& robot) {
  return InertialReader(element, link, placements, robot).run();
}

}  // namespace torsor
