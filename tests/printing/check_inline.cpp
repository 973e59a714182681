// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/printing/check_inline.hpp"

#include <map>
#include <random>

#include "torsor/generator/dynamics/equations/validation.hpp"
#include "torsor/generator/printing/lagrange_equations.hpp"
#include "torsor/generator/printing/written.hpp"
#include "torsor/generator/program/evaluation.hpp"
#include "torsor/generator/program/generic_state.hpp"

namespace torsor::test {
namespace {

using printing::Written;

/// Values of symbols by name, drawn when first asked for: names are unique in a scene.
class RandomState {
 public:
  RandomState(std::uint64_t seed, int digits) : engine_(seed), digits_(digits) {}

  Real operator()(const SymbolPointer& symbol) {
    return at_unit_quaternions(symbol, [this](const SymbolPointer& each) { return number_of(each); });
  }

  /// The value of a name that stands for a formula.
  void set(const std::string& name, const Real& value) { values_.emplace(name, value); }

 private:
  Real number_of(const SymbolPointer& symbol) {
    const auto known = values_.find(symbol->name);
    if (known != values_.end()) return known->second;
    return values_.emplace(symbol->name, draw(symbol->kind == SymbolKind::parameter)).first->second;
  }

  /// Parameters between 1/2 and 3/2, everything else between -1 and 1.
  Real draw(bool positive) {
    constexpr long scale = 1L << 30;
    const long drawn = static_cast<long>(engine_() >> 34U);  // below 2^30
    const Number value =
        positive ? Number::rational(drawn + scale / 2, scale) : Number::rational(2 * drawn - scale, scale);
    return Real(value, digits_);
  }

  std::mt19937_64 engine_;
  int digits_;
  std::map<std::string, Real> values_;
};

struct Comparison {
  std::string name;
  Written left, right;  ///< printed: left − right
  Value value;          ///< of the program
};

std::vector<Comparison> comparisons(printing::LagrangeEquations& printed) {
  const auto& definitions = printed.definitions();
  std::vector<Comparison> all;
  all.push_back({"T", collected(*printed.kinetic_energy().sum), {}, printed.kinetic_energy().value});
  all.push_back({"U", collected_around(*printed.force_function().sum, energy_pieces(printed.stretches(), 1), printed.view()), {},
                 printed.force_function().value});
  const std::vector<SymbolPointer> inputs = definitions.model().inputs();
  for (std::size_t i = 0; i < printed.equations().size(); ++i) {
    const printing::LagrangeEquation& equation = printed.equations()[i];
    Value residual = definitions.inverse_dynamics()[i];
    for (std::size_t k = 0; k < inputs.size(); ++k) {
      const Value& arm = definitions.actions().inputs[k][i];
      if (!arm.is_zero()) residual -= arm * definitions.program().symbol(inputs[k]);
    }
    all.push_back({equation.coordinate.q->name, collected(*equation.inertia.sum, {equation.coordinate.a}),
                   collected_around(*equation.force.sum, force_pieces(printed.stretches(), i), printed.view()), residual});
  }
  for (const printing::ConstraintEquation& constraint : printed.constraints()) {
    if (constraint.left.sum) {
      all.push_back({constraint.name, collected(*constraint.left.sum), {}, constraint.left.value});
    }
  }
  return all;
}

}  // namespace

InlineCheck check_inline(const Scene& scene, int digits, int states, std::uint64_t seed) {
  validate(scene);
  const WorkingDigits precision(digits);
  printing::LagrangeEquations printed(scene, {});
  InlineCheck result;
  result.worst = Real(Number(0), digits);
  result.written_out = printed.written_out() && printed.kinetic_energy().sum && printed.force_function().sum;
  if (!result.written_out) return result;
  const std::vector<Comparison> all = comparisons(printed);
  for (const Comparison& comparison : all) result.compared.push_back(comparison.name);
  for (; result.states < states; ++result.states) {
    RandomState state(seed + static_cast<std::uint64_t>(result.states), digits);
    const auto value_of = [&state](const SymbolPointer& symbol) { return state(symbol); };
    for (const auto& [product, sum] : printed.named_products()) {
      state.set(product.symbol->name, evaluate(collected(sum), value_of, digits));
    }
    for (const CoordinateContent& coordinate : scene.content().coordinates) {  // driven ones have their names
      for (const SymbolPointer& name : {coordinate.q, coordinate.v, coordinate.a}) {
        const auto law = printed.view().law(name);
        if (law) state.set(name->name, evaluate(collected(*law), value_of, digits));
      }
    }
    Evaluator<Real> program(printed.definitions().program(), value_of);
    for (const Comparison& comparison : all) {
      const Real left = evaluate(comparison.left, value_of, digits);
      const Real right = evaluate(comparison.right, value_of, digits);
      const Real expected = program(comparison.value);
      Real scale = Real(Number(1), digits);
      for (const Real& size : {abs(left), abs(right), abs(expected)}) {
        if (size > scale) scale = size;
      }
      const Real difference = abs(left - right - expected) / scale;
      if (difference <= result.worst) continue;  // NaN is worse than anything
      result.worst = difference;
      result.worst_of = comparison.name;
    }
  }
  return result;
}

}  // namespace torsor::test
