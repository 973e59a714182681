// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/emission/fmi_unit.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/emission/fmi_description.hpp"
#include "torsor/generator/torsor.hpp"

namespace torsor::fmi_unit_test {
namespace {

using namespace torsor::literals;

/// A block on a rail that does not let it fall; with a table that it touches.
Scene block_on_rail(bool touches) {
  Scene scene("block_on_rail", "A block on a rail");
  const Expression x = scene.coordinate("x", "m"), lift = scene.released_coordinate("lift", "m");
  const FrameHandle rail = scene.prismatic("rail", scene.ground(), axis::z, lift);
  const FrameHandle block = scene.prismatic("block", rail, axis::x, x);
  scene.body("block", block, Inertia::point(scene.parameter("m", "kg", 2)));
  scene.gravity({0, 0, -scene.parameter("g", "m/s^2", 9.81_r)});
  scene.point("corner", block, {0, 0, 0});
  if (touches) scene.stop(x, Expression::quantity("-1", "m"), Expression::quantity("1", "m"), {.restitution = 0});
  return scene;
}

std::string message_of(const Scene& scene, const OutputNames& outputs) {
  try {
    lower_unit(scene, FmiVersion::two, outputs);
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

TEST(FmiUnit, RefusesReactionsWhereContactsShareInThem) {
  EXPECT_EQ(message_of(block_on_rail(false), {{}, {}, {"lift"}}), "");
  EXPECT_EQ(message_of(block_on_rail(true), {{"corner"}, {"block"}, {}}), "");
  EXPECT_EQ(message_of(block_on_rail(true), {{}, {}, {"lift"}}),
            "the scene 'block_on_rail' has contacts, whose forces share in its reactions: a unit has none of 'lift'");
}

TEST(FmiUnit, NamesWhatTheSceneDoesNotHave) {
  EXPECT_NE(message_of(block_on_rail(false), {{"edge"}, {}, {}}).find("unknown point 'edge'"), std::string::npos);
  EXPECT_NE(message_of(block_on_rail(false), {{}, {"edge"}, {}}).find("unknown frame 'edge'"), std::string::npos);
  EXPECT_EQ(message_of(block_on_rail(false), {{}, {}, {"x"}}), "the scene 'block_on_rail' releases no coordinate 'x'");
}

TEST(FmiUnit, GivesRatesOfRatiosAndOfQuaternionsNoAngles) {
  Scene scene("ball", "");
  const Expression s = scene.coordinate("s", "1"), metre = Expression::quantity("1", "m"), kg = Expression::quantity("1", "kg");
  scene.body("ball", scene.spherical("ball", "ground", scene.attitude("e")), Inertia::solid_sphere(kg, metre));
  scene.body("slide", scene.prismatic("slide", "ground", axis::x, metre * s), Inertia::point(kg));
  const std::string text = fmi_description(lower_unit(scene, FmiVersion::two));
  for (const std::string name : {"der(q.e_w)", "der(q.s)"}) {
    const std::size_t at = text.find("name=\"" + name + "\"");
    ASSERT_NE(at, std::string::npos) << text;
    EXPECT_NE(text.substr(at, text.find("</ScalarVariable>", at) - at).find("unit=\"1/s\""), std::string::npos) << text;
  }
}

TEST(FmiUnit, HasTheKernelsThatItsOutputsNeedAndNoOthers) {
  const auto kernels = [](const FmiUnit& unit) {
    std::vector<std::string> names;
    for (const KernelListing& each : unit.mechanism.kernels) names.push_back(each.kernel.name);
    return names;
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(kernels(lower_unit(block_on_rail(false), FmiVersion::two)),
            (Names{"forward_dynamics", "energy", "forward_dynamics_derivatives", "energy_derivatives"}));
  EXPECT_EQ(kernels(lower_unit(block_on_rail(false), FmiVersion::two, {{"corner"}, {}, {"lift"}})),
            (Names{"forward_dynamics", "energy", "forward_dynamics_derivatives", "output_places", "output_reactions",
                   "energy_derivatives", "output_place_derivatives", "output_reaction_derivatives"}));
  EXPECT_EQ(kernels(lower_unit(block_on_rail(false), FmiVersion::two, {}, {.all_run_time = true})),
            (Names{"forward_dynamics", "energy", "forward_dynamics_derivatives", "forward_dynamics_sensitivities",
                   "energy_derivatives", "run_time_sizes"}));  // the mass is not below zero
  EXPECT_EQ(kernels(lower_unit(block_on_rail(true), FmiVersion::two, {{}, {"block"}, {}})),
            (Names{"forward_dynamics", "energy", "mass_matrix", "bias", "contacts", "contact_coefficients",
                   "output_places", "energy_derivatives", "output_place_derivatives", "contact_motion_derivatives",
                   "contact_row_derivatives"}));
}

TEST(FmiUnit, NamesAreFlatWhereTheyAreNoStructuredOnes) {
  Scene scene = block_on_rail(false);
  scene.weld("a \"b\" <c>", scene.ground(), {});
  scene.weld("\xce\xb1.2", scene.ground(), {});
  const auto description = [&scene](const std::string& frame) {
    return fmi_description(lower_unit(scene, FmiVersion::three, {{}, {frame}, {}}));
  };
  const std::string quoted = description("a \"b\" <c>"), greek = description("\xce\xb1.2");
  EXPECT_NE(quoted.find("variableNamingConvention=\"structured\""), std::string::npos);
  EXPECT_NE(quoted.find("name=\"frame.'a \\&quot;b\\&quot; &lt;c&gt;'.x\""), std::string::npos) << quoted;
  EXPECT_NE(greek.find("variableNamingConvention=\"flat\""), std::string::npos);
  EXPECT_NE(greek.find("name=\"frame.'\xce\xb1'.'2'.x\""), std::string::npos) << greek;
}

TEST(FmiUnit, TellsUnitsOfOtherOutputsApart) {
  const auto token = [](const OutputNames& outputs, FmiVersion version = FmiVersion::three) {
    return fmi_token(lower_unit(block_on_rail(false), version, outputs));
  };
  EXPECT_EQ(token({{}, {"rail"}, {}}), token({{}, {"rail"}, {}}));
  EXPECT_NE(token({{}, {"rail"}, {}}), token({}));
  EXPECT_NE(token({{}, {"rail"}, {}}), token({{}, {"ground"}, {}}));  // the same numbers under other names
  EXPECT_NE(token({}), token({}, FmiVersion::two));
}

}  // namespace
}  // namespace torsor::fmi_unit_test
