// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/verification/mechanism_comparisons.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "torsor/generator/base/linear_algebra/lu_factorisation.hpp"
#include "torsor/generator/dynamics/theorems/painleve.hpp"
#include "torsor/generator/program/derivative.hpp"
#include "torsor/generator/verification/check.hpp"
#include "torsor/generator/verification/random_state.hpp"
#include "tests/verification/linearised_mechanism.hpp"

namespace torsor::testing_mechanisms {
namespace {

/// Relative to what was added to make the compared quantities, sixty digits leave some 1e-55.
constexpr double bound = 1e-40;

double size_of(const std::vector<Real>& terms) {
  double size = 0;
  for (const Real& term : terms) size += abs(term).to_double();
  return size;
}

/// The velocities of a random state, moved by the least change onto A v = b: the rows kept, at that configuration.
std::vector<Real> possible_velocities(const Equations& equations, Evaluator<Real>& here) {
  const auto n = static_cast<std::size_t>(equations.model().unknown_count());
  std::vector<Real> v;
  for (std::size_t i = 0; i < n; ++i) v.push_back(here(equations.model().v(static_cast<int>(i))));
  if (equations.constraints().empty()) return v;
  const std::vector<std::size_t>& kept = equations.redundancy().kept;
  std::vector<std::vector<Real>> rows;
  std::vector<Real> rates, matrix;
  for (const std::size_t j : kept) {
    const ConstraintRow& row = equations.constraints()[j];
    rows.push_back(here(std::vector<Value>(row.jacobian.begin(), row.jacobian.begin() + static_cast<long>(n))));
    rates.push_back(here(row.rate));
  }
  for (const auto& a : rows) {
    for (const auto& b : rows) {
      Real sum(0);
      for (std::size_t i = 0; i < n; ++i) sum += a[i] * b[i];
      matrix.push_back(sum);
    }
  }
  const std::vector<Real> factors = solve_dense(matrix, rates);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    for (std::size_t i = 0; i < n; ++i) v[i] -= factors[k] * rows[k][i];
  }
  return v;
}

}  // namespace

std::string compare_derivations(const RandomMechanismOptions& options, unsigned seed, ComparisonCounts&) {
  const CheckOptions once{.digits = comparison_digits, .states = 1};
  for (const CheckResult& result : check_derivations(random_mechanism(seed, options), once)) {
    if (!result.passed()) return fmt::format("{}: {:.3g} (bound {:.3g})", result.name, result.worst, result.bound);
  }
  return {};
}

std::string differentiate_first_integrals(const RandomMechanismOptions& given, unsigned seed,
                                          ComparisonCounts& counts) {
  RandomMechanismOptions options = given;
  options.conservative = true;
  options.released = options.motors = false;
  const WorkingDigits precision(comparison_digits + 10);
  const Scene scene = random_mechanism(seed, options);
  const Equations equations(scene);
  const Model& model = equations.model();
  const PainleveReport report = painleve(equations);
  const auto& integrals = report.first_integrals;
  if (std::all_of(integrals.begin(), integrals.end(), [](const auto& i) { return i.value.is_constant(); })) return {};
  const RandomState state(scene, 11);
  Evaluator<Real> anywhere(equations.program(), state.in_real());
  const std::vector<Real> v = possible_velocities(equations, anywhere);
  const auto with_velocities = [&](const SymbolPointer& symbol) {
    for (std::size_t i = 0; i < v.size(); ++i) {
      if (symbol == model.coordinates()[i].v) return v[i];
    }
    return state.in_real()(symbol);
  };
  Evaluator<Real> here(equations.program(), with_velocities);
  const std::vector<Real> a = here(equations.forward().accelerations);
  Evaluator<Real> moving(equations.program(), [&](const SymbolPointer& symbol) {
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (symbol == model.coordinates()[i].a) return a[i];
    }
    return with_velocities(symbol);
  });
  for (const FirstIntegral& integral : integrals) {
    if (integral.value.is_constant()) continue;
    ++(integral.name == "energy" ? counts.energies : integral.name == "painleve" ? counts.painleve : counts.momenta);
    if (!equations.constraints().empty()) ++counts.constrained_integrals;
    const Real change = moving(time_derivative(integral.value));
    const double scale = abs(moving(integral.value)).to_double() + size_of(a);
    if (abs(change).to_double() > bound * scale)
      return fmt::format("{} changes: {:.3g}", integral.name, change.to_double());
  }
  return {};
}

std::string compare_parametrisations(const RandomMechanismOptions& given, unsigned seed, ComparisonCounts& counts) {
  if (!given.released) return {};
  RandomMechanismOptions options = given;
  const WorkingDigits precision(comparison_digits + 10);
  const Equations released(random_mechanism(seed, options));
  if (released.model().released_count() == 0) return {};
  ++counts.reactions;
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

std::string compare_linearisations(const RandomMechanismOptions& options, unsigned seed, ComparisonCounts& counts) {
  const LinearisationOutcome outcome = compare_linearisation(random_mechanism(seed, options), comparison_digits);
  ++counts.linearised;
  counts.turning += outcome.turning ? 1 : 0;
  counts.forward += outcome.forward ? 1 : 0;
  counts.reduced += outcome.reduced ? 1 : 0;
  counts.redundant += outcome.reduced && outcome.redundant ? 1 : 0;
  return outcome.difference;
}

}  // namespace torsor::testing_mechanisms
