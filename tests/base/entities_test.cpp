// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/base/entities.hpp"

#include <gtest/gtest.h>

namespace torsor::entities_test {
namespace {

TEST(Entities, StandForTheCharactersAskedForAlone) {
  EXPECT_EQ(with_entities("a<b> & \"c\"'\n", "&<>\"'\n"), "a&lt;b&gt; &amp; &quot;c&quot;&#39;&#10;");
  EXPECT_EQ(with_entities("é \"<\"", "<"), "é \"&lt;\"");
}

}  // namespace
}  // namespace torsor::entities_test
