// SPDX-License-Identifier: GPL-3.0-or-later
// Springs and attractions whose stiffness, natural length or strength depends on coordinates: Q_i = ∂U/∂q_i of the U that
// is printed for them, which holds the coefficient's own slope too.
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/dynamics/forces/selected_actions.hpp"
#include "torsor/generator/dynamics/theorems/energy_theorem.hpp"
#include "torsor/generator/dynamics/theorems/painleve.hpp"
#include "torsor/generator/verification/check.hpp"
#include "tests/dynamics/named_state.hpp"
#include "tests/scenes/sliding.hpp"

namespace torsor::varying_coefficients_test {
namespace {

using namespace testing_symbols;
using namespace testing_mechanisms;
using namespace literals;

const Point state{{"x", rational(2, 3)}, {"y", rational(5, 7)}, {"x'", rational(1, 4)}, {"y'", rational(-3, 7)},
                  {"t", rational(3, 5)}};

using Add = std::function<void(SlidingPoint&, const Expression& k)>;

/// The anchor is 1 m above the plane: |AP|² = x² + y² + 1.
PointReference anchor(SlidingPoint& s) { return s.scene.point("A", s.scene.ground(), {0, 0, metres("1")}); }

Expression turns(SlidingPoint& s) { return sin(s.scene.time() * quantity("2", "1/s")); }

struct Case {
  const char* name;
  Add action, force_function;
};

const std::vector<Case>& cases() {
  static const std::vector<Case> all{
      {"a stiffness along a formula",
       [](SlidingPoint& s, const Expression& k) { s.scene.spring("a", s.x, k * (1 + s.y / metres("2"))); },
       [](SlidingPoint& s, const Expression& k) { s.scene.force_function("a", -k * (1 + s.y / metres("2")) * s.x * s.x / 2); }},
      {"a natural length along a formula",
       [](SlidingPoint& s, const Expression& k) { s.scene.spring("a", s.x, k, s.y / 3); },
       [](SlidingPoint& s, const Expression& k) { s.scene.force_function("a", -k * (s.x - s.y / 3) * (s.x - s.y / 3) / 2); }},
      {"a stiffness between points",
       [](SlidingPoint& s, const Expression& k) {
         s.scene.spring("a", {.a = s.place, .b = anchor(s), .stiffness = k * (1 + s.y / metres("2"))});
       },
       [](SlidingPoint& s, const Expression& k) {
         const Expression square = s.x * s.x + s.y * s.y + metres("1") * metres("1");
         s.scene.force_function("a", -k * (1 + s.y / metres("2")) * square / 2);
       }},
      {"a natural length between points",
       [](SlidingPoint& s, const Expression& k) {
         s.scene.spring("a", {.a = s.place, .b = anchor(s), .stiffness = k, .rest = s.y / 3});
       },
       [](SlidingPoint& s, const Expression& k) {
         const Expression stretch = sqrt(s.x * s.x + s.y * s.y + metres("1") * metres("1")) - s.y / 3;
         s.scene.force_function("a", -k * stretch * stretch / 2);
       }},
      {"the strength of an attraction",
       [](SlidingPoint& s, const Expression& k) { s.scene.gravitation("a", s.place, anchor(s), k * s.y * s.y * metres("1")); },
       [](SlidingPoint& s, const Expression& k) {
         const Expression square = s.x * s.x + s.y * s.y + metres("1") * metres("1");
         s.scene.force_function("a", k * s.y * s.y * metres("1") / sqrt(square));
       }},
      {"a stiffness that time changes too",
       [](SlidingPoint& s, const Expression& k) { s.scene.spring("a", s.x, k * (1 + turns(s) + s.y / metres("2"))); },
       [](SlidingPoint& s, const Expression& k) {
         s.scene.force_function("a", -k * (1 + turns(s) + s.y / metres("2")) * s.x * s.x / 2);
       }},
      {"a natural length that time changes",
       [](SlidingPoint& s, const Expression& k) { s.scene.spring("a", s.x, k, turns(s) * metres("1")); },
       [](SlidingPoint& s, const Expression& k) {
         const Expression stretch = s.x - turns(s) * metres("1");
         s.scene.force_function("a", -k * stretch * stretch / 2);
       }},
      {"a stiffness and a natural length between points that time changes",
       [](SlidingPoint& s, const Expression& k) {
         s.scene.spring("a", {.a = s.place, .b = anchor(s), .stiffness = k * (1 + turns(s)), .rest = turns(s) * s.y / 3});
       },
       [](SlidingPoint& s, const Expression& k) {
         const Expression stretch = sqrt(s.x * s.x + s.y * s.y + metres("1") * metres("1")) - turns(s) * s.y / 3;
         s.scene.force_function("a", -k * (1 + turns(s)) * stretch * stretch / 2);
       }},
      {"the strength of an attraction that time changes",
       [](SlidingPoint& s, const Expression& k) {
         s.scene.gravitation("a", s.place, anchor(s), k * turns(s) * metres("1") * metres("1") * metres("1"));
       },
       [](SlidingPoint& s, const Expression& k) {
         const Expression square = s.x * s.x + s.y * s.y + metres("1") * metres("1");
         s.scene.force_function("a", k * turns(s) * metres("1") * metres("1") * metres("1") / sqrt(square));
       }}};
  return all;
}

Scene with(const Add& add) {
  SlidingPoint s("varying");
  add(s, s.scene.parameter("k", "N/m", 3));
  return s.scene;
}

TEST(VaryingCoefficients, GiveTheForcesOfTheirForceFunction) {
  const WorkingDigits precision(60);
  for (const Case& each : cases()) {
    const Equations action(with(each.action)), given(with(each.force_function));
    NamedState at_action(action, state), at_given(given, state);
    for (std::size_t i = 0; i < 2; ++i) {
      const Real expected = at_given(given.forward().accelerations[i]);
      if (i == 0) {
        EXPECT_GT(abs(expected).to_double(), 1e-3) << each.name;
      }
      EXPECT_LT(relative_difference(at_action(action.forward().accelerations[i]), expected), 1e-45) << each.name;
    }
    // What changes without a motion does no work: the energy of the spring alone goes by it.
    const Real work = at_given(action_power(given, "a", "ground"));
    EXPECT_LT(relative_difference(at_action(action_power(action, "a", "ground")), work), 1e-45) << each.name;
    EXPECT_LT(relative_difference(at_action(selected_actions(action.model(), {{"a"}, {}}).power), work), 1e-45) << each.name;
    EXPECT_EQ(painleve(action).first_integrals.size(), painleve(given).first_integrals.size()) << each.name;
    for (const CheckResult& result : check_scene(with(each.action), {})) {
      EXPECT_TRUE(result.passed()) << each.name << ", " << result.name << ": " << result.worst;
    }
  }
}

TEST(VaryingCoefficients, HaveNoShareOnOneBody) {
  const Equations equations(with(cases()[2].action));
  EXPECT_EQ(error_of<SceneError>([&] { selected_actions(equations.model(), {{"a"}, {"point"}}); }),
            "the action 'a' works on a formula, and its share on one body is not known: ask for it without bodies, or write it "
            "between points");
}

}  // namespace
}  // namespace torsor::varying_coefficients_test
