// SPDX-License-Identifier: GPL-3.0-or-later
// Five hundred random mechanisms: trees and loops, all joints, inertias, actions, laws of time. Each is derived by
// roads that have nothing in common, and compared at a random state to 50 digits.
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "generator/cli/commands.hpp"
#include "generator/dynamics/painleve.hpp"
#include "generator/expression/derivative.hpp"
#include "generator/expression/error.hpp"
#include "generator/verification/check.hpp"
#include "generator/verification/random_state.hpp"
#include "tests/dynamics/random_mechanism.hpp"

namespace torsor {
namespace {

using testing_mechanisms::random_mechanism;
using testing_mechanisms::RandomMechanismOptions;

constexpr int digits = 50;

/// What a mechanism contains, by its seed: every combination comes up.
RandomMechanismOptions options_of(unsigned seed) {
  RandomMechanismOptions options;
  options.joints = true;
  options.loops = seed % 2 == 0;
  options.actions = seed % 5 != 0;
  options.driven = seed % 3 != 0;
  options.released = seed % 7 < 3;
  options.constraints = seed % 4 == 1;
  options.motors = seed % 6 == 0;
  return options;
}

/// Relative to what was added to make the compared quantities, sixty digits leave some 1e-55.
constexpr double bound = 1e-40;

double size_of(const std::vector<Real>& terms) {
  double size = 0;
  for (const Real& term : terms) size += abs(term).to_double();
  return size;
}

/// Both derivations, M, forward dynamics, the energy theorem in Painlevé's form, constraints.
std::string compare_derivations(const RandomMechanismOptions& options, unsigned seed) {
  for (const CheckResult& result : check_derivations(random_mechanism(seed, options), {.digits = digits, .states = 1})) {
    if (!result.passed()) return fmt::format("{}: {:.3g} (bound {:.3g})", result.name, result.worst, result.bound);
  }
  return {};
}

/// First integrals do not change along the motion. Constraints hold at consistent states only, so they are left out.
std::string differentiate_first_integrals(RandomMechanismOptions options, unsigned seed) {
  options.constraints = options.loops = options.motors = false;
  options.actions = seed % 2 == 0;
  const WorkingDigits precision(digits + 10);
  const Scene scene = random_mechanism(seed, options);
  const Equations equations(scene);
  const Model& model = equations.model();
  const PainleveReport report = painleve(equations);
  const RandomState state(scene, 11);
  Evaluator<Real> here(equations.program(), state.in_real());
  const std::vector<Real> a = here(equations.forward().accelerations);
  Evaluator<Real> moving(equations.program(), [&](const SymbolPointer& symbol) {
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (symbol == model.coordinates()[i].a) return a[i];
    }
    return state.in_real()(symbol);
  });
  for (const FirstIntegral& integral : report.first_integrals) {
    if (integral.value.is_constant()) continue;
    const Real change = moving(time_derivative(integral.value));
    const double scale = abs(moving(integral.value)).to_double() + size_of(a);
    if (abs(change).to_double() > bound * scale) return fmt::format("{} changes: {:.3g}", integral.name, change.to_double());
  }
  return {};
}

/// The multiplier of a constraint q = 0 against the reaction of a released coordinate that the joint holds at zero.
std::string compare_parametrisations(RandomMechanismOptions options, unsigned seed) {
  if (!options.released) return {};
  const WorkingDigits precision(digits + 10);
  const Equations released(random_mechanism(seed, options));
  if (released.model().released_count() == 0) return {};
  options.held = true;
  const Equations held(random_mechanism(seed, options));
  const RandomState state(released.scene(), 13);
  // By name: the scenes have symbols of their own; what is held does not move.
  const auto value = [&](const std::string& name) {
    if (name.starts_with("held")) return Real(0);
    const SceneContent& content = released.scene().content();
    for (const CoordinateContent& c : content.coordinates) {
      for (const SymbolPointer& symbol : {c.q, c.v, c.a}) {
        if (symbol->name == name) return state.in_real()(symbol);
      }
    }
    for (const AttitudeContent& attitude : content.attitudes) {
      for (const SymbolPointer& e : attitude.symbols->e) {
        if (e->name == name) return state.in_real()(e);
      }
    }
    for (const ParameterContent& p : content.parameters) {
      if (p.symbol->name == name) return state.in_real()(p.symbol);
    }
    for (const SymbolPointer& input : released.model().inputs()) {
      if (input->name == name) return state.in_real()(input);
    }
    return name == "t" ? state.in_real()(content.time) : Real(0);
  };
  const auto reader = [&](const SymbolPointer& symbol) {
    return symbol->kind == SymbolKind::pi ? Real::pi() : value(symbol->name);
  };
  Evaluator<Real> here(released.program(), reader);
  const ForwardSolution& solution = released.forward();
  const std::vector<Real> a = here(solution.accelerations);
  const std::vector<Real> lambda = here(solution.multipliers);
  Evaluator<Real> moving(released.program(), [&](const SymbolPointer& symbol) {
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (symbol == released.model().coordinates()[i].a) return a[i];
    }
    for (std::size_t j = 0; j < lambda.size(); ++j) {
      if (symbol == released.constraints()[j].multiplier) return lambda[j];
    }
    return reader(symbol);
  });
  const auto n = static_cast<std::size_t>(released.model().unknown_count());
  Real reaction = moving(released.inverse_dynamics()[n]);
  const std::vector<SymbolPointer> inputs = released.model().inputs();
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    reaction -= moving(released.actions().inputs[k][n]) * moving(released.program().symbol(inputs[k]));
  }
  Evaluator<Real> there(held.program(), reader);
  const std::vector<Real> accelerations = there(held.forward().accelerations);
  const std::vector<Real> multipliers = there(held.forward().multipliers);
  const double scale = size_of(accelerations) + size_of(multipliers) + size_of(a);
  for (std::size_t j = 0; j < multipliers.size(); ++j) {
    if (held.constraints()[j].name != "hold") continue;
    const double difference = abs(multipliers[j] - reaction).to_double();
    if (difference > bound * scale) return fmt::format("multiplier and reaction differ by {:.3g}", difference);
  }
  std::size_t i = 0;
  for (const CoordinateContent& c : held.model().coordinates()) {
    const std::size_t column = i++;
    if (c.q->name == "held") continue;
    for (std::size_t k = 0; k < n; ++k) {
      if (released.model().coordinates()[k].q->name != c.q->name) continue;
      const double difference = abs(accelerations[column] - a[k]).to_double();
      if (difference > bound * scale) return fmt::format("{}'' differs by {:.3g}", c.q->name, difference);
    }
  }
  return {};
}

