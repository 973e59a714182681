// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/printing/reduced_equations.hpp"

#include <algorithm>

#include "torsor/generator/dynamics/derivatives/reduction.hpp"
#include "torsor/generator/dynamics/equations/constraint_sizes.hpp"
#include "torsor/generator/printing/written_at_state.hpp"
#include "torsor/generator/program/identically_zero.hpp"

namespace torsor::printing {
namespace {

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
  WrittenAtState write(scene, equations, limits, about);
  ReducedEquations result;
  result.coordinates = names(linear.freedoms.coordinates, false);
  result.velocities = names(linear.freedoms.velocities, true);
  result.M = write(linear.M);
  result.C = write(linear.C);
  result.K = write(linear.K);
  result.F = write(without_inputs(equations, linear.F, linear.E));
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
    WrittenAtState write(scene, equations, limits, about);
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
