// SPDX-License-Identifier: GPL-3.0-or-later
// The point where a disc or a sphere touches a plane, on and around the state where a disc lies flat.
#include <gtest/gtest.h>

#include <cmath>

#include "torsor/generator/dynamics/motion/point_motion.hpp"
#include "tests/dynamics/named_state.hpp"
#include "tests/scenes/bodies.hpp"

namespace torsor::lowest_point_test {
namespace {

using namespace testing_symbols;
using namespace testing_mechanisms;

constexpr double exact = 1e-50;

/// A disc of 3/2 m whose axis z leans from the normal by `lean` about x, after a heading about z; it spins about its
/// axis. The plane is tilted: z of `plane` is (0, -3, 4)/5 of the ground.
struct LeaningDisc {
  Scene scene{"disc"};
  Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m"), z = scene.coordinate("z", "m"),
             heading = scene.coordinate("heading", "rad"), lean = scene.coordinate("lean", "rad"),
             spin = scene.coordinate("spin", "rad");
  FrameHandle plane = scene.weld("plane", scene.ground(), {{metres("1"), 0, metres("2")}, tilt()});
  FrameHandle disc =
      scene.free("disc", plane, {x, y, z}, {.sequence = AngleSequence::euler, .angles = {heading, lean, spin}});
  PointHandle touch =
      scene.disc_contact("touch", {.frame = disc, .axis = axis::z, .radius = metres("1.5"), .plane = plane});
  PointHandle ball = scene.sphere_contact("ball", disc, metres("1.5"), plane);
  LeaningDisc() { scene.body("disc", disc, Inertia::disk(kilograms("2"), metres("1.5"), 2)); }

