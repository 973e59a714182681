// SPDX-License-Identifier: GPL-3.0-or-later
// What sizes must be, as those look at it who set parameters later: libraries and units.
#include "torsor/generator/mechanics/size_bounds.hpp"

#include <gtest/gtest.h>

#include <map>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/mechanics/inertia_operations.hpp"
#include "torsor/generator/mechanics/parameter_value.hpp"
#include "torsor/generator/mechanics/scene.hpp"
#include "tests/scenes/bodies.hpp"

namespace torsor::size_bounds_test {
namespace {

using namespace testing_mechanisms;

/// A block with a mass, moments, stops and friction that parameters give, and as many without.
struct Block {
  Scene scene{"block"};
  std::map<std::string, Expression> p;
  Block() {
    const auto add = [this](const std::string& name, const char* unit, const Expression& value) {
      p[name] = scene.parameter(name, unit, value);
    };
    add("m", "kg", 2), add("A", "kg m^2", 1), add("B", "kg m^2", 2), add("C", "kg m^2", 2), add("D", "kg m^2", 0);
    add("E", "kg m^2", 0), add("F", "kg m^2", 0);
    add("low", "m", -1), add("high", "m", 1), add("f", "1", Expression(1) / 2), add("e", "1", 0), add("r", "m", 1);
    add("a", "kg m^2", 1);
    p["n"] = scene.parameter("n", "kg", 2 * p["m"]);
    const Expression x = scene.coordinate("x", "m"), z = scene.coordinate("z", "m"), q = scene.coordinate("q", "rad");
    const FrameHandle rail = scene.prismatic("rail", scene.ground(), axis::x, x);
    const FrameHandle block = scene.revolute("block", scene.prismatic("lift", rail, axis::z, z), axis::y, q);
    scene.body("block", block,
               Inertia::general({.mass = p["n"],
                                 .xx = p["A"],
                                 .yy = p["B"],
                                 .zz = p["C"],
                                 .xy = p["D"],
                                 .xz = p["E"],
                                 .yz = p["F"]}));
    scene.body("weight", block, Inertia::point(kilograms("1")));
    scene.reflected_inertia("rotor \"q{}\"", q, p["a"]);
    scene.stop(x, p["low"], p["high"], {.restitution = p["e"]});
    scene.contact("table", shape::Sphere{.frame = block, .radius = p["r"]}, shape::Plane{.frame = scene.ground()},
                  {.friction = p["f"]});
  }

