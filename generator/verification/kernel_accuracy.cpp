// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/verification/kernel_accuracy.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <fmt/format.h>

#include "generator/base/error.hpp"
#include "generator/emission/mechanism_listing.hpp"
#include "generator/listing/generation_constant.hpp"
#include "generator/listing/listing_evaluator.hpp"
#include "generator/program/evaluation.hpp"
#include "generator/program/series_evaluation.hpp"
#include "generator/verification/ball.hpp"
#include "generator/verification/running_error.hpp"
#include "generator/verification/sensitivity.hpp"

namespace torsor {
namespace {

std::vector<Kernel> present_kernels(const Equations& equations, const std::vector<std::string>& names) {
  std::vector<Kernel> kernels;
  for (const std::string& name : names) {
    Kernel kernel = make_kernel(name, equations);
    if (kernel.skipped.empty()) kernels.push_back(std::move(kernel));
  }
  return kernels;
}

/// Of mass[2]: "mass"
std::string result_name(const Target& target) { return Target{target.result, target.member}.to_string(); }

/// Coefficients of the orders 1 to jet_orders, one order after the other.
template <class Scalar>
std::vector<Scalar> coefficients(const SeriesResult& series, Evaluator<Scalar>& here) {
  std::vector<Scalar> all;
  SeriesEvaluation<Scalar> evaluation(series.program, series.state, here);
  if (const auto& solve = series.solve) {
    evaluation.solve_for(solve->unknowns, solve->start, solve->lower, solve->inverse_pivots);
  }
  const auto by_order = evaluation(jet_orders);
  for (std::size_t k = 1; k < by_order.size(); ++k) all.insert(all.end(), by_order[k].begin(), by_order[k].end());
  return all;
}

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

std::vector<OutputGroup> groups_of(const std::vector<Kernel>& kernels) {
  std::vector<OutputGroup> groups;
  for (std::size_t k = 0; k < kernels.size(); ++k) {
    std::vector<std::pair<std::string, Unit>> keys;
    const std::size_t first = groups.size();
    const std::vector<std::pair<std::string, Unit>> results = results_of(kernels[k]);
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

/// The same results with every parameter that has a name as a symbol: a program of its own, for derivatives. Numbers
/// that the scene gives without a name are parameters too; ± 1 is none, so that in 1 - cos x nothing but x is data.
class Conditions {
 public:
  Conditions(const Scene& scene, const ModelOptions& options, const std::vector<std::string>& names,
             const std::vector<Kernel>& emitted)
      : scene_(scene), equations_(scene, options), evaluate_(equations_.program(), {}) {
    evaluate_.set_constants([this](const Number& number) {
      const Elasticity constant = Elasticity::of_number(number);
      return number.abs().is_one() ? constant : elasticity_input(constant.value(), input_count_++);
    });
    std::map<std::pair<std::string, Target>, Value> values;
    std::vector<Kernel> known = present_kernels(equations_, names);
    for (std::size_t k = 0; k < std::min(known.size(), emitted.size()); ++k) {
      // Patterns and base parameters are those of the scene's values: elsewhere results may stand at other places.
      if (known[k].assignments.size() == emitted[k].assignments.size()) continue;
      throw Error(fmt::format("the kernel '{}' with parameters as symbols has other results", emitted[k].name));
    }
    for (Kernel& kernel : known) {
      for (const Assignment& a : kernel.assignments) values.emplace(std::pair(kernel.name, a.target), a.value);
      if (kernel.series) series_.emplace(kernel.name, std::move(*kernel.series));
    }
    for (const Kernel& kernel : emitted) {
      names_.push_back(kernel.name);
      values_.emplace_back();
      for (const Assignment& a : kernel.assignments) {
        const auto place = values.find({kernel.name, a.target});
        if (place == values.end()) {
          throw Error(fmt::format("the kernel '{}' with parameters as symbols has no '{}'", kernel.name, a.target.to_string()));
        }
        values_.back().push_back(equations_.program().bind(place->second));
      }
    }
  }

  void move_to(const StressState& state) {
    known_parameters_.clear();
    known_series_.clear();
    evaluate_.move_to(symbol_values<Elasticity>(Elasticity(3.14159265358979323846264338327950288L),
                                                [this, &state](const SymbolPointer& symbol) {
                                                  return elasticity_input(value(symbol, state), number(symbol));
                                                }));
  }

  /// Of one result of a kernel: an assignment, or a coefficient.
  Elasticity operator()(std::size_t kernel, std::size_t result) {
    const auto series = series_.find(names_[kernel]);
    if (series == series_.end()) return evaluate_(values_[kernel][result]);
    std::vector<Elasticity>& known = known_series_[kernel];
    if (known.empty()) known = coefficients(series->second, evaluate_);
    return known[result];
  }

 private:
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
      Evaluator<Elasticity> evaluate(
          formula, symbol_values<Elasticity>(
                       Elasticity(3.14159265358979323846264338327950288L),
                       [&](const SymbolPointer& inner) { return Elasticity(value(inner, state)); }));
      return known_parameters_[symbol.get()] = evaluate(formula.lower(*parameter.value)).value();
    }
    throw Error(fmt::format("no value for the symbol '{}' at a state of verify", symbol->name));
  }

  const Scene& scene_;
  Equations equations_;
  Evaluator<Elasticity> evaluate_;
  std::vector<std::string> names_;          ///< by kernel
  std::vector<std::vector<Value>> values_;  ///< by kernel and assignment
  std::map<std::string, SeriesResult> series_;
  std::map<std::size_t, std::vector<Elasticity>> known_series_;
  std::size_t input_count_ = 0;
  std::map<const Symbol*, std::size_t> numbers_;                // looked up only, and so the next one
  std::map<const Symbol*, long double> known_parameters_;
};

/// Some scenes are possible with the values of their parameters only (constraints that repeat others): their folded
/// parameters are among the plain numbers then.
std::unique_ptr<Conditions> make_conditions(const Scene& scene, ModelOptions options,
                                            const std::vector<std::string>& names, const std::vector<Kernel>& emitted) {
  if (!options.sensitive_to) {
    options.sensitive_to.emplace();
    for (const SymbolPointer& symbol : run_time_parameters(scene, options)) options.sensitive_to->insert(symbol->name);
  }
  const ModelOptions folded = options;
  options.all_run_time = true;
  try {
    return std::make_unique<Conditions>(scene, options, names, emitted);
  } catch (const Error&) {
    return std::make_unique<Conditions>(scene, folded, names, emitted);
  }
}

template <class Float>
class AccuracyIn final : public KernelAccuracy {
 public:
  AccuracyIn(const Scene& scene, const ModelOptions& options, const std::vector<std::string>& names) {
    for (OwnKernel& each : make_own_kernels(scene, options, names)) {
      const Layout layout = layout_of(*each.equations, run_time_parameters(scene, options));
      texts_.emplace_back(lower_kernel(each.equations->program(), each.kernel, layout), layout);
      equations_.push_back(std::move(each.equations));
      kernels_.push_back(std::move(each.kernel));
      prepare(kernels_.size() - 1);
    }
    time_ = scene.time().as_symbol();
    groups_ = groups_of(kernels_);
    conditions_ = make_conditions(scene, options, names, kernels_);
    for (const OutputGroup& group : groups_) {
      const Kernel& kernel = kernels_[group.kernel];
      Program& program = equations_[group.kernel]->program();
      std::vector<Value> values = kernel.series ? kernel.values() : std::vector<Value>();
      if (kernel.series) {
        for (const SymbolPointer& symbol : kernel.series->state) values.push_back(program.symbol(symbol));
      } else {
        for (const std::size_t i : group.members) values.push_back(kernel.assignments[i].value);
      }
      group_symbols_.emplace_back();
      for (const ValueNumber value_number : program.live(values)) {
        const SymbolPointer& symbol = program[value_number].symbol;
        if (symbol && symbol->kind != SymbolKind::pi) group_symbols_.back().push_back(symbol);
      }
    }
  }

