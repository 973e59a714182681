// SPDX-License-Identifier: GPL-3.0-or-later
// Texts and names of a scene that are not what they look like.
#include <functional>
#include <string>

#include <gtest/gtest.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/mechanics/scene.hpp"

namespace torsor::hostile_text_test {
namespace {

const std::string lost = "\xEF\xBF\xBD";  // U+FFFD

std::string refusal_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const SceneError& error) {
    return error.what();
  }
  return "";
}

TEST(HostileText, IsReplacedInATitle) {
  EXPECT_EQ(Scene("s", "two\nlines\x07 \xE2\x80\xAE\xFF").content().title, "two lines" + lost + " " + lost + lost);
  EXPECT_EQ(Scene("s", "\xCE\xB8, \"<&>\" ]]> ?\?/ \\").content().title, "\xCE\xB8, \"<&>\" ]]> ?\?/ \\");
}

// Names of frames, joints, points, actions are compared and printed in many places: they are refused, not changed.
TEST(HostileText, IsRefusedInAName) {
  for (const std::string bad : {"a\nb", "a\tb", "\x1B[31m", "arm\xE2\x80\x8B", "\xE2\x80\xAEmra", "\xFF", "\xED\xA0\x80"}) {
    Scene scene("s");
    const Expression q = scene.coordinate("q", "rad");
    const FrameHandle arm = scene.revolute("arm", scene.ground(), axis::z, q);
    const Expression one = Expression::quantity("1", "N m s");
    for (const std::function<void()>& act : std::initializer_list<std::function<void()>>{
             [&] { scene.weld(bad, arm, {}); }, [&] { scene.name_joint(arm, bad); }, [&] { scene.damper(bad, q, one); },
             [&] { scene.body(bad, arm, Inertia::point(Expression::quantity("1", "kg"))); },
             [&] { scene.point(bad, arm, {0, 0, 0}); }, [&] { scene.coordinate(bad, "m"); },
             [&] { scene.holonomic(bad, q); }, [&] { scene.motor(bad, q); }}) {
      const std::string message = refusal_of(act);
      EXPECT_NE(message.find("name '"), std::string::npos) << message;
      EXPECT_EQ(message.find(bad), std::string::npos) << message;
    }
  }
  Scene scene("s");
  EXPECT_EQ(refusal_of([&] { scene.weld("bras \xC3\xA9tendu \"<&>\"", scene.ground(), {}); }), "");
}

}  // namespace
}  // namespace torsor::hostile_text_test
