// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <fstream>
#include <map>
#include <numbers>
#include <sstream>
#include <string>

#include "generated/model_making_press.hpp"
#include "generated/model_making_press_reduced.hpp"
#include "torsor/runtime/mechanism.hpp"
#include "tests/examples/energy_theorem.hpp"
#include "tests/examples/motion.hpp"

#include "torsor/generator/dynamics/structure/reduced_graph.hpp"
#include "torsor/generator/graphs/graph_printer.hpp"
#include "tests/examples/scenes.hpp"

namespace torsor::model_making_press_test {
namespace {

using namespace torsor::runtime;
using Press = model_making_press_reduced::Mechanism<double>;
using WholePress = model_making_press::Mechanism<double>;

// The values of the reduced scene.
constexpr double m10 = 0.84, m20 = 0.3, C20 = 1e-4, g = 9.81, K = 20000, c = 5e-4, rounding = 1.1e-16;
constexpr double p = 0.004 / (2 * std::numbers::pi);

void expect_counts(const torsor::MobilityCount& count, const std::array<int, 10>& expected) {
  const std::array<int, 10> found{count.bodies, count.joints,   count.loops,  count.parameters, count.equations,
                                  count.rank,   count.mobility, count.useful, count.internal,   count.redundancy};
  EXPECT_EQ(found, expected);
}

// Pommier, §3.5.5: 6 bodies, 8 joints, mu = 3; 17 parameters and 18 equations of rank 14 leave 3 freedoms, one of them
// useful and the spins of both cups, and 4 redundant equations.
TEST(ModelMakingPress, HasTheNumbersOfTheCourse) {
  const torsor::Mobility mobility = torsor::analyse_mobility(model_making_press_scene());
  EXPECT_FALSE(mobility.moved_to_close);
  EXPECT_FALSE(mobility.singular);
  expect_counts(mobility.given, {6, 8, 3, 17, 18, 14, 3, 1, 2, 4});
  expect_counts(mobility.generic, {6, 8, 3, 17, 18, 14, 3, 1, 2, 4});
  ASSERT_EQ(mobility.internal.size(), 2U);
  EXPECT_EQ(mobility.internal[0].bodies, std::vector<std::string>{"lower_cup"});
  EXPECT_EQ(mobility.internal[1].bodies, std::vector<std::string>{"upper_cup"});
  for (const auto& motion : mobility.internal) EXPECT_EQ(motion.text, "turns about z");
}

// Between two columns the pairs of forces along AB and the couples across z are free to be anything; of the cups, how
// hard both are pressed against the traverse.
TEST(ModelMakingPress, HasFourIndeterminateReactions) {
  const torsor::Mobility mobility = torsor::analyse_mobility(model_making_press_scene());
  std::map<std::string, std::vector<std::string>> found;
  for (const auto& each : mobility.indeterminate) found[each.joint] = each.components;
  const std::map<std::string, std::vector<std::string>> expected{
      {"L1", {"F_x", "M_x", "M_y"}},
      {"L2", {"F_z", "M_y", "M_z"}},  // L2's axis x lies along z
      {"L3", {"F_z"}},
      {"L4", {"F_z"}},
      {"L5", {"F_z"}},
      {"L6", {"F_z"}}};
  EXPECT_EQ(found, expected);
}

TEST(ModelMakingPress, ReducesToThreeBodiesAndThreeJoints) {
  const torsor::ReducedGraph reduced = torsor::reduced_graph(torsor::analyse_mobility(model_making_press_scene()));
  expect_counts(reduced.count, {3, 3, 1, 7, 6, 6, 1, 1, 0, 0});
  EXPECT_EQ(reduced.bodies, (std::vector<std::string>{"ground", "traverse", "screw"}));
  ASSERT_EQ(reduced.joints.size(), 3U);
  const auto text = [&](const std::string& name) {
    for (const auto& joint : reduced.joints) {
      if (joint.edge.name == name) return joint.allows.text();
    }
    return std::string("missing");
  };
  EXPECT_EQ(text("L1//L2"), "prismatic along z");
  EXPECT_EQ(text("(L4-L3)//(L6-L5)"), "point contact of normal z");
  EXPECT_EQ(text("L7"), "helical along z");
  const torsor::Mobility written = torsor::analyse_mobility(model_making_press_reduced_scene());
  expect_counts(written.generic, {3, 3, 1, 7, 6, 6, 1, 1, 0, 0});
}

std::string file_text(const std::string& name) {
  std::ifstream file(TORSOR_SOURCE_DIR "/examples/model_making_press/" + name);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

// When this fails: model_making_press_scene graph --of structure|analysis|reduced --format svg -o <picture>.
TEST(ModelMakingPress, HasPicturesThatAreUpToDate) {
  const torsor::Scene scene = model_making_press_scene();
  const torsor::StructureGraph graph = torsor::structure_graph(scene);
  EXPECT_EQ(file_text("structure.svg"), torsor::graph_svg(torsor::draw_structure(scene, graph)));
  EXPECT_EQ(file_text("analysis.svg"),
            torsor::graph_svg(torsor::draw_analysis(scene, graph, torsor::analysis_links(scene, graph))));
  const torsor::ReducedGraph reduced = torsor::reduced_graph(torsor::analyse_mobility(scene));
  EXPECT_EQ(file_text("reduced.svg"), torsor::graph_svg(torsor::draw_reduced(scene, reduced)));
}

constexpr double torque = -0.2;
const auto hand = [](const Press::State&) {
  Press::Inputs inputs{};
  inputs.C = torque;
  return inputs;
};

// a_z = p omega_z. The multiplier of 320 N is rounded four times or so before it divides by m10: accelerations that
// are off their proportion by 1.7e-13 m/s^2 take both apart by 3.4e-13 m in 2 s if all err alike.
TEST(ModelMakingPress, AdvancesAsTheScrewTurns) {
  const auto motion = equations_of_motion<Press>(Press::default_parameters(), hand);
  auto y = motion.initial();
  double largest = 0.0;
  const auto result = integrate(motion, y, 0.0, 2.0, DormandPrince54{.relative_tolerance = 1e-12},
                                [&](double t, const StateVector<Press>& now) {
                                  const auto state = unpack<Press>(t, now);
                                  largest = std::fmax(largest, std::abs(state.q.a_z));
                                  EXPECT_NEAR(state.q.a_z, p * state.q.omega_z, 3.4e-13);
                                });
  ASSERT_TRUE(result) << describe(result);
  EXPECT_GT(largest, 0.01);
}

// J omega'' + c omega' + p^2 K omega = C - p g m, J = C20 + p^2 m, m = m10 + m20: a damped oscillator from rest.
TEST(ModelMakingPress, MovesAsOneOscillator) {
  const double m = m10 + m20, J = C20 + p * p * m, rest = (torque - p * g * m) / (p * p * K);
  const std::complex<double> root = -c / (2 * J) + std::sqrt(std::complex<double>(c * c / (4 * J * J) - p * p * K / J));
  const auto motion = equations_of_motion<Press>(Press::default_parameters(), hand);
  for (const double t : {0.1, 0.5, 1.0, 2.0}) {
    const auto y = examples::state_at(motion, motion.initial(), 0.0, t,
                                      DormandPrince54{.relative_tolerance = 1e-13, .absolute_tolerance = 1e-13});
    // omega = rest (1 - Re[e^(root t) (1 + i Re(root)/Im(root))]).
    const std::complex<double> start(1.0, root.real() / root.imag());
    const double expected = rest * (1.0 - (std::exp(root * t) * start).real());
    // A thousand steps of 1e-13 (1 + |omega'|), |omega'| below 300 rad/s, that damping only shrinks.
    EXPECT_NEAR(unpack<Press>(t, y).q.omega_z, expected, 1000 * 3e-11);
  }
}

// The force of the traverse on the screw's end, from Newton's law for the traverse.
TEST(ModelMakingPress, PressesAsNewtonSays) {
  const auto motion = equations_of_motion<Press>(Press::default_parameters(), hand);
  for (const double omega : {-30.0, 0.0, 12.0}) {
    Press::State state = Press::initial_state();
    state.q.omega_z = omega;
    state.q.a_z = p * omega;
    state.v.omega_z = 2.0;
    state.v.a_z = p * 2.0;
    Press::Accelerations a{};
    Press::Multipliers lambda{};
    ASSERT_EQ(motion.accelerations(state, a, lambda), Evaluation::ok);
    const double on_traverse = m10 * (a.a_z + g) + K * state.q.a_z;
    EXPECT_NEAR(-lambda.lambda_LB_z, on_traverse, 50 * rounding * (K * 0.02 + 330.0));
    const double J = C20 + p * p * (m10 + m20);
    EXPECT_NEAR(a.omega_z, (torque - c * 2.0 - p * p * K * omega - p * g * (m10 + m20)) / J, 50 * rounding * 5000.0);
  }
}

TEST(ModelMakingPress, KeepsTheEnergyTheoremOverARun) {
  const auto motion = equations_of_motion<Press>(Press::default_parameters(), hand);
  const auto balance = examples::energy_balance<Press>(motion, 2.0, 1e-12);
  examples::expect_kept(balance, 0.01);
  EXPECT_GT(balance.work, 1.0);
}

/// Both cups spin at will: internal freedoms, which nothing drives and which drive nothing.
const auto whole_hand = [](const WholePress::State&) {
  WholePress::Inputs inputs{};
  inputs.C = torque;
  return inputs;
};
StateVector<WholePress> with_spins(double lower, double upper) {
  WholePress::State state = WholePress::initial_state();
  state.v.lower_omega_z = lower;
  state.v.upper_omega_z = upper;
  return pack<WholePress>(state);
}

// Eight joints, ten constraints of which four repeat others, against three joints: the same motion, whatever the spins.
TEST(ModelMakingPress, MovesWithAllItsJointsAsItDoesReduced) {
  const auto whole = equations_of_motion<WholePress>(WholePress::default_parameters(), whole_hand);
  const auto reduced = equations_of_motion<Press>(Press::default_parameters(), hand);
  constexpr DormandPrince54 precise{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12};
  for (const double t : {0.1, 0.5, 2.0}) {
    const auto one = unpack<WholePress>(t, examples::state_at(whole, with_spins(3.0, -2.0), 0.0, t, precise));
    const auto other = unpack<Press>(t, examples::state_at(reduced, reduced.initial(), 0.0, t, precise));
    // Some thousand steps of 1e-12 (1 + |omega'|), |omega'| below 300 rad/s, damped since.
    EXPECT_NEAR(one.q.omega_z, other.q.omega_z, 1000 * 3e-10);
    EXPECT_NEAR(one.q.a_z, other.q.a_z, p * 1000 * 3e-10);
    EXPECT_NEAR(one.q.a_z, p * one.q.omega_z, 1e-9);
    EXPECT_NEAR(one.v.lower_omega_z, 3.0, 1e-9);
    EXPECT_NEAR(one.v.upper_omega_z, -2.0, 1e-9);
    EXPECT_NEAR(one.q.lower_z, std::sin(1.5 * t), 1e-8);
    EXPECT_NEAR(one.q.a, 0.0, 1e-12);
  }
}

TEST(ModelMakingPress, KeepsTheEnergyTheoremWithAllItsJoints) {
  const auto motion = equations_of_motion<WholePress>(WholePress::default_parameters(), whole_hand);
  const auto balance = examples::energy_balance<WholePress>(motion, 1.0, 1e-12);
  examples::expect_kept(balance, 0.01);
  EXPECT_GT(balance.work, 1.0);
}

TEST(ModelMakingPress, MeetsItsCommittedReference) {
  examples::expect_reference(equations_of_motion<Press>(), "model_making_press_reduced", {.error = 1e-13});
}

}  // namespace
}  // namespace torsor::model_making_press_test
