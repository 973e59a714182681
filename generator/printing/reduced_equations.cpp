// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/printing/reduced_equations.hpp"

#include <algorithm>

#include "torsor/generator/dynamics/derivatives/reduction.hpp"
#include "torsor/generator/dynamics/equations/constraint_sizes.hpp"
#include "torsor/generator/program/identically_zero.hpp"

namespace torsor::printing {
namespace {

/// Values where the state is, written out; remembers whether one was too long.
class Writer {
 public:
  Writer(const Scene& scene, const Equations& equations, const InlineLimits& limits, const About& about)
      : program_(equations.program()),
        at_rest_(!about.empty()),
        at_(program_, [this](const SymbolPointer& symbol) { return value_of(symbol); }),
        view_(program_, limits, scene.content()) {
    for (const auto& [symbol, formula] : named_state(scene, about)) {
      state_.emplace_back(symbol, formula.is_zero() ? program_.number(Number(), symbol->unit) : program_.lower(formula));
    }
  }

  Sum operator()(const Value& value) {
    const Value there = too_long_ || value.is_zero() ? Value() : at_(value);
    if (there.is_zero()) return {};
    const std::optional<Sum> sum = view_.sum(there);
    too_long_ = !sum;
    return sum ? *sum : Sum();
  }
  std::vector<Sum> operator()(const std::vector<Value>& values) {
    std::vector<Sum> sums;
    for (const Value& value : values) sums.push_back((*this)(value));
    return sums;
  }
  SumMatrix operator()(const ValueMatrix& matrix) {
    SumMatrix sums;
    for (const std::vector<Value>& row : matrix) sums.push_back((*this)(row));
    return sums;
  }

  Value there(const Value& value) { return value.is_zero() ? Value() : at_(value); }

  bool too_long() const { return too_long_; }

 private:
  std::optional<Value> value_of(const SymbolPointer& symbol) const {
    for (const auto& [known, value] : state_) {
      if (known == symbol) return value;
    }
    const bool zero = symbol->kind == SymbolKind::acceleration || (at_rest_ && symbol->kind == SymbolKind::velocity);
    return zero ? std::optional<Value>(program_.number(Number(), symbol->unit)) : std::nullopt;
  }

  Program& program_;
  bool at_rest_;
  std::vector<std::pair<SymbolPointer, Value>> state_;
  Substitution at_;
  InlineView view_;
  bool too_long_ = false;
};

bool is_unit(const Sum& sum) { return compare(sum, Sum(Number(1))) == 0; }

}  // namespace

std::size_t ReducedEquations::terms() const {
  std::size_t count = 0;
  for (const Sum& sum : F) count += written_terms(sum);
  for (const SumMatrix* matrix : {&M, &C, &K, &E, &D, &N}) {
    for (const auto& row : *matrix) {
      for (const Sum& sum : row) count += written_terms(sum);
    }
  }
  return count;
}

bool ReducedEquations::rates_are_velocities() const {
  if (coordinates != velocities) return false;
  for (std::size_t i = 0; i < N.size(); ++i) {
    for (std::size_t j = 0; j < N.size(); ++j) {
      if (!D[i][j].is_zero() || (i == j ? !is_unit(N[i][j]) : !N[i][j].is_zero())) return false;
    }
  }
  return true;
}

std::optional<ReducedEquations> reduced_equations(const Scene& scene, const InlineLimits& limits, const About& about) {
  ModelOptions options;
  options.symbolic_parameters = true;
  const Equations equations(scene, options);
  const ReducedLinearisation linear = reduced_linearisation(equations);
  if (linear.freedoms.velocities.empty()) return ReducedEquations{};
  const auto names = [&](const std::vector<std::size_t>& freedoms, bool rates) {
    std::vector<std::string> list;
    for (const std::size_t i : freedoms) {
      const CoordinateContent& c = equations.model().coordinates()[i];
      list.push_back(rates && c.attitude ? c.v->name : c.q->name);
    }
    return list;
  };
  Writer write(scene, equations, limits, about);
  ReducedEquations result;
  result.coordinates = names(linear.freedoms.coordinates, false);
  result.velocities = names(linear.freedoms.velocities, true);
  result.M = write(linear.M);
  result.C = write(linear.C);
  result.K = write(linear.K);
  const std::vector<SymbolPointer> inputs = equations.model().inputs();
  for (std::size_t i = 0; i < linear.F.size(); ++i) {  // that of the program has the inputs of the state in it
    Value force = linear.F[i];
    for (std::size_t k = 0; k < inputs.size(); ++k) {
      if (!linear.E[i][k].is_zero()) force -= linear.E[i][k] * equations.program().symbol(inputs[k]);
    }
    result.F.push_back(write(force));
  }
  result.E = write(linear.E);
  result.D = write(linear.e_rates_e);
  result.N = write(linear.e_rates_w);
  if (write.too_long()) return std::nullopt;
  return result;
}

std::vector<ConstraintLeft> constraints_left(const Scene& scene, const InlineLimits& limits, const About& about) {
  ModelOptions options;
  options.symbolic_parameters = true;
  const Equations equations(scene, options);
  const ConstraintSizes sizes = constraint_sizes(equations.model(), equations.constraints());
  std::vector<ConstraintLeft> all;
  const auto add = [&](const std::string& name, bool rate, const Value& value, const Real& size) {
    Writer write(scene, equations, limits, about);
    const Value left = write.there(value);
    if (identically_zero(left)) return;
    // A state that is given in decimals fulfils it to as many digits.
    if (left.is_constant() && abs(Real(left.polynomial().constant(), Real::working_digits())) <= Real::from_double(1e-9) * size) return;
    const Sum sum = write(value);
    all.push_back({name, rate, write.too_long() ? std::nullopt : std::optional<Sum>(sum), !left.is_constant()});
  };
  for (std::size_t j = 0; j < equations.constraints().size(); ++j) {
    const ConstraintRow& row = equations.constraints()[j];
    if (row.holonomic) add(row.name, false, row.value, sizes.size[j]);
    add(row.name, true, row.rate, sizes.size[j]);
  }
  return all;
}

}  // namespace torsor::printing
