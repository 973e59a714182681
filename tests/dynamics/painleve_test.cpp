// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/theorems/painleve.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "torsor/generator/expression/piecewise.hpp"
#include "torsor/generator/verification/extrapolation.hpp"
#include "tests/dynamics/named_state.hpp"
#include "tests/scenes/pendulums.hpp"

namespace torsor::painleve_test {
namespace {

using namespace testing_symbols;
using namespace testing_mechanisms;
using namespace literals;

std::vector<std::string> names(const PainleveReport& report) {
  std::vector<std::string> all;
  for (const FirstIntegral& integral : report.first_integrals) all.push_back(integral.name);
  return all;
}

PainleveReport report_of(const Scene& scene) { return painleve(Equations(scene)); }
// The values of a report live in its equations' program; this one is for names and conditions only.

/// Integrates the forward dynamics in CLN and returns how much each first integral moves over 2 s, relative to its
/// size.
std::vector<double> drift(const Scene& scene, const std::vector<Real>& start) {
  const Equations equations(scene);
  const PainleveReport report = painleve(equations);
  const Model& model = equations.model();
  const auto n = static_cast<std::size_t>(model.unknown_count());
  const std::vector<Value> accelerations = equations.forward().accelerations;
  const auto values = [&](const Real& t, const std::vector<Real>& y) -> Evaluator<Real>::SymbolValue {
    return [&, t](const SymbolPointer& symbol) {
      if (symbol->kind == SymbolKind::pi) return Real::pi();
      if (symbol->kind == SymbolKind::time) return t;
      for (std::size_t i = 0; i < n; ++i) {
        if (symbol == model.coordinates()[i].q) return y[i];
        if (symbol == model.coordinates()[i].v) return y[n + i];
      }
      return Real(0);
    };
  };
  Evaluator<Real> evaluate(equations.program(), {});
  const auto f = [&](const Real& t, const std::vector<Real>& y) {
    evaluate.move_to(values(t, y));
    std::vector<Real> slope(y.begin() + static_cast<std::ptrdiff_t>(n), y.end());
    for (const Value& a : accelerations) slope.push_back(evaluate(a));
    return slope;
  };
  const std::vector<std::vector<Real>> end =
      integrate({f, start}, {Real(1), Real(2)}, {.columns = 12, .tolerance_digits = 45, .work_digits = 65});
  std::vector<double> drifts;
  for (const FirstIntegral& integral : report.first_integrals) {
    evaluate.move_to(values(Real(0), start));
    const Real before = evaluate(integral.value);
    double worst = 0;
    for (std::size_t k = 0; k < end.size(); ++k) {
      evaluate.move_to(values(Real(static_cast<int>(k) + 1), end[k]));
      worst = std::max(worst, relative_difference(evaluate(integral.value), before));
    }
    drifts.push_back(worst);
  }
  return drifts;
}

TEST(FirstIntegrals, OfAPendulumAreItsEnergyAlone) {
  EXPECT_EQ(names(report_of(pendulum())), std::vector<std::string>{"energy"});
  EXPECT_TRUE(report_of(pendulum()).failing_conditions.empty());
}

/// Spherical pendulum on a turntable with springs: energy and one momentum.
Scene spherical_pendulum() {
  Scene scene("spherical_pendulum");
  const Expression psi = scene.coordinate("psi", "rad");
  const Expression theta = scene.coordinate("theta", "rad");
  const FrameHandle turn = scene.revolute("turn", scene.ground(), axis::z, psi);
  const FrameHandle arm = scene.revolute("arm", turn, axis::x, theta, {.origin = {0, metres("0.3"), 0}});
  scene.body("table", turn, Inertia::disk(kilograms("3"), metres("0.5"), 2));
  scene.body("bob", arm, Inertia::solid_sphere(kilograms("2"), metres("0.1")).at({0, 0, metres("-1")}));
  scene.spring("spring", theta, Expression::quantity("4", "N m"), 0.2_r);
  scene.gravity({0, 0, Expression::quantity("-9.81", "m/s^2")});
  return scene;
}

TEST(FirstIntegrals, StayConstantAlongAnIntegrationInFiftyDigits) {
  const WorkingDigits precision(65);
  EXPECT_EQ(names(report_of(spherical_pendulum())), (std::vector<std::string>{"energy", "momentum_psi"}));
  const std::vector<Real> start{Real(0), rational(4, 5), Real(2), rational(-1, 2)};
  for (const double change : drift(spherical_pendulum(), start)) EXPECT_LT(change, 1e-42);  // 45 digits a step
}

/// A bead on a rod that turns at constant speed: the energy changes, T2 − T0 − U does not.
Scene bead(bool by_law) {
  Scene scene("bead");
  const Expression r = scene.coordinate("r", "m");
  const Expression angle = Expression::quantity("2", "rad/s") * scene.time();
  Expression turned = angle;
  if (by_law) {
    turned = scene.coordinate("phi", "rad");
    scene.drive(turned, angle);
  }
  const FrameHandle rod = scene.revolute("rod", scene.ground(), axis::z, turned);
  const FrameHandle slide = scene.prismatic("slide", rod, axis::x, r);
  scene.body("bead", slide, Inertia::point(kilograms("1.5")));
  scene.spring("spring", r, Expression::quantity("9", "N/m"), metres("0.4"));
  return scene;
}

TEST(FirstIntegrals, OfABeadOnARotatingRodAreThoseOfPainleveWhicheverWayTheRotationIsWritten) {
  const WorkingDigits precision(65);
  for (const bool by_law : {true, false}) {
    EXPECT_EQ(names(report_of(bead(by_law))), std::vector<std::string>{"painleve"});
    const std::vector<double> change = drift(bead(by_law), {rational(1, 2), rational(1, 3)});
    ASSERT_EQ(change.size(), 1U);
    EXPECT_LT(change[0], 1e-42);
  }
  // T2 − T0 = ½ m (ṙ² − ω² r²).
  const Equations equations(bead(true));
  NamedState state(equations, {{"r", Real(2)}, {"r'", Real(3)}});
  EXPECT_EQ(state.in_double(painleve(equations).t2_minus_t0), 0.5 * 1.5 * (9 - 4 * 4));
}

/// "theta: T depends on it, U depends on it"
std::vector<std::string> missing(const Scene& scene) {
  const Equations equations(scene);
  std::vector<std::string> all;
  for (const MissingMomentum& each : missing_momenta(equations, painleve(equations))) {
    std::string text = each.coordinate + ":";
    for (const std::string& reason : each.reasons) text += " " + reason + ".";
    all.push_back(text);
  }
  return all;
}

// Walls 50 m and 1 km away, on either side: neither acts at states of numbers around one.
TEST(MissingMomenta, AreHeldByWallsFarAway) {
  Scene walls("walls");
  const Expression x = walls.coordinate("x", "m"), y = walls.coordinate("y", "m");
  const FrameHandle along = walls.prismatic("along", walls.ground(), axis::x, x);
  walls.body("ball", walls.prismatic("across", along, axis::y, y), Inertia::point(kilograms("1")));
  const Expression k = walls.parameter("k", "N/m", Number(3));
  walls.generalised_force("near", x, -k * max(x - metres("50"), 0));
  walls.generalised_force("far", y, k * max(-y - metres("1000"), 0));
  EXPECT_EQ(missing(walls), (std::vector<std::string>{"x: 'near' acts along it.", "y: 'far' acts along it."}));
}

TEST(MissingMomenta, SayWhatStandsAgainstThem) {
  using Texts = std::vector<std::string>;
  EXPECT_EQ(missing(spherical_pendulum()), Texts{"theta: T depends on it. U depends on it."});
  EXPECT_EQ(missing(bead(true)), Texts{"r: T depends on it. U depends on it."});
  Scene pushed = pendulum();
  const Expression theta = pushed.content().coordinates[0].q;
  pushed.damper("friction", theta, Expression::quantity("1", "N m s"));
  pushed.motor("torque", theta);
  pushed.nonholonomic("imposed", rate(theta) - Expression::quantity("1", "rad/s"));
  EXPECT_EQ(missing(pushed), Texts{"theta: U depends on it. 'friction', 'torque', 'imposed' act along it."});
  // Euler's equations of a free body of three different moments: only its weight, along y, holds the centre back.
  Scene body("body");
  const Expression x = body.coordinate("x", "m"), y = body.coordinate("y", "m"), z = body.coordinate("z", "m");
  body.body("body", body.free("body", body.ground(), {x, y, z}, body.attitude("turn")),
            Inertia::general({.mass = kilograms("1"), .xx = moment("3"), .yy = moment("4"), .zz = moment("5")}));
  body.gravity({0, Expression::quantity("-9.81", "m/s^2"), 0});
  EXPECT_EQ(missing(body),
            (Texts{"y: U depends on it.", "turn_omega_x: its axes turn with the body.",
                   "turn_omega_y: its axes turn with the body.", "turn_omega_z: its axes turn with the body."}));
}

std::vector<std::string> failing(const Scene& scene) { return report_of(scene).failing_conditions; }

TEST(FailingConditions, TellForcesThatDeriveFromSomethingFromThoseThatDoNot) {
  Scene held = pendulum();
  const SymbolPointer theta = held.content().coordinates[0].q;
  held.generalised_force("spiral", theta, Expression::quantity("-2", "N m") * sin(theta));
  EXPECT_EQ(failing(held), std::vector<std::string>{"'spiral' has a force function that is not stated"});
  held.generalised_force("oil", theta, Expression::quantity("-2", "N m s") * rate(theta));
  EXPECT_EQ(failing(held),
            (std::vector<std::string>{"'oil' has no force function", "'spiral' has a force function that is not stated"}));
  // Each of two forces has none, both together have k x y.
  Scene crossed("crossed");
  const Expression x = crossed.coordinate("x", "m"), y = crossed.coordinate("y", "m"), k = Expression::quantity("3", "N/m");
  crossed.body("bead", crossed.prismatic("bead", crossed.prismatic("slide", "ground", axis::x, x), axis::y, y),
               Inertia::point(Expression::quantity("1", "kg")));
  crossed.generalised_force("along_x", x, k * y);
  EXPECT_EQ(failing(crossed), std::vector<std::string>{"'along_x' has no force function"});
  crossed.generalised_force("along_y", y, k * x);
  EXPECT_EQ(failing(crossed), std::vector<std::string>{"'along_x', 'along_y' have force functions that are not stated"});
  Scene stated = pendulum();
  stated.force_function("spiral", Expression::quantity("2", "N m") * cos(stated.content().coordinates[0].q));
  EXPECT_TRUE(failing(stated).empty());
}

TEST(FailingConditions, SayWhichConditionFails) {
  Scene damped = pendulum();
  const SymbolPointer theta = damped.content().coordinates[0].q;
  damped.damper("friction", theta, Expression::quantity("1", "N m s"));
  EXPECT_EQ(failing(damped), std::vector<std::string>{"'friction' has no force function"});
  EXPECT_TRUE(names(report_of(damped)).empty());
  damped.motor("torque", theta);
  EXPECT_EQ(failing(damped), std::vector<std::string>{"'friction', 'torque' have no force function"});

  Scene accelerated("accelerated");
  const Expression r = accelerated.coordinate("r", "m");
  const Expression t = accelerated.time();
  const FrameHandle rod =
      accelerated.revolute("rod", accelerated.ground(), axis::z, Expression::quantity("1", "rad/s^2") * t * t);
  accelerated.body("bead", accelerated.prismatic("slide", rod, axis::x, r), Inertia::point(kilograms("1")));
  EXPECT_EQ(failing(accelerated), std::vector<std::string>{"T depends on time explicitly"});
  accelerated.gravity({0, Expression::quantity("-9.81", "m/s^2"), 0});
  EXPECT_EQ(failing(accelerated), (std::vector<std::string>{"T depends on time explicitly",
                                                            "the force function U depends on time explicitly"}));

  Scene pushed = pendulum();
  pushed.nonholonomic("imposed",
                      rate(Expression(pushed.content().coordinates[0].q)) - Expression::quantity("1", "rad/s"));
  EXPECT_EQ(failing(pushed), std::vector<std::string>{"constraint 'imposed' imposes a velocity (b is not zero)"});
}

/// A point in the plane x, y that a force B v turned by a right angle bends: v stays what it is.
Scene bent_path() {
  Scene scene("bent_path");
  const Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m");
  const Expression B = scene.run_time_parameter("B", "kg/s", 1);
  const FrameHandle point = scene.prismatic("point", scene.prismatic("slide", scene.ground(), axis::x, x), axis::y, y);
  scene.body("point", point, Inertia::point(kilograms("1")));
  scene.point("P", point, {0, 0, 0});
  scene.force(
      "turns",
      {.body = point, .point = scene.point("P"), .components = {B * rate(y), -B * rate(x), 0}, .axes = scene.ground()});
  return scene;
}

TEST(FirstIntegrals, IncludeTheEnergyWhereActionsWithoutAForceFunctionDoNoWork) {
  const WorkingDigits precision(65);
  EXPECT_TRUE(failing(bent_path()).empty());
  EXPECT_EQ(names(report_of(bent_path())), std::vector<std::string>{"energy"});

  // Two forces that are opposite at every state work, and their sum does not.
  Scene opposed = bent_path();
  const Expression x(opposed.content().coordinates[0].q), y(opposed.content().coordinates[1].q);
  const Expression b = Expression::quantity("3", "kg/s");
  opposed.damper("brake", x, b);
  EXPECT_EQ(failing(opposed), std::vector<std::string>{"'brake' has no force function"});
  opposed.generalised_force("drive", x, b * rate(x));
  EXPECT_TRUE(failing(opposed).empty());
  // What works is named alone.
  opposed.damper("oil", y, b);
  EXPECT_EQ(failing(opposed), std::vector<std::string>{"'brake', 'drive', 'oil' have no force function"});

  // A motor on what a law of time moves gives no unknown anything.
  Scene driven = bead(true);
  driven.motor("drive", Expression(driven.content().coordinates[1].q));
  EXPECT_EQ(names(report_of(driven)), std::vector<std::string>{"painleve"});

  // Contact friction along what never slips.
  Scene across("across");
  const Expression along = across.coordinate("along", "m"), height = across.coordinate("height", "m");
  const FrameHandle block =
      across.prismatic("block", across.prismatic("way", across.ground(), axis::x, along), axis::z, height);
  across.body("block", block, Inertia::point(kilograms("2")));
  across.point("I", block, {0, 0, 0});
  const ConstraintHandle floor = across.holonomic("floor", height);
  across.sliding_friction(
      "aside", floor,
      {.coefficient = 0.5_r, .body = block, .point = across.point("I"), .direction = axis::y, .axes = across.ground()});
  EXPECT_TRUE(failing(across).empty());
  across.sliding_friction(
      "rub", floor,
      {.coefficient = 0.5_r, .body = block, .point = across.point("I"), .direction = axis::x, .axes = across.ground()});
  EXPECT_EQ(failing(across), (std::vector<std::string>{"'aside', 'rub' have no force function"}));
}

TEST(CyclicCoordinate, IsNoneWhenSomethingWorksOnIt) {
  const auto with = [](const auto& add) {
    Scene scene = spherical_pendulum();
    add(scene, Expression(scene.content().coordinates[0].q), Expression(scene.content().coordinates[1].q));
    const std::vector<std::string> all = names(report_of(scene));
    return std::find(all.begin(), all.end(), "momentum_psi") != all.end();
  };
  EXPECT_TRUE(with([](Scene&, const Expression&, const Expression&) {}));
  EXPECT_TRUE(with([](Scene& s, const Expression&, const Expression& theta) { s.motor("u", theta); }));
  EXPECT_FALSE(with([](Scene& s, const Expression& psi, const Expression&) { s.motor("u", psi); }));
  EXPECT_FALSE(with([](Scene& s, const Expression& psi, const Expression&) {
    s.spring("w", psi, Expression::quantity("1", "N m"));
  }));
  EXPECT_FALSE(with([](Scene& s, const Expression& psi, const Expression&) {
    s.damper("w", psi, Expression::quantity("1", "N m s"));
  }));
  EXPECT_FALSE(with([](Scene& s, const Expression& psi, const Expression&) {
    s.force_function("side", Expression::quantity("1", "J") * cos(psi));
  }));
  EXPECT_FALSE(
      with([](Scene& s, const Expression& psi, const Expression& theta) { s.holonomic("tied", psi - theta); }));
}

TEST(CyclicCoordinate, HasItsMomentumAsFirstIntegral) {
  const Equations equations(spherical_pendulum());
  const PainleveReport report = painleve(equations);
  NamedState state(equations, {{"psi'", Real(3)}, {"theta'", Real(7)}, {"theta", Real(0)}});
  // At θ = 0: J = ½ 3 0.25 + 2 0.3² + 2/5 2 0.01 about z, times ψ̇.
  EXPECT_NEAR(state.in_double(report.first_integrals[1].value), (0.375 + 0.18 + 0.008) * 3, 1e-14);
}

/// A block on a spring whose stiffness is `factor` of 1 N/m.
std::vector<std::string> against_energy(const std::function<Expression(Scene&, const Expression& x)>& factor) {
  Scene scene("by_pieces");
  const Expression x = scene.coordinate("x", "m"), phi = scene.coordinate("phi", "rad");
  scene.drive(phi, scene.time() * Expression::quantity("2", "1/s"));
  scene.body("block", scene.prismatic("block", scene.ground(), axis::x, x), Inertia::point(Expression::quantity("1", "kg")));
  scene.weld("sign", scene.revolute("dial", scene.ground(), axis::x, phi), {});
  scene.spring("spring", x, Expression::quantity("1", "N/m") * factor(scene, x));
  return painleve(Equations(scene)).failing_conditions;
}

// What changes in steps has no slope, and U changes with it: in time, with what is driven, and where the block passes.
TEST(Painleve, KeepsNoEnergyWhereAForceFunctionJumps) {
  const std::vector<std::string> jump{"the force function U jumps"}, none;
  const Expression one(1), two(2);
  EXPECT_EQ(against_energy([&](Scene& s, const Expression&) {
              return piecewise({{s.time() < Expression::quantity("5", "s"), one}}, two);
            }), jump);
  EXPECT_EQ(against_energy([&](Scene& s, const Expression&) {
              const Expression phi(s.content().coordinates[1].q);
              return piecewise({{phi < Expression(3), one}, {phi < Expression(4), two}}, one);
            }), jump);
  const Expression metre = Expression::quantity("1", "m");
  EXPECT_EQ(against_energy([&](Scene&, const Expression& x) { return piecewise({{x < metre, one}}, two); }), jump);
  // Of any size, and in two of what moves.
  for (const char* seconds : {"0.005", "0.02", "2000", "1000000"}) {
    EXPECT_EQ(against_energy([&](Scene& s, const Expression&) {
                return piecewise({{s.time() < Expression::quantity(seconds, "s"), one}}, two);
              }), jump) << seconds;
  }
  EXPECT_EQ(against_energy([&](Scene&, const Expression& x) { return piecewise({{x < 100000 * metre, one}}, two); }), jump);
  EXPECT_EQ(against_energy([&](Scene& s, const Expression& x) {
              const Expression phi(s.content().coordinates[1].q);
              return piecewise({{x < phi * metre / 1000, one}}, two);
            }), jump);
  // A spring that pushes on one side alone, and one that is as stiff on the other.
  EXPECT_EQ(against_energy([&](Scene&, const Expression& x) { return piecewise({{x < 0 * metre, one}}, Expression(0)); }), none);
  EXPECT_EQ(against_energy([&](Scene&, const Expression& x) { return abs(x) / metre; }), none);
}

// An atom of 1e-26 kg at a step of 0.6 eV: whatever the unit, a jump is one beside what U is around it.
TEST(Painleve, SeesJumpsOfAnySize) {
  const auto failing = [](const std::function<Expression(const Expression& x, const Expression& place)>& potential) {
    Scene scene("atom");
    const Expression x = scene.coordinate("x", "m");
    scene.body("atom", scene.prismatic("slide", scene.ground(), axis::x, x), Inertia::point(Expression::quantity("1e-26", "kg")));
    scene.force_function("step", potential(x, Expression::quantity("1e-9", "m")));
    return painleve(Equations(scene)).failing_conditions;
  };
  const Expression k = Expression::quantity("1e-7", "N/m");
  for (const char* joules : {"1e-19", "1e-11", "1"}) {
    EXPECT_EQ(failing([&](const Expression& x, const Expression& place) {
                return piecewise({{x < place, -k * x * x}}, -k * x * x - Expression::quantity(joules, "J"));
              }),
              std::vector<std::string>{"the force function U jumps"})
        << joules;
  }
  const std::vector<std::string> none;
  EXPECT_EQ(failing([&](const Expression& x, const Expression& place) { return -k * pow(max(x - place, 0 * place), 2); }), none);
  EXPECT_EQ(failing([&](const Expression& x, const Expression& place) {
              return -k * place * sqrt(place) * sqrt(max(x - place, 0 * place));
            }),
            none);
  EXPECT_EQ(failing([&](const Expression& x, const Expression& place) { return -k * place * abs(x - place / 1000); }), none);
}

}  // namespace
}  // namespace torsor::painleve_test
