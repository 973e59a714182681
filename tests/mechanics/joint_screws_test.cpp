// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/mechanics/joint_screws.hpp"
#include "torsor/generator/program/identically_zero.hpp"

#include <gtest/gtest.h>

#include "torsor/generator/base/linear_algebra/real_rows.hpp"
#include "torsor/generator/program/evaluation.hpp"
#include "tests/geometry/symbolic_vectors.hpp"

namespace torsor::joint_screws_test {
namespace {

using namespace testing_symbols;

constexpr std::array<JointType, 12> table{
    JointType::weld,         JointType::revolute,           JointType::prismatic,     JointType::helical,
    JointType::cylindrical,  JointType::universal,          JointType::spherical,     JointType::planar,
    JointType::line_contact, JointType::sphere_in_cylinder, JointType::point_contact, JointType::free};

class JointScrews : public ::testing::TestWithParam<JointType>, protected SymbolicVectors {
 protected:
  Value pitch = program.lower(make_symbol("p", "m")), angle = program.lower(make_symbol("alpha", "rad"));
  Vector ab = symbols("b", "m");
  std::vector<Twist> twists = allowed_twists(program, {.type = GetParam(), .pitch = pitch, .angle = angle});
  std::vector<Wrench> wrenches = ideal_wrenches(program, {.type = GetParam(), .pitch = pitch, .angle = angle});
};

TEST_P(JointScrews, AreAsManyAsTheFreedomsAndWhatTheyLeave) {
  EXPECT_EQ(static_cast<int>(twists.size()), freedom_count(GetParam()));
  EXPECT_EQ(static_cast<int>(wrenches.size()), 6 - freedom_count(GetParam()));
}

// At B, and reduced at any other point.
TEST_P(JointScrews, TransmitNoPowerWhateverTheMotionAndThePoint) {
  for (const Twist& twist : twists) {
    for (const Wrench& wrench : wrenches) {
      EXPECT_TRUE(identically_zero(reciprocal_product(wrench, twist)));
      const Value elsewhere = reciprocal_product(reduced_at(wrench, ab), reduced_at(twist, ab));
      EXPECT_TRUE(identically_zero(elsewhere));
    }
  }
}

// A basis placed at a distance is the basis at the point, reduced elsewhere.
TEST_P(JointScrews, MoveWithTheirPoint) {
  const std::vector<Twist> moved =
      allowed_twists(program, {.type = GetParam(), .point = -ab, .pitch = pitch, .angle = angle});
  for (std::size_t i = 0; i < twists.size(); ++i) {
    const Twist expected = reduced_at(twists[i], ab);
    EXPECT_TRUE(identically_zero(moved[i].angular - expected.angular));
    EXPECT_TRUE(identically_zero(moved[i].linear - expected.linear));
  }
  const std::vector<Wrench> far =
      ideal_wrenches(program, {.type = GetParam(), .point = -ab, .pitch = pitch, .angle = angle});
  for (std::size_t i = 0; i < wrenches.size(); ++i) {
    const Wrench expected = reduced_at(wrenches[i], ab);
    EXPECT_TRUE(identically_zero(far[i].resultant - expected.resultant));
    EXPECT_TRUE(identically_zero(far[i].moment - expected.moment));
  }
}

// Both bases are bases: independent at a state of small rational numbers, elimination in 50 digits.
TEST_P(JointScrews, AreIndependent) {
  const WorkingDigits precision(50);
  Evaluator<Real> evaluate(program, [](const SymbolPointer& symbol) {
    return Real(Number::rational(3 + static_cast<long>(symbol->name.size()), 7), 50);
  });
  const auto rows = [&](const auto& screws) {
    RealRows all;
    for (const auto& screw : screws) {
      RealRow row;
      for (int i = 0; i < 3; ++i) row.push_back(evaluate(resultant_of(screw)[i]));
      for (int i = 0; i < 3; ++i) row.push_back(evaluate(moment_of(screw)[i]));
      all.push_back(row);
    }
    return all;
  };
  const Real tolerance(Number(10).pow(-40), 50);
  EXPECT_EQ(rank(rows(twists), 6, tolerance), twists.size());
  EXPECT_EQ(rank(rows(wrenches), 6, tolerance), wrenches.size());
}

// The course's list of ideal wrenches (§6.2.3), at B on the joint's axis.
TEST_P(JointScrews, HaveTheWrenchOfTheCourse) {
  for (const Wrench& w : wrenches) {
    const Vector& R = w.resultant;
    const Vector& M = w.moment;
    const auto zero = [](const Vector& v, std::initializer_list<int> components) {
      for (const int i : components) EXPECT_TRUE(identically_zero(v[i])) << i;
    };
    const Vector x_b{program.cos(angle), program.sin(angle), Value()};  // of a line contact
    const Vector y_b{Value(), program.cos(angle), program.sin(angle)};  // of a universal joint
    const Vector across{-program.sin(angle), program.cos(angle), Value()};
    switch (GetParam()) {
      case JointType::weld:
        break;
      case JointType::revolute:
        zero(M, {0});
        break;
      case JointType::prismatic:
        zero(R, {0});
        break;
      case JointType::helical:
        EXPECT_TRUE(identically_zero(M[0] + pitch * R[0]));
        break;
      case JointType::cylindrical:
        zero(M, {0}), zero(R, {0});
        break;
      case JointType::universal:
        zero(M, {0});
        EXPECT_TRUE(identically_zero(dot(M, y_b)));
        break;
      case JointType::spherical:
        zero(M, {0, 1, 2});
        break;
      case JointType::planar:
        zero(R, {0, 1}), zero(M, {2});
        break;
      case JointType::line_contact:
        zero(R, {0, 1}), zero(M, {2});
        EXPECT_TRUE(identically_zero(dot(M, x_b)));
        EXPECT_TRUE(identically_zero(cross(M, across)));
        break;
      case JointType::sphere_in_cylinder:
        zero(M, {0, 1, 2}), zero(R, {0});
        break;
      case JointType::point_contact:
        zero(M, {0, 1, 2}), zero(R, {0, 1});
        break;
      case JointType::free:
        FAIL() << "a free joint transmits nothing";
        break;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Table, JointScrews, ::testing::ValuesIn(table), [](const auto& instance) {
  std::string name(to_string(instance.param));
  for (char& c : name) c = c == ' ' ? '_' : c;
  return name;
});

}  // namespace
}  // namespace torsor::joint_screws_test
