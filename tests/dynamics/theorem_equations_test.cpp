// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/theorems/theorem_equations.hpp"

#include <gtest/gtest.h>

#include <map>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/dynamics/theorems/joint_actions.hpp"
#include "torsor/generator/verification/random_state.hpp"
#include "tests/dynamics/named_state.hpp"
#include "tests/dynamics/random_mechanism.hpp"
#include "tests/scenes/bodies.hpp"

namespace torsor::theorem_equations_test {
namespace {

using namespace testing_symbols;
using namespace testing_mechanisms;

/// A random state of the motion itself: accelerations and multipliers are those of forward dynamics, and each named
/// component is what the joint does transmit there, dynamic screw less known actions (transmitted_wrenches).
class OnTheMotion {
 public:
  explicit OnTheMotion(const Scene& scene) : equations_(scene), state_(scene, 9) {
    const Model& model = equations_.model();
    Evaluator<Real> before(equations_.program(), state_.in_real());
    const ForwardSolution& forward = equations_.forward();
    for (std::size_t i = 0; i < forward.accelerations.size(); ++i) {
      values_[model.coordinates()[i].a->name] = before(forward.accelerations[i]);
    }
    for (std::size_t j = 0; j < forward.multipliers.size(); ++j) {
      values_[equations_.constraints()[j].multiplier->name] = before(forward.multipliers[j]);
    }
    const std::vector<Wrench> transmitted = transmitted_wrenches(equations_);
    Evaluator<Real> evaluate = evaluator();
    for (const Connection& joint : connections(equations_)) {
      const Vector at = model.locate(Vector(), joint.bottom, joint.top);
      const Wrench wrench =
          reduced_at(transmitted[static_cast<std::size_t>(joint.top)], bound(equations_.program(), at));
      for (int e = 0; e < 6; ++e) {
        const std::string name = "[" + joint.name + " " + "XYZLMN"[e] + "]";
        values_[name] = evaluate((e < 3 ? wrench.resultant : wrench.moment)[e % 3]);
      }
    }
  }

  Evaluator<Real> evaluator() const {
    return {equations_.program(), [this](const SymbolPointer& symbol) {
              const auto place = values_.find(symbol->name);
              return place == values_.end() ? state_.in_real()(symbol) : place->second;
            }};
  }
  const Real& at(const std::string& name) const { return values_.at(name); }
  const Equations& equations() const { return equations_; }

