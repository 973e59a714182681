// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/printing/alike_names.hpp"

#include <gtest/gtest.h>

#include "torsor/generator/printing/print_equations.hpp"
#include "tests/scenes/bodies.hpp"

namespace torsor::alike_names_test {
namespace {

using namespace testing_mechanisms;

Scene two_masses(const char* second) {
  Scene scene("two");
  const Expression m1 = scene.parameter("m1", "kg", 1), other = scene.parameter(second, "kg", 2);
  const Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m");
  const FrameHandle first = scene.prismatic("first", scene.ground(), axis::x, x);
  scene.body("first", first, Inertia::point(m1));
  scene.body("second", scene.prismatic("second", first, axis::x, y), Inertia::point(other));
  return scene;
}

TEST(AlikeNames, AreToldWhereFormulasAreTypeset) {
  EXPECT_EQ(printing::alike_names(two_masses("m_1").content(), {}),
            std::vector<std::string>{"Formulas spell m1, m_1 alike: rename all but one."});
  EXPECT_TRUE(printing::alike_names(two_masses("m_2").content(), {}).empty());
}

TEST(AlikeNames, AreToldOnPagesButNotInText) {
  const auto has = [](Format format, const char* sentence) {
    return print_equations(two_masses("m_1"), format).find(sentence) != std::string::npos;
  };
  EXPECT_TRUE(has(Format::latex, "Formulas spell m1, m\\_1 alike: rename all but one."));
  EXPECT_TRUE(has(Format::html, "Formulas spell m1, m_1 alike: rename all but one."));
  EXPECT_FALSE(has(Format::text, "alike"));  // which spells them as they are
}

}  // namespace
}  // namespace torsor::alike_names_test
