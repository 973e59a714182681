// SPDX-License-Identifier: GPL-3.0-or-later
// Every joint twice: as coordinates of a tree, and as constraints on a free body. Both must move alike.
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/dynamics/equations/equations.hpp"
#include "torsor/generator/dynamics/equations/validation.hpp"
#include "torsor/generator/mechanics/scene.hpp"
#include "torsor/generator/program/derivative.hpp"
#include "torsor/generator/program/evaluation.hpp"
#include "torsor/generator/verification/extrapolation.hpp"

namespace torsor::joint_closures_test {
namespace {

using namespace literals;

constexpr int digits = 60;
using Numbers = std::array<Real, 3>;

Number pitch_value() { return Number::rational(3, 17); }
Expression pitch() { return Expression::quantity(pitch_value(), units::metre); }

Placement placement() {
  const auto metres = [](int numerator) { return Expression::quantity(Number::rational(numerator, 7), units::metre); };
  return {{metres(2), metres(-3), metres(5)}, Rotation::about(0, 5) * Rotation::about(2, 3)};
}

void add_body(Scene& scene) {
  const auto kg = [](int n) { return Expression::quantity(Number::rational(n, 11), units::kilogram_metre_squared); };
  const auto metres = [](int numerator) { return Expression::quantity(Number::rational(numerator, 9), units::metre); };
  const Expression mass = Expression::quantity(Number::rational(13, 10), units::kilogram);
  scene.body(
      "body", "b",
      Inertia::general({.mass = mass, .xx = kg(20), .yy = kg(23), .zz = kg(29), .xy = kg(1), .xz = kg(-2), .yz = kg(3)})
          .at({metres(1), metres(-2), metres(4)}));
  const auto gravity = [](int n) { return Expression::quantity(Number::rational(n, 3), units::metre_per_second_squared); };
  scene.gravity({gravity(2), gravity(-5), gravity(-27)});
}

/// What the joint stands on: the ground, or a heavy body that turns about a skew axis and feels the joint's reaction.
FrameHandle base(Scene& s, bool moving) {
  if (!moving) return s.ground();
  const Triple skew{Expression(Number::rational(2, 3)), Expression(Number::rational(-1, 3)), Expression(Number::rational(2, 3))};
  const Expression c = s.coordinate("swing", "rad");
  const Placement at{{Expression::quantity("0.5", "m"), Expression::quantity("-0.25", "m"), 0}, Rotation::about(1, 2)};
  const FrameHandle carrier = s.revolute("carrier", s.ground(), skew, c, at);
  const auto edge = [](const char* value) { return Expression::quantity(value, "m"); };
  const Inertia box = Inertia::box(Expression::quantity("1.7", "kg"), edge("0.5"), edge("0.75"), edge("1.25"));
  s.body("carrier", carrier, box.at({edge("0.25"), edge("0.5"), edge("-0.75")}));
  return carrier;
}

Scene tree(JointType type, bool moving) {
  Scene s("tree");
  const FrameHandle ground = base(s, moving);
  const Placement at = placement();
  const auto length = [&s](const char* name) { return s.coordinate(name, "m"); };
  const auto angle = [&s](const char* name) { return s.coordinate(name, "rad"); };
  switch (type) {
    case JointType::revolute: s.revolute("b", ground, axis::x, angle("a"), at); break;
    case JointType::prismatic: s.prismatic("b", ground, axis::x, length("x"), at); break;
    case JointType::helical:
      s.helical("b", ground, {.axis = axis::x, .angle = angle("a"), .pitch = pitch()}, at);
      break;
    case JointType::cylindrical: {
      const Expression x = length("x");
      s.cylindrical("b", ground, {.axis = axis::x, .displacement = x, .angle = angle("a")}, at);
      break;
    }
    case JointType::universal: {
      const Expression a = angle("a");
      s.universal("b", ground, {.first = axis::x, .first_angle = a, .second = axis::y, .second_angle = angle("b")}, at);
      break;
    }
    case JointType::spherical: {
      const Expression a = angle("a");
      const Expression b = angle("b");
      s.spherical("b", ground, {.sequence = AngleSequence{{2, 1, 0}}, .angles = {a, b, angle("c")}}, at);
      break;
    }
    case JointType::planar: {
      const Expression x = length("x");
      const Expression y = length("y");
      s.planar("b", ground, {.x = x, .y = y, .angle = angle("a")}, at);
      break;
    }
    case JointType::line_contact: {
      const Expression x = length("x");
      const Expression y = length("y");
      const Expression a = angle("a");
      s.line_contact("b", ground, {.x = x, .y = y, .yaw = a, .roll = angle("b")}, at);
      break;
    }
    case JointType::sphere_in_cylinder: {
      const Expression x = length("x");
      s.sphere_in_cylinder("b", ground, {.axis = axis::x, .displacement = x, .turn = s.attitude("turn")}, at);
      break;
    }
    case JointType::point_contact: {
      const Expression x = length("x");
      const Expression y = length("y");
      const Expression a = angle("a");
      const Expression b = angle("b");
      s.point_contact("b", ground, {.x = x, .y = y, .turn = PlaneRotations{AngleSequence::cardan, {a, b, angle("c")}}},
                      at);
      break;
    }
    case JointType::weld:
    case JointType::free: break;
  }
  add_body(s);
  return s;
}

Scene closed(JointType type, bool moving) {
  Scene s("closed");
  const FrameHandle carrier = base(s, moving);
  const Expression x = s.coordinate("x", "m");
  const Expression y = s.coordinate("y", "m");
  const Expression z = s.coordinate("z", "m");
  s.free("b", s.ground(), {x, y, z}, s.attitude("turn"));
  s.weld("a", carrier, placement());
  s.loop_joint("joint",
               {.type = type, .a = "a", .b = "b", .pitch = type == JointType::helical ? pitch() : Expression(0)});
  add_body(s);
  return s;
}

/// Symbols by name.
class State {
 public:
  void set(const std::string& name, const Real& value) { values_.insert_or_assign(name, value); }
  const Real& operator[](const std::string& name) const { return values_.at(name); }
  Evaluator<Real>::SymbolValue reader() const {
    return [values = values_](const SymbolPointer& symbol) {
      if (symbol->kind == SymbolKind::pi) return Real::pi();
      return values.at(symbol->name);
    };
  }

