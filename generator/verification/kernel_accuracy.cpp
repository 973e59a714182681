// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/verification/kernel_accuracy.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/verification/ball.hpp"
#include "torsor/generator/verification/kernel_text.hpp"
#include "torsor/generator/verification/running_error.hpp"
#include "torsor/generator/verification/sensitivity.hpp"

namespace torsor {
namespace {

/// Of mass[2]: "mass"
std::string result_name(const Target& target) { return Target{target.result, target.member}.to_string(); }

/// (name, unit) of each result; no name for one that is a constant of the header.
std::vector<std::pair<std::string, Unit>> results_of(const Kernel& kernel) {
  std::vector<std::pair<std::string, Unit>> results;
  for (const Assignment& assignment : kernel.assignments) {
    const bool constant = assignment.value.is_constant();
    results.emplace_back(constant ? "" : result_name(assignment.target), assignment.value.unit());
  }
  for (int order = 1; kernel.series && order <= jet_orders; ++order) {
    for (std::size_t i = 0; i < kernel.series->state.size(); ++i) {
      const std::size_t solved = kernel.series->solve ? kernel.series->solve->unknowns.size() : 0;
      const bool given = i + solved < kernel.series->state.size();
      const bool constant = given && order > 1 && kernel.series->program.outputs()[i].terms.empty();
      results.emplace_back(constant ? "" : fmt::format("coefficients of order {}", order),
                           kernel.series->state[i]->unit / units::second.pow(order));
    }
  }
  return results;
}

std::vector<OutputGroup> groups_of(const std::vector<OwnKernel>& kernels) {
  std::vector<OutputGroup> groups;
  for (std::size_t k = 0; k < kernels.size(); ++k) {
    std::vector<std::pair<std::string, Unit>> keys;
    const std::size_t first = groups.size();
    const std::vector<std::pair<std::string, Unit>> results = results_of(kernels[k].kernel);
    for (std::size_t i = 0; i < results.size(); ++i) {
      const std::pair<std::string, Unit>& key = results[i];
      if (key.first.empty()) continue;
      auto place = std::find(keys.begin(), keys.end(), key);
      if (place == keys.end()) {
        const std::string unit = key.second.to_string();
        groups.push_back({k, fmt::format("{} [{}]", key.first, unit.empty() ? "1" : unit), {}});
        place = keys.insert(keys.end(), key);
      }
      groups[first + static_cast<std::size_t>(place - keys.begin())].members.push_back(i);
    }
  }
  return groups;
}

/// Unit in the last place of a number of that size.
template <class Float>
long double ulp(long double size) {
  int exponent = 0;
  std::frexp(size, &exponent);  // size in [2^(exponent-1), 2^exponent)
  const int least = std::numeric_limits<Float>::min_exponent;
  return std::ldexp(1.0L, std::max(size == 0 ? least : exponent, least) - std::numeric_limits<Float>::digits);
}

/// Values of a program's symbols, pi included.
template <class Scalar, class Of>
typename Evaluator<Scalar>::SymbolValue symbol_values(Scalar pi, Of of) {
  return [pi, of](const SymbolPointer& symbol) { return symbol->kind == SymbolKind::pi ? pi : of(symbol); };
}

/// Symbols that values depend on; of a series its state is among them.
std::vector<SymbolPointer> symbols_of(const OwnKernel& own, std::vector<Value> values) {
  Program& program = own.equations->program();
  if (own.kernel.series) {
    for (const SymbolPointer& symbol : own.kernel.series->state) values.push_back(program.symbol(symbol));
  }
  std::vector<SymbolPointer> symbols;
  for (const ValueNumber value_number : program.live(values)) {
    const SymbolPointer& symbol = program[value_number].symbol;
    if (symbol && symbol->kind != SymbolKind::pi) symbols.push_back(symbol);
  }
  return symbols;
}

/// The results of a kernel with every parameter that has a name as a symbol: equations of their own, for derivatives.
/// Numbers that the scene gives without a name are parameters too; ± 1 is none, so that in 1 - cos x nothing but x is
/// data.
class Condition {
 public:
  Condition(const Scene& scene, OwnKernel own, const Kernel& emitted)
      : scene_(scene), own_(std::move(own)), evaluate_(own_.equations->program(), {}) {
    // Patterns and base parameters are those of the scene's values: elsewhere results may stand at other places.
    const bool alike = std::equal(own_.kernel.assignments.begin(), own_.kernel.assignments.end(),
                                  emitted.assignments.begin(), emitted.assignments.end(),
                                  [](const Assignment& a, const Assignment& b) { return a.target == b.target; });
    if (!alike) throw Error(fmt::format("the kernel '{}' with parameters as symbols has other results", emitted.name));
    // A definition of its own for each: its formula is then made once and not at each state.
    for (Assignment& each : own_.kernel.assignments) each.value = own_.equations->program().bind(each.value);
    evaluate_.set_constants([this](const Number& number) {
      const Elasticity constant = Elasticity::of_number(number);
      return number.abs().is_one() ? constant : elasticity_input(constant.value(), input_count_++);
    });
  }
  Condition(const Condition&) = delete;
  Condition& operator=(const Condition&) = delete;

