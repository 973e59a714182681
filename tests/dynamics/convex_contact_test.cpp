// SPDX-License-Identifier: GPL-3.0-or-later
// Contacts of smooth convex bodies with a plane, and laws of friction there.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "torsor/generator/dynamics/equations/validation.hpp"
#include "torsor/generator/dynamics/forces/energy.hpp"
#include "torsor/generator/verification/check.hpp"
#include "tests/dynamics/all_checks.hpp"
#include "tests/dynamics/named_state.hpp"
#include "tests/scenes/sliding.hpp"

namespace torsor::convex_contact_test {
namespace {

using namespace testing_symbols;
using namespace testing_mechanisms;
using namespace literals;

// Values of fifty digits: an identity holds to 1e-45.
constexpr double exact = 1e-45;

using Support = std::function<Expression(const Triple&)>;

/// A stone that is free over a plane: tilted by 3 in 5 about x, or level.
struct Stone {
  Scene scene{"stone"};
  Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m"), z = scene.coordinate("z", "m");
  AttitudeHandle e = scene.attitude("e");
  FrameHandle plane, body;
  explicit Stone(bool tilted = true) {
    const Number c = Number::rational(4, 5), s = Number::rational(3, 5), o, i(1);
    const Rotation slope = tilted ? Rotation::matrix({i, o, o, o, c, -s, o, s, c}) : Rotation();
    plane = scene.weld("plane", scene.ground(), {{0, 0, 0}, slope});
    body = scene.free("body", plane, {x, y, z}, e);
    scene.body("stone", body,
               Inertia::general({.mass = kilograms("2"), .xx = moment("0.5"), .yy = moment("1"), .zz = moment("1.3")}));
    scene.gravity({0, 0, Expression::quantity("-9.81", "m/s^2")});
  }
  PointHandle ellipsoid() {
    return scene.ellipsoid_contact("touch", body, {metres("1.5"), metres("1"), metres("0.5")}, plane);
  }
};

const Point leaning{{"e_w", rational(2, 5)}, {"e_x", rational(-4, 5)}, {"e_y", rational(1, 5)}, {"e_z", rational(2, 5)},
                    {"x", rational(1, 3)},   {"y", rational(-2, 7)},   {"z", rational(5, 4)}};

TEST(EllipsoidContact, IsWhereTheTangentPlaneIsParallelToThePlane) {
  Stone it;
  const PointHandle touch = it.ellipsoid();
  const Triple place = it.scene.position(touch, it.body), n = it.scene.direction(it.plane, axis::z, it.body);
  const Equations equations(it.scene);
  NamedState here(equations, leaning);
  const auto number = [&](const Expression& formula) { return here(equations.program().lower(formula)); };
  // On the surface, Σ P_i²/a_i² = 1, with the normal P_i/a_i² along −n.
  const std::array<Real, 3> squares{rational(9, 4), Real(1), rational(1, 4)};
  Real on_surface(0), along(0), length(0);
  for (std::size_t i = 0; i < 3; ++i) {
    const Real p = number(place[i]), normal = p / squares[i];
    on_surface += p * normal;
    along -= normal * number(n[i]);
    length += normal * normal;
  }
  EXPECT_LT(relative_difference(on_surface, Real(1)), exact);
  EXPECT_LT(relative_difference(along, sqrt(length)), exact);  // parallel to n, and opposite
}

TEST(SupportContact, OfABallAndOfADiscIsWhatTheirOwnContactsAre) {
  for (const bool disc : {false, true}) {
    Stone it;
    const Support of_ball = [](const Triple& u) {
      return metres("0.7") * sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
    };
    const Support of_disc = [](const Triple& u) { return metres("0.7") * sqrt(u[0] * u[0] + u[1] * u[1]); };
    const PointHandle wanted =
        disc ? it.scene.disc_contact("own",
                                     {.frame = it.body, .axis = axis::z, .radius = metres("0.7"), .plane = it.plane})
             : it.scene.sphere_contact("own", it.body, metres("0.7"), it.plane);
    const PointHandle found = it.scene.support_contact("touch", it.body, disc ? of_disc : of_ball, it.plane);
    it.scene.point_in_plane("by_own", wanted, it.plane);
    it.scene.point_in_plane("by_support", found, it.plane);
    const Equations equations(it.scene);
    NamedState here(equations, leaning);
    for (int i = 0; i < 3; ++i) {
      const Model& model = equations.model();
      EXPECT_LT(relative_difference(here(model.locate(PointReference(found), 0, "test")[i]),
                                    here(model.locate(PointReference(wanted), 0, "test")[i])),
                exact);
    }
    EXPECT_LT(relative_difference(here(equations.constraints()[1].value), here(equations.constraints()[0].value)), exact);
    for (std::size_t i = 0; i < 6; ++i) {
      EXPECT_LT(relative_difference(here(equations.constraints()[1].jacobian[i]),
                                    here(equations.constraints()[0].jacobian[i])),
                exact);
    }
  }
}

// An axis is a direction, as that of a joint: of another length it would be the rim of another radius.
TEST(DiscContact, IsThatOfItsAxisWhateverTheLengthOfTheVector) {
  Stone it;
  const Expression lean = it.scene.parameter("lean", "1", 1);
  const auto touch = [&it](const std::string& name, const Triple& axis, bool tube) {
    const PointHandle at =
        tube ? it.scene.torus_contact(name, {.frame = it.body, .axis = axis, .circle_radius = metres("0.7"),
                                             .tube_radius = metres("0.1"), .plane = it.plane})
             : it.scene.disc_contact(name, {.frame = it.body, .axis = axis, .radius = metres("0.7"), .plane = it.plane});
    it.scene.point_in_plane("by_" + name, at, it.plane);
  };
  for (const bool tube : {false, true}) {
    touch(tube ? "torus" : "disc", {Expression(3) / 5, 0, Expression(4) / 5}, tube);
    touch(tube ? "torus_of_any" : "disc_of_any", {3, 0, 4}, tube);
    touch(tube ? "torus_of_a_parameter" : "disc_of_a_parameter", {3 * lean, 0, 4}, tube);
  }
  const Equations equations(it.scene);
  NamedState here(equations, leaning);
  const std::vector<ConstraintRow>& rows = equations.constraints();
  for (std::size_t k = 0; k < 6; ++k) {
    EXPECT_LT(relative_difference(here(rows[k].value), here(rows[k / 3 * 3].value)), exact) << rows[k].name;
  }
  EXPECT_EQ(testing_errors::error_of<SceneError>([&] { touch("nowhere", {0, 0, 0}, false); }),
            "the axis of the disc at 'nowhere' is the null vector: give a direction");
  EXPECT_EQ(testing_errors::error_of<SceneError>([&] { touch("nowhere", {0, 0, 0}, true); }),
            "the axis of the torus at 'nowhere' is the null vector: give a direction");
  EXPECT_EQ(testing_errors::error_of<SceneError>([&] {
              it.scene.contact("c", shape::Disc{.frame = it.body, .axis = {0, 0, 0}, .radius = metres("1")},
                               shape::Plane{.frame = it.plane});
            }),
            "the axis of the contact 'c' is the null vector: give a direction");
}

TEST(TorusContact, LiesATubesRadiusBelowThatOfItsCircle) {
  Stone it;
  const PointHandle circle =
      it.scene.disc_contact("circle", {.frame = it.body, .axis = axis::z, .radius = metres("1.2"), .plane = it.plane});
  const PointHandle touch = it.scene.torus_contact("touch", {.frame = it.body,
                                                             .axis = axis::z,
                                                             .circle_radius = metres("1.2"),
                                                             .tube_radius = metres("0.3"),
                                                             .plane = it.plane});
  const Triple of_circle = it.scene.position(circle, it.plane), place = it.scene.position(touch, it.plane);
  it.scene.point_in_plane("floor", touch, it.plane);
  const Equations equations(it.scene);
  NamedState here(equations, leaning);
  const auto number = [&](const Expression& formula) { return here(equations.program().lower(formula)); };
  for (std::size_t i = 0; i < 2; ++i) EXPECT_LT(relative_difference(number(place[i]), number(of_circle[i])), exact);
  EXPECT_LT(relative_difference(number(place[2]), number(of_circle[2]) - rational(3, 10)), exact);
  EXPECT_LT(relative_difference(here(equations.constraints()[0].value), number(place[2])), exact);
}

TEST(SupportContact, IsRefusedForWhatIsNoConvexBody) {
  const auto refusal = [](const Support& h) {
    Stone it;
    it.scene.support_contact("touch", it.body, h, it.plane);
    return error_of<SceneError>([&] { validate(it.scene); });
  };
  const auto norm = [](const Triple& u) { return sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]); };
  EXPECT_EQ(refusal([&](const Triple& u) { return metres("1") * norm(u) + metres("0.2") * u[2]; }), "no error");
  EXPECT_NE(refusal([&](const Triple& u) { return metres("1") * norm(u) * norm(u); }).find("h(k u) = k h(u)"),
            std::string::npos);
  EXPECT_NE(refusal([&](const Triple& u) { return metres("1") * norm(u) - metres("2") * u[2] * u[2] / norm(u); })
                .find("not convex"),
            std::string::npos);
}