 private:
  Equations equations_;
  RandomState state_;
  std::map<std::string, Real> values_;
};

FrameReference body_frame(const Model& model, const std::string& name) {
  for (const BodyContent& body : model.scene().bodies) {
    if (body.name == name) return body.frame;
  }
  throw SceneError("no body " + name);
}

class RandomTheorems : public ::testing::TestWithParam<unsigned> {};

void expect_efforts(const OnTheMotion& motion) {
  Evaluator<Real> evaluate = motion.evaluator();
  for (const JointAction& action : joint_actions(motion.equations())) {
    for (int e = 0; e < 6; ++e) {
      const std::string name = "[" + action.connection.name + " " + "XYZLMN"[e] + "]";
      const Value& component = (e < 3 ? action.wrench.resultant : action.wrench.moment)[e % 3];
      const Real given = component.is_zero() ? Real(0) : evaluate(component);
      EXPECT_LT(abs(given - motion.at(name)), power_of_ten(-38)) << name;
    }
  }
}

// What stands without a name along a joint's freedom was put there from the springs, dampers, motors and formulas: on
// the motion it is what Newton-Euler finds. States have entries of order 1 and a few thousand operations in 50 digits.
TEST_P(RandomTheorems, GiveTheActionsAlongTheFreedomsOfJoints) {
  const WorkingDigits precision(50);
  expect_efforts(OnTheMotion(random_mechanism(GetParam(), {.driven = true, .joints = GetParam() % 2 == 0})));
}

void expect_theorems(const OnTheMotion& motion) {
  Evaluator<Real> evaluate = motion.evaluator();
  const Model& model = motion.equations().model();
  std::vector<BodyNames> sets{all_bodies(model)};
  std::map<int, BodyNames> rigid;  // what is fixed together is isolated together
  for (const std::string& body : sets[0]) rigid[model.place(body_frame(model, body), "test").link].push_back(body);
  for (const auto& [link, bodies] : rigid) sets.push_back(bodies);
  for (const BodyNames& bodies : sets) {
    for (const Theorem theorem : {Theorem::resultant, Theorem::moment}) {
      const Triple direction{Expression(1), Expression(2), Expression(-3)};
      const TheoremEquation equation =
          theorem_equation(motion.equations(), bodies, {{Scene::point("P1"), "body0", "ground"}, theorem, direction});
      EXPECT_LT(abs(evaluate(equation.left) - evaluate(equation.right)), power_of_ten(-38));
    }
    for (const char* observer : {"ground", "body0"}) {
      const EnergyEquation energy = energy_equation(motion.equations(), bodies, observer);
      const Real left = energy.equation.left.is_zero() ? Real(0) : evaluate(energy.equation.left);
      EXPECT_LT(abs(left - evaluate(energy.equation.right)), power_of_ten(-38)) << observer;
    }
  }
}

TEST_P(RandomTheorems, HoldForEveryBodyAndForAll) {
  const WorkingDigits precision(50);
  expect_theorems(OnTheMotion(random_mechanism(GetParam(), {.joints = GetParam() % 2 == 0})));
}

// A reflected inertia resists in the joint that drives it, between the two bodies there, and is none itself.
TEST_P(RandomTheorems, HoldWithReflectedInertias) {
  const WorkingDigits precision(50);
  Scene scene = random_mechanism(GetParam(), {.motors = true, .joints = GetParam() % 2 == 0});
  const std::vector<CoordinateContent> coordinates = scene.content().coordinates;
  for (const CoordinateContent& c : coordinates) {
    if (c.attitude || c.law || c.released) continue;
    const char* unit = c.q->unit == units::metre ? "kg" : "kg m^2";
    scene.reflected_inertia("rotor_" + c.q->name, Expression(c.q), Expression::quantity("0.5", unit));
  }
  ASSERT_FALSE(scene.content().rotors.empty());
  const OnTheMotion motion(scene);
  expect_theorems(motion);
  expect_efforts(motion);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomTheorems, ::testing::Range(500U, 512U));

// A turntable without mass that the air on it moves with: the arm's own joint is what crosses the boundary.
TEST(TheoremEquations, LeaveAMasslessLinkOnWhichSomethingActsOutside) {
  const WorkingDigits precision(50);
  Scene scene("turntable");
  const Expression psi = scene.coordinate("psi", "rad"), theta = scene.coordinate("theta", "rad");
  const FrameHandle table = scene.revolute("table", scene.ground(), axis::z, psi);
  const FrameHandle arm = scene.revolute("arm", table, axis::z, theta);
  scene.body("arm", arm, Inertia::rod(kilograms("2"), metres("0.3"), 0).at({metres("0.15"), 0, 0}));
  const PointHandle tip = scene.point("tip", arm, {metres("0.3"), 0, 0});
  scene.drag("air", {.body = arm, .point = tip, .coefficient = Expression::quantity("0.7", "N s/m"), .relative_to = table});
  scene.drive(psi, Expression::quantity("3", "rad/s") * scene.time());
  scene.motor("T", theta);
  const OnTheMotion motion(scene);
  const TheoremEquation equation =
      theorem_equation(motion.equations(), {"arm"}, {{Scene::point("tip"), "arm", "ground"}, Theorem::moment, axis::z});
  for (const SymbolPointer& unknown : equation.unknowns) EXPECT_FALSE(unknown->name.starts_with("[table")) << unknown->name;
  const EnergyEquation energy = energy_equation(motion.equations(), {"arm"});
  EXPECT_TRUE(identically_zero(energy.internal_power)) << "of one body";
  Evaluator<Real> evaluate = motion.evaluator();
  EXPECT_LT(abs(evaluate(equation.left) - evaluate(equation.right)), power_of_ten(-38));
  EXPECT_LT(abs(evaluate(energy.equation.left) - evaluate(energy.equation.right)), power_of_ten(-38));
}

// ground - A - B1 - C1 and A - B2 - C2: forces act on B1 and B2, and A, B1, B2 have no mass. C1 and C2 alone are isolated.
TEST(TheoremEquations, LeaveOutWhatCarriesMasslessLinksThatStand) {
  const WorkingDigits precision(50);
  Scene scene("branches");
  const Expression a = scene.coordinate("a", "m");
  const FrameHandle root = scene.prismatic("A", scene.ground(), axis::x, a);
  for (const std::string k : {"1", "2"}) {
    const FrameHandle middle = scene.prismatic("B" + k, root, axis::y, scene.coordinate("b" + k, "m"));
    const PointHandle point = scene.point("P" + k, middle, {0, 0, 0});
    const Expression push = Expression::quantity("3", "N");
    scene.force("push" + k, {.body = middle, .point = point, .components = {push, 0, 0}, .axes = "ground"});
    const FrameHandle end = scene.prismatic("C" + k, middle, axis::z, scene.coordinate("c" + k, "m"));
    scene.body("C" + k, end, Inertia::point(kilograms("2")));
  }
  const Equations equations(scene);
  const TheoremEquation equation =
      theorem_equation(equations, {"C1", "C2"}, {{Scene::point("P1"), "ground", "ground"}, Theorem::resultant, axis::x});
  std::vector<std::string> names;
  for (const SymbolPointer& unknown : equation.unknowns) names.push_back(unknown->name);
  EXPECT_EQ(names, (std::vector<std::string>{"[C1 X]", "[C2 X]"}));
}

/// The ends of two rods with a spring and a motor between them, written with absolute angles.
Scene absolute_angles() {
  Scene scene("absolute");
  const Expression a = scene.coordinate("a", "rad"), b = scene.coordinate("b", "rad");
  const FrameHandle lower = scene.revolute("lower", scene.ground(), axis::z, a);
  const FrameHandle upper = scene.revolute("upper", lower, axis::z, b - a, {.origin = {metres("1"), 0, 0}});
  scene.body("lower", lower, Inertia::point(kilograms("2")).at({metres("1"), 0, 0}));
  scene.body("upper", upper, Inertia::point(kilograms("1")).at({metres("1"), 0, 0}));
  scene.spring("spring", b - a, Expression::quantity("5", "N m"));
  scene.motor("torque", a);
  return scene;
}

// A spring on b − a acts in the upper joint alone, although it enters both of Lagrange's equations.
TEST(JointActions, AreThoseOfTheJointWhateverTheCoordinates) {
  const WorkingDigits precision(50);
  const Equations equations(absolute_angles());
  const std::vector<JointAction> actions = joint_actions(equations);
  NamedState state(equations, {{"a", Real(2)}, {"b", Real(5)}, {"torque", Real(7)}});
  ASSERT_EQ(actions.size(), 2U);
  EXPECT_EQ(state.in_double(actions[0].wrench.moment[2]), 7.0);
  EXPECT_EQ(state.in_double(actions[1].wrench.moment[2]), -15.0);
  EXPECT_EQ(actions[1].unknowns.size(), 5U);
  EXPECT_TRUE(actions[1].remarks.empty());
}

/// A rod on a link without matter, in whose middle something acts.
struct RodOnALightLink {
  Scene scene{"light_link"};
  FrameHandle light = scene.revolute("light", scene.ground(), axis::y, scene.coordinate("a", "rad"));
  FrameHandle rod = scene.revolute("rod", light, axis::y, scene.coordinate("b", "rad"), {.origin = {metres("1"), 0, 0}});
  PointHandle middle = scene.point("middle", light, {metres("0.5"), 0, 0});