 private:
  std::map<std::string, Real> values_;
};

Numbers evaluate(Evaluator<Real>& at, const Vector& v) { return {at(v[0]), at(v[1]), at(v[2])}; }

/// A unit quaternion of the rotation whose columns are given, by its largest component.
std::array<Real, 4> quaternion(const std::array<Numbers, 3>& column) {
  const auto r = [&](std::size_t i, std::size_t j) { return column[j][i]; };
  const Real one(1);
  const std::array<Real, 4> squares{one + r(0, 0) + r(1, 1) + r(2, 2), one + r(0, 0) - r(1, 1) - r(2, 2),
                                    one - r(0, 0) + r(1, 1) - r(2, 2), one - r(0, 0) - r(1, 1) + r(2, 2)};
  std::size_t k = 0;
  for (std::size_t i = 1; i < 4; ++i) {
    if (squares[i] > squares[k]) k = i;
  }
  const Real big = sqrt(squares[k]);
  const Real wx = r(2, 1) - r(1, 2), wy = r(0, 2) - r(2, 0), wz = r(1, 0) - r(0, 1);
  const Real xy = r(0, 1) + r(1, 0), yz = r(1, 2) + r(2, 1), zx = r(2, 0) + r(0, 2);
  const std::array<std::array<Real, 4>, 4> products{{{big * big, wx, wy, wz}, {wx, big * big, xy, zx}, {wy, xy, big * big, yz}, {wz, zx, yz, big * big}}};
  std::array<Real, 4> e;
  for (std::size_t i = 0; i < 4; ++i) e[i] = products[k][i] / (Real(2) * big);
  return e;
}

/// Positions, then velocities.
std::vector<std::string> names_of_state(const Model& model) {
  std::vector<std::string> names;
  for (const SymbolPointer& q : model.positions()) names.push_back(q->name);
  for (int i = 0; i < model.unknown_count(); ++i) names.push_back(model.coordinates()[static_cast<std::size_t>(i)].v->name);
  return names;
}

/// The state a while later, by the forward dynamics of the equations.
State moved(const Equations& equations, const State& start, const Real& time) {
  const Model& model = equations.model();
  Program& program = equations.program();
  const std::vector<std::string> names = names_of_state(model);
  std::vector<Real> y;
  for (const std::string& name : names) y.push_back(start[name]);
  std::vector<Value> rates;
  for (const SymbolPointer& q : model.positions()) rates.push_back(time_derivative(program.symbol(q)));
  const std::vector<Value>& accelerations = equations.forward().accelerations;
  rates.insert(rates.end(), accelerations.begin(), accelerations.end());
  Evaluator<Real> at(program, {});
  const auto f = [&](const Real&, const std::vector<Real>& now) {
    State here;
    for (std::size_t i = 0; i < names.size(); ++i) here.set(names[i], now[i]);
    at.move_to(here.reader());
    return at(rates);
  };
  ExtrapolationOptions options;
  options.columns = 10;
  options.tolerance_digits = 25;
  options.work_digits = 40;
  const std::vector<Real> end = integrate({f, y}, {time}, options).front();
  State result;
  for (std::size_t i = 0; i < names.size(); ++i) result.set(names[i], end[i]);
  return result;
}

/// Pose, twist and accelerations of the body's frame at a state of the tree, in the ground's axes but for ω and ω'.
struct Motion {
  std::array<Numbers, 3> columns;
  Numbers position, velocity, omega, linear, angular;

