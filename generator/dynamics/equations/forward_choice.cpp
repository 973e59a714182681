// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/dynamics/equations/forward_choice.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <list>
#include <map>
#include <random>

#include "generator/dynamics/equations/equations.hpp"
#include "generator/dynamics/motion/nominal_number.hpp"
#include "generator/dynamics/recursions/articulated_body.hpp"
#include "generator/dynamics/recursions/joint_coordinates.hpp"
#include "generator/expression/evaluation.hpp"

namespace torsor {
namespace {

constexpr int most_unknowns = 8;   ///< of longer chains the trial takes seconds
constexpr int any_masses = 4;      ///< unknowns up to which masses at run time are taken at any ratio
constexpr double much_lighter = 10;
constexpr int trials = 32;
constexpr int few_digits = 20, many_digits = 60;
/// How much more than the most accurate method one may lose: the figure is the largest of all trials, and roundings fall
/// by chance. A light link that carries a heavy one loses thousands.
constexpr double much_worse = 16;

/// A state: what is a number there is the same in every program of the scene.
class Trial {
 public:
  Trial(const Scene& scene, const ModelOptions& options, bool masses, std::uint64_t seed)
      : scene_(&scene.content()), random_(seed) {
    for (const SymbolPointer& symbol : run_time_parameters(scene, options)) {
      static constexpr int powers[] = {0, 6, -6, 3, -3};
      const bool mass = masses && symbol->unit == units::kilogram;
      factors_[symbol.get()] = Number(10).pow(mass ? powers[below(5)] : 0) * fraction(Number::rational(3, 4));
    }
    const Symbol* before = nullptr;
    for (const CoordinateContent& c : scene_->coordinates) {
      const Symbol* q = c.q.get();
      const std::uint64_t kind = c.q->unit.is_dimensionless() ? below(4) : 0;
      const Number small = signed_fraction() * Number(10).pow(-static_cast<int>(below(8)));
      if (kind == 0) {
        numbers_[q] = Number(2) * signed_fraction();
      } else if (kind == 1 && before != nullptr) {  // absolute angles of an arm that is nearly stretched
        numbers_[q] = numbers_[before] + small;
        quarters_[q] = quarters_[before];
      } else {
        numbers_[q] = small;
        quarters_[q] = static_cast<int>(below(5)) - 2;
      }
      if (c.q->unit.is_dimensionless()) before = q;
      const Number slow = signed_fraction();
      numbers_[c.v.get()] = slow * Number(10).pow(-static_cast<int>(below(4)));
    }
    for (const AttitudeContent& attitude : scene_->attitudes) {
      for (const SymbolPointer& e : attitude.symbols->e) numbers_[e.get()] = signed_fraction();
    }
    for (const ActionContent& action : scene_->actions) {
      if (const auto* motor = std::get_if<Motor>(&action)) numbers_[motor->input.get()] = signed_fraction();
    }
    numbers_[scene_->time.get()] = fraction(Number(0));
  }

  /// At the working precision.
  Real operator()(const SymbolPointer& symbol) const {
    if (symbol->kind == SymbolKind::pi) return Real::pi();
    if (symbol->kind == SymbolKind::parameter) return parameter(symbol);
    const int digits = Real::working_digits();
    if (const auto attitude = symbol->attitude.lock()) {
      Real square(0);
      for (const SymbolPointer& e : attitude->e) square += pow(Real(numbers_.at(e.get()), digits), 2);
      return Real(numbers_.at(symbol.get()), digits) / sqrt(square);
    }
    const auto number = numbers_.find(symbol.get());
    if (number == numbers_.end()) return Real(0);
    const auto quarters = quarters_.find(symbol.get());
    const Real value(number->second, digits);
    return quarters == quarters_.end() ? value : value + Real(quarters->second) * Real::pi() / Real(2);
  }

 private:
  Real parameter(const SymbolPointer& symbol) const {
    const auto place = std::find_if(scene_->parameters.begin(), scene_->parameters.end(),
                                    [&](const ParameterContent& each) { return each.symbol == symbol; });
    Real value(1);
    if (place != scene_->parameters.end() && place->value) {
      Program formula;
      const Value lowered = formula.lower(*place->value);
      value = Evaluator<Real>(formula, [this](const SymbolPointer& inner) { return (*this)(inner); })(lowered);
    }
    const auto factor = factors_.find(symbol.get());
    return factor == factors_.end() ? value : value * Real(factor->second, Real::working_digits());
  }

  std::uint64_t below(std::uint64_t count) { return (random_() >> 11U) % count; }
  /// Between that and what is half as much more, or one; of few bits.
  Number fraction(const Number& least) { return least + Number::rational(static_cast<int>(below(1024)), 2048); }
  Number signed_fraction() {
    const Number size = fraction(Number::rational(1, 4));
    return below(2) == 0 ? size : -size;
  }

