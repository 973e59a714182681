// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "benchmarks/model_counts/models.hpp"
#include "torsor/generator/cli/command_texts.hpp"
#include "torsor/generator/import/urdf.hpp"

namespace torsor::urdf_counts_test {
namespace {

// The same arms in two files: rotations as exact matrices in models.json, as rpy="1.5707963267948966 ..." in URDF.
// Equal counts mean that no zero was lost.
TEST(UrdfCounts, AreThoseOfTheSameChainsWithExactRotations) {
  UrdfOptions options;
  options.motors = false;
  int compared = 0;
  for (const Scene& scene : read_models(TORSOR_SOURCE_DIR "/tests/reference/models.json")) {
    const std::string& name = scene.name();
    if (name != "pend2" && name != "ur5" && name != "panda" && name != "chain8") continue;
    SCOPED_TRACE(name);
    ++compared;
    const ImportedRobot robot = read_urdf(TORSOR_SOURCE_DIR "/tests/reference/urdf/" + name + ".urdf", options);
    const std::vector<std::string> kernels{"mass_matrix", "inverse_dynamics", "forward_dynamics"};
    const SceneCounts expected = count_scene(scene, kernels, {});
    const SceneCounts actual = count_scene(robot.scene, kernels, {});
    ASSERT_EQ(actual.kernels.size(), expected.kernels.size());
    for (std::size_t k = 0; k < kernels.size(); ++k) {
      SCOPED_TRACE(expected.kernels[k].first);
      EXPECT_EQ(actual.kernels[k].second.total(), expected.kernels[k].second.total());
      EXPECT_EQ(actual.kernels[k].second.multiplications, expected.kernels[k].second.multiplications);
    }
  }
  EXPECT_EQ(compared, 4);
}

}  // namespace
}  // namespace torsor::urdf_counts_test
