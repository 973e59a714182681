// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/emission/header.hpp"

#include <iomanip>
#include <regex>
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/kernels/kernel.hpp"
#include "torsor/generator/program/formula.hpp"
#include "tests/emission/golden_scene.hpp"
#include "tests/scenes/bodies.hpp"

namespace torsor::header_test {
namespace {

Scene spatial_arm() {
  using Q = Expression;
  Scene scene("spatial_arm");
  const Q a = scene.coordinate("a", "rad");
  const Q b = scene.coordinate("b", "rad");
  const Q slide = scene.coordinate("slide", "m");
  const Placement offset{{Q(0), Q::quantity("0.4", "m"), Q(0)}, {}};
  const FrameHandle first = scene.revolute("first", scene.ground(), axis::z, a);
  const FrameHandle second = scene.revolute("second", first, axis::x, b, offset);
  const FrameHandle third = scene.prismatic("third", second, axis::y, slide, offset);
  const Inertia inertia =
      Inertia::box(Q::quantity("3", "kg"), Q::quantity("0.1", "m"), Q::quantity("0.5", "m"), Q::quantity("0.2", "m"))
          .at({Q(0), Q::quantity("0.3", "m"), Q::quantity("0.05", "m")});
  scene.body("upper", first, inertia);
  scene.body("lower", second, inertia);
  scene.body("tool", third, inertia);
  scene.gravity({Q(0), Q(0), -Q::quantity("9.81", "m/s^2")});
  scene.motor("drive", a);
  return scene;
}

/// The lines between the function's head and its end.
std::string body_of(const std::string& header, const std::string& function) {
  const std::size_t head = header.find(" " + function + "(");
  const std::size_t begin = header.find("noexcept {\n", head) + 11;
  return header.substr(begin, header.find("\n  }\n", begin) - begin);
}

/// Operators in the statements of a body up to the checks of its status.
OperationCount operators_in(const std::string& body) {
  const std::string text = body.substr(0, body.find("    if (!("));
  const auto occurrences = [&text](const std::string& pattern) {
    const std::regex regex(pattern);
    return static_cast<int>(std::distance(std::sregex_iterator(text.begin(), text.end(), regex), {}));
  };
  OperationCount count;
  count.additions = occurrences("[a-z0-9_)\\]]\\s+[+-] ");
  count.multiplications = occurrences("\\s\\* ");
  count.divisions = occurrences("\\s/ ");
  count.square_roots = occurrences("traits::sqrt\\(");
  count.sincos_pairs = occurrences("traits::sincos\\(");
  const std::regex several("Scalar sines[0-9]*_\\[([0-9]+)\\]");
  for (std::sregex_iterator each(text.begin(), text.end(), several), end; each != end; ++each) {
    count.sincos_pairs += std::stoi((*each)[1]);
  }
  return count;
}

void expect_equal(const OperationCount& text, const OperationCount& counted, const std::string& what) {
  EXPECT_EQ(text.additions, counted.additions) << what;
  EXPECT_EQ(text.multiplications, counted.multiplications) << what;
  EXPECT_EQ(text.divisions, counted.divisions) << what;
  EXPECT_EQ(text.square_roots, counted.square_roots) << what;
  EXPECT_EQ(text.sincos_pairs, counted.sincos_pairs) << what;
}

TEST(Header, StatesExactlyTheOperationsThatAreCounted) {
  const Scene scene = spatial_arm();
  const std::vector<std::string> names =
      parse_kernel_list("kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,linearisation");
  const std::string header = emit_header(scene, names);
  for (const auto& [own, kernel] : make_own_kernels(scene, {}, names)) {
    const Equations& equations = *own;
    const OperationCount counted = count(equations.program(), kernel.values());
    ASSERT_GT(counted.total(), 0) << kernel.name;
    expect_equal(operators_in(body_of(header, kernel.name)), counted, kernel.name);
    // The head comment tells the same, and the number before optimisation behind it.
    const std::regex row("// +" + kernel.name + " .* " + std::to_string(counted.total()) + " +[0-9]+\n");
    EXPECT_GE(count_unoptimised(equations.program(), kernel.values()).total(), counted.total()) << kernel.name;
    EXPECT_TRUE(std::regex_search(header, row)) << kernel.name;
  }
}

TEST(Header, DoesOnceWhatDependsOnParametersOnly) {
  const Scene scene = testing_scenes::golden_pendulum();
  const Equations equations(scene);
  const Kernel kernel = make_kernel("mass_matrix", equations);
  const std::string header = emit_header(scene, {"mass_matrix"});
  // M = m l²: nothing is left to the kernel.
  EXPECT_EQ(operators_in(body_of(header, "mass_matrix")).total(), 0);
  expect_equal(operators_in(body_of(header, "precompute")),
               count(equations.program(), kernel.values(), Occasion::parameters), "M");
}

TEST(Header, IsTheSameForTheSameScene) {
  const auto header = [] {
    return emit_header(spatial_arm(), parse_kernel_list("all"));
  };
  const std::string first = header();
  const std::vector<std::string> disturbance(1000, std::string(100, 'x'));  // other addresses for the second
  EXPECT_EQ(first, header());
}

// What is measured was remembered in a program that had forgotten its definitions: a second kernel crashed.
TEST(Header, HasTheSameFunctionsAloneWhereForcesMeasureTheMotion) {
  Scene scene("swing");
  const Expression m = scene.parameter("m", "kg", 1), l = scene.parameter("l", "m", 1);
  const Expression c = scene.parameter("c", "N s^2/m^2", Number(1) / Number(10)), theta = scene.coordinate("theta", "rad");
  const FrameHandle bar = scene.revolute("bar", scene.ground(), axis::y, theta);
  scene.body("bar", bar, Inertia::rod(m, l, 2).at({0, 0, -l / 2}));
  const PointHandle tip = scene.point("tip", bar, {0, 0, -l});
  const Triple v = scene.velocity(tip, bar, "ground"), p = scene.position(tip, "ground");
  scene.force("air", {.body = bar, .point = tip, .components = {-c * abs(v[0]) * v[0], 0, 0}, .axes = "ground"});
  scene.force_function("elastic", -Expression::quantity("1", "N/m") * p[0] * p[0]);
  const std::vector<std::string> names = parse_kernel_list("all");
  const std::string together = emit_header(scene, names), backwards = emit_header(scene, {names.rbegin(), names.rend()});
  std::size_t compared = 0;
  for (const std::string& name : names) {
    if (together.find(" " + name + "(const Precomputed&") == std::string::npos) continue;
    EXPECT_EQ(body_of(together, name), body_of(emit_header(scene, {name}), name)) << name;
    EXPECT_EQ(body_of(together, name), body_of(backwards, name)) << name;
    ++compared;
  }
  EXPECT_GT(compared, 10U);
}

Scene block_of(const std::string& mass, const std::string& title) {
  Scene scene("block", title);
  scene.body("block", scene.prismatic("slide", scene.ground(), axis::x, scene.coordinate("x", "m")),
             Inertia::point(Expression::quantity(mass, "kg")));
  return scene;
}

std::string fingerprint_in(const std::string& header) {
  return header.substr(header.find("fingerprint = 0x") + 16, 16);
}

TEST(Header, HasTheFingerprintOfItsTextBelowTheHead) {
  std::string header = emit_header(block_of("2", ""), parse_kernel_list("bias,mass_matrix"));
  const std::string fingerprint = fingerprint_in(header);
  header.replace(header.find(fingerprint), 16, 16, '0');
  // FNV-1a with 64 bits: http://www.isthe.com/chongo/tech/comp/fnv/, offset basis and prime in decimal as given there.
  unsigned long long bits = 14695981039346656037ULL;
  for (std::size_t i = header.find("#pragma once"); i < header.size(); ++i) {
    bits = (bits ^ static_cast<unsigned char>(header[i])) * 1099511628211ULL;
  }
  std::ostringstream text;
  text << std::hex << std::setw(16) << std::setfill('0') << bits;
  EXPECT_EQ(fingerprint, text.str());
}

TEST(Header, HasAnotherFingerprintForAnotherMassButNotForAnotherTitle) {
  const auto fingerprint = [](const Scene& scene) {
    return fingerprint_in(emit_header(scene, parse_kernel_list("mass_matrix")));
  };
  EXPECT_EQ(fingerprint(block_of("2", "A block")), fingerprint(block_of("2", "The same")));
  EXPECT_NE(fingerprint(block_of("2", "A block")), fingerprint(block_of("2.5", "A block")));
}

TEST(Header, HasOnlyTheKernelsAskedFor) {
  const std::string header = emit_header(spatial_arm(), parse_kernel_list("bias,constraints"));
  EXPECT_NE(header.find("static void bias("), std::string::npos);
  EXPECT_EQ(header.find("mass_matrix"), std::string::npos);
  EXPECT_EQ(header.find("struct Constraints"), std::string::npos);
  EXPECT_NE(header.find("//   constraints: left out, the scene has no constraints\n"), std::string::npos);
  EXPECT_NE(header.find("//   spatial_arm_scene generate --kernels bias,constraints --output spatial_arm.hpp\n"),
            std::string::npos);
}

TEST(Header, CountsFirstIntegralsWhereThereAreNoneToo) {
  const auto has = [](const Scene& scene, const std::string& kernels, const std::string& text) {
    return emit_header(scene, parse_kernel_list(kernels)).find(text) != std::string::npos;
  };
  // The pendulum has friction and keeps nothing; the arm keeps nothing it was asked for.
  EXPECT_TRUE(has(testing_scenes::golden_pendulum(), "first_integrals", "int first_integral_count = 0;"));
  EXPECT_TRUE(has(spatial_arm(), "mass_matrix", "int first_integral_count = 0;"));
}

TEST(Header, KeepsTheParametersItIsAskedToKeep) {
  ModelOptions options;
  options.run_time = {"mass"};
  const std::string with_mass = emit_header(testing_scenes::golden_pendulum(), parse_kernel_list("bias"), options);
  EXPECT_NE(with_mass.find("// Parameters set at run time: length, friction, mass\n"), std::string::npos);
  EXPECT_NE(with_mass.find("--kernels bias --run-time mass --output"), std::string::npos);
  EXPECT_NE(with_mass.find("= parameters.mass;"), std::string::npos);

  ModelOptions everything;
  everything.all_run_time = true;
  const std::string with_all = emit_header(testing_scenes::golden_pendulum(), parse_kernel_list("bias"), everything);
  EXPECT_NE(with_all.find("parameter_count = 4;"), std::string::npos);
  EXPECT_NE(with_all.find("--run-time all"), std::string::npos);
}

TEST(Header, LeavesArgumentsWithoutUseUnnamed) {
  const std::string header = emit_header(testing_scenes::golden_pendulum(), parse_kernel_list("mass_matrix"));
  EXPECT_NE(header.find("mass_matrix(const Precomputed& precomputed, const State&,\n"
                        "      std::array<Scalar, 1>& mass) noexcept"),
            std::string::npos);
}

TEST(Header, RefusesNamesThatCppDoesNotTake) {
  const auto message_of = [](const std::string& scene_name, const std::string& coordinate) -> std::string {
    Scene scene(scene_name);
    const Expression q = scene.coordinate(coordinate, "m");
    scene.body("block", scene.prismatic("slide", scene.ground(), axis::x, q),
               Inertia::point(Expression::quantity("1", "kg")));
    const Equations equations(scene);
    try {
      emit_header(equations.scene(), parse_kernel_list("mass_matrix"));
    } catch (const SceneError& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_EQ(message_of("block", "x"), "no error");
  EXPECT_NE(message_of("gamma", "x").find("the name 'gamma' of a scene belongs to the C library"), std::string::npos);
  EXPECT_NE(message_of("block", "Scalar").find("the name 'Scalar' of a member of Coordinates is used by the header"),
            std::string::npos);
}

TEST(Header, SaysWhichConstantsNoFloatIsNearTo) {
  Scene scene("oscillator");
  const Expression x = scene.coordinate("x", "m"), per_metre = Expression::quantity("1", "N/m");
  scene.body("mass", scene.prismatic("slide", scene.ground(), axis::x, x), Inertia::point(Expression::quantity("1", "kg")));
  scene.generalised_force("weak", x, Expression(Number(10).pow(-60)) * per_metre * x);
  scene.generalised_force("strong", x, Expression(Number(10).pow(60)) * per_metre * abs(x));
  const std::string header = emit_header(scene, {"bias"});
  for (const char* what : {"0", "infinite"}) {
    const std::string line = fmt::format("// In float the next constant is {}.\n    const Scalar ", what);
    EXPECT_NE(header.find(line), std::string::npos) << what;
  }
}

TEST(Header, GivesAQuaternionsComponentsNoUnitOfAnAngle) {
  const std::string header = emit_header(testing_mechanisms::torque_free_body(), parse_kernel_list("mass_matrix"));
  EXPECT_NE(header.find("    Scalar e_w;  ///< component of a unit quaternion [1]\n"), std::string::npos) << header;
  EXPECT_NE(header.find("    Scalar e_omega_x;  ///< angular velocity, in moving axes [rad/s]\n"), std::string::npos);
}

TEST(Header, RefusesAKernelThatReadsWhatItIsNotGiven) {
  const Equations equations(spatial_arm());
  Program& program = equations.program();
  const Kernel kernel = make_kernel("inverse_dynamics", equations);
  const Layout layout{equations.model().positions(), {}, {}, {}, {}, {}};
  const Schedule schedule = make_schedule(program, kernel.values());
  try {
    lower(program, schedule.function, kernel, {&layout, &schedule, kernel.name});
    FAIL() << "the accelerations are not among the arguments";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("the kernel 'inverse_dynamics' needs"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace torsor::header_test
