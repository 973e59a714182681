// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/equations/forward_choice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <iterator>
#include <list>
#include <map>
#include <optional>
#include <random>
#include <vector>

#include "torsor/generator/dynamics/equations/equations.hpp"
#include "torsor/generator/dynamics/motion/nominal_number.hpp"
#include "torsor/generator/dynamics/recursions/articulated_motion.hpp"
#include "torsor/generator/dynamics/recursions/joint_coordinates.hpp"
#include "torsor/generator/program/evaluation.hpp"

namespace torsor {
namespace {

constexpr int most_unknowns = 8;   ///< of longer chains the trial takes seconds
constexpr int any_masses = 4;      ///< unknowns up to which masses at run time are taken at any ratio
constexpr double much_lighter = 10;
constexpr double lighter_in_energies = 100;  ///< a sum loses that ratio at most, where a pivot loses it in each solve
constexpr std::size_t trials = 32;
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
  Candidate(ForwardMethod of, const Scene& scene, const ModelOptions& options)
      : method(of), equations(scene, options), evaluate(equations.program(), {}) {
    const bool cheapest = of == ForwardMethod::cheapest;
    const ForwardSolution solution = cheapest ? equations.cheapest_forward() : equations.forward();
    accelerations = solution.accelerations;
    cost = cost_of(equations.program(), solution);
  }

  std::vector<Real> at(const Trial& trial, int digits) {
    const WorkingDigits precision(digits);
    evaluate.move_to([&trial](const SymbolPointer& symbol) { return trial(symbol); });
    return evaluate(accelerations);
  }

  ForwardMethod method;
  Equations equations;
  Evaluator<Real> evaluate;  // keeps its formulas from trial to trial
  std::vector<Value> accelerations;
  int cost = 0;
  std::array<std::optional<double>, trials> errors;
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

/// What methods lose at the same states, each looked at only when the choice depends on it.
class Contest {
 public:
  Contest(const Scene& scene, const ModelOptions& options) {
    add(ForwardMethod::cheapest, scene, options);
    add(ForwardMethod::sums_of_squares, scene, options);
    add(ForwardMethod::factorisation, scene, options);
    const Model& model = candidates_.front().equations.model();
    if (has_simple_joints(model)) add(ForwardMethod::articulated_body, scene, options);
    const bool any = model.unknown_count() <= any_masses;
    for (std::uint64_t seed = 0; seed < trials; ++seed) trials_.emplace_back(scene, options, any, seed);
  }

  /// The cheapest of those that keep their digits; the one that loses least where none does.
  ForwardMethod choice() {
    std::vector<Candidate*> by_cost;
    for (Candidate& each : candidates_) by_cost.push_back(&each);
    std::stable_sort(by_cost.begin(), by_cost.end(),
                     [](const Candidate* a, const Candidate* b) { return a->cost < b->cost; });
    for (Candidate* each : by_cost) {
      if (keeps_digits(*each)) return each->method;
    }
    std::vector<double> worst;
    for (Candidate& each : candidates_) worst.push_back(worst_of(each));
    const auto least = std::min_element(worst.begin(), worst.end());
    return std::next(candidates_.begin(), least - worst.begin())->method;
  }

 private:
  void add(ForwardMethod method, const Scene& scene, ModelOptions options) {
    options.forward = method;
    candidates_.emplace_back(method, scene, options);
  }

  double error_of(Candidate& candidate, std::size_t trial) {
    std::optional<double>& error = candidate.errors[trial];
    if (!error) {
      std::vector<Real> exact = exact_[trial];
      if (exact.empty()) exact = exact_[trial] = candidates_.front().at(trials_[trial], many_digits);
      const bool result = std::all_of(exact.begin(), exact.end(), [](const Real& each) { return !each.is_nan(); });
      if (!result) exact = candidate.at(trials_[trial], many_digits);
      error = relative_error(candidate.accelerations, candidate.at(trials_[trial], few_digits), exact);
    }
    return *error;
  }

  /// The error over the least of all methods there, but for roundings; 0 where no method has a result.
  double worse_than_best(Candidate& candidate, std::size_t trial) {
    double best = HUGE_VAL;
    for (Candidate& each : candidates_) {
      const double error = error_of(each, trial);
      best = error < best ? error : best;
    }
    if (best == HUGE_VAL) return 0;
    const double worse = error_of(candidate, trial) / std::max(best, roundings_);
    return std::isnan(worse) ? HUGE_VAL : worse;
  }

  bool keeps_digits(Candidate& candidate) {
    for (std::size_t trial = 0; trial < trials_.size(); ++trial) {
      if (error_of(candidate, trial) <= much_worse * roundings_) continue;  // whatever the others lose
      if (worse_than_best(candidate, trial) > much_worse) return false;
    }
    return true;
  }

  double worst_of(Candidate& candidate) {
    double worst = 0;
    for (std::size_t trial = 0; trial < trials_.size(); ++trial) {
      worst = std::max(worst, worse_than_best(candidate, trial));
    }
    return worst;
  }

  std::list<Candidate> candidates_;  // equations stay where they are made
  std::deque<Trial> trials_;
  std::array<std::vector<Real>, trials> exact_;
  double roundings_ = 8 * Real(Number(1), few_digits).epsilon().to_double();
};

/// Whether a link, or with `empty_too` also one without matter, carries so many times its own; of few unknowns also
/// where that depends on masses at run time.
bool carries_more(const Model& model, double times, bool empty_too) {
  const auto& links = model.links();
  std::vector<double> carried(links.size(), 0);
  for (std::size_t k = links.size(); k-- > 1;) {
    const Value& mass = links[k].mass.mass;
    const bool fixed = mass.is_zero() || mass.is_constant();
    const std::optional<double> own = nominal_number(model.scene(), mass);
    if (empty_too || (!mass.is_zero() && carried[k] > 0)) {
      if (!own || (!fixed && model.unknown_count() <= any_masses)) return true;
      if (!links[k].partials.empty() && carried[k] > times * *own) return true;
    }
    carried[static_cast<std::size_t>(links[k].parent)] += carried[k] + own.value_or(1);
  }
  return false;
}

}  // namespace

bool light_may_carry_heavy(const Model& model) {
  const int n = model.unknown_count();
  return n >= 2 && n <= most_unknowns && !model.options().symbolic_parameters &&
         carries_more(model, much_lighter, true);
}

bool light_matter_may_carry_heavy(const Model& model) {
  return !model.options().symbolic_parameters && carries_more(model, lighter_in_energies, false);
}

ForwardMethod forward_method_that_keeps_digits(const Scene& scene, const ModelOptions& options) {
  return Contest(scene, options).choice();
}

}  // namespace torsor
