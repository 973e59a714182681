// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "torsor/generator/import/urdf.hpp"
#include "torsor/generator/kernels/kernel.hpp"
#include "tests/import/urdf_motion.hpp"
#include "tests/scenes/pendulums.hpp"

namespace torsor::kernel_absence_test {
namespace {

using namespace testing_urdf;

/// Links one behind the other, by joints about all axes in turn.
Scene arm(int joints) {
  std::string text = "<link name=\"base\"/>";
  std::string parent = "base";
  for (int i = 0; i < joints; ++i) {
    const std::string name = fmt::format("l{}", i);
    text += link(name) + joint(fmt::format("j{}", i), "revolute", parent, name,
                               fmt::format("<origin xyz=\"0.1 0.2 0.3\"/><axis xyz=\"{} {} 1\"/>", i % 2, i % 3));
    parent = name;
  }
  return read(text);
}

Scene massless_tool() {
  return read("<link name=\"base\"/>" + link("arm") + "<link name=\"tool\"/>" + joint("j", "revolute", "base", "arm", "") +
              joint("k", "revolute", "arm", "tool", ""));
}

Scene weightless() { return read("<link name=\"base\"/><link name=\"a\"/>" + joint("j", "prismatic", "base", "a", "")); }

/// Two links whose joints are tied by so many constraints: two leave no freedom.
Scene tied(int constraints) {
  Scene scene = arm(2);
  const Expression first = scene.content().coordinates[0].q, second = scene.content().coordinates[1].q;
  scene.holonomic("tie", first + second);
  if (constraints == 2) scene.holonomic("tie_2", first - second);
  return scene;
}

/// A pendulum whose pivot is released.
Scene with_reactions() {
  Scene scene("hung");
  const Expression x = scene.released_coordinate("x", "m");
  const Expression angle = scene.coordinate("angle", "rad");
  scene.prismatic("pivot", scene.ground(), axis::x, x);
  const FrameHandle frame = scene.revolute("arm", "pivot", axis::z, angle);
  scene.body("bob", frame, Inertia::point(scene.parameter("m", "kg", 1)).at({Expression::quantity("1", "m"), 0, 0}));
  return scene;
}

TEST(KernelAbsence, IsFoundWithoutDerivingAsItIsByDeriving) {
  const std::vector<Scene> scenes{arm(2),
                                  massless_tool(),
                                  weightless(),
                                  with_reactions(),
                                  testing_mechanisms::pendulum(),
                                  testing_mechanisms::torque_free_body(),
                                  tied(1),
                                  tied(2)};
  int absent = 0, present = 0;
  for (const Scene& scene : scenes) {
    for (const std::string& name : kernel_names()) {
      SCOPED_TRACE(scene.name() + " " + name);
      const std::string reason = why_absent(name, Equations(scene));
      const Equations equations(scene);
      const Kernel kernel = make_kernel(name, equations);
      EXPECT_EQ(reason, kernel.skipped);
      ++(reason.empty() ? present : absent);
    }
  }
  EXPECT_GT(absent, 40);
  EXPECT_GT(present, 90);
}

// Kernels of second order, linearisation, regressor and base parameters are what costs: a list of names needs none of it.
TEST(KernelAbsence, CostsALittleOfWhatKernelsDo) {
  const Scene scene = arm(7);
  const Equations listed(scene);
  for (const std::string& name : kernel_names()) why_absent(name, listed);
  const Equations derived(scene);
  for (const std::string& name : usual_kernel_names()) make_kernel(name, derived);
  EXPECT_LT(3 * listed.program().size(), derived.program().size());
}

}  // namespace
}  // namespace torsor::kernel_absence_test
