// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/verification/check_kernels.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "generator/emission/kernel.hpp"
#include "generator/verification/dense_linear.hpp"
#include "generator/verification/random_state.hpp"
#include "generator/verification/sensitivity.hpp"

namespace torsor {
namespace {

using RealMatrix = std::vector<std::vector<Real>>;

/// ‖M‖₁ ‖M⁻¹‖₁.
double condition_number(const RealMatrix& m) {
  const std::size_t n = m.size();
  std::vector<Real> entries(n * n);
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t i = 0; i < n; ++i) entries[i + j * n] = m[i][j];
  }
  const LuFactorisation lu(entries, static_cast<int>(n));
  double norm = 0;
  double inverse_norm = 0;
  for (std::size_t j = 0; j < n; ++j) {
    std::vector<Real> unit(n, Real(0));
    unit[j] = Real(1);
    double column = 0;
    double inverse_column = 0;
    const std::vector<Real> solution = lu.solve(unit);
    for (std::size_t i = 0; i < n; ++i) {
      column += std::abs(entries[i + j * n].to_double());
      inverse_column += std::abs(solution[i].to_double());
    }
    norm = std::max(norm, column);
    inverse_norm = std::max(inverse_norm, inverse_column);
  }
  return norm * inverse_norm;
}

/// The matrix that forward dynamics solves with, [M  B; A  0] of the constraints that are kept, M scaled to a unit
/// diagonal, each row of A then and each column of B to the length 1, so that units do not matter.
RealMatrix scaled_matrix(const Equations& equations, Evaluator<Real>& exact) {
  const ValueMatrix& mass = equations.mass();
  const std::size_t n = mass.size();
  const std::vector<std::size_t> kept =
      equations.constraints().empty() ? std::vector<std::size_t>{} : equations.redundancy().kept;
  RealMatrix all(n + kept.size(), std::vector<Real>(n + kept.size(), Real(0)));
  std::vector<Real> root(n);
  for (std::size_t i = 0; i < n; ++i) root[i] = sqrt(exact(mass[i][i]));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) all[i][j] = exact(mass[i][j]) / (root[i] * root[j]);
  }
  const auto scaled = [&](const std::vector<Value>& row) {
    std::vector<Real> result(n);
    Real square(0);
    for (std::size_t i = 0; i < n; ++i) {
      result[i] = exact(row[i]) / root[i];
      square += result[i] * result[i];
    }
    for (Real& entry : result) entry = entry / sqrt(square);
    return result;
  };
  for (std::size_t k = 0; k < kept.size(); ++k) {
    const ConstraintRow& constraint = equations.constraints()[kept[k]];
    const std::vector<Real> row = scaled(constraint.jacobian);
    const std::vector<Real> column = scaled(constraint.column);
    for (std::size_t i = 0; i < n; ++i) {
      all[n + k][i] = row[i];
      all[i][n + k] = column[i];
    }
  }
  return all;
}

/// Indices of a kernel's assignments gathered by unit: numbers of different units have no common norm.
std::vector<std::vector<std::size_t>> groups_by_unit(const Kernel& kernel) {
  std::vector<std::pair<Unit, std::vector<std::size_t>>> groups;
  for (std::size_t i = 0; i < kernel.assignments.size(); ++i) {
    const Value& value = kernel.assignments[i].value;
    if (value.is_zero()) continue;
    auto place = std::find_if(groups.begin(), groups.end(), [&](const auto& g) { return g.first == value.unit(); });
    if (place == groups.end()) place = groups.insert(groups.end(), {value.unit(), {}});
    place->second.push_back(i);
  }
  std::vector<std::vector<std::size_t>> result;
  for (auto& [unit, members] : groups) result.push_back(std::move(members));
  return result;
}

Evaluator<Sensitivity>::SymbolValue with_sensitivity(const RandomState& state) {
  return [value = state.in_double()](const SymbolPointer& symbol) {
    return Sensitivity::input(value(symbol), static_cast<std::uint64_t>(symbol->index));
  };
}

/// |double - exact| of the assignments of one unit, relative to their norm. Where that is above `enough` the terms of
/// the result may cancel, or a solve be nearly singular at this state: the error is then compared with what as large an
/// error of the inputs would do, if that is larger.
double relative_error(const Kernel& kernel, const std::vector<std::size_t>& group, Evaluator<double>& fast,
                      Evaluator<Real>& exact, Evaluator<Sensitivity>& sensitive, double enough) {
  double difference = 0;
  double size = 0;
  for (const std::size_t index : group) {
    const Value& value = kernel.assignments[index].value;
    const Real truth = exact(value);
    const double error = (Real::from_double(fast(value)) - truth).to_double();
    difference += error * error;
    size += truth.to_double() * truth.to_double();
  }
  if (difference == 0) return 0;
  const double relative = std::sqrt(difference / size);
  if (relative <= enough) return relative;
  double moved = 0;
  for (const std::size_t index : group) moved += sensitive(kernel.assignments[index].value).mean_square();
  return std::min(relative, std::sqrt(difference / moved));
}

}  // namespace

std::vector<CheckResult> check_kernels(const Scene& scene, const CheckOptions& options) {
  const WorkingDigits precision(options.digits + 10);
  const Equations equations(scene);
  std::vector<Kernel> kernels;
  for (const std::string& name : kernel_names()) {
    Kernel kernel = make_kernel(name, equations);
    if (kernel.skipped.empty()) kernels.push_back(std::move(kernel));
  }
  std::vector<double> worst(kernels.size(), 0);
  const Program& program = equations.program();
  Evaluator<double> fast(program, {});
  Evaluator<Real> exact(program, {});
  Evaluator<Sensitivity> sensitive(program, {});
  for (int k = 0; k < options.states; ++k) {
    const RandomState state(scene, static_cast<std::uint64_t>(k) + 1);
    fast.move_to(state.in_double());
    exact.move_to(state.in_real());
    sensitive.move_to(with_sensitivity(state));
    const double condition = condition_number(scaled_matrix(equations, exact));
    for (std::size_t i = 0; i < kernels.size(); ++i) {
      const Kernel& kernel = kernels[i];
      // Solves lose what the condition of their matrix costs: 1e-14 of it, expressed against the common bound of 1e-13.
      const double allowance = kernel.pivots.empty() ? 1 : std::max(1.0, condition / 10);
      for (const auto& group : groups_by_unit(kernel)) {
        const double relative = relative_error(kernel, group, fast, exact, sensitive, allowance * worst[i]) / allowance;
        if (!(relative <= worst[i])) worst[i] = relative;
      }
    }
  }
  std::vector<CheckResult> results;
  for (std::size_t i = 0; i < kernels.size(); ++i) {
    const bool solves = !kernels[i].pivots.empty();
    results.push_back({"double." + kernels[i].name,
                       solves ? "double against CLN, as a multiple of max(1, condition/10)" : "double against CLN",
                       worst[i], 1e-13});
  }
  return results;
}

}  // namespace torsor
