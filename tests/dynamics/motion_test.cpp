// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/motion/motion.hpp"

#include <gtest/gtest.h>

#include "torsor/generator/dynamics/equations/equations.hpp"
#include "torsor/generator/dynamics/forces/energy.hpp"
#include "torsor/generator/program/derivative.hpp"
#include "torsor/generator/program/identically_zero.hpp"
#include "torsor/generator/verification/random_state.hpp"
#include "tests/dynamics/random_mechanism.hpp"
#include "tests/mechanics/gauss_quadrature.hpp"
#include "tests/program/test_symbols.hpp"

namespace torsor::motion_test {
namespace {

using namespace testing_symbols;
using testing_mechanisms::random_mechanism;

// Distinct types: what must not be added or multiplied does not compile.
template <class A, class B>
concept Addable = requires(A a, B b) {
  a + b;
};
template <class A, class B>
concept ReciprocalProduct = requires(A a, B b) {
  reciprocal_product(a, b);
};
static_assert(Addable<Vector, Vector>);
static_assert(!Addable<Twist, Wrench> && !Addable<Wrench, Twist>);
static_assert(!Addable<Twist, MomentumScrew> && !Addable<Wrench, MomentumScrew>);
static_assert(!std::is_convertible_v<Twist, Wrench> && !std::is_convertible_v<Wrench, MomentumScrew>);
static_assert(ReciprocalProduct<Wrench, Twist> && ReciprocalProduct<MomentumScrew, Twist>);
static_assert(!ReciprocalProduct<Twist, Twist> && !ReciprocalProduct<Wrench, Wrench>);
static_assert(!ReciprocalProduct<Wrench, MomentumScrew>);

Vector rates(const Vector& v) {
  Vector result;
  for (int i = 0; i < 3; ++i) {
    if (!v[i].is_zero()) result[i] = time_derivative(v[i]);
  }
  return result;
}

/// |v| evaluated at a random state, scaled by a state of order one.
double size_of(const Vector& v, Evaluator<Real>& evaluate) {
  double sum = 0;
  for (int i = 0; i < 3; ++i) sum += abs(evaluate(v[i])).to_double();
  return sum;
}

/// Whether there is a resultant and a turn, so that the point matters.
bool momentum_turns(const MomentumScrew& screw, const Twist& twist, Evaluator<Real>& evaluate) {
  return size_of(screw.resultant, evaluate) > 1e-6 && size_of(twist.angular, evaluate) > 1e-6 &&
         size_of(cross(screw.resultant, twist.angular), evaluate) > 1e-6;
}

class RandomMotion : public ::testing::TestWithParam<unsigned> {
 protected:
  RandomMotion() : scene(random_mechanism(GetParam(), {.actions = false, .constraints = false})), equations(scene) {}

