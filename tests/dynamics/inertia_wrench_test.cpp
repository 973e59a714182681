// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/motion/inertia_wrench.hpp"

#include <gtest/gtest.h>

#include "tests/dynamics/point_cloud.hpp"
#include "tests/dynamics/random_mechanism.hpp"

namespace torsor::inertia_wrench_test {
namespace {

using namespace testing_symbols;
using namespace testing_mechanisms;

/// Column of a vector given in a link, along the axes of another.
Column along(const Model& model, Evaluator<Real>& evaluate, const Vector& v, int from, int to) {
  return columns(evaluate, model.express(v, from, to));
}

TEST(InertiaWrench, IsASumOverTheBodysPoints) {
  const WorkingDigits precision(50);
  const BodyOnCarrier given;
  const Equations equations(given.scene);
  const Model& model = equations.model();
  Program& program = equations.program();
  const RandomState state(given.scene, 11);
  Evaluator<Real> evaluate(program, state.in_real());
  const int R = model.place("R", "test").link;
  const int S = model.place("S", "test").link;
  const Column a = columns(evaluate, model.locate(PointReference("X"), 0, "test"));
  // A point held in R, its place to be filled in: R's own acceleration where each point of the body is.
  Vector held;
  for (int i = 0; i < 3; ++i) held[i] = program.lower(given.frozen[static_cast<std::size_t>(i)]);
  const Vector held_acceleration = rates_of(rates_of(model.locate(held, R, 0)));
  const Vector omega = model.express(relative_twist(model, R, 0).angular, R, 0);
  Column transport{}, transport_moment{}, coriolis{}, coriolis_moment{};
  for (const Vector& local : BodyOnCarrier::points(program)) {
    const Vector in_R = model.locate(local, S, R);
    const Column place = columns(evaluate, in_R);
    Evaluator<Real> evaluate_held(program, [&](const SymbolPointer& symbol) {
      for (std::size_t i = 0; i < 3; ++i) {
        if (given.frozen[i].as_symbol() == symbol) return place[i];
      }
      return state.in_real()(symbol);
    });
    const Real m = BodyOnCarrier::mass_of_point();
    const Column arm = columns(evaluate, model.locate(local, S, 0)) - a;
    const Column carried = columns(evaluate_held, held_acceleration);
    const Column seen = along(model, evaluate, rates_of(in_R), R, 0);
    const Column turning = Real(2) * cross(columns(evaluate, omega), seen);
    transport = transport - m * carried;
    transport_moment = transport_moment - m * cross(arm, carried);
    coriolis = coriolis - m * turning;
    coriolis_moment = coriolis_moment - m * cross(arm, turning);
  }
  const ScrewQuery query{Scene::point("X"), "ground", "R"};
  const Wrench of_transport = transport_inertia_wrench(model, {"cloud"}, query);
  EXPECT_LT(distance(columns(evaluate, of_transport.resultant), transport), 1e-45);
  EXPECT_LT(distance(columns(evaluate, of_transport.moment), transport_moment), 1e-45);
  const Wrench of_coriolis = coriolis_inertia_wrench(model, {"cloud"}, query);
  EXPECT_LT(distance(columns(evaluate, of_coriolis.resultant), coriolis), 1e-45);
  EXPECT_LT(distance(columns(evaluate, of_coriolis.moment), coriolis_moment), 1e-45);
}

/// −{m Γ(G/ground); AG ∧ m Γ(G/ground) + d(J_G Ω)/dt} of the cloud, in the ground's axes, as the course prints it.
std::pair<Column, Column> printed_transport(const Model& model, Evaluator<Real>& evaluate, const std::string& body,
                                            const PointReference& point, const FrameReference& observer) {
  Program& program = model.program();
  const auto [link, mass] = mass_by_link(model, {body}, "test")[0];
  const int R = model.place(observer, "test").link;
  const Vector center = bound(program, pow(mass.mass, -1) * mass.first_moment);
  const Column AG =
      columns(evaluate, model.locate(center, link, 0)) - columns(evaluate, model.locate(point, 0, "test"));
  const Column force = columns(evaluate, rates_of(rates_of(model.locate(center, link, 0))));
  const Column m_gamma = evaluate(mass.mass) * force;
  Matrix central = mass.inertia;  // J_G = J_O − m (OG² 1 − OG OGᵀ)
  const Value square = dot(center, center);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (i == j) central(i, j) -= mass.mass * square;
      central(i, j) += mass.mass * (center[i] * center[j]);
    }
  }
  const Vector omega = model.express(relative_twist(model, R, 0).angular, R, link);
  const Vector spin = bound(program, bound(program, central) * omega);
  const Column moment = columns(evaluate, rates_of(model.express(spin, link, 0)));
  return {Real(-1) * m_gamma, Real(-1) * (cross(AG, m_gamma) + moment)};
}

