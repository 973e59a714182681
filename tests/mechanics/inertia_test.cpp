// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/mechanics/inertia.hpp"

#include <gtest/gtest.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/program/evaluation.hpp"
#include "tests/mechanics/gauss_quadrature.hpp"

namespace torsor::inertia_test {
namespace {

using namespace testing_quadrature;
using Points = std::vector<MassPoint>;

constexpr double mass = 2.5;
constexpr double radius = 0.7;
constexpr double length = 1.3;

Expression quantity(double value, const char* unit) {
  return Expression::quantity(std::to_string(value), unit);  // six decimals suffice for the numbers used here
}

std::array<double, 6> operator_of(const Inertia& inertia) {
  Program program;
  Evaluator<double> evaluate(program, {});
  const auto value = [&](const Expression& entry) { return evaluate(program.lower(entry)); };
  return {value(inertia.xx), value(inertia.yy), value(inertia.zz),
          value(inertia.xy), value(inertia.xz), value(inertia.yz)};
}

/// Places (a, b, c) with c along the axis and a, b along the two that follow it.
std::array<double, 3> along(int axis, double a, double b, double c) {
  std::array<double, 3> place{};
  place[static_cast<std::size_t>(axis)] = c;
  place[static_cast<std::size_t>((axis + 1) % 3)] = a;
  place[static_cast<std::size_t>((axis + 2) % 3)] = b;
  return place;
}

/// Points of a circle, for a trapezoidal rule that is exact for the squares of coordinates.
std::vector<std::pair<double, double>> circle() {
  std::vector<std::pair<double, double>> rule;
  const double pi = std::acos(-1.0);
  for (int k = 0; k < 12; ++k) rule.emplace_back(2 * pi * k / 12, 2 * pi / 12);
  return rule;
}

/// Scales the masses of points of equal density to `mass` in all.
Points of_mass(Points points) {
  const double sum = total_mass(points);
  for (MassPoint& point : points) point.mass *= mass / sum;
  return points;
}

/// The rules are exact for these polynomials, so that only some 10³ roundings remain.
void expect_inertia(const Inertia& inertia, const Points& points) {
  const std::array<double, 6> given = operator_of(inertia);
  const std::array<double, 6> integrated = inertia_about_origin(of_mass(points));
  for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(given[k], integrated[k], 1e-13) << "entry " << k;
}

const Expression m = quantity(mass, "kg");
const Expression r = quantity(radius, "m");
const Expression l = quantity(length, "m");

TEST(InertiaCatalogue, IntegratesARod) {
  for (int axis = 0; axis < 3; ++axis) {
    Points points;
    for (const auto& [z, w] : gauss_legendre(20, -length / 2, length / 2)) points.push_back({w, along(axis, 0, 0, z)});
    expect_inertia(Inertia::rod(m, l, axis), points);
  }
}

TEST(InertiaCatalogue, IntegratesADiskARingAndACylinder) {
  for (int axis = 0; axis < 3; ++axis) {
    Points disk, ring, cylinder;
    for (const auto& [angle, w] : circle()) {
      ring.push_back({w, along(axis, radius * std::cos(angle), radius * std::sin(angle), 0)});
      for (const auto& [rho, v] : gauss_legendre(20, 0, radius)) {
        const double x = rho * std::cos(angle);
        const double y = rho * std::sin(angle);
        disk.push_back({w * v * rho, along(axis, x, y, 0)});
        for (const auto& [z, u] : gauss_legendre(20, -length / 2, length / 2)) {
          cylinder.push_back({w * v * rho * u, along(axis, x, y, z)});
        }
      }
    }
    expect_inertia(Inertia::ring(m, r, axis), ring);
    expect_inertia(Inertia::disk(m, r, axis), disk);
    expect_inertia(Inertia::cylinder(m, r, l, axis), cylinder);
  }
}

TEST(InertiaCatalogue, IntegratesASolidAndAHollowSphere) {
  Points shell, solid;
  for (const auto& [angle, w] : circle()) {
    for (const auto& [cosine, v] : gauss_legendre(20, -1, 1)) {
      const double sine = std::sqrt(1 - cosine * cosine);
      const auto place = [&, c = cosine, a = angle](double rho) {
        return std::array<double, 3>{rho * sine * std::cos(a), rho * sine * std::sin(a), rho * c};
      };
      shell.push_back({w * v, place(radius)});
      for (const auto& [rho, u] : gauss_legendre(20, 0, radius)) solid.push_back({w * v * u * rho * rho, place(rho)});
    }
  }
  expect_inertia(Inertia::hollow_sphere(m, r), shell);
  expect_inertia(Inertia::solid_sphere(m, r), solid);
}

TEST(InertiaCatalogue, IntegratesABoxAndAPlate) {
  Points box, plate;
  for (const auto& [x, u] : gauss_legendre(20, -0.3, 0.3)) {
    for (const auto& [y, v] : gauss_legendre(20, -0.45, 0.45)) {
      plate.push_back({u * v, {x, y, 0}});
      for (const auto& [z, w] : gauss_legendre(20, -0.65, 0.65)) box.push_back({u * v * w, {x, y, z}});
    }
  }
  const Expression a = quantity(0.6, "m");
  const Expression b = quantity(0.9, "m");
  expect_inertia(Inertia::box(m, a, b, l), box);
  expect_inertia(Inertia::plate(m, a, b), plate);
}

TEST(InertiaCatalogue, HasUnitsOfInertiaAndItsCentreAtTheOrigin) {
  for (const Inertia& inertia : {Inertia::point(m), Inertia::rod(m, l, 0), Inertia::cylinder(m, r, l, 2)}) {
    for (const Expression* entry : {&inertia.xx, &inertia.yy, &inertia.zz, &inertia.xy}) {
      EXPECT_TRUE(entry->is_zero() || entry->unit() == units::kilogram_metre_squared);
    }
    for (const Expression& component : inertia.center) EXPECT_TRUE(component.is_zero());
  }
  EXPECT_EQ(operator_of(Inertia::point(m)), (std::array<double, 6>{}));
}

TEST(InertiaCatalogue, NamesAnAxisThatDoesNotExist) {
  try {
    Inertia::disk(m, r, 3);
    FAIL();
  } catch (const SceneError& error) {
    EXPECT_STREQ(error.what(), "axis 3 of an inertia does not exist: use 0, 1 or 2 for x, y or z");
  }
}

TEST(InertiaCatalogue, MovesWithoutTurning) {
  const Inertia moved = Inertia::box(m, r, l, l).at({l, 0, -r});
  EXPECT_EQ(operator_of(moved), operator_of(Inertia::box(m, r, l, l)));
  EXPECT_EQ(moved.center[0].to_string(), l.to_string());
}

}  // namespace
}  // namespace torsor::inertia_test