  static Rotation tilt() {
    const Number c = Number::rational(4, 5), s = Number::rational(3, 5), o, i(1);
    return Rotation::matrix({i, o, o, o, c, -s, o, s, c});
  }
};

Point state(const Real& lean) {
  return {{"x", rational(1, 3)},  {"y", rational(-2, 7)},    {"z", rational(5, 4)},        {"heading", rational(3, 5)},
          {"lean", lean},         {"spin", rational(-7, 3)}, {"x'", rational(1, 2)},       {"y'", rational(-1, 3)},
          {"z'", rational(2, 5)}, {"lean'", rational(4, 7)}, {"heading'", rational(1, 9)}, {"spin'", rational(5, 3)}};
}

/// The point from the centre in axes that follow the heading, divided by the radius.
std::array<Real, 3> from_centre(const Equations& equations, const PointHandle& point, NamedState& here,
                                const Point& at) {
  const Model& model = equations.model();
  const int ground = 0;
  const FramePlace& disc = model.place("disc", "test");
  const Vector place = model.locate(PointReference(point), ground, "test") - model.locate(Vector(), disc.link, ground);
  const Rotation back = LeaningDisc::tilt().transpose();
  const Vector in_plane = bound(equations.program(), back * bound(equations.program(), place));
  const Real c = cos(at.at("heading")), s = sin(at.at("heading"));
  const Real px = here(in_plane[0]), py = here(in_plane[1]);
  const Real radius = rational(3, 2);
  return {(c * px + s * py) / radius, (-s * px + c * py) / radius, here(in_plane[2]) / radius};
}

// With k = (0, -sin a, cos a) after the heading, n − (n·k) k = sin a (0, cos a, sin a): P = C − r sign(sin a)(0, cos a,
// sin a).
TEST(DiscContact, IsTheLowestPointOfTheRim) {
  const WorkingDigits precision(60);
  LeaningDisc it;
  const Equations equations(it.scene);
  for (const long lean : {1L, 2L, -1L, -2L, 4L}) {
    const Point at = state(rational(lean, 1));
    NamedState here(equations, at);
    const std::array<Real, 3> p = from_centre(equations, it.touch, here, at);
    const Real a = rational(lean, 1);
    const Real side = sin(a) > Real(0) ? Real(-1) : Real(1);
    EXPECT_LT(abs(p[0]).to_double(), exact);
    EXPECT_LT(abs(p[1] - side * cos(a)).to_double(), exact) << lean;
    EXPECT_LT(abs(p[2] - side * sin(a)).to_double(), exact) << lean;
    // Every other point of the rim, at the angle φ from the line of nodes, is higher: its height is sin φ sin a.
    for (int k = 0; k < 24; ++k) EXPECT_LE(p[2].to_double(), std::sin(k * 0.2618) * std::sin(double(lean)) + 1e-15);
  }
}

TEST(SphereContact, IsStraightBelowTheCentreHoweverTheSphereTurns) {
  const WorkingDigits precision(60);
  LeaningDisc it;
  const Equations equations(it.scene);
  for (const long lean : {0L, 1L, 2L, -3L}) {
    const Point at = state(rational(lean, 1));
    NamedState here(equations, at);
    const std::array<Real, 3> p = from_centre(equations, it.ball, here, at);
    EXPECT_LT(abs(p[0]).to_double() + abs(p[1]).to_double() + abs(p[2] + Real(1)).to_double(), exact);
  }
}

// A rolling point moves over the disc: V(P/R) is the derivative of its position, not the velocity of the material
// point.
TEST(DiscContact, MovesAsItsFormulaDifferentiated) {
  const WorkingDigits precision(60);
  LeaningDisc it;
  const Equations equations(it.scene);
  const Model& model = equations.model();
  const GeometricPoint point = geometric_point(model, it.touch, "test");
  const Vector v = bound(equations.program(), model.express(velocity(model, point, 0), point.link, 0));
  const Point at = state(rational(1, 1));
  NamedState here(equations, at);
  // In the plane's axes that follow the heading, C − r (0, cos a, sin a) moves by C' + ψ' ∧ CP + r a' (0, sin a, -cos
  // a).
  const Real r = rational(3, 2), a = rational(1, 1), lean_rate = at.at("lean'"), turn = at.at("heading'");
  const Real c = cos(at.at("heading")), s = sin(at.at("heading"));
  const std::array<Real, 3> along{c * at.at("x'") + s * at.at("y'") + turn * r * cos(a),
                                  -s * at.at("x'") + c * at.at("y'") + r * lean_rate * sin(a),
                                  at.at("z'") - r * lean_rate * cos(a)};
  const Vector seen = bound(equations.program(), LeaningDisc::tilt().transpose() * v);
  const Real vx = here(seen[0]), vy = here(seen[1]);
  EXPECT_LT(abs(c * vx + s * vy - along[0]).to_double(), exact);
  EXPECT_LT(abs(c * vy - s * vx - along[1]).to_double(), exact);
  EXPECT_LT(abs(here(seen[2]) - along[2]).to_double(), exact);
}

// Its digits do not depend on how small the lean is: once, of 60 of them a lean of 1e-20 left 20. A coin that spins
// until it lies flat was held by such rounding.
TEST(DiscContact, KeepsItsDigitsUntilTheDiscLiesFlat) {
  const WorkingDigits precision(60);
  LeaningDisc it;
  const Equations equations(it.scene);
  for (const int exponent : {-10, -20}) {
    for (const int side : {1, -1}) {
      const Real a = Real(side) * power_of_ten(exponent);
      const Point at = state(a);
      NamedState here(equations, at);
      const std::array<Real, 3> p = from_centre(equations, it.touch, here, at);
      EXPECT_LT(abs(p[0]).to_double(), exact);
      EXPECT_LT(abs(p[1] + Real(side) * cos(a)).to_double(), exact);
      EXPECT_LT((abs(p[2] + abs(sin(a))) / abs(a)).to_double(), exact);
    }
  }
}

// Flat, every point of the rim is as low as any other: there is no point of contact, and none is invented. The height
// over the plane, which is what a contact constrains, does not need the point.
TEST(DiscContact, IsNoNumberWhereTheDiscLiesFlatButItsHeightIsOne) {
  const WorkingDigits precision(60);
  LeaningDisc it;
  const Equations equations(it.scene);
  const Point at = state(Real(0));
  NamedState here(equations, at);
  const std::array<Real, 3> p = from_centre(equations, it.touch, here, at);
  EXPECT_TRUE(p[0].is_nan() && p[1].is_nan() && p[2].is_nan());
  const Model& model = equations.model();
  const PointContent& touch = it.scene.content().points[static_cast<std::size_t>(it.touch.index)];
  const Value height = model.lowest_height(touch, 0, "test");
  EXPECT_LT(abs(here(height) - at.at("z")).to_double(), exact);
  NamedState leaning(equations, state(power_of_ten(-20)));
  EXPECT_LT(abs(leaning(height) - (at.at("z") - rational(3, 2) * sin(power_of_ten(-20)))).to_double(), exact);
}

// The accelerations of what rolls need the point: flat, a pivot is no number, which the kernels report as singular.
TEST(DiscContact, LeavesAPivotThatIsNoNumberWhereARollingDiscLiesFlat) {
  LeaningDisc it;
  it.scene.point_in_plane("touches", it.touch, it.plane);
  it.scene.rolling("rolls", {.body = it.disc, .on = it.plane, .contact = it.touch, .tangents = it.plane});
  it.scene.initial(it.lean, 1);
  it.scene.initial(it.z, metres("1.5") * sin(Expression(1)));
  const Equations equations(it.scene);
  const auto regular = [&](const Real& lean) {
    NamedState here(equations, state(lean));
    for (const PivotTest& test : equations.forward().pivots) {
      if (!(here(test.pivot) > Real(0))) return false;
    }
    return true;
  };
  EXPECT_TRUE(regular(rational(1, 1)));
  EXPECT_TRUE(regular(rational(1, 1000)));
  EXPECT_FALSE(regular(Real(0)));
}

}  // namespace
}  // namespace torsor::lowest_point_test
