// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/kernels/kernel_kinematics.hpp"

#include <gtest/gtest.h>

#include "torsor/generator/program/identically_zero.hpp"
#include "tests/scenes/bodies.hpp"

namespace torsor::kernel_kinematics_test {
namespace {

using testing_mechanisms::kilograms;
using testing_mechanisms::metres;

/// A turntable with a point F fixed on it and a point P that runs along its x axis at s.
class KinematicsOfPoints : public ::testing::Test {
 protected:
  static Scene make() {
    Scene scene("turntable");
    const FrameHandle table = scene.revolute("table", scene.ground(), axis::z, scene.coordinate("a", "rad"));
    const Expression s = scene.coordinate("s", "m");
    scene.body("table", table, Inertia::disk(kilograms("1"), metres("1"), 2));
    scene.prismatic("slider", table, axis::x, s);
    scene.body("slider", "slider", Inertia::point(kilograms("1")));
    scene.point("F", table, {metres("0.5"), 0, 0});
    scene.point("P", table, {s, 0, 0});
    return scene;
  }
  bool has(const std::string& member) const {
    for (const Member& m : kernel.structures[0].members) {
      if (m.name == member) return true;
    }
    return false;
  }
  Value result(const std::string& member, int index) const {
    const std::string target = "result." + member + "[" + std::to_string(index) + "]";
    for (const Assignment& assignment : kernel.assignments) {
      if (assignment.target.to_string() == target) return assignment.value;
    }
    ADD_FAILURE() << "no " << target;
    return {};
  }

  Equations equations{make()};
  Kernel kernel = make_kinematics(equations);
};

TEST_F(KinematicsOfPoints, GiveBothVelocitiesOfAPointThatMovesInItsFrame) {
  const Model& model = equations.model();
  Program& program = equations.program();
  const Value sine = program.sin(model.q(0));
  const Value cosine = program.cos(model.q(0));
  const Value across = model.q(1) * model.v(0);
  // Of the table's point at P: s a' along v = (−sin a, cos a, 0); P itself has s' along u = (cos a, sin a, 0) too.
  EXPECT_TRUE(identically_zero(result("P_velocity", 0) + across * sine));
  EXPECT_TRUE(identically_zero(result("P_velocity", 1) - across * cosine));
  const Value x = model.v(1) * cosine - across * sine;
  const Value y = model.v(1) * sine + across * cosine;
  EXPECT_TRUE(identically_zero(result("P_geometric_velocity", 0) - x));
  EXPECT_TRUE(identically_zero(result("P_geometric_velocity", 1) - y));
  EXPECT_TRUE(identically_zero(result("P_geometric_velocity", 2)));
}

TEST_F(KinematicsOfPoints, GiveOneVelocityOfAPointOfTheBody) {
  EXPECT_TRUE(has("F_velocity") && has("P_geometric_velocity"));
  EXPECT_FALSE(has("F_geometric_velocity"));
}

}  // namespace
}  // namespace torsor::kernel_kinematics_test