  /// What is said of the first bound that is broken, with numbers at their places.
  std::string said(const std::map<std::string, Expression>& values) {
    Scene other = scene;
    for (const auto& [name, value] : values) other.set_parameter(p.at(name), value);
    std::vector<SymbolPointer> all;
    for (const ParameterContent& each : other.content().parameters) all.push_back(each.symbol);
    try {
      require_bounds(other.content(), bounds_that_depend_on(other.content(), all));
    } catch (const SceneError& error) {
      return error.what();
    }
    return {};
  }
};

TEST(SizeBounds, NameTheSizeAndItsValue) {
  Block block;
  EXPECT_EQ(block.said({}), "");
  EXPECT_EQ(block.said({{"m", -1}}).substr(0, 64), "body 'block' has the mass n = -2 kg: a mass is never negative; s");
  EXPECT_EQ(block.said({{"a", -1}}).substr(0, 68), "reflected inertia 'rotor \"q{}\"' is a = -1 and must not be negative: ");
  EXPECT_EQ(block.said({{"low", 2}}),
            "the stop 'x_lower' at low = 2 is not below 'x_upper' at high = 1: give it a smaller place");
  EXPECT_EQ(block.said({{"low", 1}}).substr(0, 28), "the stop 'x_lower' at low = ");
  EXPECT_EQ(block.said({{"f", -1}}), "contact 'table' has the friction f = -1: a surface never pushes along the slip");
  EXPECT_EQ(block.said({{"e", 2}}), "contact 'x_lower' has the restitution e = 2: it must lie between 0 and 1");
  EXPECT_EQ(block.said({{"e", -1}}), "contact 'x_lower' has the restitution e = -1: it must lie between 0 and 1");
  EXPECT_NE(block.said({{"r", -1}}).find("radius r = -1: give the size of what touches the plane"), std::string::npos);
}

/// What is said of a body of that inertia, whose sizes are parameters.
std::string said_of(Inertia (*make)(const Expression& a, const Expression& b, const Expression& c), double a, double b,
                    double c) {
  Scene scene("bodies");
  const Expression A = scene.run_time_parameter("A", "m", a), B = scene.parameter("B", "m", b), C = scene.parameter("C", "m", c);
  const Expression q = scene.coordinate("q", "rad");
  scene.body("top", scene.revolute("hinge", scene.ground(), axis::y, q), make(A, B, C));
  const auto error = [&](const std::vector<SizeBound>& bounds) -> std::string {
    try {
      require_bounds(scene.content(), bounds);
    } catch (const SceneError& refused) {
      return refused.what();
    }
    return {};
  };
  const std::string of_all = error(bounds_of_stated_sizes(scene.content()));
  const std::vector<SymbolPointer> all{A.as_symbol(), B.as_symbol(), C.as_symbol()};
  EXPECT_EQ(error(bounds_that_depend_on(scene.content(), all)), of_all);
  return of_all;
}

const Expression two = kilograms("2");

// Only squares of lengths stand in moments of inertia.
TEST(SizeBounds, KnowTheLengthsThatInertiasWereMadeOf) {
  const std::string of_length = " m: a length is never negative; give its size";
  using E = const Expression&;
  const auto box = [](E a, E b, E c) { return Inertia::box(two, a, b, c); };
  EXPECT_EQ(said_of(box, 1, 2, 3), "");
  EXPECT_EQ(said_of(box, 1, 2, 0), "");  // a plate
  EXPECT_EQ(said_of(box, -1, 2, 3), "body 'top' has the edge of a box A = -1" + of_length);
  EXPECT_EQ(said_of(box, 1, -2, 3), "body 'top' has the edge of a box B = -2" + of_length);
  EXPECT_EQ(said_of(box, 1, 2, -3), "body 'top' has the edge of a box C = -3" + of_length);
  const auto moved = [](E a, E b, E) {
    return (Inertia::point(two) + Inertia::cylinder(two, a, b, 2).rotated({1, 2, 3}, Expression(1) / 2)).at({0, 0, a});
  };
  EXPECT_EQ(said_of(moved, -1, 2, 0), "body 'top' has the radius of a cylinder A = -1" + of_length);
  EXPECT_EQ(said_of(moved, 1, -2, 0), "body 'top' has the height of a cylinder B = -2" + of_length);
  const auto hole = [](E a, E b, E c) { return Inertia::solid_sphere(10 * two, c) - Inertia::rod(two, a + b, 2); };
  EXPECT_EQ(said_of(hole, 1, -2, 1), "body 'top' has the length of a rod (A + B) = -1" + of_length);
  const auto tube = [](E a, E b, E c) { return Inertia::hollow_cylinder({two, a, b, c, 2}); };
  EXPECT_EQ(said_of(tube, 2, 1, 1), "");
  EXPECT_EQ(said_of(tube, 1, 1, 0), "");
  EXPECT_EQ(said_of(tube, 1, 2, 1),
            "body 'top' has the outer radius of a hollow cylinder A = 1 m, below the inner radius B = 2 m: exchange them, or "
            "correct one");
  EXPECT_EQ(said_of(tube, 2, -1, 1), "body 'top' has the inner radius of a hollow cylinder B = -1" + of_length);
  EXPECT_EQ(said_of(tube, 2, 1, -1), "body 'top' has the height of a hollow cylinder C = -1" + of_length);
}

TEST(SizeBounds, KnowEveryShapeOfInertias) {
  using E = const Expression&;
  using Make = Inertia (*)(E, E, E);
  const std::map<std::string, Make> of_a{
      {"length of a rod", [](E a, E, E) { return Inertia::rod(two, a, 0); }},
      {"radius of a disk", [](E a, E, E) { return Inertia::disk(two, a, 0); }},
      {"radius of a ring", [](E a, E, E) { return Inertia::ring(two, a, 0); }},
      {"radius of a cylindrical shell", [](E a, E b, E) { return Inertia::cylindrical_shell(two, a, b, 0); }},
      {"height of a cylindrical shell", [](E a, E b, E) { return Inertia::cylindrical_shell(two, b, a, 0); }},
      {"radius of a cone", [](E a, E b, E) { return Inertia::cone(two, a, b, 0); }},
      {"height of a cone", [](E a, E b, E) { return Inertia::cone(two, b, a, 0); }},
      {"radius of a conical shell", [](E a, E b, E) { return Inertia::conical_shell(two, a, b, 0); }},
      {"height of a conical shell", [](E a, E b, E) { return Inertia::conical_shell(two, b, a, 0); }},
      {"radius of a sphere", [](E a, E, E) { return Inertia::solid_sphere(two, a); }},
      {"radius of a hollow sphere", [](E a, E, E) { return Inertia::hollow_sphere(two, a); }},
      {"edge of a plate", [](E a, E b, E) { return Inertia::plate(two, b, a); }},
      {"radius of a half disk", [](E a, E, E) { return Inertia::half_disk(two, a, 0); }},
      {"radius of a quarter disk", [](E a, E, E) { return Inertia::quarter_disk(two, a, 0); }},
  };
  for (const auto& [what, make] : of_a) {
    EXPECT_EQ(said_of(make, -1, 1, 1), "body 'top' has the " + what + " A = -1 m: a length is never negative; give its size");
    EXPECT_EQ(said_of(make, 1, 1, 1), "") << what;
  }
}

TEST(SizeBounds, KnowTheLengthsOfWhatTouches) {
  const auto said = [](const ContactShape& shape) -> std::string {
    Scene scene("touch");
    const Expression z = scene.coordinate("z", "m");
    scene.body("stone", scene.prismatic("stone", scene.ground(), axis::z, z), Inertia::point(kilograms("1")));
    scene.contact("floor", shape, shape::Plane{.frame = scene.ground()}, {});
    try {
      require_bounds(scene.content(), bounds_of_stated_sizes(scene.content()));
    } catch (const SceneError& error) {
      return error.what();
    }
    return {};
  };
  const Expression one = Expression::quantity("1", "m");
  EXPECT_EQ(said(shape::Ellipsoid{.frame = "stone", .semi_axes = {one, one, 2 * one}}), "");
  EXPECT_EQ(said(shape::Ellipsoid{.frame = "stone", .semi_axes = {one, -one, 2 * one}}),
            "contact 'floor' has the semi-axis of an ellipsoid -1 m: it must be above 0");
  EXPECT_EQ(said(shape::Box{.frame = "stone", .half_edges = {one, 0, one}}), "");
  EXPECT_EQ(said(shape::Box{.frame = "stone", .half_edges = {-one, 0, one}}),
            "contact 'floor' has the half edge of a box -1 m: a length is never negative; give its size");
  EXPECT_EQ(said(shape::Box{.frame = "stone", .half_edges = {one, one, -2 * one}}),
            "contact 'floor' has the half edge of a box -2 m: a length is never negative; give its size");
}

// A + B >= C of principal moments: with a product D these are C and those of [A D; D B]. E and F are the other products.
TEST(SizeBounds, AskOfMomentsWhatMatterHas) {
  Block block;
  const std::string no_matter = "body 'block' has the moments of inertia xx = ";
  const auto refused = [&](const std::map<std::string, Expression>& values) { return block.said(values).starts_with(no_matter); };
  EXPECT_FALSE(refused({{"A", 1}, {"B", 2}, {"C", 3}}));  // a plate
  EXPECT_TRUE(refused({{"A", 1}, {"B", 2}, {"C", Expression(31) / 10}}));
  EXPECT_TRUE(refused({{"A", Expression(31) / 10}, {"B", 1}, {"C", 2}}));
  EXPECT_TRUE(refused({{"A", 1}, {"B", Expression(31) / 10}, {"C", 2}}));
  EXPECT_TRUE(refused({{"A", -1}, {"B", 1}, {"C", 1}}));
  EXPECT_FALSE(refused({{"A", 0}, {"B", 0}, {"C", 0}}));
  EXPECT_FALSE(refused({{"D", Expression(86) / 100}}));
  EXPECT_TRUE(refused({{"D", Expression(87) / 100}}));  // principal moments 0.497, 2 and 2.503
  EXPECT_FALSE(refused({{"E", Expression(86) / 100}}));
  EXPECT_TRUE(refused({{"E", Expression(87) / 100}}));
  EXPECT_FALSE(refused({{"F", Expression(49) / 100}}));
  EXPECT_TRUE(refused({{"F", Expression(51) / 100}}));
  // det (5/2 - J) = 3/8 - 5/2 d^2 - 2 D E F.
  const Expression d = Expression(35) / 100;
  EXPECT_TRUE(refused({{"D", d}, {"E", d}, {"F", d}}));
  EXPECT_FALSE(refused({{"D", d}, {"E", d}, {"F", -d}}));
}

TEST(SizeBounds, ShowTheMomentsThatNoMatterHas) {
  const std::string of_no_matter =
      " about its centre of mass: of no matter is a principal one larger than the sum of the others, or negative; check the "
      "entries, the sign of the products (xy = -int x y dm) and that the operator is about the centre of mass";
  Block block;
  EXPECT_EQ(block.said({{"A", 1}, {"B", 2}, {"C", Expression(7) / 2}, {"F", Expression(-1) / 8}}),
            "body 'block' has the moments of inertia xx = 1, yy = 2 and zz = 3.5 kg m^2, the products xy = 0, xz = 0 and yz = "
            "-0.125 kg m^2," + of_no_matter);
  Scene scene("bar");
  const Expression J = scene.parameter("J", "kg m^2", 3), one = Expression::quantity("1", "kg m^2");
  const Expression q = scene.coordinate("q", "rad");
  scene.body("bar", scene.revolute("hinge", scene.ground(), axis::y, q),
             Inertia::general({.mass = kilograms("1"), .xx = one, .yy = J, .zz = one}));
  try {
    require_bounds(scene.content(), bounds_that_depend_on(scene.content(), {J.as_symbol()}));
    FAIL();
  } catch (const SceneError& error) {
    EXPECT_EQ(error.what(), "body 'bar' has the moments of inertia xx = 1, yy = 3 and zz = 1 kg m^2" + of_no_matter);
  }
}

TEST(SizeBounds, AreThoseOfTheParametersThatAreAskedFor) {
  Block block;
  const auto count = [&](const std::string& name) {
    return bounds_that_depend_on(block.scene.content(), {block.p.at(name).as_symbol()}).size();
  };
  EXPECT_EQ(count("m"), 1u);  // through n
  EXPECT_EQ(count("low"), 1u);
  EXPECT_EQ(count("f"), 2u);  // the static one is the same
  EXPECT_EQ(count("e"), 4u);  // of two stops
  EXPECT_EQ(count("A"), 3u);
}

}  // namespace
}  // namespace torsor::size_bounds_test
