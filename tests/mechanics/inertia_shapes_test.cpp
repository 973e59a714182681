// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/program/identically_zero.hpp"
#include "tests/mechanics/inertia_points.hpp"

namespace torsor::inertia_shapes_test {
namespace {

using namespace testing_quadrature;

constexpr double mass = 2.5;
constexpr double radius = 0.7;
constexpr double length = 1.3;
const Expression m = in_unit(mass, "kg");
const Expression r = in_unit(radius, "m");
const Expression h = in_unit(length, "m");
const double pi_double = std::acos(-1.0);

TEST(InertiaShapes, IntegrateASolidConeAndAConicalShell) {
  for (int axis = 0; axis < 3; ++axis) {
    Points solid, shell;
    for (const auto& [angle, w] : circle()) {
      for (const auto& [s, v] : gauss_legendre(20, 0, 1)) {  // s from the apex to the base
        const double wide = radius * s;
        const double height = (1 - s) * length;  // above the base
        shell.push_back({w * v * s, along(axis, wide * std::cos(angle), wide * std::sin(angle), height - length / 3)});
        for (const auto& [rho, u] : gauss_legendre(20, 0, wide)) {
          solid.push_back(
              {w * v * u * rho, along(axis, rho * std::cos(angle), rho * std::sin(angle), height - length / 4)});
        }
      }
    }
    expect_body(Inertia::cone(m, r, h, axis), of_mass(mass, solid));
    expect_body(Inertia::conical_shell(m, r, h, axis), of_mass(mass, shell));
  }
}

TEST(InertiaShapes, IntegrateAHollowCylinderAndACylindricalShell) {
  for (int axis = 0; axis < 3; ++axis) {
    Points thick, thin;
    for (const auto& [angle, w] : circle()) {
      for (const auto& [z, v] : gauss_legendre(20, -length / 2, length / 2)) {
        thin.push_back({w * v, along(axis, radius * std::cos(angle), radius * std::sin(angle), z)});
        for (const auto& [rho, u] : gauss_legendre(20, 0.4, radius)) {
          thick.push_back({w * v * u * rho, along(axis, rho * std::cos(angle), rho * std::sin(angle), z)});
        }
      }
    }
    expect_body(Inertia::hollow_cylinder(
                    {.mass = m, .outer_radius = r, .inner_radius = in_unit(0.4, "m"), .height = h, .axis = axis}),
                of_mass(mass, thick));
    expect_body(Inertia::cylindrical_shell(m, r, h, axis), of_mass(mass, thin));
  }
}

Points sector(int axis, double last_angle) {
  Points points;
  // Twenty nodes integrate trigonometric functions of order two over half a turn beyond double precision.
  for (const auto& [angle, w] : gauss_legendre(20, 0, last_angle)) {
    for (const auto& [rho, v] : gauss_legendre(20, 0, radius)) {
      points.push_back({w * v * rho, along(axis, rho * std::cos(angle), rho * std::sin(angle), 0)});
    }
  }
  return of_mass(mass, points);
}

TEST(InertiaShapes, IntegrateAHalfAndAQuarterDisk) {
  for (int axis = 0; axis < 3; ++axis) {
    expect_body(Inertia::half_disk(m, r, axis), sector(axis, pi_double));
    expect_body(Inertia::quarter_disk(m, r, axis), sector(axis, pi_double / 2));
  }
}

TEST(InertiaShapes, GiveTheQuarterDiskOfTheCourseExactly) {
  // 4r/(3π) both ways, about the corner m r²/4, m r²/4, m r²/2 and −m r²/(2π): identities, π being exact.
  const Inertia vane = Inertia::quarter_disk(m, r, 2);
  const InertiaOperator corner = operator_about(vane, {0, 0, 0});
  Program program;
  const auto same = [&](const Expression& a, const Expression& b) { return identically_zero(program.lower(a - b)); };
  EXPECT_TRUE(same(vane.center[0], 4 * r / (3 * pi())));
  EXPECT_TRUE(same(vane.center[1], 4 * r / (3 * pi())));
  EXPECT_TRUE(same(corner.xx, m * r * r / 4));
  EXPECT_TRUE(same(corner.yy, m * r * r / 4));
  EXPECT_TRUE(same(corner.zz, m * r * r / 2));
  EXPECT_TRUE(same(corner.xy, -m * r * r / (2 * pi())));
  EXPECT_FALSE(same(vane.xy, corner.xy));
  EXPECT_TRUE(corner.xz.is_zero() && corner.yz.is_zero());
}

TEST(InertiaShapes, IntegrateATriangleAnywhere) {
  const std::array<Place, 3> corners{{{0.2, 0.1, -0.4}, {1.1, -0.3, 0.5}, {-0.6, 0.9, 0.2}}};
  Points points;
  for (const auto& [u, w] : gauss_legendre(10, 0, 1)) {
    for (const auto& [v, x] : gauss_legendre(10, 0, 1)) {  // a + u (b − a) + u v (c − b), area element ∝ u
      Place place;
      for (std::size_t i = 0; i < 3; ++i) {
        place[i] = corners[0][i] + u * (corners[1][i] - corners[0][i]) + u * v * (corners[2][i] - corners[1][i]);
      }
      points.push_back({w * x * u, place});
    }
  }
  const auto corner = [&](std::size_t k) {
    return Triple{in_unit(corners[k][0], "m"), in_unit(corners[k][1], "m"), in_unit(corners[k][2], "m")};
  };
  expect_body(Inertia::triangle(m, corner(0), corner(1), corner(2)), of_mass(mass, points));
}

/// The printed table of the course has C = B for the disk; A = B is meant (and C = A + B, it being flat).
TEST(InertiaShapes, GiveADiskEqualMomentsAcrossAndTwiceThatAlong) {
  const Inertia disk = Inertia::disk(m, r, 2);
  const std::array<double, 6> integrated = inertia_about_origin(sector(2, 2 * pi_double));
  EXPECT_NEAR(in_double(disk.xx), integrated[0], 1e-13);
  EXPECT_NEAR(in_double(disk.yy), integrated[1], 1e-13);
  EXPECT_NEAR(in_double(disk.zz), integrated[2], 1e-13);
  EXPECT_NEAR(in_double(disk.xx), mass * radius * radius / 4, 1e-15);
  EXPECT_GT(std::abs(in_double(disk.zz) - in_double(disk.yy)), 0.3) << "C = B as printed";
}

TEST(InertiaShapes, HaveTheUnitsOfABody) {
  const Triple corner{r, 0, h};
  for (const Inertia& body :
       {Inertia::cone(m, r, h, 0), Inertia::conical_shell(m, r, h, 1),
        Inertia::hollow_cylinder({.mass = m, .outer_radius = r, .inner_radius = h, .height = h, .axis = 2}),
        Inertia::cylindrical_shell(m, r, h, 0), Inertia::half_disk(m, r, 1), Inertia::quarter_disk(m, r, 2),
        Inertia::triangle(m, {0, 0, 0}, corner, {h, 0, 0}).rotated({0, 1, 2}, Expression(0.3))}) {
    EXPECT_EQ(body.mass.unit(), units::kilogram);
    for (const Expression* entry : {&body.xx, &body.yy, &body.zz, &body.xy, &body.xz, &body.yz}) {
      EXPECT_TRUE(entry->is_zero() || entry->unit() == units::kilogram_metre_squared) << entry->to_string();
    }
    for (const Expression& c : body.center) EXPECT_TRUE(c.is_zero() || c.unit() == units::metre) << c.to_string();
  }
}

}  // namespace
}  // namespace torsor::inertia_shapes_test