  const SceneContent* scene_;
  std::mt19937_64 random_;
  std::map<const Symbol*, Number> numbers_, factors_;  // looked up only, and so the next one
  std::map<const Symbol*, int> quarters_;
};

/// One method in a program of its own.
struct Candidate {
  Candidate(ForwardMethod of, const Scene& scene, const ModelOptions& options) : method(of), equations(scene, options) {
    const bool cheapest = of == ForwardMethod::cheapest;
    const ForwardSolution solution = cheapest ? equations.cheapest_forward() : equations.forward();
    accelerations = solution.accelerations;
    cost = cost_of(equations.program(), solution);
  }

  ForwardMethod method;
  Equations equations;
  std::vector<Value> accelerations;
  int cost = 0;
  double worst = 0;
};

double size(const std::vector<Real>& all) {
  Real square(0);
  for (const Real& each : all) square += each * each;
  return sqrt(square).to_double();
}

/// ‖a − b‖/‖b‖ of those with one unit, the largest of all units; NaN where there is no result.
double relative_error(const std::vector<Value>& values, const std::vector<Real>& a, const std::vector<Real>& b) {
  double worst = 0;
  for (std::size_t first = 0; first < values.size(); ++first) {
    std::vector<Real> off, exact;
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!(values[i].unit() == values[first].unit())) continue;
      off.push_back(a[i] - b[i]);
      exact.push_back(b[i]);
    }
    const double error = size(off) / size(exact);
    if (!(error <= worst)) worst = error;
  }
  return worst;
}

std::vector<Real> accelerations_at(const Candidate& candidate, const Trial& trial, int digits) {
  const WorkingDigits precision(digits);
  Evaluator<Real> evaluate(candidate.equations.program(), [&](const SymbolPointer& symbol) { return trial(symbol); });
  return evaluate(candidate.accelerations);
}

}  // namespace

bool light_may_carry_heavy(const Model& model) {
  const int n = model.unknown_count();
  if (n < 2 || n > most_unknowns || model.options().symbolic_parameters) return false;
  const auto& links = model.links();
  std::vector<double> carried(links.size(), 0);
  for (std::size_t k = links.size(); k-- > 1;) {
    const Value& mass = links[k].mass.mass;
    const bool fixed = mass.is_zero() || mass.is_constant();
    const std::optional<double> own = nominal_number(model.scene(), mass);
    if (!own || (!fixed && n <= any_masses)) return true;
    if (!links[k].partials.empty() && carried[k] > much_lighter * *own) return true;
    carried[static_cast<std::size_t>(links[k].parent)] += carried[k] + *own;
  }
  return false;
}

ForwardMethod forward_method_that_keeps_digits(const Scene& scene, const ModelOptions& options) {
  std::list<Candidate> candidates;  // equations stay where they are made
  const auto add = [&](ForwardMethod method) {
    ModelOptions named = options;
    named.forward = method;
    candidates.emplace_back(method, scene, named);
  };
  add(ForwardMethod::cheapest);
  add(ForwardMethod::sums_of_squares);
  add(ForwardMethod::factorisation);
  const Model& model = candidates.front().equations.model();
  if (has_simple_joints(model)) add(ForwardMethod::articulated_body);
  const bool any = model.unknown_count() <= any_masses;
  const double least = Real(Number(1), few_digits).epsilon().to_double();
  for (std::uint64_t seed = 0; seed < trials; ++seed) {
    const Trial trial(scene, options, any, seed);
    std::vector<double> errors;
    for (const Candidate& candidate : candidates) {
      const std::vector<Real> exact = accelerations_at(candidate, trial, many_digits);
      const std::vector<Real> rounded = accelerations_at(candidate, trial, few_digits);
      errors.push_back(relative_error(candidate.accelerations, rounded, exact));
    }
    double best = HUGE_VAL;
    for (const double error : errors) best = error < best ? error : best;
    if (best == HUGE_VAL) continue;  // no method has a result there
    auto error = errors.begin();
    for (Candidate& candidate : candidates) {
      const double worse = *error++ / std::max(best, 8 * least);
      if (!(worse <= candidate.worst)) candidate.worst = std::isnan(worse) ? HUGE_VAL : worse;
    }
  }
  const auto good = [](const Candidate& candidate) { return candidate.worst <= much_worse; };
  const Candidate* chosen = nullptr;
  for (const Candidate& each : candidates) {
    if (chosen == nullptr) {
      chosen = &each;
    } else if (good(each) != good(*chosen)) {
      if (good(each)) chosen = &each;
    } else if (good(each) ? each.cost < chosen->cost : each.worst < chosen->worst) {
      chosen = &each;
    }
  }
  return chosen->method;
}

}  // namespace torsor
