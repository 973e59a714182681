// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "torsor/generator/verification/check.hpp"
#include "tests/import/urdf_motion.hpp"

namespace torsor::urdf_many_mimics_test {
namespace {

using namespace testing_urdf;

/// Joints one behind the other about y and z and along x in turn, each after the first `leaders` following one of those.
Scene row(int joints, int leaders) {
  std::string text = "<link name=\"base\"/>";
  std::string parent = "base";
  for (int i = 0; i < joints; ++i) {
    const std::string name = fmt::format("l{}", i);
    const bool slides = i % 5 == 4;
    const std::string axis = slides ? "1 0 0" : i % 2 == 0 ? "0 1 0" : "0 0 1";
    const std::string mimic =
        i < leaders ? "" : fmt::format("<mimic joint=\"j{}\" multiplier=\"{}0.{}\" offset=\"0.{}\"/>", i % leaders,
                                       i % 3 == 0 ? "-" : "", i + 1, i);
    text += link(name) + joint(fmt::format("j{}", i), slides ? "prismatic" : "revolute", parent, name,
                               fmt::format("<origin xyz=\"0.1 0 0.2\"/><axis xyz=\"{}\"/>{}", axis, mimic));
    parent = name;
  }
  return read(text);
}

// Thirty joints have 465 pairs of one that carries the other: wrenches are summed by coordinate there.
TEST(UrdfManyMimics, HaveTheMassMatrixOfTheirKineticEnergy) {
  for (const CheckResult& result : check_derivations(row(30, 3), {30, 1, {}})) {
    EXPECT_TRUE(result.passed()) << result.name << " " << result.worst;
  }
}

// Three definitions for each pair of joints would be four times as many for twice as many joints.
TEST(UrdfManyMimics, TakeAsMuchWorkAsTheyAreMany) {
  const auto definitions = [](int joints) {
    const Scene scene = row(joints, 1);
    const Equations equations(scene);
    equations.mass();
    return equations.program().size();
  };
  EXPECT_LT(2 * definitions(80), 5 * definitions(40));
}

}  // namespace
}  // namespace torsor::urdf_many_mimics_test
