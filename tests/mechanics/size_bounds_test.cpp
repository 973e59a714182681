// SPDX-License-Identifier: GPL-3.0-or-later
// What sizes must be, as those look at it who set parameters later: libraries and units.
#include "torsor/generator/mechanics/size_bounds.hpp"

#include <gtest/gtest.h>

#include <map>

#include "torsor/generator/base/error.hpp"
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
