// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes and units that a generated text states of what its kernels write.
#include <gtest/gtest.h>

#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "torsor/generator/emission/description.hpp"
#include "torsor/generator/torsor.hpp"
#include "tests/scenes/pendulums.hpp"

namespace torsor::described_results_test {
namespace {

using namespace literals;

/// A trolley on a level rail with a rod that hangs from it: a length and an angle.
Scene trolley() {
  Scene scene("trolley");
  const Expression x = scene.coordinate("x", "m"), a = scene.coordinate("a", "rad");
  const FrameHandle car = scene.prismatic("car", scene.ground(), axis::x, x);
  const FrameHandle rod = scene.revolute("rod", car, axis::y, a);
  scene.body("car", car, Inertia::point(scene.parameter("M", "kg", 3)));
  scene.body("rod", rod, Inertia::point(scene.parameter("m", "kg", 1)).at({0, 0, -scene.parameter("l", "m", 1)}));
  scene.gravity({0, 0, -scene.parameter("g", "m/s^2", 9.81_r)});
  return scene;
}

/// "name: dimensions, rows x columns [unit]" of each result of a kernel.
std::string described(const Scene& scene, const std::string& kernel) {
  const MechanismListing mechanism = lower_mechanism(scene, {kernel});
  std::string text;
  for (const DescribedResult& each : described_results(mechanism, mechanism.kernels.back())) {
    text += fmt::format("{}: {}, {} x {} [{}]\n", each.member.empty() ? each.result : each.member, each.dimensions, each.rows,
                        each.columns, each.unit);
  }
  return text;
}

TEST(DescribedResults, HaveOneUnitOrThatOfEachEntry) {
  const Scene scene = trolley();
  EXPECT_EQ(described(scene, "inverse_dynamics"), "forces: 1, 2 x 1 [N, N m]\n");
  EXPECT_EQ(described(scene, "mass_matrix"), "mass: 2, 2 x 2 []\n");  // kg, kg m, kg m^2
  EXPECT_EQ(described(scene, "energy"), "kinetic: 0, 1 x 1 [J]\nforce_function: 0, 1 x 1 [J]\npower: 0, 1 x 1 [W]\n");
  EXPECT_EQ(described(scene, "gravity"), "forces: 1, 2 x 1 [N m]\n");  // along the rail none, always
  EXPECT_EQ(described(scene, "jets"), "coefficients: 2, 4 x 0 []\n");
}

TEST(DescribedResults, OfOneCoordinateKeepTheirDimensions) {
  const Scene scene = testing_mechanisms::pendulum_with_motor();
  EXPECT_EQ(described(scene, "mass_matrix"), "mass: 2, 1 x 1 [kg m^2]\n");
  EXPECT_EQ(described(scene, "inverse_dynamics"), "forces: 1, 1 x 1 [N m]\n");
  EXPECT_EQ(described(scene, "forward_dynamics"), "accelerations: 1, 1 x 1 [rad/s^2]\nmultipliers: 1, 0 x 1 []\n");
}

// Accelerations by positions, m/s^2 over m: no angle has a part in them. Nor has the quotient of two.
TEST(DescribedResults, OfDerivativesAlongLengthsAreNoAngles) {
  Scene rail("rail");
  const Expression x = rail.coordinate("x", "m"), y = rail.coordinate("y", "m");
  const FrameHandle car = rail.prismatic("car", rail.prismatic("slide", rail.ground(), axis::x, x), axis::y, y);
  rail.body("car", car, Inertia::point(rail.parameter("m", "kg", 1)));
  const Expression k = rail.parameter("k", "N/m", 2), c = rail.parameter("c", "N s/m", 3);
  rail.generalised_force("pull", x, -k * x * y * y / rail.parameter("s", "m^2", 1) - c * rate(x));
  const std::string derivatives = described(rail, "forward_dynamics_derivatives");
  EXPECT_NE(derivatives.find("by_position: 2, 2 x 2 [1/s^2]\n"), std::string::npos) << derivatives;
  EXPECT_NE(derivatives.find("by_velocity: 2, 2 x 2 [1/s]\n"), std::string::npos) << derivatives;
  EXPECT_EQ(derivatives.find("rad"), std::string::npos) << derivatives;
  const std::string turning = described(testing_mechanisms::pendulum_with_motor(), "forward_dynamics_derivatives");
  EXPECT_NE(turning.find("by_position: 2, 1 x 1 [1/s^2]\n"), std::string::npos) << turning;
}

TEST(DescribedResults, StandInTheTextsOfAllLanguages) {
  const MechanismListing mechanism = lower_mechanism(trolley(), {"inverse_dynamics", "energy"});
  const auto kernels = kernels_json(mechanism);
  EXPECT_EQ(kernels[0]["results"][0]["unit"], "N, N m");
  EXPECT_EQ(kernels[1]["results"][0]["members"][0]["unit"], "J");
  const KernelEntries entries = kernel_entries(mechanism, "results", {"0", "1"});
  EXPECT_EQ(entries.results.front(), "{\"forces\", \"\", 2, 1, 1, \"N, N m\"}");
}

}  // namespace
}  // namespace torsor::described_results_test
