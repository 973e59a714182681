// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "tests/import/urdf_motion.hpp"

namespace torsor::urdf_deviation_test {
namespace {

using namespace testing_urdf;
using Lines = std::vector<std::string>;

// 3.141592654 is 4.10e-10 above pi, 1.570796327 is 2.05e-10 above pi/2, 0.785398164 is 6.0e-10 above pi/4 (six digits of the
// differences: 4.10207, 2.05103, 6.02552).
const std::string half_turn = "<origin rpy=\"3.141592654 0 0\"/>";
const std::string quarter_turn = "<origin rpy=\"1.570796327 0 0\"/>";

/// Joints one behind the other, each with an origin or more, about z.
std::string chain(const Lines& origins, const std::string& root, const std::string& prefix) {
  std::string text;
  std::string parent = root;
  for (std::size_t i = 0; i < origins.size(); ++i) {
    const std::string name = prefix + std::to_string(i);
    text += link(name) + joint("to_" + name, "revolute", parent, name, origins[i] + "<axis xyz=\"0 0 1\"/>");
    parent = name;
  }
  return text;
}

Lines notes(const std::string& body, const char* tolerance = "1e-9") {
  UrdfOptions options;
  options.angle_tolerance = parse_decimal(tolerance);
  return read("<link name=\"base\"/>" + body, options).content().origin.notes;
}

bool contains(const Lines& lines, const std::string& line) { return std::find(lines.begin(), lines.end(), line) != lines.end(); }

TEST(UrdfDeviation, IsToldFromTheRootToTheLinkWhereItIsLargest) {
  EXPECT_EQ(notes(chain({half_turn, half_turn}, "base", "a")),
            (Lines{"Angles and axes that were made exact:", "  3.141592654 is pi: joint to_a0 (rpy), joint to_a1 (rpy)",
                   "  from the root to link a1 they add up to 8.3e-10 rad, to no other link to more"}));
}

TEST(UrdfDeviation, StaysWithinTheToleranceAsAWhole) {
  const std::string three = chain({half_turn, half_turn, half_turn}, "base", "a");
  const Lines refused = notes(three);
  EXPECT_FALSE(contains(refused, "Angles and axes that were made exact:"));
  EXPECT_TRUE(contains(refused,
                       "  all within --angle-tolerance would add up to 1.3e-09 rad from the root to link a2, beyond it; "
                       "--angle-tolerance 1.3e-09 takes them all"));
  // What is proposed does it.
  EXPECT_TRUE(contains(notes(three, "1.3e-9"), "  from the root to link a2 they add up to 1.3e-09 rad, to no other link to more"));
}

TEST(UrdfDeviation, AddsUpAlongOneWayOnly) {
  const Lines two = notes(chain({half_turn, half_turn}, "base", "a") + chain({half_turn, half_turn}, "base", "b"));
  EXPECT_TRUE(contains(two, "  from the root to link a1 they add up to 8.3e-10 rad, to no other link to more"));
}

TEST(UrdfDeviation, TakesTheSmallestFirst) {
  const Lines mixed = notes(chain({half_turn, quarter_turn, half_turn, quarter_turn}, "base", "a"));
  EXPECT_TRUE(contains(mixed, "  1.570796327 is pi/2: joint to_a1 (rpy), joint to_a3 (rpy)"));
  EXPECT_FALSE(contains(mixed, "  3.141592654 is pi: joint to_a0 (rpy), joint to_a2 (rpy)"));
  EXPECT_TRUE(contains(mixed, "  from the root to link a3 they add up to 4.2e-10 rad, to no other link to more"));
}

TEST(UrdfDeviation, CountsInertiaAxesAndMimics) {
  const std::string turned_moments =
      "<link name=\"a\"><inertial><origin rpy=\"0 3.141592654 0\"/><mass value=\"1\"/>"
      "<inertia ixx=\"0.01\" iyy=\"0.012\" izz=\"0.013\" ixy=\"0\" ixz=\"0\" iyz=\"0.001\"/></inertial></link>";
  EXPECT_TRUE(contains(notes(turned_moments + joint("j", "revolute", "base", "a", half_turn)),
                       "  from the root to link a they add up to 8.3e-10 rad, to no other link to more"));
  // An axis that turns by 4.12e-10 carries attitudes with it twice.
  EXPECT_TRUE(contains(notes(link("a") + joint("j", "revolute", "base", "a", "<axis xyz=\"0 4.12e-10 1\"/>")),
                       "  from the root to link a they add up to 8.3e-10 rad, to no other link to more"));
  // The offset of b, half of it in c that follows b, both on the way to c.
  const std::string mimics =
      link("a") + link("b") + link("c") + joint("j", "revolute", "base", "a", "") +
      joint("k", "revolute", "a", "b", "<mimic joint=\"j\" offset=\"3.141592654\"/>") +
      joint("l", "revolute", "b", "c", "<mimic joint=\"k\" multiplier=\"-0.5\"/>");
  EXPECT_TRUE(contains(notes(mimics), "  from the root to link c they add up to 6.2e-10 rad, to no other link to more"));
}

TEST(UrdfDeviation, OfWhatIsExactIsNone) {
  const Lines exact = notes(link("a") + joint("j", "revolute", "base", "a", "<axis xyz=\"1 1 0\"/>"));
  EXPECT_EQ(exact, Lines());
}

// Links in a circle are refused for that, not for angles.
TEST(UrdfDeviation, OfAGraphThatIsNoTreeEnds) {
  const std::string circle = link("a") + link("b") + joint("j", "revolute", "a", "b", half_turn) +
                             joint("k", "revolute", "b", "a", half_turn + "<mimic joint=\"k\" offset=\"3.141592654\"/>");
  EXPECT_THROW(notes(circle), FileError);
}

}  // namespace
}  // namespace torsor::urdf_deviation_test
