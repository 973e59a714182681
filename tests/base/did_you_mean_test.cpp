// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "torsor/generator/base/did_you_mean.hpp"

namespace torsor::did_you_mean_test {
namespace {

using Words = std::vector<std::string>;

TEST(DidYouMean, CountsEditsOfNeighbouringLettersAsOne) {
  EXPECT_EQ(edit_distance("", ""), 0U);
  EXPECT_EQ(edit_distance("", "abc"), 3U);
  EXPECT_EQ(edit_distance("abc", ""), 3U);
  EXPECT_EQ(edit_distance("axes", "axis"), 1U);         // replaced
  EXPECT_EQ(edit_distance("orgin", "origin"), 1U);      // left out
  EXPECT_EQ(edit_distance("dynamicss", "dynamics"), 1U);  // inserted
  EXPECT_EQ(edit_distance("inertail", "inertial"), 1U);  // exchanged
  EXPECT_EQ(edit_distance("ca", "abc"), 3U);             // no letter twice: the textbook's difference from Damerau's own
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
  EXPECT_EQ(edit_distance("Elbow", "elbow"), 0U);
}

TEST(DidYouMean, TakesAWordForAMisspellingByItsLength) {
  EXPECT_TRUE(looks_like("axes", "axis"));
  EXPECT_TRUE(looks_like("inertail", "inertial"));
  EXPECT_TRUE(looks_like("M", "m"));
  EXPECT_FALSE(looks_like("x", "y"));
  EXPECT_FALSE(looks_like("k1", "k2"));
  EXPECT_FALSE(looks_like("rod", "hub"));
  EXPECT_FALSE(looks_like("mass", "axis"));
  const std::string hostile(100000, 'a');
  EXPECT_FALSE(looks_like(hostile, hostile + "b"));
}

TEST(DidYouMean, NamesTheNearestWordsInTheirOrder) {
  const Words known{"upper_arm", "forearm", "hand", "upper_arms"};
  EXPECT_EQ(nearest_words("uper_arm", known), Words{"upper_arm"});
  EXPECT_EQ(did_you_mean("uper_arm", known), "did you mean 'upper_arm'? ");
  EXPECT_EQ(did_you_mean("Forearm", known), "did you mean 'forearm'? ");
  EXPECT_EQ(did_you_mean("wheel", known), "");
  EXPECT_EQ(did_you_mean("tetha", {"phi", "theta"}), "did you mean 'theta'? ");  // two edits of five letters
  EXPECT_TRUE(nearest_words("tetha", {"phi", "theta"}).empty());
  EXPECT_EQ(did_you_mean("wheel", {}), "");
  EXPECT_EQ(did_you_mean("", known), "");
  EXPECT_EQ(did_you_mean("arm3", {"arm2", "arm1", "arm2"}), "did you mean 'arm2' or 'arm1'? ");
}

TEST(DidYouMean, NamesWordsThatBeginWithTheGivenOne) {
  const Words kernels{"forward_dynamics", "inverse_dynamics", "mass_matrix"};
  EXPECT_EQ(did_you_mean("forward", kernels), "did you mean 'forward_dynamics'? ");
  EXPECT_EQ(did_you_mean("fo", kernels), "");
  EXPECT_EQ(did_you_mean("link", {"link_of_1", "link_of_2", "link_of_3", "link_of_4"}), "");
}

}  // namespace
}  // namespace torsor::did_you_mean_test
