// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/verification/check_kernels.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "generator/emission/kernel.hpp"
#include "generator/verification/dense_linear.hpp"
#include "generator/verification/random_state.hpp"

namespace torsor {
namespace {

/// Condition number ‖M‖₁ ‖M⁻¹‖₁ of M scaled to a unit diagonal, so that units do not matter.
double scaled_condition(const std::vector<std::vector<Real>>& m) {
  const std::size_t n = m.size();
  std::vector<Real> scaled(n * n);
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t i = 0; i < n; ++i) scaled[i + j * n] = m[i][j] / sqrt(m[i][i] * m[j][j]);
  }
  const LuFactorisation lu(scaled, static_cast<int>(n));
  double norm = 0;
  double inverse_norm = 0;
  for (std::size_t j = 0; j < n; ++j) {
    std::vector<Real> unit(n, Real(0));
    unit[j] = Real(1);
    double column = 0;
    double inverse_column = 0;
    const std::vector<Real> solution = lu.solve(unit);
    for (std::size_t i = 0; i < n; ++i) {
      column += std::abs(scaled[i + j * n].to_double());
      inverse_column += std::abs(solution[i].to_double());
    }
    norm = std::max(norm, column);
    inverse_norm = std::max(inverse_norm, inverse_column);
  }
  return norm * inverse_norm;
}

/// Largest ratio of what a pivot is compared with to the pivot: a random state may determine the dependent freedoms
/// badly, and the equations reduced there divide by the pivots' roots more than once.
double smallest_pivot_costs(const Kernel& kernel, Evaluator<Real>& exact) {
  double largest = 1;
  for (const auto& [pivot, compared] : kernel.pivots) {
    largest = std::max(largest, std::abs((exact(compared) / exact(pivot)).to_double()));
  }
  return largest;
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

/// The same state with every number moved by a relative 2⁻³⁰, up or down in turn of the symbols' order. What a result
/// then moves by, times 2³⁰, has the size of the terms it is the sum of, even where they cancel.
Evaluator<Real>::SymbolValue nearby(const RandomState& state) {
  return [value = state.in_real()](const SymbolPointer& symbol) {
    const Real shift = Real(1) / Real(1 << 30);
    return value(symbol) * (symbol->index % 2 == 0 ? Real(1) + shift : Real(1) - shift);
  };
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
  const ValueMatrix& mass = equations.mass();
  Evaluator<double> fast(program, {});
  Evaluator<Real> exact(program, {});
  Evaluator<Real> beside(program, {});
  for (int k = 0; k < options.states; ++k) {
    const RandomState state(scene, static_cast<std::uint64_t>(k) + 1);
    fast.move_to(state.in_double());
    exact.move_to(state.in_real());
    beside.move_to(nearby(state));
    std::vector<std::vector<Real>> m;
    for (const auto& row : mass) m.push_back(exact(row));
    const double condition = scaled_condition(m);
    for (std::size_t i = 0; i < kernels.size(); ++i) {
      const Kernel& kernel = kernels[i];
      // Solves lose what the condition of M costs: 1e-14 cond(M), expressed against the common bound of 1e-13.
      double allowance = kernel.pivots.empty() ? 1 : std::max(1.0, condition / 10);
      // Constraints are solved for too: the pivots of A M⁻¹ Aᵀ tell what that costs at this state. It is a second solve,
      // of an array that is off by what the first costs: both multiply.
      const bool constrained = kernel.name == "forward_dynamics" && !equations.constraints().empty();
      if (constrained) allowance *= smallest_pivot_costs(kernel, exact);
      if (kernel.name == "linearisation") allowance = std::max(allowance, smallest_pivot_costs(kernel, exact) / 10);
      for (const auto& group : groups_by_unit(kernel)) {
        double difference = 0;
        double size = 0, moved = 0;
        for (const std::size_t index : group) {
          const Value& value = kernel.assignments[index].value;
          const Real truth = exact(value);
          const double error = (Real::from_double(fast(value)) - truth).to_double();
          difference += error * error;
          size += truth.to_double() * truth.to_double();
          const double move = (beside(value) - truth).to_double() * (1 << 30);
          moved += move * move;
        }
        const double relative = difference == 0 ? 0 : std::sqrt(difference / std::max(size, moved)) / allowance;
        if (!(relative <= worst[i])) worst[i] = relative;
      }
    }
  }
  std::vector<CheckResult> results;
  for (std::size_t i = 0; i < kernels.size(); ++i) {
    const bool solves = !kernels[i].pivots.empty();
    results.push_back({"double." + kernels[i].name,
                       solves ? "double against CLN, as a multiple of max(1, cond(M)/10)" : "double against CLN",
                       worst[i], 1e-13});
  }
  return results;
}

}  // namespace torsor
