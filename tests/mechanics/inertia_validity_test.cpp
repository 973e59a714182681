// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/mechanics/inertia_validity.hpp"

#include <gtest/gtest.h>

#include "torsor/generator/mechanics/inertia_operations.hpp"
#include "torsor/generator/mechanics/scene.hpp"
#include "tests/program/test_symbols.hpp"
#include "tests/scenes/bodies.hpp"

namespace torsor::inertia_validity_test {
namespace {

using testing_mechanisms::kilograms;
using testing_mechanisms::moment;
using testing_symbols::error_of;

Expression metre(const char* value) { return Expression::quantity(value, "m"); }

std::string refusal(const Inertia& inertia) {
  Scene scene("scene");
  scene.body("plank", scene.ground(), inertia);
  return error_of<SceneError>([&] { check_inertia(scene.content(), scene.content().bodies[0]); });
}

TEST(InertiaValidity, LetsTrueBodiesThrough) {
  const Expression m = kilograms("2");
  for (const Inertia& body :
       {Inertia::point(m), Inertia::rod(m, metre("1.3"), 1), Inertia::plate(m, metre("0.3"), metre("0.7")),
        Inertia::rod(m, metre("1.3"), 1).rotated({1, 2, 3}, Expression(0.4)),
        Inertia::quarter_disk(m, metre("0.3"), 0).rotated({1, 2, 3}, Expression(0.4)),
        Inertia::triangle(m, {0, 0, 0}, {metre("1"), 0, 0}, {0, metre("1"), metre("1")}),
        Inertia::box(m, metre("1"), metre("2"), metre("3")) - Inertia::rod(kilograms("0.1"), metre("1"), 2)}) {
    EXPECT_EQ(refusal(body), "no error");
  }
  // Six figures of a flat plate, and plane motion where one moment alone matters.
  EXPECT_EQ(refusal(Inertia::general({.mass = m, .xx = moment("0.333333"), .yy = moment("0.333333"),
                                      .zz = moment("0.666667")})),
            "no error");
  EXPECT_EQ(refusal(Inertia::general({.mass = m, .zz = moment("4")})), "no error");
}

TEST(InertiaValidity, NamesTheBodyWhoseMomentsNoMatterHas) {
  const std::string remedy =
      " kg m^2 about its centre of mass: of no matter is one larger than the sum of the others, or negative; check the "
      "entries, the sign of the products (xy = -int x y dm) and that the operator is about the centre of mass";
  EXPECT_EQ(
      refusal(Inertia::general({.mass = kilograms("2"), .xx = moment("1"), .yy = moment("2"), .zz = moment("3.1")})),
      "body 'plank' has the principal moments of inertia 1, 2 and 3.1" + remedy);
  // Turned so that only the products show it: principal moments 1, 2, 3.1 at 45 degrees about x.
  EXPECT_EQ(
      refusal(Inertia::general({.mass = kilograms("2"), .xx = moment("1"), .yy = moment("2"), .zz = moment("3.1")})
                  .rotated(axis::x, pi() / 4)
                  .rotated(Rotation::about(1, 3))),
      "body 'plank' has the principal moments of inertia 1, 2 and 3.1" + remedy);
  EXPECT_EQ(
      refusal(Inertia::general({.mass = kilograms("2"), .xx = moment("1"), .yy = moment("1"), .zz = moment("1"),
                                .xy = moment("-1.25")})),
      "body 'plank' has the principal moments of inertia -0.25, 1 and 2.25" + remedy);
}

TEST(InertiaValidity, NamesANegativeMass) {
  EXPECT_EQ(
      refusal(-Inertia::rod(kilograms("2"), metre("1"), 0)),
      "body 'plank' has the mass -2 kg: a mass is never negative; subtract a hole from the body it is cut from, as "
      "in Inertia::box(...) - Inertia::cylinder(...)");
}

TEST(InertiaValidity, UsesTheValuesOfParameters) {
  Scene scene("scene");
  const Expression A = scene.parameter("A", "kg m^2", Expression::quantity("1"));
  const Expression C = scene.parameter("C", "kg m^2");
  scene.body("known", scene.ground(), Inertia::general({.mass = kilograms("1"), .xx = A, .yy = A, .zz = 3 * A}));
  scene.body("unknown", scene.ground(), Inertia::general({.mass = kilograms("1"), .xx = A, .yy = A, .zz = 3 * A + C}));
  const auto check = [&](std::size_t k) {
    return error_of<SceneError>([&] { check_inertia(scene.content(), scene.content().bodies[k]); });
  };
  EXPECT_EQ(check(0).substr(0, 66), "body 'known' has the principal moments of inertia 1, 1 and 3 kg m^");
  EXPECT_EQ(check(1), "no error");
}

TEST(InertiaValidity, RefusesAShapeThatChanges) {
  Scene scene("scene");
  const Expression q = scene.coordinate("q", "rad");
  scene.body("bent", scene.ground(), Inertia::plate(kilograms("1"), metre("1"), metre("2")).rotated(axis::x, q));
  EXPECT_EQ(error_of<SceneError>([&] { check_inertia(scene.content(), scene.content().bodies[0]); }),
            "the inertia of body 'bent' depends on 'q', which changes in time: a body's mass and shape are constant in "
            "its frame; use a joint for what moves");
}

}  // namespace
}  // namespace torsor::inertia_validity_test
