// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/mechanics/inertia_operations.hpp"

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/program/identically_zero.hpp"
#include "tests/mechanics/inertia_points.hpp"
#include "tests/program/test_symbols.hpp"

namespace torsor::inertia_operations_test {
namespace {

using namespace testing_quadrature;
using testing_symbols::error_of;

const Expression m = in_unit(2.5, "kg");
const Expression a = in_unit(0.4, "m");
const Expression b = in_unit(0.6, "m");
const Expression c = in_unit(1.1, "m");

/// A box of edges 0.4, 0.6, 1.1 about a centre: four nodes a side integrate squares exactly.
Points box(double mass, const Place& center) {
  Points points;
  for (const auto& [x, u] : gauss_legendre(4, -0.2, 0.2)) {
    for (const auto& [y, v] : gauss_legendre(4, -0.3, 0.3)) {
      for (const auto& [z, w] : gauss_legendre(4, -0.55, 0.55)) {
        points.push_back({u * v * w, {x + center[0], y + center[1], z + center[2]}});
      }
    }
  }
  return of_mass(mass, points);
}

/// Each point turned by Rodrigues' formula on vectors, with no array: v c + n ∧ v s + n (n·v)(1 − c).
Points turned_about(const Place& n, double angle, Points points) {
  for (MassPoint& point : points) {
    const Place v = point.place;
    const double along_axis = n[0] * v[0] + n[1] * v[1] + n[2] * v[2];
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      const std::size_t k = (i + 2) % 3;
      point.place[i] = v[i] * std::cos(angle) + (n[j] * v[k] - n[k] * v[j]) * std::sin(angle) +
                       n[i] * along_axis * (1 - std::cos(angle));
    }
  }
  return points;
}

const Triple place{in_unit(0.5, "m"), in_unit(-0.2, "m"), in_unit(0.3, "m")};
const Place place_double{0.5, -0.2, 0.3};

TEST(InertiaOperations, TurnABodyAsItsPointsTurn) {
  const Inertia body = Inertia::box(m, a, b, c).at(place);
  const Points points = box(2.5, place_double);
  for (const auto& [axis, n] : {std::pair<Triple, Place>(axis::x, {1, 0, 0}),
                                {-axis::y, {0, -1, 0}},
                                {axis::z, {0, 0, 1}},
                                {{1, 2, 2}, {1. / 3, 2. / 3, 2. / 3}}}) {
    expect_body(body.rotated(axis, Expression(0.7)), turned_about(n, 0.7, points));
  }
  const Triple irrational{1, -2, 3};
  const double norm = std::sqrt(14.0);
  expect_body(body.rotated(irrational, Expression(-1.9)), turned_about({1 / norm, -2 / norm, 3 / norm}, -1.9, points));
}

TEST(InertiaOperations, TurnByAConstantRotationAsByItsAngle) {
  const Inertia body = Inertia::box(m, a, b, c).at(place);
  expect_body(body.rotated(Rotation::about(1, 5)),
              turned_about({0, 1, 0}, 5 * std::acos(-1.0) / 12, box(2.5, place_double)));
  // Multiples of π/12 are exact both ways: the same number, not a near one.
  const Inertia by_array = body.rotated(Rotation::about(2, 5));
  const Inertia by_angle = body.rotated(axis::z, 5 * pi() / 12);
  Program program;
  EXPECT_EQ(program.lower(by_array.xy).polynomial(), program.lower(by_angle.xy).polynomial());
  EXPECT_EQ(program.lower(by_array.center[0]).polynomial(), program.lower(by_angle.center[0]).polynomial());
  EXPECT_TRUE(program.lower(by_angle.xy).is_constant());
}

/// A blade along x with pitch α: B cos² α + C sin² α and (B − C) sin α cos α, by hand.
TEST(InertiaOperations, PitchABladeByASymbol) {
  const auto symbol = testing_symbols::make_symbol("alpha");
  const Expression alpha(symbol);
  const Inertia blade = Inertia::plate(m, c, a);  // thin, in the plane x, y
  const Inertia pitched = blade.rotated(axis::x, alpha);
  Program program;
  const auto same = [&](const Expression& x, const Expression& y) { return identically_zero(program.lower(x - y)); };
  EXPECT_TRUE(same(pitched.xx, blade.xx));
  EXPECT_TRUE(same(pitched.yy, blade.yy * pow(cos(alpha), 2) + blade.zz * pow(sin(alpha), 2)));
  EXPECT_TRUE(same(pitched.zz, blade.yy * pow(sin(alpha), 2) + blade.zz * pow(cos(alpha), 2)));
  EXPECT_TRUE(same(pitched.yz, (blade.yy - blade.zz) * sin(alpha) * cos(alpha)));
  EXPECT_TRUE(identically_zero(program.lower(pitched.xy)));
}

TEST(InertiaOperations, RefuseTheNullAxis) {
  EXPECT_EQ(error_of<SceneError>([] {
              Inertia::box(m, a, b, c).rotated({0, 0, 0}, Expression(0.3));
            }),
            "a body cannot be turned about the null vector: give the axis a direction");
}

TEST(InertiaOperations, AssembleBodiesAsTheirPoints) {
  const Inertia first = Inertia::box(m, a, b, c);
  const Inertia second = Inertia::box(in_unit(1.2, "kg"), a, b, c).rotated({1, 2, 2}, Expression(0.7)).at(place);
  const Inertia third = Inertia::box(in_unit(0.7, "kg"), a, b, c).at({c, b, -a});
  Points points =
      together(box(2.5, {}), seen_from({-0.5, 0.2, -0.3}, turned_about({1. / 3, 2. / 3, 2. / 3}, 0.7, box(1.2, {}))));
  expect_body(first + second, points);
  expect_body(second + first, points);
  points = together(points, box(0.7, {1.1, 0.6, -0.4}));
  expect_body(assembly({first, second, third}), points);
  expect_body(first + (second + third), points);
}

TEST(InertiaOperations, AddOperatorsWithoutMass) {
  const Inertia flywheel = Inertia::general({.mass = 0, .zz = Expression::quantity("0.3", "kg m^2")});
  const Inertia body = Inertia::box(m, a, b, c).at(place);
  for (const Inertia& sum : {body + flywheel, flywheel + body}) {
    EXPECT_NEAR(in_double(sum.zz), in_double(body.zz) + 0.3, 1e-15);
    EXPECT_NEAR(in_double(sum.xx), in_double(body.xx), 1e-15);
    EXPECT_NEAR(in_double(sum.center[0]), 0.5, 1e-15);
    EXPECT_NEAR(in_double(sum.mass), 2.5, 1e-15);
  }
}

TEST(InertiaOperations, CutAHole) {
  // A full cylinder less the concentric core of the same density is the tube of the catalogue.
  const Expression density = Expression::quantity("700", "kg/m^3");
  const auto mass_of = [&](const Expression& radius) { return density * pi() * pow(radius, 2) * c; };
  const Inertia tube =
      Inertia::cylinder(mass_of(b), b, c, 1).at(place) - Inertia::cylinder(mass_of(a), a, c, 1).at(place);
  const Inertia expected =
      Inertia::hollow_cylinder(
          {.mass = mass_of(b) - mass_of(a), .outer_radius = b, .inner_radius = a, .height = c, .axis = 1})
          .at(place);
  Program program;
  for (const auto& [entry, value] : {std::pair(tube.mass, expected.mass), std::pair(tube.xx, expected.xx),
                                     std::pair(tube.yy, expected.yy), std::pair(tube.center[2], expected.center[2])}) {
    EXPECT_TRUE(identically_zero(program.lower(entry - value)));
  }
  // A hole beside the centre moves it: the rest, put together with the core again, is the whole.
  const Inertia core = Inertia::box(in_unit(0.5, "kg"), a, b, c).rotated(axis::y, Expression(0.2)).at({a, 0, 0});
  const Inertia whole = (Inertia::box(m, a, b, c) - core) + core;
  expect_body(whole, box(2.5, {}));
}

TEST(InertiaOperations, RefuseAnAssemblyOfNoMass) {
  const Inertia body = Inertia::box(m, a, b, c);
  EXPECT_EQ(error_of<SceneError>([&] { return body - body.at(place); }),
            "the masses 5/2 and -5/2 of an assembly cancel: it has no centre of mass; a hole must be lighter than what "
            "it is cut from");
  EXPECT_EQ(error_of<SceneError>([] { return assembly({}); }),
            "an assembly of no bodies has no inertia: give at least one");
}

TEST(InertiaOperations, GoBackToTheCentreByHuygens) {
  const Inertia body = Inertia::box(m, a, b, c).rotated({1, 2, 2}, Expression(0.7)).at(place);
  const Triple point{c, -a, b};
  const Inertia back = from_operator_about(body.mass, body.center, point, operator_about(body, point));
  expect_body(back, seen_from({-0.5, 0.2, -0.3}, turned_about({1. / 3, 2. / 3, 2. / 3}, 0.7, box(2.5, {}))));
}

TEST(InertiaOperations, MakeTwoQuartersAHalf) {
  const Inertia quarter = Inertia::quarter_disk(m / 2, c, 2);
  const Inertia half = quarter + quarter.rotated(Rotation::about(2, 6));
  const Inertia expected = Inertia::half_disk(m, c, 2);
  Program program;
  const std::vector<std::pair<Expression, Expression>> pairs{{half.xx, expected.xx},
                                                             {half.yy, expected.yy},
                                                             {half.zz, expected.zz},
                                                             {half.center[0], expected.center[0]},
                                                             {half.center[1], expected.center[1]}};
  for (const auto& [entry, value] : pairs) EXPECT_TRUE(identically_zero(program.lower(entry - value)));
  EXPECT_TRUE(identically_zero(program.lower(half.xy)));
}

}  // namespace
}  // namespace torsor::inertia_operations_test