  const std::vector<Kernel>& kernels() const override { return kernels_; }
  const std::vector<OutputGroup>& groups() const override { return groups_; }
  const std::vector<SymbolPointer>& symbols(std::size_t group) const override { return group_symbols_[group]; }
  const std::vector<SymbolPointer>& symbols() const override { return symbols_; }

  void move_to(const StressState& state) override {
    state_ = &state;
    for (Text& text : texts_) text.results.clear();
    conditions_->move_to(state);
  }

  std::vector<double> computed(std::size_t kernel) override {
    std::vector<double> values;
    const std::size_t count = results_of(kernels_[kernel]).size();
    for (std::size_t i = 0; i < count; ++i) values.push_back(static_cast<double>(computed_result(kernel, i).value()));
    return values;
  }

  Accuracy estimate(std::size_t group) override {
    return measure(group, [&](std::size_t kernel, std::size_t i) { return (*conditions_)(kernel, i).value(); });
  }

  Accuracy certify(std::size_t group, int digits) override {
    Accuracy result = settled<Real>(group, digits);
    if (!result.counted || !Ball::available()) return result;
    const Accuracy surely = settled<Ball>(group, digits);
    result.enclosed = surely.counted && surely.error <= result.error + 1e-3 * std::max(result.error, 1e-3);
    return result;
  }

