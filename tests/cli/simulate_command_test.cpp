// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "torsor/generator/expression/piecewise.hpp"
#include "tests/cli/scene_runner.hpp"

namespace torsor::simulate_command_test {
namespace {

using testing_programs::Outcome;
using testing_programs::pendulum;
using testing_programs::run;
using namespace testing_mechanisms;

/// Names, then rows.
std::pair<std::vector<std::string>, std::vector<std::vector<double>>> table(const std::string& csv) {
  std::pair<std::vector<std::string>, std::vector<std::vector<double>>> result;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("#")) continue;
    std::istringstream cells(line);
    std::vector<double> row;
    for (std::string cell; std::getline(cells, cell, ',');) {
      if (result.second.empty() && std::isalpha(static_cast<unsigned char>(cell[0]))) result.first.push_back(cell);
      else row.push_back(std::stod(cell));
    }
    if (!row.empty()) result.second.push_back(row);
  }
  return result;
}

TEST(Simulate, WritesATable) {
  const Outcome outcome = run(pendulum, {"simulate", "--to", "0.55", "--step", "0.1", "--initial", "theta=0.5,theta'=-1"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto [names, rows] = table(outcome.out);
  ASSERT_GE(names.size(), 6U);
  EXPECT_EQ(names[0], "time");
  EXPECT_EQ(names[1], "theta");
  EXPECT_EQ(names[2], "theta'");
  EXPECT_EQ(names[5], "mechanical_energy");
  ASSERT_EQ(rows.size(), 7U);
  EXPECT_EQ(rows[0][1], 0.5);
  EXPECT_EQ(rows[0][2], -1.0);
  EXPECT_EQ(rows.back()[0], 0.55);
  // Conserved within what steps of 1e-10 leave, of energies of some 30 J.
  for (const auto& row : rows) EXPECT_NEAR(row[5], rows[0][5], 1e-7);
}

/// Three masses of 1 kg on springs k1 = 1, k2 = 2 k1 and, at run time, k3 = 2 k1 (N/m), each 1 m away from rest.
Scene springs() {
  Scene scene("springs");
  const Expression k1 = scene.run_time_parameter("k1", "N/m", 1), k2 = scene.parameter("k2", "N/m", 2 * k1),
                   k3 = scene.run_time_parameter("k3", "N/m", 2 * k1);
  int number = 0;
  for (const Expression& k : {k1, k2, k3}) {
    const std::string name = "x" + std::to_string(++number);
    const Expression x = scene.coordinate(name, "m");
    scene.body(name, scene.prismatic(name, scene.ground(), axis::x, x), Inertia::point(Expression::quantity("1", "kg")));
    scene.spring("of_" + name, x, k);
    scene.initial(x, 1);
  }
  return scene;
}

// As in a header, where default_parameters() gives numbers: k1 changes k2, which is a formula of it, and not the default of k3.
// x = cos(sqrt(k) t) after 1 s; steps of 1e-10 leave some 1e-9.
// Where all lengths are far below 1 m the tolerance knows nothing of their size, which is said.
TEST(Simulate, SaysWhereItsToleranceIsCoarseBesideTheMotion) {
  const auto notes = [](const std::string& start, const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments{"simulate", "--to", "0.1", "--step", "0.05", "--initial", start};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = run(springs, arguments);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return outcome.err;
  };
  const std::string coarse = "coordinates in m stay below 2.0e-06, and a step may err by 1e-10 (1 + |y|), 5e-05 of that: "
                             "give --tolerance 2e-14";
  EXPECT_NE(notes("x1=1e-6,x2=-2e-6,x3=1e-6").find(coarse), std::string::npos);
  EXPECT_NE(notes("x1=1e-9,x2=0,x3=0", {"--tolerance", "1e-14"}).find("1e-05 of that: give --method gauss"), std::string::npos);
  for (const std::string& silent : {notes("x1=1e-6,x2=1,x3=0"), notes("x1=1e-3,x2=0,x3=0"), notes("x1=0,x2=0,x3=0"),
                                    notes("x1=1e-6,x2=0,x3=0", {"--tolerance", "1e-14"}),
                                    notes("x1=1e-9,x2=0,x3=0", {"--method", "gauss"})}) {
    EXPECT_EQ(silent.find("stay below"), std::string::npos) << silent;
  }
}

TEST(Simulate, DefaultsOfRunTimeParametersAreNumbers) {
  const auto ends = [](const std::vector<std::string>& words) {
    std::vector<std::string> all{"simulate", "--to", "1", "--step", "1"};
    all.insert(all.end(), words.begin(), words.end());
    const std::vector<double> row = table(run(springs, all).out).second.at(1);
    return std::array<double, 3>{row[1], row[2], row[3]};
  };
  const auto expect_stiffness = [&](const std::vector<std::string>& words, const std::array<double, 3>& k) {
    const std::array<double, 3> x = ends(words);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(x[i], std::cos(std::sqrt(k[i])), 1e-7) << i;
  };
  expect_stiffness({}, {1, 2, 2});
  expect_stiffness({"--run-time", "k1=8"}, {8, 16, 2});
  expect_stiffness({"--run-time", "k1=8,k3=3"}, {8, 16, 3});
  expect_stiffness({"--run-time", "k2=5"}, {1, 5, 2});
  const Outcome header = run(springs, {"generate", "--kernels", "bias", "--output", "-"});
  const std::size_t begin = header.out.find("parameters.k3 = ");
  ASSERT_NE(begin, std::string::npos) << header.out;
  EXPECT_EQ(header.out.substr(begin, header.out.find('\n', begin) - begin).find("k1"), std::string::npos) << header.out;
}

TEST(Simulate, RefusesANumberGivenTwice) {
  for (const std::string option : {"--initial", "--run-time", "--input"}) {
    const Outcome twice = run(pendulum, {"simulate", option, "theta=2,theta=3"});
    EXPECT_EQ(twice.code, 2);
    EXPECT_NE(twice.err.find(option + " names 'theta' twice: give it one value"), std::string::npos) << twice.err;
  }
  const Outcome about = run(pendulum, {"equations", "--about", "theta=0", "--about", "theta=1"});
  EXPECT_EQ(about.code, 2);
  EXPECT_NE(about.err.find("--about names 'theta' twice: give it one value"), std::string::npos) << about.err;
}

TEST(Simulate, HoldsAParameterAndAnInput) {
  const auto rows = table(run(pendulum, {"simulate", "--to", "0.1", "--run-time", "mass=4"}).out).second;
  const auto usual = table(run(pendulum, {"simulate", "--to", "0.1"}).out).second;
  const auto driven = table(run(pendulum, {"simulate", "--to", "0.1", "--input", "torque=7"}).out).second;
  ASSERT_FALSE(rows.empty() || usual.empty() || driven.empty());
  EXPECT_NEAR(rows[0][4], 2 * usual[0][4], 1e-12 * std::abs(rows[0][4]));  // the potential energy m g h
  // A torque C adds C t / (m l²) to the rate, m l² = 4.5 kg m²; at t = 0.1 s the weight's difference is of order t³.
  EXPECT_NEAR(driven.back()[2] - usual.back()[2], 0.7 / 4.5, 0.01);
}

TEST(Simulate, DrawsColumns) {
  const auto folder = std::filesystem::temp_directory_path() / "torsor_simulate_test";
  std::filesystem::create_directories(folder);
  const std::string picture = (folder / "motion.svg").string();
  const Outcome outcome = run(pendulum, {"simulate", "--to", "1", "--plot", picture, "theta,mechanical_energy"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  std::ifstream file(picture);
  std::ostringstream svg;
  svg << file.rdbuf();
  EXPECT_TRUE(svg.str().starts_with("<svg "));
  EXPECT_NE(svg.str().find("theta [rad]"), std::string::npos);
  EXPECT_EQ(run(pendulum, {"simulate", "--plot", picture, "thetta"}).code, 2);
  EXPECT_EQ(run(pendulum, {"simulate", "--plot", "motion.png", "theta"}).code, 2);
  std::filesystem::remove_all(folder);
}

TEST(Simulate, RefusesWhatMakesNoSense) {
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"--to", "-1"}, {"--step", "0"}, {"--tolerance", "2"}, {"--initial", "theta"}, {"--initial", "thetta=1"},
           {"--initial", "theta=nan"}, {"--run-time", "m=3"}, {"--input", "u=1"}, {"--plot", "motion.svg"}}) {
    std::vector<std::string> arguments{"simulate"};
    arguments.insert(arguments.end(), words.begin(), words.end());
    const Outcome outcome = run(pendulum, arguments);
    EXPECT_EQ(outcome.code, 2) << words[0] << " " << words[1];
    EXPECT_EQ(outcome.out, "");
  }
}

TEST(Simulate, RefusesTwoColumnsOfOneName) {
  const auto scene = [] {
    Scene named("named");
    const Expression x = named.coordinate("kinetic_energy", "m");
    named.body("block", named.prismatic("slide", named.ground(), axis::x, x), Inertia::point(Expression::quantity("1", "kg")));
    return named;
  };
  testing_programs::expect_failure_beginning(run(scene, {"simulate", "--to", "1"}), 2,
                                             "the motion has two columns 'kinetic_energy': a coordinate or a contact of the scene has");
}

TEST(Simulate, HasSeveralMethods) {
  const auto end = [](const std::string& method) {
    std::vector<std::string> words{"simulate", "--to", "1", "--step", "0.1", "--method", method};
    if (method == "gauss") words.insert(words.end(), {"--method-step", "0.01"});
    const Outcome outcome = run(pendulum, words);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return table(outcome.out).second.back()[1];
  };
  const double theta = end("dp853");
  EXPECT_NEAR(end("gauss"), theta, 1e-10);
  EXPECT_NEAR(end("radau"), theta, 1e-8);
  const Outcome unknown = run(pendulum, {"simulate", "--method", "raday"});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_NE(unknown.err.find("did you mean 'radau'"), std::string::npos) << unknown.err;
  const Outcome steps = run(pendulum, {"simulate", "--method-step", "0.01"});
  EXPECT_EQ(steps.code, 2);
  EXPECT_NE(steps.err.find("--method-step is for --method gauss"), std::string::npos) << steps.err;
  for (const char* none : {"0", "inf", "nan", "-1"}) {
    const Outcome step = run(pendulum, {"simulate", "--method", "gauss", "--method-step", none});
    EXPECT_EQ(step.code, 2) << none;
    EXPECT_NE(step.err.find("--method-step must be a time above 0"), std::string::npos) << step.err;
    const Outcome rows = run(pendulum, {"simulate", "--step", none});
    EXPECT_EQ(rows.code, 2) << none;
    EXPECT_NE(rows.err.find("--step must be a time above 0"), std::string::npos) << rows.err;
  }
  const Outcome tolerance = run(pendulum, {"simulate", "--method", "gauss", "--tolerance", "1e-9"});
  EXPECT_EQ(tolerance.code, 2);
  EXPECT_NE(tolerance.err.find("--tolerance is for methods that choose"), std::string::npos) << tolerance.err;
}

// A pendulum is at its lowest after a quarter of its period, and as fast as from the other side after three.
TEST(Simulate, EndsWhereAFormulaPassesThroughZero) {
  const Outcome outcome = run(pendulum, {"simulate", "--to", "10", "--until", "theta = 0"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto rows = table(outcome.out).second;
  EXPECT_NEAR(rows.back()[1], 0.0, 1e-13);
  // T/4 = K(sin(θ0/2)) √(l/g).
  EXPECT_NEAR(rows.back()[0], std::comp_ellint_1(std::sin(0.25)) * std::sqrt(1.5 / 9.81), 1e-9);
  EXPECT_NE(outcome.out.find("# Event: theta = 0 at t = "), std::string::npos);
}

TEST(Simulate, HasARowForEachEvent) {
  const Outcome met = run(pendulum, {"simulate", "--to", "5", "--step", "0.5", "--events", "lowest: theta", "--events", "turn: theta'"});
  ASSERT_EQ(met.code, 0) << met.err;
  const auto rows = table(met.out).second;
  const double quarter = std::comp_ellint_1(std::sin(0.25)) * std::sqrt(1.5 / 9.81);
  const auto has = [&](double t, std::size_t column) {
    return std::any_of(rows.begin(), rows.end(), [&](const auto& row) {
      return std::abs(row[0] - t) < 1e-8 && std::abs(row[column]) < 1e-12;
    });
  };
  for (int k = 1; k < 8; ++k) EXPECT_TRUE(has(k * quarter, k % 2 == 1 ? 1 : 2)) << k;
  EXPECT_TRUE(std::is_sorted(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a[0] < b[0]; }));
  EXPECT_EQ(rows.size(), 11U + static_cast<std::size_t>(5 / quarter));
}

TEST(Simulate, TellsTheFirstEventsAndTheLastOnes) {
  const Outcome met = run(pendulum, {"simulate", "--to", "10", "--events", "lowest: theta", "--events", "turn: theta'"});
  ASSERT_EQ(met.code, 0) << met.err;
  const auto count = [](const std::string& text, const std::string& word) {
    int found = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++found;
    return found;
  };
  const int all = count(met.out, "# Event: ");
  ASSERT_EQ(all, static_cast<int>(10 / (std::comp_ellint_1(std::sin(0.25)) * std::sqrt(1.5 / 9.81))));
  EXPECT_EQ(count(met.err, "note: event: "), 10) << met.err;
  EXPECT_EQ(count(met.err, "note: " + std::to_string(all - 10) + " events more: the table has all"), 1) << met.err;
}

// The pendulum passes theta = 0 between 0 and 1 s: 1/theta changes its sign there without a zero.
TEST(Simulate, TakesNoPoleForAnEvent) {
  const Outcome outcome = run(pendulum, {"simulate", "--to", "1", "--events", "pole: 1/theta", "--events", "zero: theta"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out.find("# Event: pole"), std::string::npos);
  EXPECT_NE(outcome.out.find("# Event: zero"), std::string::npos);
}

TEST(Simulate, RefusesEventsThatMakeNoSense) {
  for (const char* event : {"theta''", "thetta", ": theta", "a,b: theta", "theta = = 2"}) {
    EXPECT_EQ(run(pendulum, {"simulate", "--events", event}).code, 2) << event;
  }
}

/// A point on a line that its parabola f = x² + 1 never meets.
Scene impossible() {
  Scene scene("impossible", "");
  const Expression x = scene.coordinate("x", "m");
  scene.initial(x, Expression::quantity("1", "m"));
  const FrameHandle slider = scene.prismatic("slider", scene.ground(), axis::x, x);
  scene.body("point", slider, Inertia::point(Expression::quantity("1", "kg")));
  scene.holonomic("parabola", x * x + Expression::quantity("1", "m^2"));
  return scene;
}

/// A parallelogram that turns; at 0 and π its rows of constraints are parallel.
Scene parallelogram() {
  Scene scene("parallelogram");
  const auto length = [](int value) { return value * Expression::quantity("1", "m"); };
  const Expression a = scene.coordinate("a", "rad"), b = scene.coordinate("b", "rad"), c = scene.coordinate("c", "rad");
  const FrameHandle crank = scene.revolute("crank", scene.ground(), axis::z, a);
  const FrameHandle coupler = scene.revolute("coupler", crank, axis::z, b - a, {.origin = {length(1), 0, 0}});
  const FrameHandle rocker = scene.revolute("rocker", scene.ground(), axis::z, c, {.origin = {length(2), 0, 0}});
  const Expression kilogram = Expression::quantity("1", "kg");
  scene.body("crank", crank, Inertia::rod(kilogram, length(1), 0).at({length(1) / 2, 0, 0}));
  scene.body("coupler", coupler, Inertia::rod(2 * kilogram, length(2), 0).at({length(1), 0, 0}));
  scene.body("rocker", rocker, Inertia::rod(kilogram, length(1), 0).at({length(1) / 2, 0, 0}));
  scene.holonomic("x", cos(a) + 2 * cos(b) - cos(c) - 2);
  scene.holonomic("y", sin(a) + 2 * sin(b) - sin(c));
  scene.initial(a, 1, 3);
  scene.initial(c, 1, 3);
  return scene;
}

TEST(Simulate, NamesTheChangePointWhereItEnds) {
  const Outcome at = run(parallelogram, {"simulate", "--to", "1", "--initial", "a=0,c=0"});
  EXPECT_NE((at.out + at.err).find("a change point"), std::string::npos) << at.out << at.err;
  const Outcome elsewhere = run(parallelogram, {"simulate", "--to", "0.3"});
  EXPECT_EQ((elsewhere.out + elsewhere.err).find("change point"), std::string::npos) << elsewhere.out << elsewhere.err;
}

/// Windows of parallelograms side by side that start at 2 rad. At π/2 they are folded: of each loop one row vanishes as a whole.
Scene folding(int count) {
  Scene scene("folding");
  const Expression l = scene.parameter("l", "m", 1), m = scene.parameter("m", "kg", 1);
  std::vector<FrameHandle> cranks;
  std::vector<Expression> angles;
  for (int i = 0; i <= count; ++i) {
    const std::string number = std::to_string(i);
    angles.push_back(scene.coordinate("a" + number, "rad"));
    cranks.push_back(scene.revolute("crank" + number, scene.ground(), axis::x, angles.back(), {.origin = {0, i * l, 0}}));
    scene.body("c" + number, cranks.back(), Inertia::rod(m, l, 2).at({0, 0, -l / 2}));
    scene.initial(angles.back(), 2, 1);
  }
  for (std::size_t i = 0; i + 1 < cranks.size(); ++i) {
    const std::string number = std::to_string(i);
    const Expression turn = scene.coordinate("b" + number, "rad") - angles[i];
    const FrameHandle coupler = scene.revolute("coupler" + number, cranks[i], axis::x, turn, {.origin = {0, 0, -l}});
    scene.body("d" + number, coupler, Inertia::rod(m, l, 1).at({0, l / 2, 0}));
    const FrameHandle end = scene.weld("end" + number, coupler, {.origin = {0, l, 0}});
    const FrameHandle tip = scene.weld("tip" + number, cranks[i + 1], {.origin = {0, 0, -l}});
    scene.loop_joint("pin" + number, {.type = JointType::revolute, .a = end, .b = tip});
  }
  scene.gravity({0, 0, Expression::quantity("-9.81", "m/s^2")});
  return scene;
}
Scene folding_once() { return folding(1); }
Scene folding_thrice() { return folding(3); }

TEST(Simulate, TellsAChangePointFromAConstraintThatJumps) {
  int ended = 0;
  for (const auto& scene : {folding_once, folding_thrice}) {
    for (const char* method : {"dp853", "radau"}) {
      for (const char* tolerance : {"1e-8", "1e-9", "1e-10"}) {
        const Outcome outcome = run(scene, {"simulate", "--to", "2", "--step", "1", "--method", method, "--tolerance", tolerance});
        if (outcome.code == 0) continue;  // steps may end on either side of it
        ++ended;
        EXPECT_NE(outcome.err.find("a change point, which this command does not pass"), std::string::npos) << outcome.err;
        EXPECT_EQ(outcome.err.find("jumps"), std::string::npos) << outcome.err;
      }
    }
  }
  EXPECT_GT(ended, 2);
}

/// A puck that slides along x and spins about z: nothing works on it, so that both momenta stay.
Scene puck() {
  Scene scene("puck");
  const Expression x = scene.coordinate("x", "m"), phi = scene.coordinate("phi", "rad");
  const FrameHandle slide = scene.prismatic("slide", scene.ground(), axis::x, x);
  scene.body("puck", scene.revolute("disc", slide, axis::z, phi),
             Inertia::general({.mass = Expression::quantity("2", "kg"), .zz = Expression::quantity("3", "kg m^2")}));
  return scene;
}

Scene puck_with_a_stop() {
  Scene scene = puck();
  scene.stop(Expression(scene.content().coordinates[0].q), std::nullopt, Expression::quantity("5", "m"));
  return scene;
}

// m x' is a force times a time, J phi' a torque times a time.
/// A gear, and two blocks on one angle of a large circle: rows of one unit, one of which is far smaller than the other.
Scene gear_and_satellites() {
  Scene scene("satellites");
  std::vector<Expression> q;
  for (const char* name : {"a", "b", "c", "d"}) {
    const bool turns = q.size() < 2;
    q.push_back(scene.coordinate(std::string("q_") + name, turns ? "rad" : "m"));
    const FrameHandle frame =
        turns ? scene.revolute(name, scene.ground(), axis::z, q.back())
              : scene.prismatic(name, scene.ground(), axis::x, q.back());
    scene.body(name, frame, Inertia::general({.mass = kilograms("1"), .xx = moment("1"), .yy = moment("1"), .zz = moment("1")}));
  }
  scene.motor("F", q[2]);
  scene.holonomic("gear", q[0] - q[1]);
  scene.holonomic("same", (q[2] - q[3]) / metres("6400000"));
  return scene;
}

TEST(Simulate, TakesASmallRowForNoChangePoint) {
  const Outcome outcome = run(gear_and_satellites, {"simulate", "--to", "2", "--step", "2", "--input", "F=1"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto [names, rows] = table(outcome.out);
  const auto column = std::find(names.begin(), names.end(), "q_d") - names.begin();
  EXPECT_NEAR(rows.back().at(static_cast<std::size_t>(column)), 1.0, 1e-9) << outcome.out;
}

TEST(Simulate, WritesTheUnitOfEachFirstIntegral) {
  const std::string units = "# Units: s, m, rad, m/s, rad/s, J, J, J, J, N s, N m s";
  const auto table_of = [&units](Scene (*scene)()) {
    const std::string out = run(scene, {"simulate", "--to", "0.1", "--initial", "x'=1"}).out;
    EXPECT_NE(out.find(units), std::string::npos) << out;
    return out;
  };
  const std::string free = table_of(puck), stopped = table_of(puck_with_a_stop);
  EXPECT_NE(free.find("first_integral_energy,first_integral_momentum_x,first_integral_momentum_phi"), std::string::npos) << free;
  // What a contact changes is called no first integral.
  const std::string others = ",mechanical_energy,without_contacts_energy,without_contacts_momentum_x,without_contacts_momentum_phi";
  EXPECT_NE(stopped.find(others), std::string::npos) << stopped;
  EXPECT_EQ(stopped.find("first_integral"), std::string::npos) << stopped;
}

/// 1 kg at 1 m/s, which a force of 2 N brakes by its sign: at rest at t = 1/2 s, x = 1/4 m, from where the sign jumps.
Scene braked() {
  Scene scene("braked");
  const Expression x = scene.coordinate("x", "m");
  const FrameHandle block = scene.prismatic("block", scene.ground(), axis::x, x);
  scene.body("block", block, Inertia::point(Expression::quantity("1", "kg")));
  scene.generalised_force("dry", x, -Expression::quantity("2", "N") * sign(rate(x)));
  scene.initial(x, 0, 1);
  return scene;
}

TEST(Simulate, EndsWhereTheRightHandSideJumps) {
  for (const std::vector<std::string>& method : {std::vector<std::string>{}, {"--method", "radau", "--tolerance", "1e-8"}}) {
    std::vector<std::string> words{"simulate", "--to", "1", "--step", "0.25"};
    words.insert(words.end(), method.begin(), method.end());
    const Outcome outcome = run(braked, words);
    EXPECT_EQ(outcome.code, 1);
    const auto rows = table(outcome.out).second;
    ASSERT_EQ(rows.size(), 3U);
    // Near the jump an error of the rate is below one step's, of the place below that over the time of a step.
    EXPECT_NEAR(rows.back()[1], 0.25, 1e-7);
    EXPECT_NE(outcome.err.find("steps stay below 1e-8 of the motion at t = 0.5"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("the right-hand side jumps here"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("; state: x = 0.25"), std::string::npos) << outcome.err;
  }
}

/// A cart that follows a speed: one that rises from 0 to 1 m/s within some ms, or one that jumps at 0.5 s.
Scene following(bool jumps) {
  Scene scene(jumps ? "jump" : "rise");
  const Expression x = scene.coordinate("x", "m"), one = Expression::quantity("1", "m/s");
  const Expression since = (scene.time() - Expression::quantity("0.5", "s")) / Expression::quantity("1", "s");
  scene.body("cart", scene.prismatic("cart", scene.ground(), axis::x, x), Inertia::point(Expression::quantity("1", "kg")));
  scene.nonholonomic("law", rate(x) - (jumps ? piecewise({{since < 0, 0 * one}}, one) : one / (1 + exp(-500 * since))));
  return scene;
}
Scene rising() { return following(false); }
Scene jumping() { return following(true); }

TEST(Simulate, FollowsASpeedThatRisesWithinAStepWhateverTheRowsAskedFor) {
  for (const char* method : {"dp853", "radau"}) {
    for (const char* step : {"0.25", "0.3", "1"}) {
      const Outcome outcome = run(rising, {"simulate", "--to", "1", "--step", step, "--method", method, "--tolerance", "1e-9"});
      EXPECT_EQ(outcome.code, 0) << outcome.err;
      // The integral of the law, by its symmetry.
      EXPECT_NEAR(table(outcome.out).second.back()[1], 0.5, 1e-7) << method << step;
    }
  }
}

TEST(Simulate, EndsWhereASpeedJumps) {
  for (const char* method : {"dp853", "radau"}) {
    for (const char* step : {"0.25", "0.3", "1"}) {
      const Outcome outcome = run(jumping, {"simulate", "--to", "1", "--step", step, "--method", method, "--tolerance", "1e-9"});
      EXPECT_EQ(outcome.code, 1);
      EXPECT_NE(outcome.err.find("the steps have become too short at t = 0.5"), std::string::npos) << outcome.err;
      EXPECT_NE(outcome.err.find("a law of time in a constraint jumps here"), std::string::npos) << outcome.err;
    }
  }
}

// The table and the picture are both written, or none of them.
TEST(Simulate, WritesTableAndPictureTogether) {
  const auto folder = std::filesystem::temp_directory_path() / "torsor_simulate_together_test";
  std::filesystem::create_directories(folder);
  const auto simulated = [&](const std::string& table, const std::string& picture) {
    return run(pendulum, {"simulate", "--to", "0.1", "-o", table, "--plot", picture, "theta"});
  };
  const std::string one = (folder / "x.svg").string(), again = (folder / "." / "x.svg").string();
  EXPECT_EQ(simulated(one, one).code, 2);
  EXPECT_EQ(simulated(again, one).code, 2);
  EXPECT_EQ(simulated((folder / "none" / "x.csv").string(), one).code, 3);
  EXPECT_TRUE(std::filesystem::is_empty(folder));
  EXPECT_EQ(simulated((folder / "x.csv").string(), one).code, 0);
  EXPECT_TRUE(std::filesystem::exists(one) && std::filesystem::exists(folder / "x.csv"));
  std::filesystem::remove_all(folder);
}

TEST(Simulate, SaysThatConstraintsCannotBeClosed) {
  const Outcome outcome = run(impossible, {"simulate"});
  EXPECT_NE(outcome.code, 0);
  EXPECT_EQ(outcome.out, "");
}

}  // namespace
}  // namespace torsor::simulate_command_test
