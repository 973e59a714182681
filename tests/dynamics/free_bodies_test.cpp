// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "torsor/generator/dynamics/equations/equations.hpp"
#include "torsor/generator/dynamics/equations/validation.hpp"
#include "torsor/generator/program/generic_state.hpp"
#include "tests/dynamics/random_source.hpp"
#include "tests/long_tests.hpp"
#include "tests/program/test_symbols.hpp"
#include "tests/scenes/bodies.hpp"

namespace torsor::free_bodies_test {
namespace {

using namespace testing_symbols;
using namespace testing_mechanisms;

enum class Part { parameters, coordinates, attitude };
using Order = std::array<Part, 3>;

std::vector<Order> all_orders() {
  Order order{Part::parameters, Part::coordinates, Part::attitude};
  std::vector<Order> orders;
  do orders.push_back(order);
  while (std::next_permutation(order.begin(), order.end()));
  return orders;
}

/// What the values of parameters are: numbers that the generator folds, symbols that keep a value, symbols without one.
enum class Values { folded, run_time, none };

/// A free body by quaternion, its centre of mass anywhere and its inertia that of any box along any axes, with an arm
/// on it where the seed says so. The same mechanism in whatever order its quantities are declared.
struct FreeBody {
  FreeBody(unsigned seed, const Order& order, Values values) : scene("free_body") {
    RandomSource random(seed);
    const Inertia box = random.inertia(kilograms("1"));
    const Triple center = random.vector("m");
    const bool with_arm = random.one_in(2);
    const Placement place = random.placement();
    const Triple hinge = random.axis();
    Expression mass, size, angle;
    Triple at;
    AttitudeHandle turn;
    for (const Part part : order) {
      if (part == Part::parameters) {
        mass = parameter("mass", "kg", random.fraction(), values);
        size = parameter("side", "m", random.fraction(), values);
      } else if (part == Part::coordinates) {
        for (std::size_t i = 0; i < 3; ++i) at[i] = scene.coordinate(std::string(1, "xyz"[i]), "m");
        if (with_arm) angle = scene.coordinate("angle", "rad");
      } else {
        turn = scene.attitude("e");
      }
    }
    const FrameHandle body = scene.free("body", scene.ground(), at, turn);
    // Σ over the parts of a box: mass and size change none of the inequalities between moments.
    const Expression unit = Expression::quantity("1", "kg m^2");
    const auto scaled = [&](const Expression& moment) { return mass * size * size * (moment / unit); };
    const auto away = [&](const Expression& length) { return size * (length / metres("1")); };
    const Inertia inertia = Inertia::general({.mass = mass, .xx = scaled(box.xx), .yy = scaled(box.yy),
                                              .zz = scaled(box.zz), .xy = scaled(box.xy), .xz = scaled(box.xz),
                                              .yz = scaled(box.yz)})
                                .at({away(center[0]), away(center[1]), away(center[2])});
    scene.body("body", body, inertia);
    if (with_arm) {
      scene.body("arm", scene.revolute("arm", body, hinge, angle, place), inertia);
    }
  }

  Expression parameter(const std::string& name, const char* unit, const Number& value, Values values) {
    if (values == Values::none) return scene.parameter(name, unit);
    if (values == Values::run_time) return scene.run_time_parameter(name, unit, value);
    return scene.parameter(name, unit, value);
  }

  Scene scene;
};

// A free body accelerates along each of its six freedoms, wherever its centre of mass is: at |e| = 1, det M is
// m³ det J_G, and nothing of the declaration enters.
TEST(FreeBodies, HaveMassInEveryOrderOfDeclaration) {
  const std::vector<Order> orders = all_orders();
  ASSERT_EQ(orders.size(), 6U);
  for (unsigned seed = 0; seed < wanted(12U, 40U); ++seed) {
    for (const Values values : {Values::folded, Values::run_time, Values::none}) {
      for (std::size_t k = 0; k < orders.size(); ++k) {
        const FreeBody free(seed, orders[k], values);
        EXPECT_EQ(error_of([&] { validate(free.scene); }), "no error")
            << "seed " << seed << ", order " << k << ", values " << static_cast<int>(values);
      }
    }
  }
}

// A line of mass has no inertia about itself: no order of declaration may hide it.
TEST(FreeBodies, ThatAreALineOfMassAreRefusedInEveryOrderOfDeclaration) {
  for (const Order& order : all_orders()) {
    Scene scene("line");
    Expression mass, moment;
    Triple at;
    AttitudeHandle turn;
    for (const Part part : order) {
      if (part == Part::parameters) {
        mass = scene.parameter("mass", "kg", 2);
        moment = scene.parameter("moment", "kg m^2", 3);
      } else if (part == Part::coordinates) {
        for (std::size_t i = 0; i < 3; ++i) at[i] = scene.coordinate(std::string(1, "xyz"[i]), "m");
      } else {
        turn = scene.attitude("e");
      }
    }
    const FrameHandle rod = scene.free("rod", scene.ground(), at, turn);
    // J (1 − u uᵀ) with u = (3/5, 0, 4/5), the line through the origin and the centre of mass.
    const Expression along = Expression(Number::rational(16, 25)) * moment,
                     across = Expression(Number::rational(9, 25)) * moment;
    const Inertia line = Inertia::general({.mass = mass, .xx = along, .yy = moment, .zz = across,
                                           .xz = Expression(Number::rational(-12, 25)) * moment});
    scene.body("rod", rod, line.at({metres("0.3"), 0, metres("0.4")}));
    const std::string text = error_of([&] { validate(scene); });
    EXPECT_TRUE(text.starts_with("the mass matrix is singular at every state: coordinate 'e_omega_z'")) << text;
  }
}

// A tool of a robot whose mass is zero unless told otherwise: the parameter can change, and with it what moves.
TEST(FreeBodies, MayHaveAMassThatIsZeroInTheSceneAndSetAtRunTime) {
  Scene scene("tool");
  const Expression mass = scene.run_time_parameter("mass", "kg", 0);
  const Expression x = scene.coordinate("x", "m");
  scene.body("tool", scene.prismatic("slide", scene.ground(), axis::x, x), Inertia::point(mass));
  EXPECT_EQ(error_of([&] { validate(scene); }), "no error");
}

TEST(GenericState, HasUnitQuaternionsAndNoRelationBetweenNeighbours) {
  Scene scene("states");
  std::vector<SymbolPointer> symbols;
  for (int k = 0; k < 3; ++k) {
    scene.coordinate("q" + std::to_string(k), "rad");
    scene.attitude("e" + std::to_string(k));
  }
  const WorkingDigits precision(50);
  for (int trial = 0; trial < 5; ++trial) {
    for (const AttitudeContent& attitude : scene.content().attitudes) {
      Real square(0);
      for (const SymbolPointer& e : attitude.symbols->e) square += generic_value(e, trial) * generic_value(e, trial);
      EXPECT_LT(abs(square - Real(1)).to_double(), 1e-48);  // a few roundings in 50 digits
    }
    const auto& all = scene.content().coordinates;
    for (std::size_t i = 2; i < all.size(); ++i) {
      const Real bend = generic_value(all[i].v, trial) - generic_value(all[i - 1].v, trial) -
                        generic_value(all[i - 1].v, trial) + generic_value(all[i - 2].v, trial);
      EXPECT_FALSE(bend.is_zero()) << trial << ' ' << i;
    }
  }
}

}  // namespace
}  // namespace torsor::free_bodies_test