  RodOnALightLink() { scene.body("rod", rod, generic_body()); }
};

Scene pushed() {
  RodOnALightLink it;
  it.scene.force("push", {.body = it.light, .point = it.middle, .components = {0, 0, quantity("3", "N")}, .axes = it.scene.ground()});
  return it.scene;
}

Scene pulled_by_a_spring() {
  RodOnALightLink it;
  const PointHandle hook = it.scene.point("hook", it.scene.ground(), {0, 0, metres("1")});
  it.scene.spring("spring", {.a = it.middle, .b = hook, .stiffness = Expression::quantity("10", "N/m")});
  return it.scene;
}

Scene tied_to_a_slide() {
  RodOnALightLink it;
  const FrameHandle slide = it.scene.prismatic("slide", it.scene.ground(), axis::x, it.scene.coordinate("x", "m"));
  it.scene.body("slide", slide, Inertia::point(kilograms("2")));
  it.scene.closure("tie", it.middle, it.scene.point("end", slide, {0, 0, 0}), axis::x);
  return it.scene;
}

// What the ground's joint transmits to the link is not what the link transmits to the rod.
TEST(TheoremEquation, CountsWhatActsOnALinkWithoutMatter) {
  const WorkingDigits precision(50);
  for (Scene (*make)() : {pushed, pulled_by_a_spring, tied_to_a_slide}) {
    const OnTheMotion motion(make());
    Evaluator<Real> evaluate = motion.evaluator();
    EXPECT_GE(joint_actions(motion.equations()).size(), 2U);
    for (const BodyNames& bodies : {BodyNames{"rod"}, all_bodies(motion.equations().model())}) {
      for (const Theorem theorem : {Theorem::resultant, Theorem::moment}) {
        const Triple direction{Expression(1), Expression(2), Expression(-3)};
        const TheoremEquation equation =
            theorem_equation(motion.equations(), bodies, {{Scene::point("middle"), "rod", "ground"}, theorem, direction});
        EXPECT_LT(abs(evaluate(equation.left) - evaluate(equation.right)), power_of_ten(-38));
      }
      for (const char* observer : {"ground", "light"}) {
        const EnergyEquation energy = energy_equation(motion.equations(), bodies, observer);
        EXPECT_LT(abs(evaluate(energy.equation.left) - evaluate(energy.equation.right)), power_of_ten(-38)) << observer;
      }
    }
  }
}

}  // namespace
}  // namespace torsor::theorem_equations_test
