// SPDX-License-Identifier: GPL-3.0-or-later
// Springs and dampers between points of a chain: sums under roots and under fraction bars that are short once they are simplified.
#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "tests/printing/check_inline.hpp"
#include "torsor/generator/printing/print_equations.hpp"

namespace torsor::long_radicands_test {
namespace {

using namespace literals;

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t result = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++result;
  return result;
}

/// Bars in a row with relative angles, the tip of the last one held by a spring, and a damper, to a point of the ground.
Scene bars(int number, const std::pair<int, int>& held_at, bool damped) {
  Scene scene("bars");
  const Expression m = scene.parameter("m", "kg", 1), l = scene.run_time_parameter("l", "m", 0.5_r);
  const Expression k = scene.parameter("k", "N/m", 100), l0 = scene.parameter("l0", "m", 0.4_r);
  FrameHandle bar = scene.ground();
  for (int i = 1; i <= number; ++i) {
    const std::string name = "b" + std::to_string(i);
    const Expression q = scene.coordinate("q" + std::to_string(i), "rad");
    bar = scene.revolute(name, bar, axis::y, q, {.origin = {0, 0, i == 1 ? 0 * l : -l}});
    scene.body(name, bar, Inertia::rod(m, l, 2).at({0, 0, -l / 2}));
  }
  const PointHandle tip = scene.point("tip", bar, {0, 0, -l});
  const PointHandle there = scene.point("there", scene.ground(), {held_at.first * l, 0, held_at.second * l});
  scene.spring("spring", SpringBetween{.a = tip, .b = there, .stiffness = k, .rest = l0});
  if (damped) scene.damper("damper", tip, there, scene.parameter("c", "N s/m", 2));
  return scene;
}

void expect_what_the_program_says(const Scene& scene) {
  const test::InlineCheck check = test::check_inline(scene, 50, 3);
  ASSERT_TRUE(check.written_out);
  // Some 400 terms of size 1e3 at most, rounded at 1e-50 each.
  EXPECT_LT(check.worst, Real::parse("1e-44")) << check.worst_of;
}

// The square of the length has 113 products before anything cancels, and 7 terms; no root of 2 stands beside its root.
TEST(LongRadicands, OfASpringAreReduced) {
  const std::string page = print_equations(bars(3, {1, 0}, false), Format::text, {});
  EXPECT_FALSE(has(page, "too long")) << page;
  EXPECT_FALSE(has(page, "sqrt(2)")) << page;
  EXPECT_TRUE(has(page, "k l0 root_1")) << page;
  EXPECT_EQ(count(page, "sqrt("), 1U) << page;
  expect_what_the_program_says(bars(3, {1, 0}, false));
}

// Off the axes the force function was given up at 71,000 products; 13 terms stand under the root.
TEST(LongRadicands, OfAPointOffTheAxesAreWrittenOut) {
  const Scene scene = bars(3, {1, -2}, false);
  const std::string page = print_equations(scene, Format::text, {});
  EXPECT_FALSE(has(page, "too long")) << page;
  EXPECT_EQ(count(page, "sqrt("), 1U) << page;
  expect_what_the_program_says(scene);
}

// The rate of the length has its square as a denominator, in each term: named, and not counted again.
TEST(LongRadicands, StandAsDenominatorsOfADamper) {
  const Scene scene = bars(3, {1, 0}, true);
  const std::string page = print_equations(scene, Format::text, {});
  EXPECT_FALSE(has(page, "too long")) << page;
  EXPECT_TRUE(has(page, "/root_1^2")) << page;
  EXPECT_FALSE(has(page, "/(")) << page;
  expect_what_the_program_says(scene);
}

// What is too long says by how much: T of five bars is short, their damper is not.
TEST(LongRadicands, SayWhichLimitTheyPass) {
  const std::string page = print_equations(bars(5, {1, -2}, true), Format::text, {});
  ASSERT_TRUE(has(page, "Equations below with everything but the inputs on the left are too long")) << page;
  const std::size_t at = page.find("up to ", page.find("Equations below"));
  EXPECT_GT(std::stod(page.substr(at + 6)), 20000) << page.substr(at, 60);
}

}  // namespace
}  // namespace torsor::long_radicands_test