void roll(Stone& it, const PointHandle& touch) {
  it.scene.point_in_plane("floor", touch, it.plane);
  it.scene.rolling("roll", {.body = it.body, .on = it.scene.ground(), .contact = touch, .tangents = it.plane});
}

TEST(RollingEllipsoid, IsDerivedInTwoWaysAlike) {
  Stone it;
  roll(it, it.ellipsoid());
  it.scene.initial(it.z, metres("0.5"));
  expect_all_checks(it.scene);
}

/// A motion by the classical method of fourth order, from the program itself.
class Rolling {
 public:
  explicit Rolling(const Equations& equations)
      : equations_(equations), evaluate_(equations.program(), {}), positions_(equations.model().positions()) {
    for (int i = 0; i < equations.model().unknown_count(); ++i) {
      velocities_.push_back(equations.model().coordinates()[static_cast<std::size_t>(i)].v);
    }
    for (const SymbolPointer& q : positions_) outputs_.push_back(rate_of(equations.program(), q));
    for (const Value& a : equations.forward().accelerations) outputs_.push_back(a);
    energy_ = kinetic_energy(equations.model()) - gravity_force_function(equations.model());
  }
  std::vector<double> rates(const std::vector<double>& y) { return at(y)(outputs_); }
  double energy(const std::vector<double>& y) { return at(y)(energy_); }
  double height(const std::vector<double>& y) { return at(y)(equations_.constraints()[0].value); }