  Motion(const Equations& equations, State state) {
    const Model& model = equations.model();
    Program& program = equations.program();
    Evaluator<Real> still(program, state.reader());
    const std::vector<Real> rates = still(equations.forward().accelerations);
    for (std::size_t i = 0; i < rates.size(); ++i) state.set(model.coordinates()[i].a->name, rates[i]);
    Evaluator<Real> here(program, state.reader());
    const int link = model.place("b", "test").link;
    for (int i = 0; i < 3; ++i) {
      Vector axis;
      axis[i] = program.number(Number(1));
      columns[static_cast<std::size_t>(i)] = evaluate(here, model.express(axis, link, 0));
    }
    position = evaluate(here, model.locate(Vector(), link, 0));
    const Twist twist = twists(model)[static_cast<std::size_t>(link)];
    velocity = evaluate(here, model.express(twist.linear, link, 0));
    omega = evaluate(here, twist.angular);
    const std::vector<Axes> axes(model.links().size(), Axes::own);
    std::vector<Acceleration> all = accelerations(model, AccelerationInput::symbols, axes);
    const Acceleration& of_link = all[static_cast<std::size_t>(link)];
    linear = evaluate(here, model.express(of_link.linear(), link, 0));
    if (model.length_unit()) {  // accelerations are over it
      for (Real& component : linear) component *= Real(*model.length_unit(), digits);
    }
    const Numbers gravity = evaluate(here, lower(program, model.scene().gravity));
    for (std::size_t i = 0; i < 3; ++i) linear[i] += gravity[i];
    angular = evaluate(here, of_link.angular());
  }
};

class EveryJoint : public ::testing::TestWithParam<std::tuple<JointType, bool>> {
 protected:
  const WorkingDigits precision{digits};
  const JointType type = std::get<0>(GetParam());
  const bool moving = std::get<1>(GetParam());

  /// Any state of the tree; angles of some tenths keep clear of singular sequences.
  State start(const Model& model) const {
    State state;
    int k = 0;
    for (const SymbolPointer& q : model.positions()) state.set(q->name, Real(Number::rational(2 + 3 * k++, 11), digits));
    for (const auto& attitude : model.scene().attitudes) {
      const std::array<int, 4> e{1, 3, -5, 1};  // norm 6
      for (std::size_t i = 0; i < 4; ++i) state.set(attitude.symbols->e[i]->name, Real(Number::rational(e[i], 6), digits));
    }
    for (int i = 0; i < model.unknown_count(); ++i) {
      state.set(model.coordinates()[static_cast<std::size_t>(i)].v->name, Real(Number::rational(7 - 4 * i, 5), digits));
    }
    return state;
  }