  void move_to(const StressState& state) {
    known_parameters_.clear();
    coefficients_.clear();
    evaluate_.move_to(symbol_values<Elasticity>(pi, [this, &state](const SymbolPointer& symbol) {
      return elasticity_input(value(symbol, state), number(symbol));
    }));
  }

  /// Of one result: an assignment, or a coefficient.
  Elasticity operator()(std::size_t result) {
    if (!own_.kernel.series) return evaluate_(own_.kernel.assignments[result].value);
    if (coefficients_.empty()) {
      coefficients_ = from_order_one(taylor_coefficients(*own_.kernel.series, evaluate_, jet_orders));
    }
    return coefficients_[result];
  }

 private:
  static inline const Elasticity pi{3.14159265358979323846264338327950288L};

  std::size_t number(const SymbolPointer& symbol) {
    const auto [place, added] = numbers_.emplace(symbol.get(), input_count_);
    if (added) ++input_count_;
    return place->second;
  }

  long double value(const SymbolPointer& symbol, const StressState& state) {
    const auto& of_state = state.symbols();
    if (std::find(of_state.begin(), of_state.end(), symbol) != of_state.end()) return state.value(symbol);
    if (const auto known = known_parameters_.find(symbol.get()); known != known_parameters_.end()) return known->second;
    for (const ParameterContent& parameter : scene_.content().parameters) {
      if (parameter.symbol != symbol || !parameter.value) continue;
      Program formula;
      Evaluator<Elasticity> evaluate(formula, symbol_values<Elasticity>(pi, [&](const SymbolPointer& inner) {
                                       return Elasticity(value(inner, state));
                                     }));
      return known_parameters_[symbol.get()] = evaluate(formula.lower(*parameter.value)).value();
    }
    throw Error(fmt::format("no value for the symbol '{}' at a state of verify", symbol->name));
  }

  const Scene& scene_;
  OwnKernel own_;
  Evaluator<Elasticity> evaluate_;
  std::vector<Elasticity> coefficients_;
  std::size_t input_count_ = 0;
  std::map<const Symbol*, std::size_t> numbers_;  // looked up only, and so the next one
  std::map<const Symbol*, long double> known_parameters_;
};

using Conditions = std::vector<std::unique_ptr<Condition>>;  ///< by kernel

Conditions conditions_of(const Scene& scene, const ModelOptions& options, const std::vector<OwnKernel>& emitted) {
  Conditions conditions;
  for (const OwnKernel& each : emitted) {
    std::vector<OwnKernel> own = make_own_kernels(scene, options, {each.kernel.name});
    if (own.empty()) throw Error(fmt::format("there is no kernel '{}' with parameters as symbols", each.kernel.name));
    conditions.push_back(std::make_unique<Condition>(scene, std::move(own.front()), each.kernel));
  }
  return conditions;
}

/// Some scenes are possible with the values of their parameters only (constraints that repeat others): their folded
/// parameters are among the plain numbers then.
Conditions make_conditions(const Scene& scene, ModelOptions options, const std::vector<OwnKernel>& emitted) {
  if (!options.sensitive_to) {
    options.sensitive_to.emplace();
    for (const SymbolPointer& symbol : run_time_parameters(scene, options)) options.sensitive_to->insert(symbol->name);
  }
  const ModelOptions folded = options;
  options.all_run_time = true;
  try {
    return conditions_of(scene, options, emitted);
  } catch (const Error&) {
    return conditions_of(scene, folded, emitted);
  }
}

template <class Float>
class AccuracyIn final : public KernelAccuracy {
 public:
  AccuracyIn(const Scene& scene, const ModelOptions& options, const std::vector<std::string>& names)
      : kernels_(make_own_kernels(scene, options, names)),
        groups_(groups_of(kernels_)),
        conditions_(make_conditions(scene, options, kernels_)) {
    for (OwnKernel& own : kernels_) {
      texts_.emplace_back(scene, options, own, numbers(), jet_orders);
      // A definition of its own for each result: its formula is then made once and not at each state.
      Program& program = own.equations->program();
      for (Assignment& assignment : own.kernel.assignments) assignment.value = program.bind(assignment.value);
      for (PivotTest& test : own.kernel.pivots) {
        test.pivot = program.bind(test.pivot);
        test.measure = program.bind(test.measure);
      }
      for (const SymbolPointer& symbol : symbols_of(own, own.kernel.values())) {
        if (std::find(symbols_.begin(), symbols_.end(), symbol) == symbols_.end()) symbols_.push_back(symbol);
      }
    }
    for (const OutputGroup& group : groups_) {
      const OwnKernel& own = kernels_[group.kernel];
      std::vector<Value> values = own.kernel.series ? own.kernel.values() : std::vector<Value>();
      for (const std::size_t i : group.members) {
        if (!own.kernel.series) values.push_back(own.kernel.assignments[i].value);
      }
      group_symbols_.push_back(symbols_of(own, std::move(values)));
    }
  }

