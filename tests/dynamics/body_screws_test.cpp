// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/motion/body_screws.hpp"

#include <gtest/gtest.h>

#include "torsor/generator/dynamics/forces/energy.hpp"
#include "tests/dynamics/point_cloud.hpp"
#include "tests/dynamics/random_mechanism.hpp"

namespace torsor::body_screws_test {
namespace {

using namespace testing_symbols;
using namespace testing_mechanisms;

/// ∫ V dm, ∫ AP ∧ V dm, ∫ Γ dm, ∫ AP ∧ Γ dm and ½ ∫ V² dm over the eight points, seen from a link, in its axes.
struct Sums {
  Column momentum{}, moment{}, force{}, dynamic_moment{};
  Real energy;

  Sums(const Equations& equations, Evaluator<Real>& evaluate, int observer, const PointReference& about) {
    const Model& model = equations.model();
    const int body = model.place("S", "test").link;
    const Column a = columns(evaluate, model.locate(about, observer, "test"));
    for (const Vector& local : BodyOnCarrier::points(equations.program())) {
      const Vector place = model.locate(local, body, observer);
      const Vector velocity = rates_of(place);
      const Column arm = columns(evaluate, place) - a;
      const Column v = columns(evaluate, velocity);
      const Column gamma = columns(evaluate, rates_of(velocity));
      const Real m = BodyOnCarrier::mass_of_point();
      momentum = momentum + m * v;
      moment = moment + m * cross(arm, v);
      force = force + m * gamma;
      dynamic_moment = dynamic_moment + m * cross(arm, gamma);
      energy += m * dot(v, v) / Real(2);
    }
  }
};

TEST(BodyScrews, AreSumsOverTheBodysPoints) {
  const WorkingDigits precision(50);
  const BodyOnCarrier given;
  const Equations equations(given.scene);
  const Model& model = equations.model();
  const RandomState state(given.scene, 3);
  Evaluator<Real> evaluate(equations.program(), state.in_real());
  for (const char* observer : {"ground", "R", "arm"}) {
    for (const char* point : {"X", "E"}) {
      const Sums sums(equations, evaluate, model.place(observer, "test").link, PointReference(point));
      const ScrewQuery query{Scene::point(point), observer, observer};
      const MomentumScrew momentum = momentum_screw(model, {"cloud"}, query);
      EXPECT_LT(distance(columns(evaluate, momentum.resultant), sums.momentum), 1e-45) << observer;
      EXPECT_LT(distance(columns(evaluate, momentum.moment), sums.moment), 1e-45) << observer << point;
      const DynamicScrew dynamic = dynamic_screw(model, {"cloud"}, query);
      EXPECT_LT(distance(columns(evaluate, dynamic.resultant), sums.force), 1e-45) << observer;
      EXPECT_LT(distance(columns(evaluate, dynamic.moment), sums.dynamic_moment), 1e-45) << observer << point;
      EXPECT_LT(relative_difference(evaluate(kinetic_energy(model, {"cloud"}, observer)), sums.energy), 1e-45);
      const Value energy = kinetic_energy_at(model, {"cloud"}, Scene::point(point), observer);
      EXPECT_LT(relative_difference(evaluate(energy), sums.energy), 1e-45) << observer << point;
    }
  }
}

class RandomScrews : public ::testing::TestWithParam<unsigned> {};

TEST_P(RandomScrews, AreTheSameFromTwistsAndFromPositions) {
  const WorkingDigits precision(50);
  Scene scene = random_mechanism(GetParam(), {.actions = false, .constraints = false});
  const CoordinateContent q = scene.content().coordinates.front();
  const Expression any = Expression(q.q) / Expression::quantity(Number(1), q.q->unit);
  const Expression metre = Expression::quantity("1", "m");
  const std::size_t last = scene.content().frames.size() - 1;
  const FrameReference observer = FrameHandle{static_cast<int>(1 + GetParam() % last)};
  const FrameReference axes = FrameHandle{static_cast<int>(last)};
  scene.point("X", axes, {metre * sin(any), metre / 3, metre * any / 5});
  const Equations equations(scene);
  const Model& model = equations.model();
  const RandomState state(scene, 5);
  Evaluator<Real> evaluate(equations.program(), state.in_real());
  const BodyNames bodies = all_bodies(model);
  for (const ScrewQuery& query :
       {ScrewQuery{Scene::point("X"), axes, "ground"}, ScrewQuery{Scene::point("Q0"), "ground", observer}, ScrewQuery{Scene::point("X"), observer, observer}}) {
    const MomentumScrew momentum = momentum_screw(model, bodies, query);
    const MomentumScrew momentum_again = momentum_screw_from_positions(model, bodies, query);
    EXPECT_LT(distance(columns(evaluate, momentum.resultant), columns(evaluate, momentum_again.resultant)), 1e-44);
    EXPECT_LT(distance(columns(evaluate, momentum.moment), columns(evaluate, momentum_again.moment)), 1e-44);
    const DynamicScrew dynamic = dynamic_screw(model, bodies, query);
    const DynamicScrew dynamic_again = dynamic_screw_from_positions(model, bodies, query);
    EXPECT_LT(distance(columns(evaluate, dynamic.resultant), columns(evaluate, dynamic_again.resultant)), 1e-44);
    EXPECT_LT(distance(columns(evaluate, dynamic.moment), columns(evaluate, dynamic_again.moment)), 1e-44);
  }
  const Real energy = evaluate(kinetic_energy_from_positions(model));
  EXPECT_LT(relative_difference(evaluate(kinetic_energy(model, bodies)), energy), 1e-44);
  Real sum(0);
  for (const std::string& body : bodies) sum += evaluate(kinetic_energy_at(model, {body}, Scene::point("X")));
  EXPECT_LT(relative_difference(sum, energy), 1e-44);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomScrews, ::testing::Range(300U, 308U));

/// An eccentric disk of radius r on a horizontal line; x and φ are independent, so that it may slip. The contact I is
/// at (x, 0): its velocity ẋ is not that of the disk's own point there, ẋ + r φ̇.
struct EccentricDisk {
  EccentricDisk() {
    const auto metre = [](const char* value) { return Expression::quantity(value, "m"); };
    const Expression x = scene.coordinate("x", "m");
    const FrameHandle slide = scene.prismatic("slide", scene.ground(), axis::x, x, {.origin = {0, metre("0.5"), 0}});
    const FrameHandle disk = scene.revolute("disk", slide, axis::z, scene.coordinate("phi", "rad"));
    scene.body("disk", disk,
               Inertia::general({.mass = Expression::quantity("3", "kg"), .zz = Expression::quantity("0.4", "kg m^2")})
                   .at({metre("0.2"), 0, 0}));
    scene.point("I", scene.ground(), {x, 0, 0});
  }
  Scene scene{"eccentric_disk"};
};

TEST(DynamicScrew, TakesTheVelocityOfTheGeometricPointOfContact) {
  const WorkingDigits precision(50);
  const EccentricDisk given;
  const Equations equations(given.scene);
  const Model& model = equations.model();
  const Real m(3), r = rational(1, 2), e = rational(1, 5), J = rational(2, 5), phi = rational(7, 10);
  const Real dx = rational(6, 5), dphi = rational(-9, 4), ddx = rational(3, 7), ddphi = rational(5, 3);
  Evaluator<Real> evaluate(
      equations.program(),
      at({{"x", rational(1, 3)}, {"phi", phi}, {"x'", dx}, {"phi'", dphi}, {"x''", ddx}, {"phi''", ddphi}}));
  // G = (x + e cos φ, r + e sin φ) by hand.
  const Column IG{e * cos(phi), r + e * sin(phi), Real(0)};
  const Column VG{dx - e * sin(phi) * dphi, e * cos(phi) * dphi, Real(0)};
  const Column acceleration{ddx - e * sin(phi) * ddphi - e * cos(phi) * dphi * dphi,
                            e * cos(phi) * ddphi - e * sin(phi) * dphi * dphi, Real(0)};
  const Real sigma = cross(IG, m * VG)[2] + J * dphi;
  const Real delta = cross(IG, m * acceleration)[2] + J * ddphi;
  const ScrewQuery query{Scene::point("I")};
  const Vector moment = momentum_screw(model, {"disk"}, query).moment;
  EXPECT_LT(relative_difference(evaluate(moment[2]), sigma), 1e-45);
  // σ_I = m IG ∧ V(I ∈ S) + J_I Ω wants the disk's own point ...
  const Real J_I = J + m * dot(IG, IG);
  const Column own_point{dx + r * dphi, Real(0), Real(0)};
  const Column geometric{dx, Real(0), Real(0)};
  EXPECT_LT(relative_difference(cross(IG, m * own_point)[2] + J_I * dphi, sigma), 1e-45);
  EXPECT_GT(relative_difference(cross(IG, m * geometric)[2] + J_I * dphi, sigma), 1e-2);
  // ... and δ_I = dσ_I/dt + m V(I) ∧ V_G the geometric one.
  const Real sigma_rate = evaluate(time_derivative(moment[2]));
  EXPECT_LT(relative_difference(evaluate(dynamic_screw(model, {"disk"}, query).moment[2]), delta), 1e-45);
  EXPECT_LT(relative_difference(sigma_rate + cross(geometric, m * VG)[2], delta), 1e-45);
  EXPECT_GT(relative_difference(sigma_rate + cross(own_point, m * VG)[2], delta), 1e-2);
}

/// The course's summary prints J_G for J_Q in 2T = m V_Q² + Ω·J_Q Ω + 2 m V_Q·(Ω ∧ QG): at Q ≠ G that is another
/// number.
TEST(KineticEnergy, NeedsTheOperatorAtThePointItIsWrittenAt) {
  const WorkingDigits precision(50);
  const EccentricDisk given;
  const Equations equations(given.scene);
  const Real m(3), r = rational(1, 2), e = rational(1, 5), J = rational(2, 5), phi = rational(7, 10);
  const Real dx = rational(6, 5), dphi = rational(-9, 4);
  Evaluator<Real> evaluate(equations.program(), at({{"x", rational(1, 3)}, {"phi", phi}, {"x'", dx}, {"phi'", dphi}}));
  const Column IG{e * cos(phi), r + e * sin(phi), Real(0)};
  const Column VG{dx - e * sin(phi) * dphi, e * cos(phi) * dphi, Real(0)};
  const Real doubled = m * dot(VG, VG) + J * dphi * dphi;  // König
  EXPECT_LT(relative_difference(evaluate(kinetic_energy_at(equations.model(), {"disk"}, Scene::point("I"))), doubled / Real(2)),
            1e-45);
  const Column V_I{dx + r * dphi, Real(0), Real(0)};
  const Column turned = cross({Real(0), Real(0), dphi}, IG);
  const Real mixed = Real(2) * m * dot(V_I, turned);
  const Real J_I = J + m * dot(IG, IG);
  EXPECT_LT(relative_difference(m * dot(V_I, V_I) + J_I * dphi * dphi + mixed, doubled), 1e-45);
  EXPECT_GT(relative_difference(m * dot(V_I, V_I) + J * dphi * dphi + mixed, doubled), 1e-2) << "J_G as printed";
}

TEST(BodyScrews, NameWhatIsAskedWrongly) {
  const BodyOnCarrier given;
  const Equations equations(given.scene);
  const Model& model = equations.model();
  EXPECT_EQ(error_of<SceneError>([&] { momentum_screw(model, {"moon"}, {Scene::point("X")}); }),
            "unknown body 'moon' in a momentum screw: the scene has cloud, weight");
  EXPECT_EQ(error_of<SceneError>([&] {
              dynamic_screw(model, {"cloud", "weight", "cloud"}, {Scene::point("X")});
            }),
            "a dynamic screw names the body 'cloud' twice");
  EXPECT_EQ(error_of<SceneError>([&] { dynamic_screw(model, {}, {Scene::point("X")}); }),
            "a dynamic screw is asked for no body: name at least one of cloud, weight");
  EXPECT_EQ(error_of<SceneError>([&] {
              kinetic_energy_at(model, {"cloud", "weight"}, Scene::point("X"));
            }),
            "the kinetic energy at a point is that of one rigid body, and the bodies asked for move on 2 links (R, S, "
            "...): ask for each, or for kinetic_energy");
}

}  // namespace
}  // namespace torsor::body_screws_test
