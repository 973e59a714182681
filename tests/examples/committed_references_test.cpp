// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "generated/elastic_wing.hpp"
#include "generated/falling_plate.hpp"
#include "generated/model_making_press.hpp"
#include "generated/nose_radar.hpp"
#include "generated/plumb_line.hpp"
#include "generated/rolling_hoop_contact_forces.hpp"
#include "generated/segment_in_sphere.hpp"
#include "generated/sprung_absorber.hpp"
#include "generated/watt_governor.hpp"
#include "generated/whipple_bicycle.hpp"
#include "generated/winder.hpp"
#include "torsor/runtime/mechanism.hpp"
#include "torsor/runtime/records/reference.hpp"
#include "tests/examples/motion.hpp"

namespace torsor::committed_references_test {

// The committed references of the examples whose own tests compare with other truths only. They come from Lagrange's
// operator and an extrapolation in high precision; the kernels come from virtual power.

namespace {

using namespace torsor::runtime;

/// A step is kept when its estimated errors have Σ (e_i / s_i)² <= n, s_i = tolerance (1 + |y_i|), thus
/// |e| <= √n tolerance (1 + max |y_i|). As if all steps erred alike, and as much as the flow amplifies from the start.
template <class Mechanism>
void expect_met(const std::string& name) {
  constexpr double tolerance = 1e-13;
  constexpr std::size_t n = coordinates_of<Mechanism> + velocities_of<Mechanism>;
  const auto reference = read_reference<double>(TORSOR_SOURCE_DIR "/generated/" + name + ".reference.csv");
  ASSERT_GE(reference.rows(), 2U) << name;
  const auto motion = equations_of_motion<Mechanism>();
  examples::Amplification growth(motion, motion.initial(), 0.0);
  for (std::size_t row = 0; row < reference.rows(); ++row) {
    const double time = reference.times[row];
    auto y = motion.initial();
    double size = 1.0;
    const auto result = integrate(motion, y, motion.initial_time(), time,
                                  DormandPrince54{.relative_tolerance = tolerance, .absolute_tolerance = tolerance},
                                  [&size](double, const auto& now) {
                                    for (const double each : now) size = std::fmax(size, std::abs(each));
                                  });
    ASSERT_TRUE(result) << name << ": " << describe(result);
    const double error = std::sqrt(static_cast<double>(n)) * tolerance * (1.0 + size);
    const double kappa = std::fmax(1.0, growth.until(time));
    const double allowed = static_cast<double>(result.statistics.accepted) * error * kappa;
    const double difference = examples::largest_difference(y, reference.template state<n>(row));
    EXPECT_LE(difference, allowed) << name << " at t = " << time;
    EXPECT_LT(allowed, 1e-6 * size) << name << ": a bound that says little";
  }
}

TEST(CommittedReference, IsMetByElasticWing) { expect_met<elastic_wing::Mechanism<double>>("elastic_wing"); }
TEST(CommittedReference, IsMetByFallingPlate) { expect_met<falling_plate::Mechanism<double>>("falling_plate"); }
TEST(CommittedReference, IsMetByModelMakingPress) {
  expect_met<model_making_press::Mechanism<double>>("model_making_press");
}
TEST(CommittedReference, IsMetByNoseRadar) { expect_met<nose_radar::Mechanism<double>>("nose_radar"); }
TEST(CommittedReference, IsMetByPlumbLine) { expect_met<plumb_line::Mechanism<double>>("plumb_line"); }
TEST(CommittedReference, IsMetByRollingHoopContactForces) {
  expect_met<rolling_hoop_contact_forces::Mechanism<double>>("rolling_hoop_contact_forces");
}
TEST(CommittedReference, IsMetBySegmentInSphere) {
  expect_met<segment_in_sphere::Mechanism<double>>("segment_in_sphere");
}
TEST(CommittedReference, IsMetBySprungAbsorber) { expect_met<sprung_absorber::Mechanism<double>>("sprung_absorber"); }
TEST(CommittedReference, IsMetByWattGovernor) { expect_met<watt_governor::Mechanism<double>>("watt_governor"); }
TEST(CommittedReference, IsMetByWhippleBicycle) { expect_met<whipple_bicycle::Mechanism<double>>("whipple_bicycle"); }
TEST(CommittedReference, IsMetByWinder) { expect_met<winder::Mechanism<double>>("winder"); }

}  // namespace
}  // namespace torsor::committed_references_test