  const std::vector<OwnKernel>& kernels() const override { return kernels_; }
  const std::vector<OutputGroup>& groups() const override { return groups_; }
  const std::vector<SymbolPointer>& symbols(std::size_t group) const override { return group_symbols_[group]; }
  const std::vector<SymbolPointer>& symbols() const override { return symbols_; }

  void move_to(const StressState& state) override {
    state_ = &state;
    for (KernelText<Running<Float>>& text : texts_) {
      text.move_to([this](const SymbolPointer& symbol) {
        return Running<Float>(static_cast<Float>(state_->value(symbol)));
      });
    }
    for (const auto& condition : conditions_) condition->move_to(state);
  }

  std::vector<double> computed(std::size_t kernel) override {
    std::vector<double> values;
    for (const Running<Float>& result : texts_[kernel].results()) values.push_back(static_cast<double>(result.value()));
    return values;
  }

  Accuracy estimate(std::size_t group) override {
    return measure(group, [&](std::size_t i) { return (*conditions_[groups_[group].kernel])(i).value(); });
  }

  Accuracy certify(std::size_t group, int digits) override {
    Accuracy result = settled<Real>(group, digits);
    if (!result.counted || !Ball::available()) return result;
    const Accuracy surely = settled<Ball>(group, digits);
    result.enclosed = surely.counted && surely.error <= result.error + 1e-3 * std::max(result.error, 1e-3);
    return result;
  }

 private:
  static NumbersOf<Running<Float>> numbers() {
    return {[](const Number& number) { return Running<Float>::of_number(number); },
            [](const RoundedConstant& constant) { return Running<Float>::rounded_literal(literal(constant)); },
            Running<Float>::rounded_literal(static_cast<Float>(3.14159265358979323846))};
  }

  static Float literal(const RoundedConstant& constant) {
    if constexpr (std::is_same_v<Float, float>) {
      return constant.in_float;
    } else {
      return constant.in_double;
    }
  }

  /// With as many digits as the error depends on.
  template <class Exact>
  Accuracy settled(std::size_t group, int digits) {
    Accuracy before;
    for (int precision = digits;; precision *= 2) {
      const Accuracy now = against<Exact>(group, precision);
      if (precision > digits) {
        const bool same = std::abs(now.error - before.error) <= 1e-3 * std::max(now.error, 1e-3);
        if (same || precision > 64 * digits) return now;
      }
      before = now;
    }
  }

  template <class Exact>
  Accuracy against(std::size_t group, int digits) {
    const WorkingDigits precision(digits);
    const OwnKernel& own = kernels_[groups_[group].kernel];
    Evaluator<Exact> exact(own.equations->program(), symbol_values<Exact>(Exact::pi(), [this](const SymbolPointer& symbol) {
                             return Exact::from_double(state_->value(symbol));
                           }));
    if (own.kernel.series) {
      const std::vector<Exact> all = from_order_one(taylor_coefficients(*own.kernel.series, exact, jet_orders));
      return measure(group, [&](std::size_t i) { return all[i]; });
    }
    return measure(group, [&](std::size_t i) { return exact(own.kernel.assignments[i].value); });
  }

