// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/motion/ground_motion.hpp"

#include <gtest/gtest.h>

#include "torsor/generator/dynamics/equations/equations.hpp"
#include "torsor/generator/dynamics/motion/motion.hpp"
#include "torsor/generator/kernels/kernel.hpp"
#include "torsor/generator/verification/random_state.hpp"
#include "tests/dynamics/random_mechanism.hpp"
#include "tests/program/test_symbols.hpp"
#include "tests/scenes/bodies.hpp"

namespace torsor::ground_motion_test {
namespace {

using namespace testing_symbols;
using namespace testing_mechanisms;

class RandomGround : public ::testing::TestWithParam<unsigned> {
 protected:
  double size(const Vector& v) {
    double sum = 0;
    for (int i = 0; i < 3; ++i) sum += abs(evaluate(v[i])).to_double();
    return sum;
  }

  const WorkingDigits precision{50};
  Scene scene = random_mechanism(GetParam(), {.actions = false, .constraints = false});
  Equations equations{scene};
  const Model& model = equations.model();
  Program& program = equations.program();
  RandomState state{scene, 5};
  Evaluator<Real> evaluate{equations.program(), state.in_real()};
  GroundMotion motion{model};
};

/// Against the derivation inwards (places and vectors carried from link to link), rates of places, and the recursion of
/// twists in the links' axes. Everything is of order one to a thousand: 50 digits leave 1e-44.
TEST_P(RandomGround, AgreesWithTheRoadInwardsAndWithRatesOfPlaces) {
  const std::vector<Twist> all = twists(model);
  const Value one = program.number(Number(1)), metre = program.number(Number(1), units::metre);
  const Vector place(metre, Number(-2) * metre, Number::rational(1, 3) * metre);
  for (int k = 1; k < static_cast<int>(model.links().size()); ++k) {
    EXPECT_LE(size(motion.origin(k) - model.locate(Vector(), k, 0)), 1e-44) << k;
    for (int i = 0; i < 3; ++i) {
      Vector unit;
      unit[i] = one;
      EXPECT_LE(size(motion.rotation(k) * unit - model.express(unit, k, 0)), 1e-44) << k;
    }
    const auto twisting = model.turning_link(static_cast<std::size_t>(k));
    if (twisting != static_cast<std::size_t>(k)) continue;  // only the last of a quaternion's links is a body
    EXPECT_LE(size(motion.angular(k) - model.express(all[twisting].angular, k, 0)), 1e-44) << k;
    const Vector there = bound(program, model.locate(place, k, 0));
    const Vector velocity = motion.velocity(k, place);
    EXPECT_LE(size(velocity - time_derivative(there)), 1e-44) << k;

    const Vector arm = bound(program, motion.rotation(k) * place);
    const std::vector<Vector> partials = motion.partial_velocities(k, arm);
    for (std::size_t i = 0; i < static_cast<std::size_t>(model.unknown_count()); ++i) {  // held ones have no derivative
      Derivation by = partial_derivation(program, model.coordinates()[i].v);
      EXPECT_LE(size(partials[i] - Vector(by(velocity[0]), by(velocity[1]), by(velocity[2]))), 1e-44) << k << " " << i;
    }
  }
}
INSTANTIATE_TEST_SUITE_P(Seeds, RandomGround, ::testing::Range(1U, 9U));

/// A crank on a carriage: kinematics in double with the carriage at the origin and 2^30 m away.
TEST(GroundMotion, JacobiansDoNotFeelWhereTheOriginIs) {
  Scene scene("crank_on_a_carriage");
  const Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m");
  const Expression first = scene.coordinate("first", "rad"), second = scene.coordinate("second", "rad");
  const FrameHandle along = scene.prismatic("along", scene.ground(), axis::x, x);
  const FrameHandle carriage = scene.prismatic("carriage", along, axis::y, y);
  const FrameHandle crank = scene.revolute("crank", carriage, axis::x, first);
  const FrameHandle arm = scene.revolute("arm", crank, axis::z, second, {.origin = {0, metres("0.3"), metres("0.1")}});
  scene.body("arm", arm, Inertia::point(kilograms("1")));
  scene.point("tip", arm, {metres("0.7"), metres("0.2"), 0});
  const Equations equations(scene);
  const Kernel kernel = make_kernel("kinematics", equations);
  const auto jacobian = [&](double place) {
    Evaluator<double> evaluate(equations.program(), [&](const SymbolPointer& symbol) {
      return symbol->name == "x" || symbol->name == "y" ? place : symbol->name == "first" ? 0.7 : 1.1;
    });
    std::vector<double> entries;
    for (const Assignment& assignment : kernel.assignments) {
      if (assignment.target.member == "tip_jacobian") entries.push_back(evaluate(assignment.value));
    }
    return entries;
  };
  const std::vector<double> near = jacobian(0), far = jacobian(0x1p30);
  ASSERT_EQ(near.size(), 12U);
  EXPECT_EQ(near, far);
}

/// A wheel that spins about an axis through its centre: no spin leaves a trace in the centre's velocity.
TEST(GroundMotion, ASpinAboutAnAxisThroughAPointDoesNotMoveIt) {
  Scene scene("wheel");
  const Expression turn = scene.coordinate("turn", "rad"), lean = scene.coordinate("lean", "rad"),
                   spin = scene.coordinate("spin", "rad");
  const FrameHandle fork = scene.revolute("fork", scene.ground(), axis::z, turn);
  const FrameHandle leaning = scene.revolute("leaning", fork, axis::x, lean);
  const FrameHandle wheel = scene.revolute("wheel", leaning, axis::y, spin);
  scene.body("wheel", wheel, Inertia::point(kilograms("1")).at({0, metres("0.7"), 0}));
  const Equations equations(scene);
  const Kernel kernel = make_kernel("kinematics", equations);
  for (const Assignment& assignment : kernel.assignments) {
    if (assignment.target.member != "wheel_velocity") continue;
    for (const ValueNumber value_number : equations.program().live({assignment.value})) {
      const SymbolPointer& symbol = equations.program()[value_number].symbol;
      EXPECT_FALSE(symbol && symbol->name == "spin'") << assignment.target.to_string();
    }
  }
}

}  // namespace
}  // namespace torsor::ground_motion_test