  /// The same state of the free body; the carrier's is the tree's own.
  State of_free_body(const Motion& motion, const State& tree) const {
    State free;
    const std::array<Real, 4> e = quaternion(motion.columns);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string letter(1, "xyz"[i]);
      free.set(letter, motion.position[i]);
      free.set(letter + "'", motion.velocity[i]);
      free.set("turn_omega_" + letter, motion.omega[i]);
      free.set("turn_" + letter, e[i + 1]);
    }
    free.set("turn_w", e[0]);
    if (moving) {
      free.set("swing", tree["swing"]);
      free.set("swing'", tree["swing'"]);
    }
    return free;
  }
};

TEST_P(EveryJoint, HasAsManyFreedomsInTheTreeAsTheTableSays) {
  const Scene scene = tree(type, moving);
  EXPECT_EQ(Equations(scene).model().unknown_count(), freedom_count(type) + (moving ? 1 : 0));
  EXPECT_EQ(closed(type, moving).content().constraints.size(), static_cast<std::size_t>(6 - freedom_count(type)));
  EXPECT_NO_THROW(validate(scene));
}

TEST_P(EveryJoint, MovesTheSameAsCoordinatesAndAsConstraints) {
  const Equations one(tree(type, moving));
  const State state = start(one.model());
  const Motion motion(one, state);

  const Equations two(closed(type, moving));
  const State free = of_free_body(motion, state);
  Evaluator<Real> there(two.program(), free.reader());
  for (const ConstraintRow& row : two.constraints()) {
    EXPECT_LT(abs(there(row.value)).to_double(), 1e-50) << row.name;
    EXPECT_LT(abs(there(row.rate)).to_double(), 1e-50) << row.name;
  }
  const std::vector<Real> found = there(two.forward().accelerations);
  const std::size_t first = moving ? 1 : 0;
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_LT(abs(found[first + i] - motion.linear[i]).to_double(), 1e-45) << "acceleration " << i;
    EXPECT_LT(abs(found[first + i + 3] - motion.angular[i]).to_double(), 1e-45) << "angular acceleration " << i;
  }
  if (moving) {
    Evaluator<Real> here(one.program(), state.reader());
    EXPECT_LT(abs(found[0] - here(one.forward().accelerations[0])).to_double(), 1e-45) << "acceleration of the carrier";
  }
}

// Both are integrated with local errors below 1e-25; over a few steps of a motion of order one 1e-20 remain.
TEST_P(EveryJoint, IsAtTheSamePlaceAWhileLaterAsCoordinatesAndAsConstraints) {
  const Equations one(tree(type, moving));
  const Equations two(closed(type, moving));
  const State state = start(one.model());
  const Real time(Number::rational(1, 8), digits);
  const State end = moved(one, state, time);
  const State free_end = moved(two, of_free_body(Motion(one, state), state), time);
  const State wanted = of_free_body(Motion(one, end), end);
  // e and -e are one orientation.
  Real same(0);
  for (const char* e : {"turn_w", "turn_x", "turn_y", "turn_z"}) same += wanted[e] * free_end[e];
  for (const std::string& name : names_of_state(two.model())) {
    const bool turned = name == "turn_w" || name == "turn_x" || name == "turn_y" || name == "turn_z";
    const Real found = turned && same < Real(0) ? -free_end[name] : free_end[name];
    EXPECT_LT(abs(found - wanted[name]).to_double(), 1e-20) << name;
  }
}

std::string name_of(const ::testing::TestParamInfo<std::tuple<JointType, bool>>& info) {
  std::string name(to_string(std::get<0>(info.param)));
  for (char& c : name) {
    if (c == ' ') c = '_';
  }
  return name + (std::get<1>(info.param) ? "_on_a_moving_body" : "");
}