  static long double difference(Float computed, long double truth) { return computed - truth; }
  static long double difference(Float computed, const Real& truth) {
    return std::isfinite(computed) ? (Real::from_double(computed) - truth).to_double()
                                   : std::numeric_limits<long double>::infinity();
  }
  static long double difference(Float computed, const Ball& truth) {
    return std::isfinite(computed) ? (Ball::from_double(computed) - truth).largest()
                                   : std::numeric_limits<long double>::infinity();
  }
  static long double size(const Ball& truth) { return truth.largest(); }
  static long double size(long double truth) { return truth; }
  static long double size(const Real& truth) { return truth.to_double(); }

  template <class Truth>
  Accuracy measure(std::size_t index, const Truth& truth_of) {
    const OutputGroup& group = groups_[index];
    const Kernel& kernel = kernels_[group.kernel].kernel;
    KernelText<Running<Float>>& text = texts_[group.kernel];
    Accuracy result;
    const bool regular = text.is_regular([](const Running<Float>& pivot, const Running<Float>& diagonal) {
      return pivot.value() > std::numeric_limits<Float>::epsilon() * std::abs(diagonal.value());
    });
    if (!regular) return result;
    long double error = 0, norm = 0, bound = 0;
    std::vector<long double> squares;
    for (const std::size_t i : group.members) {
      const Running<Float> computed = text.results()[i];
      if (!kernel.pivots.empty() && !std::isfinite(computed.value())) return result;
      const auto truth = truth_of(i);
      if (!std::isfinite(size(truth))) {
        result.undefined = kernel.pivots.empty();
        return result;
      }
      const long double off = difference(computed.value(), truth);
      error += off * off;
      norm += size(truth) * size(truth);
      bound += static_cast<long double>(computed.bound()) * computed.bound();
      const Elasticity elasticity = (*conditions_[group.kernel])(i);
      const std::vector<long double>& moved_by = elasticity.slopes().by_input;
      squares.resize(std::max(squares.size(), moved_by.size()), 0);
      for (std::size_t j = 0; j < moved_by.size(); ++j) squares[j] += moved_by[j] * moved_by[j];
    }
    error = std::isnan(error) ? std::numeric_limits<long double>::infinity() : std::sqrt(error);
    norm = std::sqrt(norm);
    bound = std::sqrt(bound);
    long double moved = 0;
    for (const long double square : squares) moved += std::sqrt(square);
    const long double unit = ulp<Float>(norm);
    // Where nothing is left of the results, the condition is infinite, but what they are made of has a size.
    const long double allowed = norm == 0 ? std::max(unit, moved * std::numeric_limits<Float>::epsilon())
                                          : unit * std::max(1.0L, moved / norm);
    // Neither an ulp nor a condition, 0/0: nothing is left but what `long double` or CLN make of zero.
    result.identically_zero = bound > 0 && norm < 0x1p-10L * bound && moved < 0x1p-10L * bound;
    if (result.identically_zero && error > 0 && error <= bound) return result;
    result.counted = true;
    result.error = static_cast<double>(error / unit);
    result.condition = norm == 0 && moved == 0 ? 1.0 : static_cast<double>(moved / norm);
    result.scaled = static_cast<double>(error / allowed);
    result.bound = static_cast<double>(bound / unit);
    result.potential = static_cast<double>(bound / allowed);
    return result;
  }

  std::vector<OwnKernel> kernels_;
  std::vector<OutputGroup> groups_;
  Conditions conditions_;                            ///< by kernel, and so the next
  std::vector<KernelText<Running<Float>>> texts_;
  std::vector<SymbolPointer> symbols_;
  std::vector<std::vector<SymbolPointer>> group_symbols_;
  const StressState* state_ = nullptr;
};

}  // namespace

std::unique_ptr<KernelAccuracy> kernel_accuracy(const Scene& scene, const ModelOptions& options,
                                                const std::vector<std::string>& kernels, Precision precision) {
  if (precision == Precision::in_float) return std::make_unique<AccuracyIn<float>>(scene, options, kernels);
  return std::make_unique<AccuracyIn<double>>(scene, options, kernels);
}

}  // namespace torsor