  std::vector<double> moved(std::vector<double> y, double duration, int steps) {
    const double h = duration / steps;
    const auto plus = [](std::vector<double> a, double k, const std::vector<double>& b) {
      for (std::size_t i = 0; i < a.size(); ++i) a[i] += k * b[i];
      return a;
    };
    for (int step = 0; step < steps; ++step) {
      const std::vector<double> a = rates(y), b = rates(plus(y, h / 2, a)), c = rates(plus(y, h / 2, b)),
                                d = rates(plus(y, h, c));
      for (std::size_t i = 0; i < y.size(); ++i) y[i] += h / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
    }
    return y;
  }

 private:
  Evaluator<double>& at(const std::vector<double>& y) {
    evaluate_.move_to([this, y](const SymbolPointer& symbol) {
      for (std::size_t i = 0; i < positions_.size(); ++i) {
        if (symbol == positions_[i]) return y[i];
      }
      for (std::size_t i = 0; i < velocities_.size(); ++i) {
        if (symbol == velocities_[i]) return y[positions_.size() + i];
      }
      return symbol->kind == SymbolKind::pi ? std::acos(-1.0) : 0.0;
    });
    return evaluate_;
  }

  const Equations& equations_;
  Evaluator<double> evaluate_;
  std::vector<SymbolPointer> positions_, velocities_;
  std::vector<Value> outputs_;
  Value energy_;
};

