// SPDX-License-Identifier: GPL-3.0-or-later
// Second derivatives against central differences of the first ones in sixty digits, and against a closed form.
#include "tests/long_tests.hpp"
#include "torsor/generator/dynamics/derivatives/second_derivatives.hpp"

#include <gtest/gtest.h>


#include "benchmarks/model_counts/models.hpp"
#include "torsor/generator/dynamics/derivatives/forward_derivatives.hpp"
#include "torsor/generator/dynamics/derivatives/forward_second_derivatives.hpp"
#include "torsor/generator/kernels/kernel.hpp"
#include "torsor/generator/program/formula.hpp"
#include "tests/dynamics/central_differences.hpp"
#include "tests/dynamics/named_state.hpp"
#include "tests/dynamics/random_mechanism.hpp"
#include "tests/scenes/pendulums.hpp"

namespace torsor::second_derivatives_test {
namespace {

using testing_mechanisms::CentralDifferences;
using testing_mechanisms::flattened;
using testing_mechanisms::largest_difference;

/// What was compared, for tests that must have met everything.
struct Met {
  bool attitude = false, constraint = false, wrench = false;
};

Met expect_slopes_of_first_derivatives(const Scene& scene, std::uint64_t seed) {
  const WorkingDigits precision(CentralDifferences::digits);
  const Equations one(scene), other(scene);
  const Model& model = other.model();
  const SecondForceDerivatives second = second_residual_derivatives(one, Inputs::act);
  const ForceDerivatives first = residual_derivatives(other, Inputs::act);
  const RandomState state(scene, seed);
  Evaluator<Real> at(one.program(), state.in_real());
  CentralDifferences differences(other, seed);
  const auto compare = [&](const ValueMatrix& page, const ValueMatrix& matrix,
                           const CentralDifferences::Change& change) {
    const std::vector<Real> exact = at(flattened(page)), slopes = differences(flattened(matrix), change);
    EXPECT_LT(largest_difference(exact, slopes), CentralDifferences::bound) << scene.name() << " " << seed;
  };
  Met met;
  for (std::size_t k = 0; k < static_cast<std::size_t>(model.unknown_count()); ++k) {
    const CentralDifferences::Change turn = differences.along(k), rate = differences.of(model.coordinates()[k].v);
    compare(second.position_position[k], first.by_position, turn);
    compare(second.position_velocity[k], first.by_position, rate);
    compare(second.velocity_velocity[k], first.by_velocity, rate);
    compare(second.acceleration_position[k], other.mass(), turn);
    met.attitude = met.attitude || model.coordinates()[k].attitude >= 0;
  }
  met.constraint = !other.constraints().empty();
  met.wrench = !other.actions().wrenches.empty();
  return met;
}

/// Of accelerations and multipliers; true where inputs act along something that turns.
bool expect_slopes_of_forward_derivatives(const Scene& scene, std::uint64_t seed) {
  const WorkingDigits precision(CentralDifferences::digits);
  const Equations one(scene), other(scene);
  const Model& model = other.model();
  const ForwardSecondDerivatives second = forward_second_derivatives(one);
  const ForwardDerivatives first = forward_derivatives(other);
  const RandomState state(scene, seed);
  Evaluator<Real> at(one.program(), state.in_real());
  CentralDifferences differences(other, seed);
  bool inputs = false;
  for (const auto& [twice, once] :
       {std::pair{&second.accelerations, &first.accelerations}, std::pair{&second.multipliers, &first.multipliers}}) {
    const auto compare = [&](const ValuePages& pages, std::size_t k, const ValueMatrix& matrix,
                             const CentralDifferences::Change& change) {
      const std::vector<Real> exact = at(flattened(pages[k])), slopes = differences(flattened(matrix), change);
      EXPECT_LT(largest_difference(exact, slopes), CentralDifferences::bound) << scene.name() << " " << seed;
    };
    for (std::size_t k = 0; k < static_cast<std::size_t>(model.unknown_count()); ++k) {
      const CentralDifferences::Change rate = differences.of(model.coordinates()[k].v);
      compare(twice->position_position, k, once->by_position, differences.along(k));
      compare(twice->position_velocity, k, once->by_position, rate);
      compare(twice->velocity_velocity, k, once->by_velocity, rate);
    }
    for (std::size_t k = 0; k < model.inputs().size(); ++k) {
      const CentralDifferences::Change input = differences.of(model.inputs()[k]);
      compare(twice->position_input, k, once->by_position, input);
      compare(twice->velocity_input, k, once->by_velocity, input);
      inputs = inputs || !twice->position_input[k].empty();
    }
  }
  return inputs;
}

Scene model_of_benchmarks(const std::string& name) {
  for (const Scene& scene : read_models(TORSOR_SOURCE_DIR "/tests/reference/models.json")) {
    if (scene.name() == name) return scene;
  }
  throw Error("no model " + name);
}

TEST(SecondDerivatives, AreThoseOfThePendulum) {
  // f = m l² a + m g l sin q: 2 · (3/2)² = 9/2 kg m², 2 · 9.81 · 3/2 = 29.43 N m.
  const WorkingDigits precision(CentralDifferences::digits);
  const Scene scene = testing_mechanisms::pendulum();
  const Equations equations(scene);
  const SecondForceDerivatives second = second_residual_derivatives(equations, Inputs::left_out);
  testing_mechanisms::NamedState at(equations, {{"theta", Real(1)}});
  EXPECT_NEAR(at.in_double(second.position_position[0][0][0]), -29.43 * std::sin(1.0), 1e-13);
  for (const ValuePages* zero :
       {&second.position_velocity, &second.velocity_velocity, &second.acceleration_position}) {
    EXPECT_TRUE((*zero)[0][0][0].is_zero());
  }
}

TEST(SecondDerivatives, AreSlopesOfTheFirstOnesForArms) {
  for (const char* name : {"pend2", "ur5"}) expect_slopes_of_first_derivatives(model_of_benchmarks(name), 3);
}

TEST(SecondDerivatives, AreSlopesOfTheFirstOnesForRandomMechanisms) {
  const unsigned seeds = wanted(12U, 24U);
  Met met;
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    testing_mechanisms::RandomMechanismOptions options;
    options.motors = seed % 2 == 0;
    options.joints = options.loops = seed % 3 == 0;
    options.constraints = seed % 3 == 1;
    options.most_bodies = 3;
    SCOPED_TRACE(testing_mechanisms::call_of(seed, options));
    const Met here = expect_slopes_of_first_derivatives(testing_mechanisms::random_mechanism(seed, options), seed);
    met = {met.attitude || here.attitude, met.constraint || here.constraint, met.wrench || here.wrench};
  }
  EXPECT_TRUE(met.attitude && met.constraint && met.wrench);
}

TEST(SecondDerivatives, OfForwardDynamicsAreSlopesOfItsFirstOnesForArms) {
  for (const char* name : {"pend2", "ur5"}) expect_slopes_of_forward_derivatives(model_of_benchmarks(name), 3);
}

TEST(SecondDerivatives, OfForwardDynamicsAreSlopesOfItsFirstOnesForRandomMechanisms) {
  const unsigned seeds = wanted(6U, 12U);
  unsigned with_inputs = 0;
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    testing_mechanisms::RandomMechanismOptions options;
    options.motors = true;
    options.joints = seed % 3 == 0;
    options.constraints = seed % 3 != 2;
    options.most_bodies = 3;
    SCOPED_TRACE(testing_mechanisms::call_of(seed, options));
    const Scene scene = testing_mechanisms::random_mechanism(seed, options);
    with_inputs += expect_slopes_of_forward_derivatives(scene, seed) ? 1U : 0U;
  }
  EXPECT_GE(with_inputs, seeds / 2);
}