 private:
  void prepare(std::size_t place) {
    Program& program = equations_[place]->program();
    Kernel& kernel = kernels_[place];
    // A definition of its own for each result: its formula is then made once and not at each state.
    for (Assignment& assignment : kernel.assignments) assignment.value = program.bind(assignment.value);
    for (auto& [pivot, diagonal] : kernel.pivots) pivot = program.bind(pivot), diagonal = program.bind(diagonal);
    std::vector<Value> all = kernel.values();
    if (kernel.series) {
      for (const SymbolPointer& symbol : kernel.series->state) all.push_back(program.symbol(symbol));
    }
    for (const ValueNumber value_number : program.live(all)) {
      const Definition& definition = program[value_number];
      const bool known = std::find(symbols_.begin(), symbols_.end(), definition.symbol) != symbols_.end();
      if (definition.symbol && definition.symbol->kind != SymbolKind::pi && !known) symbols_.push_back(definition.symbol);
    }
  }

  /// A kernel as it is emitted, and what it gives at the state.
  struct Text {
    Text(LoweredKernel lowered, Layout arguments)
        : layout(std::move(arguments)),
          kernel(std::make_unique<const LoweredKernel>(std::move(lowered))),
          once(kernel->once, numbers()),
          compute(kernel->listing, numbers()) {}
    Layout layout;
    std::unique_ptr<const LoweredKernel> kernel;
    ListingEvaluator<Running<Float>> once, compute;
    std::vector<Running<Float>> results{};  ///< none: not yet computed at this state
    bool regular = true;                    ///< as traits::regular of the header
  };

  const Text& text(std::size_t kernel) {
    Text& text = texts_[kernel];
    if (!text.results.empty()) return text;
    const auto argument = [&](Table table, std::size_t place) {
      const SymbolPointer symbol = table == Table::time ? time_ : text.layout.of(table)[place];
      return Running<Float>(static_cast<Float>(state_->value(symbol)));
    };
    text.once(argument);
    const auto with_precomputed = [&](Table table, std::size_t place) {
      return table == Table::precomputed ? text.once.outputs()[place] : argument(table, place);
    };
    text.compute(with_precomputed, jet_orders);
    if (text.kernel->listing.recurrence) {
      const auto& by_order = text.compute.coefficients();
      for (std::size_t k = 1; k < by_order.size(); ++k) {
        text.results.insert(text.results.end(), by_order[k].begin(), by_order[k].end());
      }
    } else {
      text.results = text.compute.outputs();
    }
    const auto& pivots = text.compute.pivots();
    text.regular = std::all_of(pivots.begin(), pivots.end(), [](const auto& each) {
      return each.first.value() > std::numeric_limits<Float>::epsilon() * std::abs(each.second.value());
    });
    return text;
  }

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

  Running<Float> computed_result(std::size_t kernel, std::size_t result) { return text(kernel).results[result]; }

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
    Evaluator<Exact> exact(equations_[groups_[group].kernel]->program(), symbol_values<Exact>(Exact::pi(), [this](const SymbolPointer& symbol) {
                             return Exact::from_double(state_->value(symbol));
                           }));
    const Kernel& kernel = kernels_[groups_[group].kernel];
    if (kernel.series) {
      const std::vector<Exact> all = coefficients(*kernel.series, exact);
      return measure(group, [&](std::size_t, std::size_t i) { return all[i]; });
    }
    return measure(group, [&](std::size_t, std::size_t i) { return exact(kernel.assignments[i].value); });
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
    const Kernel& kernel = kernels_[group.kernel];
    Accuracy result;
    if (!text(group.kernel).regular) return result;
    long double error = 0, norm = 0, bound = 0;
    std::vector<long double> squares;
    for (const std::size_t i : group.members) {
      const Running<Float> computed = computed_result(group.kernel, i);
      if (!kernel.pivots.empty() && !std::isfinite(computed.value())) return result;
      const auto truth = truth_of(group.kernel, i);
      if (!std::isfinite(size(truth))) {
        result.undefined = kernel.pivots.empty();
        return result;
      }
      const long double off = difference(computed.value(), truth);
      error += off * off;
      norm += size(truth) * size(truth);
      bound += static_cast<long double>(computed.bound()) * computed.bound();
      const Elasticity elasticity = (*conditions_)(group.kernel, i);
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

  std::vector<std::unique_ptr<const Equations>> equations_;  ///< by kernel, and so the next two
  std::vector<Kernel> kernels_;
  std::vector<Text> texts_;
  std::vector<OutputGroup> groups_;
  std::unique_ptr<Conditions> conditions_;
  std::vector<SymbolPointer> symbols_;
  std::vector<std::vector<SymbolPointer>> group_symbols_;
  SymbolPointer time_;
  const StressState* state_ = nullptr;
};

}  // namespace

std::unique_ptr<KernelAccuracy> kernel_accuracy(const Scene& scene, const ModelOptions& options,
                                                const std::vector<std::string>& kernels, Precision precision) {
  if (precision == Precision::in_float) return std::make_unique<AccuracyIn<float>>(scene, options, kernels);
  return std::make_unique<AccuracyIn<double>>(scene, options, kernels);
}

}  // namespace torsor