/// An ellipsoid that rocks and rolls on a level plane keeps its energy and its contact: what the method of fourth order
/// leaves of both falls by 2^4 when the step is halved.
TEST(RollingEllipsoid, KeepsItsEnergyAndItsContact) {
  Stone it(false);
  roll(it, it.ellipsoid());
  const Equations equations(it.scene);
  Rolling motion(equations);
  // x y z e ẋ ẏ ż ω: V(C) = Ω ∧ PC with PC = (0, 0, 1/2) m.
  const std::vector<double> start{0, 0, 0.5, 1, 0, 0, 0, 0.5 * 2, -0.5 * 1.5, 0, 1.5, 2, 0.3};
  const double before = motion.energy(start);
  const auto drift = [&](int steps) {
    const std::vector<double> end = motion.moved(start, 1, steps);
    EXPECT_GT(std::abs(end[4]) + std::abs(end[5]), 0.2);  // it has turned
    return std::pair(std::abs(motion.energy(end) - before) / before, std::abs(motion.height(end)));
  };
  const auto coarse = drift(100), fine = drift(200);
  EXPECT_LT(fine.first, coarse.first / 8);
  EXPECT_LT(fine.second, coarse.second / 8);
  EXPECT_LT(fine.first, 1e-6);
  EXPECT_LT(fine.second, 1e-6);
}

struct HeavyBlock : Block {
  HeavyBlock() { scene.gravity({0, 0, quantity("-9.81", "m/s^2")}); }
};

TEST(FrictionLaw, IsMinusNPhiAlongTheSlip) {
  // φ(s) = 1/5 + 3/10 exp(-s/(2 m/s)): of a slip (3, -4) m/s, 5 m/s long.
  HeavyBlock it;
  it.scene.friction_law(
      "law", it.floor,
      {.law = [](const Expression& s) { return 0.2_r + 0.3_r * exp(-s / Expression::quantity("2", "m/s")); },
       .body = it.block,
       .point = it.contact,
       .plane = it.scene.ground()});
  const Equations equations(it.scene);
  const WorkingDigits precision(50);
  NamedState here(equations, {{"x'", Real(3)}, {"y'", Real(-4)}});
  const Real phi = rational(1, 5) + rational(3, 10) * exp(rational(-5, 2)), g = rational(981, 100);
  // The smoothing of 1e-6 m/s takes 2e-14 of the force, and as little of φ.
  EXPECT_LT(relative_difference(here(equations.forward().accelerations[0]), -(phi * g * rational(3, 5))), 1e-13);
  EXPECT_LT(relative_difference(here(equations.forward().accelerations[1]), phi * g * rational(4, 5)), 1e-13);
  EXPECT_LT(relative_difference(here(equations.forward().multipliers[0]), Real(2) * g), exact);
  EXPECT_LT(relative_difference(here(equations.power()), -(Real(2) * g * phi * Real(5))), 1e-12);
  expect_all_checks(it.scene);
}