TEST(InertiaWrench, IsThePrintedOneOnlyForABodyFixedInTheFrame) {
  const WorkingDigits precision(50);
  const BodyOnCarrier given;
  Scene scene = given.scene;
  const auto metre = [](const char* value) { return Expression::quantity(value, "m"); };
  scene.body("fixed", "R",
             Inertia::box(Expression::quantity("2", "kg"), metre("0.3"), metre("0.4"), metre("0.9"))
                 .at({metre("0.2"), metre("0.5"), 0}));
  const Equations equations(scene);
  const Model& model = equations.model();
  const RandomState state(scene, 11);
  Evaluator<Real> evaluate(equations.program(), state.in_real());
  const ScrewQuery query{Scene::point("X"), "ground", "R"};
  const auto fixed = printed_transport(model, evaluate, "fixed", Scene::point("X"), "R");
  const Wrench of_fixed = transport_inertia_wrench(model, {"fixed"}, query);
  EXPECT_LT(distance(columns(evaluate, of_fixed.resultant), fixed.first), 1e-45);
  EXPECT_LT(distance(columns(evaluate, of_fixed.moment), fixed.second), 1e-45);
  const Wrench none = coriolis_inertia_wrench(model, {"fixed"}, query);
  EXPECT_LT(distance(columns(evaluate, none.resultant), Column{}), 1e-45);
  EXPECT_LT(distance(columns(evaluate, none.moment), Column{}), 1e-45);
  const auto moving = printed_transport(model, evaluate, "cloud", Scene::point("X"), "R");
  const Wrench of_moving = transport_inertia_wrench(model, {"cloud"}, query);
  EXPECT_GT(distance(columns(evaluate, of_moving.resultant), moving.first), 1e-2);
  EXPECT_GT(distance(columns(evaluate, of_moving.moment), moving.second), 1e-2);
}

class RandomInertiaWrench : public ::testing::TestWithParam<unsigned> {};

/// {D(S/R)} − {transport} − {Coriolis} = {D(S/ground)}, the dynamic screws from positions, each in its own frame.
TEST_P(RandomInertiaWrench, MakesTheTheoremsHoldInAMovingFrame) {
  const WorkingDigits precision(50);
  const Scene scene = random_mechanism(GetParam(), {.actions = false, .constraints = false});
  const Equations equations(scene);
  const Model& model = equations.model();
  const RandomState state(scene, 5);
  Evaluator<Real> evaluate(equations.program(), state.in_real());
  const std::size_t last = scene.content().frames.size() - 1;
  const FrameReference R = FrameHandle{static_cast<int>(1 + GetParam() % last)};
  const FrameReference axes = FrameHandle{static_cast<int>(last)};
  for (const BodyNames& bodies : {all_bodies(model), BodyNames{scene.content().bodies.back().name}}) {
    const ScrewQuery seen{Scene::point("Q1"), axes, R};
    const DynamicScrew in_R = dynamic_screw_from_positions(model, bodies, seen);
    const DynamicScrew in_ground = dynamic_screw_from_positions(model, bodies, {Scene::point("Q1"), axes, "ground"});
    const Wrench transport = transport_inertia_wrench(model, bodies, seen);
    const Wrench coriolis = coriolis_inertia_wrench(model, bodies, seen);
    EXPECT_LT(distance(columns(evaluate, in_R.resultant - transport.resultant - coriolis.resultant),
                       columns(evaluate, in_ground.resultant)),
              1e-44);
    EXPECT_LT(distance(columns(evaluate, in_R.moment - transport.moment - coriolis.moment),
                       columns(evaluate, in_ground.moment)),
              1e-44);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomInertiaWrench, ::testing::Range(400U, 412U));

}  // namespace
}  // namespace torsor::inertia_wrench_test