TEST(SecondDerivatives, OfInverseDynamicsCostThreeTimesTheFirstOnesOfAnArm) {
  const Equations equations(model_of_benchmarks("ur5"));
  const Kernel kernel = make_kernel("inverse_dynamics_second_derivatives", equations);
  EXPECT_LE(count(equations.program(), kernel.values()).total(), 4'000);
}

TEST(SecondDerivatives, AreLaidOutPageByPage) {
  const WorkingDigits precision(CentralDifferences::digits);
  const Scene scene = model_of_benchmarks("pend2");
  const Equations equations(scene);
  const SecondForceDerivatives second = second_residual_derivatives(equations, Inputs::left_out);
  const Kernel kernel = make_kernel("inverse_dynamics_second_derivatives", equations);
  const RandomState state(scene, 1);
  Evaluator<Real> at(equations.program(), state.in_real());
  for (const auto& [name, pages] : {std::pair{"by_position_position", &second.position_position},
                                    std::pair{"by_position_velocity", &second.position_velocity},
                                    std::pair{"by_velocity_velocity", &second.velocity_velocity},
                                    std::pair{"by_acceleration_position", &second.acceleration_position}}) {
    for (std::size_t entry = 0; entry < 8; ++entry) {
      const std::string target = "result." + std::string(name) + "[" + std::to_string(entry) + "]";
      const auto place = std::find_if(kernel.assignments.begin(), kernel.assignments.end(),
                                      [&](const Assignment& each) { return each.target.to_string() == target; });
      ASSERT_NE(place, kernel.assignments.end()) << target;
      const Value& expected = (*pages)[entry / 4][entry % 2][entry / 2 % 2];
      EXPECT_LT(abs(at(place->value) - at(expected)).to_double(), 1e-50) << target;
    }
  }
}

}  // namespace
}  // namespace torsor::second_derivatives_test