using Comparison = std::function<std::string(const RandomMechanismOptions&, unsigned)>;

/// An empty text when all is well; a scene that cannot be built fails too.
std::string outcome(const Comparison& compare, const RandomMechanismOptions& options, unsigned seed) {
  try {
    return compare(options, seed);
  } catch (const Error& error) {
    return std::string("error: ") + error.what();
  }
}

/// The smallest of the seed's mechanisms that still fails: features are taken away one by one.
std::string smallest(const Comparison& compare, RandomMechanismOptions options, unsigned seed) {
  for (bool simpler = true; simpler;) {
    simpler = false;
    std::vector<RandomMechanismOptions> candidates(7, options);
    candidates[0].most_bodies = options.most_bodies - 1;
    candidates[1].actions = candidates[2].driven = candidates[3].released = candidates[4].constraints = false;
    candidates[5].loops = candidates[6].motors = false;
    for (const RandomMechanismOptions& candidate : candidates) {
      const bool different = candidate.most_bodies != options.most_bodies || candidate.actions != options.actions ||
                             candidate.driven != options.driven || candidate.released != options.released ||
                             candidate.constraints != options.constraints || candidate.loops != options.loops ||
                             candidate.motors != options.motors;
      if (!different || candidate.most_bodies < 1 || outcome(compare, candidate, seed).empty()) continue;
      options = candidate;
      simpler = true;
      break;
    }
  }
  std::string text;
  try {
    text = list_text(random_mechanism(seed, options));
  } catch (const Error& error) {
    text = fmt::format("(cannot be listed: {})\n", error.what());
  }
  return text + outcome(compare, options, seed);
}

class FiveHundredMechanisms : public ::testing::TestWithParam<unsigned> {
 protected:
  static constexpr unsigned part = 25;

  void expect(const Comparison& compare) const {
    for (unsigned seed = part * GetParam(); seed < part * (GetParam() + 1); ++seed) {
      const RandomMechanismOptions options = options_of(seed);
      const std::string failure = outcome(compare, options, seed);
      EXPECT_EQ(failure, "") << "seed " << seed << "; the smallest that fails:\n" << smallest(compare, options, seed);
    }
  }
};

TEST_P(FiveHundredMechanisms, HaveOneSetOfEquationsByEveryRoad) { expect(compare_derivations); }
TEST_P(FiveHundredMechanisms, KeepTheirFirstIntegrals) { expect(differentiate_first_integrals); }
TEST_P(FiveHundredMechanisms, HaveTheSameReactionsByBothParametrisations) { expect(compare_parametrisations); }

INSTANTIATE_TEST_SUITE_P(Seeds, FiveHundredMechanisms, ::testing::Range(0U, 20U));

}  // namespace
}  // namespace torsor
