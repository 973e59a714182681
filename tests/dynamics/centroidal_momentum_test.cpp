// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/recursions/centroidal_momentum.hpp"

#include <gtest/gtest.h>

#include "torsor/generator/dynamics/equations/equations.hpp"
#include "torsor/generator/dynamics/motion/motion.hpp"
#include "torsor/generator/kernels/kernel.hpp"
#include "torsor/generator/verification/random_state.hpp"
#include "tests/dynamics/named_state.hpp"
#include "tests/dynamics/random_mechanism.hpp"
#include "tests/scenes/bodies.hpp"

namespace torsor::centroidal_momentum_test {
namespace {

using namespace testing_mechanisms;

/// Against the sum over links of their momentum screws, by the recursion of twists in the links' axes, carried to the
/// ground link by link; columns against derivatives by velocities. Everything is of order one to 1e4: 50 digits leave
/// 1e-44.
void expect_sum_over_links(const Scene& scene) {
  const WorkingDigits precision(50);
  const Equations equations(scene);
  const Model& model = equations.model();
  Program& program = equations.program();
  const CentroidalMomentum found = centroidal_momentum(model);
  const RandomState state(scene, 5);
  Evaluator<Real> at(program, state.in_real());
  const auto size = [&](const Vector& v) {
    double sum = 0;
    for (int i = 0; i < 3; ++i) sum += abs(at(v[i])).to_double();
    return sum;
  };

  Value mass;
  Vector moment;  // Σ m OG
  MomentumScrew at_origin;
  const std::vector<Twist> all = twists(model);
  for (std::size_t k = 1; k < all.size(); ++k) {
    const MassProperties& body = model.links()[k].mass;
    const int link = static_cast<int>(k);
    const MomentumScrew own = momentum(body, all[k]);
    const Vector origin = bound(program, model.locate(Vector(), link, 0));
    const Vector linear = bound(program, model.express(own.resultant, link, 0));
    mass += body.mass;
    moment += body.mass * origin;
    moment += model.express(body.first_moment, link, 0);
    at_origin.resultant += linear;
    at_origin.moment += model.express(own.moment, link, 0);
    at_origin.moment += cross(origin, linear);
  }
  mass = program.bind(mass);
  moment = bound(program, moment);
  const Vector resultant = bound(program, at_origin.resultant);
  EXPECT_LE(size(mass * found.center - moment), 1e-44) << scene.name();
  EXPECT_LE(size(found.momentum.resultant - resultant), 1e-44) << scene.name();
  const Vector about_center = bound(program, at_origin.moment - cross(found.center, resultant));
  EXPECT_LE(size(found.momentum.moment - about_center), 1e-44) << scene.name();
  EXPECT_GT(size(about_center), 0) << scene.name() << ": nothing was compared";
  for (int i = 0; i < model.unknown_count(); ++i) {
    Derivation by = partial_derivation(program, model.coordinates()[static_cast<std::size_t>(i)].v);
    const MomentumScrew& column = found.columns[static_cast<std::size_t>(i)];
    const auto slope = [&by](const Vector& v) { return Vector(by(v[0]), by(v[1]), by(v[2])); };
    EXPECT_LE(size(column.resultant - slope(resultant)), 1e-44) << scene.name() << ", column " << i;
    EXPECT_LE(size(column.moment - slope(about_center)), 1e-44) << scene.name() << ", column " << i;
  }
}

class RandomMomenta : public ::testing::TestWithParam<unsigned> {};

TEST_P(RandomMomenta, AreSumsOverLinks) {
  expect_sum_over_links(random_mechanism(GetParam(), {.actions = false, .constraints = false}));
  expect_sum_over_links(random_mechanism(GetParam(), {.actions = false, .constraints = false, .joints = true}));
}
INSTANTIATE_TEST_SUITE_P(Seeds, RandomMomenta, ::testing::Range(1U, 9U));

/// A disk of 1 kg and 2 kg m² on a cart of 3 kg, a metre above it: p = 4 v and σ = 2 ω, C is a quarter metre up.
TEST(CentroidalMomentum, IsThatOfACartWithARotor) {
  const WorkingDigits precision(50);
  Scene scene("cart_with_a_rotor");
  const Expression x = scene.coordinate("x", "m"), q = scene.coordinate("q", "rad");
  const FrameHandle cart = scene.prismatic("cart", scene.ground(), axis::x, x);
  scene.body("cart_mass", cart, Inertia::point(kilograms("3")));
  const FrameHandle bearing = scene.weld("bearing", cart, {{0, metres("1"), 0}, {}});
  scene.body("rotor", scene.revolute("turning", bearing, axis::z, q), Inertia::disk(kilograms("1"), metres("2"), 2));
  const Equations equations(scene);
  const CentroidalMomentum found = centroidal_momentum(equations.model());
  const auto& coordinates = equations.model().coordinates();
  NamedState state(equations, {{"x", Real(7)}, {coordinates[0].v->name, Real(5)}, {coordinates[1].v->name, Real(-3)}});
  const auto expect = [&state](const Vector& v, double vx, double vy, double vz) {
    EXPECT_EQ(state.in_double(v[0]), vx);
    EXPECT_EQ(state.in_double(v[1]), vy);
    EXPECT_EQ(state.in_double(v[2]), vz);
  };
  expect(found.center, 7, 0.25, 0);
  expect(found.momentum.resultant, 20, 0, 0);
  expect(found.momentum.moment, 0, 0, -6);
  expect(found.columns[0].resultant, 4, 0, 0);
  expect(found.columns[0].moment, 0, 0, 0);  // 1 kg above C has what 3 kg below have
  expect(found.columns[1].resultant, 0, 0, 0);
  expect(found.columns[1].moment, 0, 0, 2);
}

TEST(CentroidalMomentum, IsAbsentWhereNothingMoves) {
  Scene scene("bolted");
  scene.coordinate("q", "rad");
  EXPECT_EQ(why_absent("centroidal_momentum", Equations(scene)), "no body that moves has a mass");
}

}  // namespace
}  // namespace torsor::centroidal_momentum_test