TEST(FrictionLaw, IsSmoothThroughRest) {
  HeavyBlock it;
  const Expression smoothing = Expression::quantity("0.01", "m/s");
  it.scene.friction_law("law", it.floor,
                        {.law = [](const Expression&) { return 0.5_r; },
                         .body = it.block,
                         .point = it.contact,
                         .plane = it.scene.ground(),
                         .other = it.scene.ground(),
                         .smoothing = smoothing});
  const Equations equations(it.scene);
  NamedState at_rest(equations, {}), creeping(equations, {{"x'", rational(1, 100)}});
  EXPECT_TRUE(at_rest(equations.forward().accelerations[0]).is_zero());
  const Value slope =
      partial_derivation(equations.program(), equations.model().coordinates()[0].v)(equations.forward().accelerations[0]);
  const Real g = rational(981, 100);
  EXPECT_LT(relative_difference(at_rest(slope), -(rational(1, 2) * g * Real(100))), exact);  // -f g/ε
  EXPECT_LT(relative_difference(creeping(equations.forward().accelerations[0]), -(rational(1, 2) * g / sqrt(Real(2)))),
            exact);
  EXPECT_NE(error_of<SceneError>([&] {
              it.scene.friction_law("sharp", it.floor,
                                    {.law = [](const Expression&) { return 0.5_r; },
                                     .body = it.block,
                                     .point = it.contact,
                                     .plane = it.scene.ground(),
                                     .other = it.scene.ground(),
                                     .smoothing = 0});
            }).find("no number at rest"),
            std::string::npos);
}

/// −N φ G/s of a block on a plane, tilted by 3 in 5 about x or level, that slides along x alone, or along x and y.
void expect_digits_of_slopes(const std::function<Expression(const Expression&)>& law, bool tilted, bool across) {
  Scene scene("slides");
  const Number c = Number::rational(4, 5), s = Number::rational(3, 5), o, i(1);
  const Expression x = scene.coordinate("x", "m"), z = scene.coordinate("z", "m");
  const FrameHandle plane =
      scene.weld("plane", scene.ground(), {{0, 0, 0}, tilted ? Rotation::matrix({i, o, o, o, c, -s, o, s, c}) : Rotation()});
  FrameHandle slide = scene.prismatic("along", across ? scene.ground() : plane, axis::x, x);
  if (across) slide = scene.prismatic("across", slide, axis::y, scene.coordinate("y", "m"));
  const FrameHandle block = scene.prismatic("block", slide, axis::z, z);
  scene.body("block", block, Inertia::point(scene.parameter("m", "kg", 2)));
  scene.gravity({0, 0, quantity("-9.81", "m/s^2")});
  const PointHandle foot = scene.point("foot", block, {0, 0, 0});
  const ConstraintHandle held = scene.point_in_plane("held", foot, plane);
  scene.friction_law("friction", held, {.law = law, .body = block, .point = foot, .plane = plane});
  for (const CheckResult& result : check_scene(scene, {.digits = 40, .states = 4})) {
    EXPECT_TRUE(result.passed()) << result.name << ": " << result.worst << " of " << result.bound << (across ? ", across" : "");
  }
}

// The slope of G/s is ε²/s³ along G, 1e-12 of 1/s: where φ' is small it is all there is.
TEST(FrictionLaw, HasSlopesWithAllTheirDigits) {
  const auto stribeck = [](const Expression& s) { return 0.3_r + exp(-s / Expression::quantity("0.1", "m/s")); };
  const auto constant = [](const Expression&) { return 0.3_r; };
  const auto viscous = [](const Expression& s) { return 0.3_r + s / Expression::quantity("5", "m/s"); };
  for (const bool tilted : {false, true}) {
    for (const bool across : {false, true}) {
      expect_digits_of_slopes(stribeck, tilted, across);
      expect_digits_of_slopes(constant, tilted, across);
      expect_digits_of_slopes(viscous, tilted, across);
    }
  }
}

/// Of a rolling ellipsoid with a law of friction in place of adhesion: two derivations of everything.
TEST(FrictionLaw, ActsOnAConvexBody) {
  Stone it;
  const PointHandle touch = it.ellipsoid();
  const ConstraintHandle floor = it.scene.point_in_plane("floor", touch, it.plane);
  it.scene.friction_law(
      "law", floor,
      {.law = [](const Expression& s) { return 0.4_r * min(s / Expression::quantity("0.1", "m/s"), 1); },
       .body = it.body,
       .point = touch,
       .plane = it.plane});
  it.scene.initial(it.z, metres("0.5"));
  expect_all_checks(it.scene);
}

}  // namespace
}  // namespace torsor::convex_contact_test