INSTANTIATE_TEST_SUITE_P(Table, EveryJoint,
                         ::testing::Combine(::testing::Values(JointType::revolute, JointType::prismatic,
                                                              JointType::helical, JointType::cylindrical,
                                                              JointType::universal, JointType::spherical,
                                                              JointType::planar, JointType::line_contact,
                                                              JointType::sphere_in_cylinder, JointType::point_contact),
                                            ::testing::Bool()),
                         name_of);

// Multipliers of a closing joint are components of the force and of the moment on b: a welded body at rest hangs on the
// opposite of its weight and of its moment about the joint.
TEST(ClosingJoint, HasMultipliersThatAreComponentsOfItsWrench) {
  const WorkingDigits precision(digits);
  Scene s("hung");
  const Expression x = s.coordinate("x", "m");
  const Expression y = s.coordinate("y", "m");
  const Expression z = s.coordinate("z", "m");
  s.free("b", s.ground(), {x, y, z}, s.attitude("turn"));
  s.loop_joint("joint", {.type = JointType::weld, .a = s.ground(), .b = "b"});
  add_body(s);
  const Equations equations(s);
  State state;
  for (const char* name : {"x", "y", "z", "x'", "y'", "z'", "turn_x", "turn_y", "turn_z", "turn_omega_x",
                           "turn_omega_y", "turn_omega_z"}) {
    state.set(name, Real(0));
  }
  state.set("turn_w", Real(1));
  Evaluator<Real> at(equations.program(), state.reader());
  for (const Real& a : at(equations.forward().accelerations)) EXPECT_LT(abs(a).to_double(), 1e-45);
  const std::vector<Real> wrench = at(equations.forward().multipliers);
  // m = 13/10, g = (2, -5, -27)/3, centre (1, -2, 4)/9: force -m g, moment -c x m g.
  const Number m = Number::rational(13, 10);
  const std::array<Number, 3> f{Number::rational(-2, 3) * m, Number::rational(5, 3) * m, Number(9) * m};
  const std::array<Number, 3> c{Number::rational(1, 9), Number::rational(-2, 9), Number::rational(4, 9)};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    EXPECT_LT(abs(wrench[i] - Real(f[i], digits)).to_double(), 1e-45) << i;
    EXPECT_LT(abs(wrench[i + 3] - Real(c[j] * f[k] - c[k] * f[j], digits)).to_double(), 1e-45) << i;
  }
}

TEST(ClosingJoint, AsksForAPitchWhereThereIsOne) {
  Scene s("wrong");
  const FrameHandle b = s.revolute("b", s.ground(), axis::x, s.coordinate("a", "rad"));
  EXPECT_THROW(s.loop_joint("screw", {.type = JointType::helical, .a = s.ground(), .b = b}), SceneError);
  EXPECT_THROW(s.loop_joint("hinge", {.type = JointType::revolute, .a = s.ground(), .b = b, .pitch = pitch()}),
               SceneError);
  EXPECT_THROW(s.loop_joint("nothing", {.type = JointType::free, .a = s.ground(), .b = b}), SceneError);
  EXPECT_THROW(
      s.loop_joint("screw",
                   {.type = JointType::helical, .a = s.ground(), .b = b, .pitch = Expression::quantity("1", "s")}),
      UnitError);
}

TEST(Attitude, IsRefusedInTwoJoints) {
  Scene s("twice");
  const AttitudeHandle turn = s.attitude("turn");
  s.spherical("b", s.ground(), turn);
  EXPECT_THROW(s.spherical("c", s.ground(), turn), SceneError);
}

TEST(Attitude, IsRefusedWhenItTurnsNothing) {
  Scene s("idle");
  const Expression a = s.coordinate("a", "rad");
  s.revolute("b", s.ground(), axis::x, a);
  s.attitude("turn");
  add_body(s);
  EXPECT_THROW(validate(s), SceneError);
}

}  // namespace
}  // namespace torsor::joint_closures_test
