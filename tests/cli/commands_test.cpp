// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include <nlohmann/json.hpp>

#include "torsor/generator/base/error.hpp"
#include "tests/cli/scene_runner.hpp"

namespace torsor::commands_test {
namespace {

using namespace testing_programs;
using nlohmann::json;

TEST(SceneProgram, ListsWhatTheSceneContains) {
  const Outcome text = run(pendulum, {"list"});
  EXPECT_EQ(text.code, 0);
  EXPECT_EQ(text.err, "");
  EXPECT_NE(text.out.find("pendulum: Pendulum with a motor"), std::string::npos);
  EXPECT_NE(text.out.find("length = 1.5 [m] (run time)"), std::string::npos) << text.out;

  const Outcome data = run(pendulum, {"list", "--json"});
  EXPECT_EQ(data.code, 0);
  const json list = json::parse(data.out);
  EXPECT_EQ(list.at("name"), "pendulum");
  EXPECT_EQ(list.at("coordinates").at(0).at("name"), "theta");
  EXPECT_EQ(list.at("coordinates").at(0).at("role"), "unknown");
  EXPECT_EQ(list.at("frames"), (json{"ground", "arm"}));
  EXPECT_EQ(list.at("actions"), json::array({"torque"}));
  for (const json& kernel : list.at("kernels")) {
    const bool absent = kernel.at("name") == "constraints" || kernel.at("name") == "reactions" ||
                        kernel.at("name") == "first_integrals" || kernel.at("name") == "sparse_constraint_jacobian" ||
                        kernel.at("name") == "contacts" || kernel.at("name") == "contact_coefficients" ||
                        kernel.at("name") == "frames" || kernel.at("name") == "operational_inertia" ||
                        kernel.at("name") == "delassus" || kernel.at("name") == "impact";
    EXPECT_EQ(kernel.at("available"), !absent) << kernel;
    EXPECT_EQ(kernel.contains("why_not"), absent) << kernel;
  }
}

TEST(SceneProgram, DescribesTheSceneAsItsHeaderDoes) {
  const json list = json::parse(run(pendulum, {"list", "--json"}).out);
  const auto quantity = [](const char* name, const char* unit) { return json{{"name", name}, {"unit", unit}}; };
  EXPECT_EQ(list.at("coordinates").at(0).at("unit"), "rad");
  EXPECT_EQ(list.at("velocities"), json::array({quantity("theta", "rad/s")}));
  EXPECT_EQ(list.at("inputs"), json::array({quantity("torque", "N m")}));
  EXPECT_EQ(list.at("initial_state"), (json{{"time", 0.0}, {"q", json::array({0.5})}, {"v", json::array({0.0})}}));
  std::size_t described = 0;
  for (const json& kernel : list.at("kernels")) {
    if (!kernel.contains("results")) continue;
    ++described;
    if (kernel.at("name") != "mass_matrix") continue;
    const json mass{{"name", "mass"}, {"size", 1}, {"rows", 1}, {"columns", 1}, {"unit", "kg m^2"}};
    EXPECT_EQ(kernel.at("results"), json::array({mass}));
    EXPECT_EQ(kernel.at("status"), false);
  }
  EXPECT_GT(described, 5U);
  const std::string header = run(pendulum, {"generate", "--output", "-"}).out;
  EXPECT_NE(header.find("fingerprint = 0x" + list.at("fingerprint").get<std::string>()), std::string::npos);
  // Of other kernels.
  const json few = json::parse(run(pendulum, {"list", "--json", "--kernels", "energy"}).out);
  EXPECT_NE(few.at("fingerprint"), list.at("fingerprint"));
}

TEST(SceneProgram, WritesSupportOnceForHeadersThatAskForIt) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("torsor_support_" + std::to_string(std::random_device{}()));
  const auto path = [&folder](const char* name) { return (folder / name).string(); };
  const auto text_of = [&path](const char* name) {
    std::ifstream file(path(name));
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  std::filesystem::create_directories(folder / "below");
  const Outcome outcome = run(pendulum, {"generate", "--kernels", "energy", "--support", path("shared.hpp"), "--output",
                                         path("below/pendulum.hpp")});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::string header = text_of("below/pendulum.hpp"), support = text_of("shared.hpp");
  EXPECT_NE(header.find("\n#include \"../shared.hpp\"\n"), std::string::npos);
  EXPECT_EQ(header.find("struct SineCosine"), std::string::npos);
  EXPECT_NE(support.find("struct SineCosine"), std::string::npos);
  EXPECT_NE(support.find("class Convolutions"), std::string::npos);
  // But for the support, the text is that of a header of its own.
  const std::string alone = run(pendulum, {"generate", "--kernels", "energy", "--output", "-"}).out;
  const auto kernels = [](const std::string& text) { return text.substr(text.find("  /// Parameters that are set")); };
  EXPECT_EQ(kernels(header), kernels(alone));
  EXPECT_NE(alone.find("struct SineCosine"), std::string::npos);
  expect_failure_beginning(run(pendulum, {"generate", "--language", "javascript", "--support", path("x.mjs"), "--output", "-"}), 2,
                           "--support is for");
  expect_failure_beginning(run(pendulum, {"generate", "--source", path("x.c"), "--output", path("x.hpp")}), 2,
                           "--source is for");
  expect_failure_beginning(run(pendulum, {"generate", "--support", path("x.hpp"), "--output", path("x.hpp")}), 2,
                           "--support " + path("x.hpp") + " is written by another option");
  std::filesystem::remove_all(folder);
}

Scene sliding_top() {
  Scene scene("top");
  const Expression x = scene.coordinate("x", "m");
  const AttitudeHandle turn = scene.attitude("e");
  const Expression z = scene.coordinate("z", "m"), y = scene.coordinate("y", "m");
  const Expression one = Expression::quantity("1", "kg m^2");
  const FrameHandle top = scene.free("top", scene.ground(), {x, y, z}, turn);
  scene.body("top", top, Inertia::general({.mass = Expression::quantity("1", "kg"), .xx = one, .yy = one, .zz = one}));
  return scene;
}

// The coordinate of an angular velocity has no position: what is listed is the velocity.
TEST(SceneProgram, ListsQuasiVelocitiesInTheirUnit) {
  const json list = json::parse(run(sliding_top, {"list", "--json"}).out);
  int found = 0;
  for (const json& coordinate : list.at("coordinates")) {
    if (coordinate.at("role") == "quasi-velocity") found += coordinate.at("unit") == "rad/s" ? 1 : 0;
    if (coordinate.at("role") == "unknown") {
      EXPECT_EQ(coordinate.at("unit"), "m");
    }
  }
  EXPECT_EQ(found, 3);
  const std::string text = run(sliding_top, {"list"}).out;
  EXPECT_NE(text.find("e_omega_x [rad/s] (quasi-velocity)"), std::string::npos) << text;
}

// Who fills q[i] by the order of a list must fill the right ones: lists, pages and headers have one order.
TEST(SceneProgram, ListsPositionsInTheOrderOfTheHeader) {
  const std::vector<std::string> expected{"x", "e_w", "e_x", "e_y", "e_z", "z", "y"};
  const Outcome header = run(sliding_top, {"generate", "--kernels", "energy", "--output", "-"});
  ASSERT_EQ(header.code, 0) << header.err;
  const std::size_t begin = header.out.find("struct Coordinates {"), end = header.out.find("};", begin);
  const std::string members = header.out.substr(begin, end - begin);
  const auto ordered = [&](const std::string& text, const std::string& before, const std::string& after) {
    std::size_t last = 0;
    for (const std::string& name : expected) {
      const std::size_t place = text.find(before + name + after);
      EXPECT_NE(place, std::string::npos) << name << text;
      EXPECT_GE(place, last) << name << " comes too early in\n" << text;
      last = place;
    }
  };
  ordered(members, "Scalar ", ";");
  const std::string list = run(sliding_top, {"list"}).out;
  ordered(list.substr(list.find("coordinates")), " ", " [");
  const std::string page = run(sliding_top, {"equations"}).out;
  ordered(page.substr(page.find("Coordinates\n")), "\n  ", " [");
  std::vector<std::string> names;
  const json data = json::parse(run(sliding_top, {"list", "--json"}).out);
  for (const json& each : data.at("coordinates")) {
    if (each.at("role") == "unknown" || each.at("role") == "quaternion") names.push_back(each.at("name"));
  }
  EXPECT_EQ(names, expected);
}

TEST(SceneProgram, CountsUnknownsAndIsolatesBodies) {
  const Outcome report = run(pendulum, {"unknowns"});
  EXPECT_EQ(report.code, 0);
  EXPECT_NE(report.out.find("  6 unknowns: 5 components in joints, 0 multipliers, 1 acceleration\n"), std::string::npos)
      << report.out;
  const Outcome wrong = run(pendulum, {"unknowns", "--isolate", "moon", "--at", "nowhere"});
  EXPECT_EQ(wrong.code, 3);
  EXPECT_NE(wrong.err.find("unknown body 'moon' in a report on isolated bodies"), std::string::npos) << wrong.err;
  const Outcome half = run(pendulum, {"unknowns", "--isolate", "bob"});
  EXPECT_EQ(half.code, 2);
  EXPECT_NE(half.err.find("--isolate BODIES and --at POINT go together"), std::string::npos) << half.err;
}

TEST(SceneProgram, CountsTheKernelsAskedForInTheOrderOfTheHeader) {
  const Outcome data = run(pendulum, {"counts", "--json", "--kernels", "energy,mass_matrix,energy"});
  EXPECT_EQ(data.code, 0);
  const json counts = json::parse(data.out);
  const json& kernels = counts.at("kernels");
  EXPECT_EQ(kernels.size(), 2U);
  for (const char* kernel : {"mass_matrix", "energy"}) {
    const json& count = kernels.at(kernel);
    const int total = count.at("additions").get<int>() + count.at("multiplications").get<int>() +
                      count.at("divisions").get<int>() + count.at("square_roots").get<int>() +
                      2 * count.at("sincos_pairs").get<int>() + count.at("others").get<int>();
    EXPECT_EQ(count.at("total"), total);
  }
  EXPECT_EQ(kernels.at("energy").at("sincos_pairs"), 1);
  EXPECT_EQ(kernels.at("mass_matrix").at("sincos_pairs"), 0);
  // What several kernels need is computed once: no fewer operations than in the largest, no more than in all of them.
  const json several = json::parse(run(pendulum, {"counts", "--json", "--kernels", "energy,forward_dynamics"}).out);
  const int joint = several.at("joint").at("total"), energy = several.at("kernels").at("energy").at("total"),
            forward = several.at("kernels").at("forward_dynamics").at("total");
  EXPECT_GT(joint, std::max(energy, forward));
  EXPECT_LT(joint, energy + forward);
  const Outcome table = run(pendulum, {"counts", "--kernels", "energy,mass_matrix"});
  EXPECT_EQ(table.code, 0);
  EXPECT_LT(table.out.find("mass_matrix"), table.out.find("energy"));
}

/// The total of a kernel in the table of a header's head.
int total_in_the_head(const std::string& header, const std::string& kernel) {
  const std::size_t begin = header.find("//   " + kernel + " ");
  if (begin == std::string::npos) return -1;
  std::istringstream row(header.substr(begin + 4, header.find('\n', begin) - begin - 4));
  std::string name;
  int count = 0;
  row >> name;
  for (int column = 0; column < 7; ++column) row >> count;  // the total is the seventh
  return count;
}

TEST(SceneProgram, CountsTheKernelsAsTheHeaderDoes) {
  const Outcome header = run(pendulum, {"generate", "--kernels", "energy,forward_dynamics,jets", "-o", "-"});
  const Outcome counts = run(pendulum, {"counts", "--json", "--kernels", "energy,forward_dynamics,jets"});
  const json kernels = json::parse(counts.out).at("kernels");
  ASSERT_EQ(kernels.size(), 3U);
  EXPECT_GT(json::parse(counts.out).at("joint").at("total"), kernels.at("jets").at("total"));
  for (const auto& [kernel, count] : kernels.items()) {
    EXPECT_NE(header.out.find(kernel), std::string::npos);
    EXPECT_EQ(count.at("total"), total_in_the_head(header.out, kernel)) << kernel << "\n" << header.out.substr(0, 3000);
  }
}

TEST(SceneProgram, CountsNoKernelsThatAreAbsent) {
  const Outcome named = run(pendulum, {"counts", "--json", "--kernels", "energy,constraints"});
  EXPECT_EQ(named.code, 0);
  EXPECT_EQ(json::parse(named.out).at("kernels").size(), 1U);
  EXPECT_NE(named.err.find("note: the kernel constraints is absent"), std::string::npos) << named.err;
  const Outcome all = run(pendulum, {"counts", "--json"});
  EXPECT_FALSE(json::parse(all.out).at("kernels").contains("constraints"));
  EXPECT_EQ(all.err, "");
}

TEST(SceneProgram, KeepsParametersThatAreAskedToStaySymbols) {
  const auto multiplications = [](const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"counts", "--json", "--kernels", "energy"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = run(pendulum, arguments);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return json::parse(outcome.out).at("kernels").at("energy").dump();
  };
  EXPECT_EQ(multiplications({"--run-time", "mass"}), multiplications({"--run-time", "all"}));
  const auto header = [](const std::string& list) {
    return run(pendulum, {"generate", "--kernels", "mass_matrix", "--run-time", list, "--output", "-"}).out;
  };
  for (const char* list : {"mass", "mass,length", "all"}) {
    EXPECT_NE(header(list).find("// Parameters set at run time: mass, length\n"), std::string::npos) << list;
  }
  EXPECT_NE(header("length").find("// Parameters set at run time: length\n"), std::string::npos);
  expect_failure(run(pendulum, {"counts", "--run-time", "mas"}), 2,
                 "unknown parameter 'mas' in --run-time: did you mean 'mass'? the scene 'pendulum' has mass, length");
}

TEST(SceneProgram, ChecksTheSceneAndReportsEachComparison) {
  const Outcome data = run(pendulum, {"check", "--digits", "30", "--states", "2", "--json"});
  EXPECT_EQ(data.code, 0);
  const json check = json::parse(data.out);
  EXPECT_TRUE(check.at("passed"));
  EXPECT_GT(check.at("checks").size(), 10U);
  for (const json& result : check.at("checks")) {
    EXPECT_TRUE(result.at("passed"));
    EXPECT_LE(result.at("worst").get<double>(), result.at("bound").get<double>());
  }
  const Outcome text = run(pendulum, {"check", "--digits", "30", "--states", "2"});
  EXPECT_NE(text.out.find("ok    derivations"), std::string::npos) << text.out;
}

/// A spring so long that its force and the force that balances it leave nothing of x in a double.
Scene ill_conditioned() {
  Scene scene("ill_conditioned");
  const Expression x = scene.coordinate("x", "m");
  const FrameHandle slide = scene.prismatic("slide", scene.ground(), axis::x, x);
  scene.body("block", slide, Inertia::point(Expression::quantity("1", "kg")));
  scene.point("G", slide, {0, 0, 0});
  scene.spring("spring", x, Expression::quantity("1", "N/m"), Expression::quantity("1e18", "m"));
  scene.force("balance", {.body = slide,
                          .point = scene.point("G"),
                          .components = {Expression::quantity("-1e18", "N"), 0, 0},
                          .axes = scene.ground()});
  return scene;
}

TEST(SceneProgram, ExitsWithOneWhenACheckFails) {
  const Outcome data = run(ill_conditioned, {"check", "--states", "2", "--json"});
  EXPECT_EQ(data.code, 1);
  EXPECT_EQ(data.err, "");
  const json check = json::parse(data.out);
  EXPECT_FALSE(check.at("passed"));
  for (const json& result : check.at("checks")) {
    if (result.at("name") != "derivations" && result.at("name") != "double.bias") continue;
    EXPECT_EQ(result.at("passed"), result.at("name") == "derivations") << result;
  }
  EXPECT_NE(run(ill_conditioned, {"check", "--states", "1"}).out.find("FAIL  double.bias"), std::string::npos);
}

TEST(SceneProgram, PrintsEquationsAsTextAndAsLatex) {
  const Outcome text = run(pendulum, {"equations"});
  EXPECT_EQ(text.code, 0);
  EXPECT_NE(text.out.find("theta"), std::string::npos);
  const Outcome latex = run(pendulum, {"equations", "--format", "latex"});
  EXPECT_EQ(latex.code, 0);
  EXPECT_NE(latex.out.find("\\theta"), std::string::npos);
  EXPECT_EQ(run(pendulum, {"equations", "--format", "html"}).code, 2);
  expect_failure_beginning(run(pendulum, {"equations", "--about", "theta"}), 2,
                           "--about takes NAME=VALUE, e.g. theta=0, and got 'theta'");
}

TEST(SceneProgram, IntegratesAReference) {
  const Outcome outcome = run(pendulum, {"reference", "--digits", "20", "--times", "0.1,0.2"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_NE(outcome.out.find("\ntime,theta,theta'\n0.1,0.4"), std::string::npos) << outcome.out;
  EXPECT_EQ(run(pendulum, {"reference"}).code, 2);
  EXPECT_NE(run(pendulum, {"reference", "--times", "soon"}).code, 0);
  for (const char* times : {"0", "-1", "0.1,0.1", "0.2,0.1"}) {
    const Outcome refused = run(pendulum, {"reference", "--digits", "20", "--times", times});
    EXPECT_EQ(refused.code, 2) << times;
    EXPECT_NE(refused.err.find("times are positive and increase"), std::string::npos) << refused.err;
  }
  expect_failure(run(pendulum, {"reference", "--times", "1e400"}), 2,
                 "--times: '1e400' is beyond what a double holds, and no motion gets there");
}

TEST(SceneProgram, HelpsEverywhere) {
  const Outcome help = run(pendulum, {"--help"});
  EXPECT_EQ(help.code, 0);
  for (const char* command : {"equations", "generate", "counts", "check", "reference", "list"}) {
    EXPECT_NE(help.out.find(command), std::string::npos) << command;
    const Outcome one = run(pendulum, {command, "--help"});
    EXPECT_EQ(one.code, 0) << command;
    EXPECT_EQ(one.err, "") << command;
    EXPECT_NE(one.out.find("--output"), std::string::npos) << command;
  }
  EXPECT_EQ(run(pendulum, {"--version"}).out, "torsor " TORSOR_VERSION "\n");
  EXPECT_NE(run(pendulum, {"generate", "--help"}).out.find("forward_dynamics"), std::string::npos);
}

TEST(SceneProgram, HelpsBeforeTheSceneIsBuilt) {
  const auto broken = []() -> Scene { throw SceneError("this scene cannot be built"); };
  EXPECT_EQ(run(broken, {"check", "--help"}).code, 0);
  expect_failure(run(broken, {"list"}), 3, "this scene cannot be built");
}

TEST(SceneProgram, RefusesWhatItDoesNotUnderstand) {
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{{},
                                                                                         {"lst"},
                                                                                         {"list", "--jsn"},
                                                                                         {"list", "more"},
                                                                                         {"check", "--digits", "5"},
                                                                                         {"check", "--states", "many"},
                                                                                         {"generate"},
                                                                                         {"list", "--output"}}) {
    const Outcome outcome = run(pendulum, arguments);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_TRUE(outcome.err.starts_with("scene: ")) << outcome.err;
    EXPECT_TRUE(outcome.err.ends_with("; see --help\n")) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  }
}

TEST(SceneProgram, NamesAnUnknownKernelAndTheKnownOnes) {
  for (const char* command : {"counts", "generate"}) {
    expect_failure(
        run(pendulum, {command, "--output", "/nowhere/x", "--kernels", "mass_matrix,weights"}), 2,
        "unknown kernel 'weights': known are kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, "
        "energy, first_integrals, constraints, reactions, contacts, contact_coefficients, linearisation, "
        "inverse_dynamics_derivatives, "
                  "forward_dynamics_derivatives, regressor, jets, sparse_constraint_jacobian, residual, residual_jacobian, "
                  "inverse_dynamics_second_derivatives, forward_dynamics_second_derivatives, "
                  "inverse_dynamics_sensitivities, forward_dynamics_sensitivities, gravity, centroidal_momentum, frames, "
                  "operational_inertia, delassus, impact, poses, "
                  "or all");
  }
}

}  // namespace
}  // namespace torsor::commands_test
