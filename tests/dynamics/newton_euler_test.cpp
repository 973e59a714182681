// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/theorems/newton_euler.hpp"

#include <gtest/gtest.h>

#include "torsor/generator/dynamics/forces/constraint_wrench.hpp"
#include "tests/dynamics/named_state.hpp"
#include "tests/dynamics/point_cloud.hpp"
#include "tests/dynamics/random_mechanism.hpp"
#include "tests/scenes/pendulums.hpp"

namespace torsor::newton_euler_test {
namespace {

using namespace testing_symbols;
using namespace testing_mechanisms;

double gap(Evaluator<Real>& evaluate, const Wrench& a, const Wrench& b) {
  return distance(columns(evaluate, a.resultant), columns(evaluate, b.resultant)) +
         distance(columns(evaluate, a.moment), columns(evaluate, b.moment));
}

/// Bodies of a link and of all that hangs on it.
BodyNames bodies_beyond(const Model& model, std::size_t top) {
  BodyNames names;
  for (const BodyContent& body : model.scene().bodies) {
    for (const int k : model.chain(model.place(body.frame, "test").link)) {
      if (k == static_cast<int>(top)) names.push_back(body.name);
    }
  }
  return names;
}

class RandomNewtonEuler : public ::testing::TestWithParam<unsigned> {};

/// Along each freedom the joints transmit the generalised force that Lagrange's equation wants there: that of the
/// inertia forces by virtual power, less what acts on the bodies themselves.
TEST_P(RandomNewtonEuler, TransmitsTheGeneralisedForcesThroughTheJoints) {
  const WorkingDigits precision(50);
  const Scene scene = random_mechanism(GetParam());
  const Equations equations(scene);
  const Model& model = equations.model();
  const RandomState state(scene, 9);
  Evaluator<Real> evaluate(equations.program(), state.in_real());
  const std::vector<Wrench> transmitted = transmitted_wrenches(equations);
  std::vector<Real> efforts(model.coordinates().size(), Real(0));
  for (std::size_t k = 1; k < transmitted.size(); ++k) {
    const Link& link = model.links()[k];
    const bool turns = link.joint != JointKind::prismatic;
    const Value effort = dot(link.axis, turns ? transmitted[k].moment : transmitted[k].resultant);
    for (const auto& [i, partial] : link.partials) {
      efforts[static_cast<std::size_t>(i)] += evaluate(partial) * evaluate(effort);
    }
  }
  for (std::size_t i = 0; i < efforts.size(); ++i) {
    Real expected = evaluate(equations.inverse_dynamics()[i]) + evaluate(equations.actions().passive[i]);
    for (std::size_t j = 0; j < equations.constraints().size(); ++j) {
      const ConstraintRow& row = equations.constraints()[j];
      if (constraint_wrench(model, static_cast<int>(j))) continue;
      expected += evaluate(equations.program().symbol(row.multiplier)) * evaluate(row.column[i]);
    }
    EXPECT_LT(relative_difference(efforts[i], expected), 1e-43) << model.coordinates()[i].q->name;
  }
}

TEST_P(RandomNewtonEuler, IsolatesASubTreeAsTheRecursionDoes) {
  const WorkingDigits precision(50);
  const Scene scene = random_mechanism(GetParam());
  const Equations equations(scene);
  const Model& model = equations.model();
  const RandomState state(scene, 9);
  Evaluator<Real> evaluate(equations.program(), state.in_real());
  const FrameReference axes = FrameHandle{static_cast<int>(scene.content().frames.size()) - 1};
  for (std::size_t k = 1; k < model.links().size(); ++k) {
    const BodyNames bodies = bodies_beyond(model, k);
    const ScrewQuery query{Scene::point("P1"), axes};
    const Wrench recursive = transmitted_wrench(equations, model.links()[k].name, query);
    EXPECT_LT(gap(evaluate, newton_euler(equations, bodies, query).transmitted, recursive), 1e-43) << k;
    // Seen from a moving frame the inertia wrenches make up for the other dynamic screw.
    const ScrewQuery moving{Scene::point("P1"), axes, "body0"};
    const NewtonEuler theorem = newton_euler(equations, bodies, moving);
    EXPECT_LT(gap(evaluate, theorem.transmitted, recursive), 1e-43) << k;
    EXPECT_GT(gap(evaluate, theorem.inertia, Wrench{}), 1e-6) << k;
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomNewtonEuler, ::testing::Range(500U, 520U));

/// An arm on a skew base; the forearm's joint about z once closed, and once with all its other directions released.
struct Elbow {
  explicit Elbow(bool released) {
    const Expression q1 = scene.coordinate("q1", "rad");
    const Expression q2 = scene.coordinate("q2", "rad");
    const FrameHandle arm = scene.revolute("arm", scene.ground(), {1, 2, 2}, q1);
    const Placement elbow{.origin = {metres("0.7"), 0, metres("0.1")}, .rotation = Rotation::about(0, 5)};
    const FrameHandle fixed = scene.weld("fixed", arm, elbow);
    FrameHandle last = fixed;
    if (released) {
      const std::array<Triple, 3> directions{axis::x, axis::y, axis::z};
      for (std::size_t i = 0; i < 3; ++i) {
        const std::string name(1, "XYZ"[i]);
        last = scene.prismatic("slide_" + name, last, directions[i], scene.released_coordinate(name, "m"));
      }
      for (std::size_t i = 0; i < 2; ++i) {
        const std::string name(1, "LM"[i]);
        last = scene.revolute("turn_" + name, last, directions[i], scene.released_coordinate(name, "rad"));
      }
    }
    const FrameHandle forearm = scene.revolute("forearm", last, axis::z, q2);
    const Inertia box = Inertia::box(kilograms("2"), metres("0.8"), metres("0.1"), metres("0.2"));
    scene.body("arm", arm, box.at({metres("0.4"), 0, 0}));
    scene.body("forearm", forearm, box.at({metres("0.4"), metres("0.1"), metres("0.2")}));
    scene.gravity({0, Expression::quantity("-2", "m/s^2"), Expression::quantity("-9.81", "m/s^2")});
    scene.point("E", fixed, {0, 0, 0});
    scene.point("tip", forearm, {metres("0.8"), 0, 0});
    scene.point("post", scene.ground(), {metres("1"), metres("2"), 0});
    scene.spring("tie", {.a = scene.point("tip"),
                         .b = scene.point("post"),
                         .stiffness = Expression::quantity("70", "N/m"),
                         .rest = metres("0.5")});
    scene.motor("torque", q2);
  }
  Scene scene{"elbow"};
};

TEST(TransmittedWrench, HasTheReactionsFoundWithReleasedCoordinates) {
  const WorkingDigits precision(50);
  const Elbow closed(false), open(true);
  const Equations of_closed(closed.scene), of_open(open.scene);
  const Point point{{"q1", rational(3, 7)},  {"q2", rational(-8, 5)},  {"q1'", rational(9, 4)},
                    {"q2'", rational(5, 3)}, {"q1''", rational(1, 3)}, {"q2''", rational(-7, 2)}};
  NamedState state(of_closed, point), state_open(of_open, point);
  const Wrench wrench = transmitted_wrench(of_closed, "forearm", {Scene::point("E"), "fixed"});
  const std::vector<Value>& forces = of_open.inverse_dynamics();  // q1, q2, then X, Y, Z, L, M
  for (int i = 0; i < 3; ++i) {
    EXPECT_LT(relative_difference(state(wrench.resultant[i]), state_open(forces[static_cast<std::size_t>(2 + i)])),
              1e-45);
  }
  for (int i = 0; i < 2; ++i) {
    EXPECT_LT(relative_difference(state(wrench.moment[i]), state_open(forces[static_cast<std::size_t>(5 + i)])), 1e-45);
  }
  EXPECT_LT(relative_difference(state(wrench.moment[2]), state_open(forces[1])), 1e-45);
  EXPECT_GT(abs(state(wrench.moment[0])).to_double(), 0.1);
}

TEST(NewtonEuler, GivesTheTensionInTheRodOfAPendulum) {
  const WorkingDigits precision(50);
  Scene scene = pendulum();
  scene.point("O", scene.ground(), {0, 0, 0});
  const Equations equations(scene);
  const Real m(2), l = rational(3, 2), g = rational(981, 100), theta = rational(2, 3), rate = rational(7, 5);
  NamedState state(equations, {{"theta", theta}, {"theta'", rate}, {"theta''", -g * sin(theta) / l}});
  // Along the rod: tension = m (g cos θ + l θ̇²), towards O along y of the arm; nothing across, no moment about O.
  const ScrewQuery query{Scene::point("O"), "arm"};
  const NewtonEulerEquation along = newton_euler_along(equations, {"bob"}, {query, Theorem::resultant, axis::y});
  EXPECT_LT(relative_difference(state(along.transmitted), m * (g * cos(theta) + l * rate * rate)), 1e-45);
  EXPECT_LT(relative_difference(state(along.known), -(m * g * cos(theta))), 1e-45);
  EXPECT_LT(relative_difference(state(along.dynamic), m * l * rate * rate), 1e-45);
  EXPECT_TRUE(along.constraints.is_zero());
  const NewtonEulerEquation across = newton_euler_along(equations, {"bob"}, {query, Theorem::resultant, axis::x});
  EXPECT_LT(relative_difference(state(across.transmitted), Real(0)), 1e-45);
  const NewtonEulerEquation about = newton_euler_along(equations, {"bob"}, {query, Theorem::moment, {0, 0, 1}});
  EXPECT_LT(relative_difference(state(about.transmitted), Real(0)), 1e-45);
  EXPECT_LT(relative_difference(state(about.known), -(m * g * l * sin(theta))), 1e-45);
}

TEST(NewtonEuler, IsolatesWholeRigidBodiesOnly) {
  Scene scene = pendulum();
  scene.point("O", scene.ground(), {0, 0, 0});
  scene.body("paint", "arm", Inertia::point(kilograms("0.1")));
  scene.body("pillar", scene.ground(), Inertia::point(kilograms("10")));
  const Equations equations(scene);
  EXPECT_EQ(
      error_of<SceneError>([&] { newton_euler(equations, {"bob"}, {Scene::point("O")}); }),
      "Newton-Euler's theorem isolates part of a rigid body: 'paint' is fixed to what is asked for; name it too, or "
      "put a joint with a released coordinate between them");
  EXPECT_EQ(error_of<SceneError>([&] { newton_euler(equations, {"pillar"}, {Scene::point("O")}); }),
            "Newton-Euler's theorem isolates pillar, part of the ground, which nothing moves: leave that out, or release a "
            "coordinate");
  EXPECT_EQ(error_of<SceneError>([&] { transmitted_wrench(equations, "ground"); }),
            "no joint carries the ground: ask for the wrench transmitted to a frame that moves");
}

/// The wrench of each constraint works with every virtual motion as its column says, closures by joints included.
TEST(ConstraintWrench, WorksAsItsGeneralisedForces) {
  const WorkingDigits precision(50);
  for (const JointType type : {JointType::revolute, JointType::prismatic, JointType::universal, JointType::planar,
                               JointType::line_contact, JointType::sphere_in_cylinder, JointType::point_contact}) {
    Scene scene("loop");
    FrameHandle a = scene.ground();
    FrameHandle b = scene.ground();
    const std::array<Triple, 3> axes{Triple{1, 2, 2}, axis::y, Triple{2, -1, 2}};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string k = std::to_string(i);
      a = scene.revolute("a" + k, a, axes[i], scene.coordinate("qa" + k, "rad"), {.origin = {metres("0.3"), 0, 0}});
      b = scene.revolute("b" + k, b, axes[(i + 1) % 3], scene.coordinate("qb" + k, "rad"),
                         {.origin = {0, metres("0.4"), metres("0.2")}});
    }
    scene.body("a", a, Inertia::box(kilograms("1"), metres("0.2"), metres("0.3"), metres("0.4")));
    scene.body("b", b, Inertia::box(kilograms("1"), metres("0.2"), metres("0.3"), metres("0.4")));
    scene.loop_joint("loop", {.type = type, .a = a, .b = b});
    const Equations equations(scene);
    const Model& model = equations.model();
    const RandomState state(scene, 4);
    Evaluator<Real> evaluate(equations.program(), state.in_real());
    const std::vector<Twist> all = twists(model);
    for (std::size_t j = 0; j < equations.constraints().size(); ++j) {
      const auto wrenches = constraint_wrench(model, static_cast<int>(j));
      ASSERT_TRUE(wrenches);
      EXPECT_EQ(wrenches->size(), 2U);
      for (std::size_t i = 0; i < model.coordinates().size(); ++i) {
        Derivation partial = partial_derivation(equations.program(), model.coordinates()[i].v);
        Real power(0);
        for (const auto& [link, wrench] : *wrenches) {
          Twist moved;
          for (int k = 0; k < 3; ++k) {
            moved.angular[k] = partial(all[static_cast<std::size_t>(link)].angular[k]);
            moved.linear[k] = partial(all[static_cast<std::size_t>(link)].linear[k]);
          }
          power += evaluate(reciprocal_product(wrench, moved));
        }
        EXPECT_LT(relative_difference(power, evaluate(equations.constraints()[j].column[i])), 1e-45)
            << to_string(type) << " " << j;
      }
    }
  }
}

}  // namespace
}  // namespace torsor::newton_euler_test
