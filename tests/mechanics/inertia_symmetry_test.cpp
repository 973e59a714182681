// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/mechanics/inertia_symmetry.hpp"

#include <gtest/gtest.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/mechanics/inertia_operations.hpp"
#include "tests/program/test_symbols.hpp"

namespace torsor::inertia_symmetry_test {
namespace {

const Expression m(testing_symbols::make_symbol("m", "kg"));
const Expression a(testing_symbols::make_symbol("a", "m"));
const Expression b(testing_symbols::make_symbol("b", "m"));
const Expression alpha(testing_symbols::make_symbol("alpha"));
using enum MaterialSymmetry;

TEST(InertiaSymmetry, IsThatOfTheShape) {
  const Inertia quarter = Inertia::quarter_disk(m, a, 2);
  EXPECT_TRUE(allows(quarter, plane, 2));  // flat
  EXPECT_FALSE(allows(quarter, plane, 0));
  EXPECT_FALSE(allows(quarter, half_turn, 2));
  EXPECT_TRUE(allows(quarter.rotated(axis::z, pi() / 4), plane, 0));  // its bisector is now y
  const Inertia half = Inertia::half_disk(m, a, 2);
  EXPECT_TRUE(allows(half, plane, 0));
  EXPECT_FALSE(allows(half, plane, 1));  // the operator would, the centre of mass does not
  EXPECT_TRUE(allows(half, half_turn, 1));
  EXPECT_FALSE(allows(half, revolution, 1));
  const Inertia cone = Inertia::cone(m, a, b, 0).at({b / 4, 0, 0});
  EXPECT_TRUE(allows(cone, revolution, 0));
  EXPECT_FALSE(allows(cone, revolution, 1));
}

TEST(InertiaSymmetry, KnowsSpheresAndBodiesOfRevolution) {
  const Inertia moved = Inertia::solid_sphere(m, a).rotated({1, 2, 3}, alpha).at({a, b, 0});
  EXPECT_TRUE(is_spherical(moved));
  EXPECT_FALSE(is_spherical(Inertia::cylinder(m, a, b, 2)));
  // A cylinder of height √3 a is dynamically a sphere.
  EXPECT_TRUE(is_spherical(Inertia::cylinder(m, a, Expression(Number::sqrt3()) * a, 2)));
  const Inertia disk = Inertia::disk(m, a, 2).at({a, 0, b});
  EXPECT_TRUE(is_of_revolution(disk, 2));
  EXPECT_FALSE(is_of_revolution(disk, 0));
  EXPECT_TRUE(is_of_revolution(disk.rotated(axis::z, alpha), 2));
  EXPECT_FALSE(is_of_revolution(disk.rotated(axis::x, alpha), 2));
  EXPECT_TRUE(is_principal(disk.rotated(axis::x, alpha), 0));
  EXPECT_FALSE(is_principal(disk.rotated(axis::x, alpha), 2));
  // Four blades a quarter of a turn apart, each pitched by α: of revolution as the course finds, one alone is not.
  const Inertia blade = Inertia::plate(m, a, b).rotated(axis::x, alpha).at({a, 0, 0});
  std::vector<Inertia> blades;
  for (int k = 0; k < 4; ++k) blades.push_back(blade.rotated(Rotation::about(2, 6 * k)));
  EXPECT_FALSE(is_of_revolution(blade, 2));
  EXPECT_TRUE(is_of_revolution(assembly(blades), 2));
}

TEST(InertiaSymmetry, SettlesTheEntriesThatVanish) {
  const auto moment = [](const char* name) { return Expression(testing_symbols::make_symbol(name, "kg m^2")); };
  const Inertia any = Inertia::general({.mass = m, .xx = moment("A"), .yy = moment("B"), .zz = moment("C"),
                                        .xy = moment("F"), .xz = moment("E"), .yz = moment("D")})
                          .at({a, b, 2 * a});
  for (int axis = 0; axis < 3; ++axis) {
    for (const MaterialSymmetry symmetry : {plane, half_turn, revolution}) {
      EXPECT_FALSE(allows(any, symmetry, axis));
      EXPECT_TRUE(allows(with_symmetry(any, symmetry, axis), symmetry, axis));
    }
  }
  const Inertia flat = with_symmetry(any, plane, 1);
  EXPECT_TRUE(flat.center[1].is_zero() && flat.xy.is_zero() && flat.yz.is_zero());
  EXPECT_EQ(flat.xz.to_string(), "E");
  EXPECT_EQ(flat.center[2].to_string(), any.center[2].to_string());
  const Inertia round = with_symmetry(any, revolution, 2);
  EXPECT_EQ(round.xx.to_string(), "A");
  EXPECT_EQ(round.yy.to_string(), "A");
  EXPECT_TRUE(round.xy.is_zero() && round.xz.is_zero() && round.yz.is_zero());
  EXPECT_EQ(testing_symbols::error_of<SceneError>([&] { allows(any, plane, 4); }),
            "axis 4 of an inertia does not exist: use 0, 1 or 2 for x, y or z");
}

}  // namespace
}  // namespace torsor::inertia_symmetry_test