  const WorkingDigits precision{50};
  Scene scene;
  Equations equations;
  RandomState state{scene, 7};
};

TEST_P(RandomMotion, HasTheTwistsOfItsPositionsDifferentiated) {
  const Model& model = equations.model();
  const std::vector<Twist> all = twists(model);
  Evaluator<Real> evaluate(equations.program(), state.in_real());
  for (std::size_t k = 1; k < all.size(); ++k) {
    const int link = static_cast<int>(k);
    const Vector velocity = rates(model.locate(Vector(), link, 0)) - model.express(all[k].linear, link, 0);
    EXPECT_LT(size_of(velocity, evaluate), 1e-45) << "velocity of " << model.links()[k].name;
    for (int i = 0; i < 3; ++i) {  // de/dt = Ω ∧ e for each axis of the link
      Vector e;
      e[i] = equations.program().number(Number(1));
      const Vector gap = rates(model.express(e, link, 0)) - model.express(cross(all[k].angular, e), link, 0);
      EXPECT_LT(size_of(gap, evaluate), 1e-45) << "turn of " << model.links()[k].name;
    }
  }
}

TEST_P(RandomMotion, HasAReciprocalProductThatDoesNotDependOnThePoint) {
  const Model& model = equations.model();
  Program& program = equations.program();
  const std::vector<Twist> all = twists(model);
  Evaluator<Real> evaluate(program, state.in_real());
  for (std::size_t k = 1; k < all.size(); ++k) {
    const MomentumScrew at_origin = momentum(model.links()[k].mass, all[k]);
    Vector arm;  // from O to P, any point
    for (int i = 0; i < 3; ++i) arm[i] = program.number(Number::rational(3 * i - 2, 7), units::metre);
    // V_P = V_O + Ω ∧ OP, σ_P = σ_O + m V_G ∧ OP
    const Twist moved_twist{all[k].angular, all[k].linear + cross(all[k].angular, arm)};
    const MomentumScrew moved{at_origin.resultant, at_origin.moment + cross(bound(program, at_origin.resultant), arm)};
    const Real here = evaluate(reciprocal_product(at_origin, all[k]));
    const Real there = evaluate(reciprocal_product(moved, moved_twist));
    EXPECT_LT(relative_difference(there, here), 1e-45);
    if (momentum_turns(at_origin, all[k], evaluate)) {  // the twist moved alone gives another number
      EXPECT_GT(relative_difference(evaluate(reciprocal_product(at_origin, moved_twist)), here), 1e-20);
    }
  }
}

TEST_P(RandomMotion, HasTheSameKineticEnergyFromTwistsAndFromPositions) {
  Evaluator<Real> evaluate(equations.program(), state.in_real());
  const Real from_twists = evaluate(kinetic_energy(equations.model()));
  const Real from_positions = evaluate(kinetic_energy_from_positions(equations.model()));
  const Real about_centres = evaluate(kinetic_energy_about_centres(equations.model()));
  EXPECT_GT(from_twists.to_double(), 0);
  EXPECT_LT(relative_difference(from_positions, from_twists), 1e-45);
  EXPECT_LT(relative_difference(about_centres, from_twists), 1e-45);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomMotion, ::testing::Range(100U, 115U));

/// A box on a spinning and sliding carrier as 1,000 mass points: the sum of their momenta, moments and energies.
TEST(MomentumScrew, IsThatOfTheBodysPoints) {
  using testing_quadrature::gauss_legendre;
  Scene scene("spinning_box");
  const auto m = [](const char* value) { return Expression::quantity(value, "m"); };
  const Expression q1 = scene.coordinate("q1", "rad");
  const Expression q2 = scene.coordinate("q2", "m");
  const Expression q3 = scene.coordinate("q3", "rad");
  const FrameHandle first = scene.revolute("first", scene.ground(), axis::z, q1, {.origin = {m("0.2"), 0, 0}});
  const FrameHandle second = scene.prismatic("second", first, axis::x, q2);
  const FrameHandle third = scene.revolute("third", second, {1, 2, 2}, q3, {.origin = {0, m("0.3"), 0}});
  scene.body("box", third,
             Inertia::box(Expression::quantity("1.5", "kg"), m("0.4"), m("0.6"), m("1.0"))
                 .at({m("0.1"), m("-0.2"), m("0.5")}));
  const Equations equations(scene);
  const RandomState state(scene, 3);
  Evaluator<double> evaluate(equations.program(), state.in_double());
  const Twist twist = twists(equations.model())[3];
  const MomentumScrew screw = momentum(equations.model().links()[3].mass, twist);

  const auto triple = [&](const Vector& v) {
    return std::array<double, 3>{evaluate(v[0]), evaluate(v[1]), evaluate(v[2])};
  };
  const std::array<double, 3> omega = triple(twist.angular);
  const std::array<double, 3> linear = triple(twist.linear);
  const auto wedge = [](const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return std::array<double, 3>{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  };
  std::array<double, 3> resultant{}, moment{};
  double doubled_energy = 0;
  for (const auto& [x, u] : gauss_legendre(10, -0.2, 0.2)) {
    for (const auto& [y, v] : gauss_legendre(10, -0.3, 0.3)) {
      for (const auto& [z, w] : gauss_legendre(10, -0.5, 0.5)) {
        const double mass = 1.5 * u * v * w / (0.4 * 0.6 * 1.0);
        const std::array<double, 3> place{x + 0.1, y - 0.2, z + 0.5};
        const std::array<double, 3> turn = wedge(omega, place);
        const std::array<double, 3> velocity{linear[0] + turn[0], linear[1] + turn[1], linear[2] + turn[2]};
        const std::array<double, 3> arm = wedge(place, velocity);
        for (std::size_t i = 0; i < 3; ++i) {
          resultant[i] += mass * velocity[i];
          moment[i] += mass * arm[i];
          doubled_energy += mass * velocity[i] * velocity[i];
        }
      }
    }
  }
  // The quadrature is exact for squares: what remains is the rounding of 10³ terms of order one.
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(evaluate(screw.resultant[i]), resultant[static_cast<std::size_t>(i)], 1e-12);
    EXPECT_NEAR(evaluate(screw.moment[i]), moment[static_cast<std::size_t>(i)], 1e-12);
  }
  EXPECT_NEAR(evaluate(reciprocal_product(screw, twist)), doubled_energy, 1e-12);
}

/// Generalised Huygens: two boxes on one link, one of them turned and moved, against their points.
TEST(MassProperties, GatherWhatIsWeldedTogether) {
  using testing_quadrature::gauss_legendre;
  using testing_quadrature::MassPoint;
  Scene scene("assembly");
  const auto m = [](const char* value) { return Expression::quantity(value, "m"); };
  const FrameHandle link = scene.revolute("link", scene.ground(), axis::z, scene.coordinate("q", "rad"));
  const Rotation turn = Rotation::about(0, 2) * Rotation::about(2, 9);
  const FrameHandle flange = scene.weld("flange", link, {.origin = {m("0.3"), m("-0.4"), m("0.7")}, .rotation = turn});
  const Inertia box = Inertia::box(Expression::quantity("2", "kg"), m("0.4"), m("0.6"), m("1.0"));
  scene.body("first", link, box.at({m("0.5"), 0, m("0.1")}));
  scene.body("second", flange, box.at({0, m("0.2"), m("-0.1")}));
  const Equations equations(scene);
  const MassProperties& sum = equations.model().links()[1].mass;

  std::vector<MassPoint> points;
  for (const auto& [x, u] : gauss_legendre(4, -0.2, 0.2)) {
    for (const auto& [y, v] : gauss_legendre(4, -0.3, 0.3)) {
      for (const auto& [z, w] : gauss_legendre(4, -0.5, 0.5)) {
        const double mass = 2 * u * v * w / 0.24;
        points.push_back({mass, {x + 0.5, y, z + 0.1}});
        const std::array<double, 3> local{x, y + 0.2, z - 0.1};
        std::array<double, 3> place{0.3, -0.4, 0.7};
        for (int i = 0; i < 3; ++i) {
          for (int j = 0; j < 3; ++j) {
            place[static_cast<std::size_t>(i)] += turn(i, j).to_double() * local[static_cast<std::size_t>(j)];
          }
        }
        points.push_back({mass, place});
      }
    }
  }
  Evaluator<double> evaluate(equations.program(), {});
  const std::array<double, 6> integrated = testing_quadrature::inertia_about_origin(points);
  const std::array<std::pair<int, int>, 6> places{{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};
  for (std::size_t k = 0; k < 6; ++k) {
    EXPECT_NEAR(evaluate(sum.inertia(places[k].first, places[k].second)), integrated[k], 1e-13);
    EXPECT_EQ(sum.inertia(places[k].first, places[k].second).polynomial(),
              sum.inertia(places[k].second, places[k].first).polynomial());
  }
  EXPECT_NEAR(evaluate(sum.mass), 4, 1e-15);
  for (int i = 0; i < 3; ++i) {
    double first_moment = 0;
    for (const MassPoint& point : points) first_moment += point.mass * point.place[static_cast<std::size_t>(i)];
    EXPECT_NEAR(evaluate(sum.first_moment[i]), first_moment, 1e-13);
  }
}

TEST(Vanishing, KnowsThatQuaternionsHaveTheNormOne) {
  Scene scene("ball");
  const FrameHandle ball = scene.spherical("ball", scene.ground(), scene.attitude("turn"));
  scene.body("ball", ball, Inertia::solid_sphere(Expression::quantity("2", "kg"), Expression::quantity("0.1", "m")));
  const Equations equations(scene);
  Program& program = equations.program();
  Value square = program.number(Number(-1));
  for (const SymbolPointer& e : equations.model().positions()) square += pow(program.symbol(e), 2);
  EXPECT_TRUE(identically_zero(square));
  EXPECT_FALSE(identically_zero(square + program.symbol(equations.model().positions()[1])));
}

}  // namespace
}  // namespace torsor::motion_test
