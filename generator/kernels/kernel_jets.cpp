// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/kernels/kernel_jets.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "torsor/generator/program/derivative.hpp"
#include "torsor/generator/program/identically_zero.hpp"

namespace torsor {

namespace {

// Relative to one convolution: a term of the solve, and an operation that is done with and without the accelerations.
constexpr double cost_of_term = 0.12, cost_of_second_pass = 0.25;

/// The accelerations as unknowns of the inverse dynamics; none where these are not linear in them (always: without
/// constraints) or cost more than the forward dynamics.
std::optional<SeriesResult> by_inverse_dynamics(const Equations& equations, const std::vector<SymbolPointer>& state,
                                                const std::vector<Value>& rates, int convolutions) {
  if (!equations.constraints().empty() || equations.differentiates_squares()) return std::nullopt;
  Program& program = equations.program();
  const ForwardSolution& solution = equations.forward();
  const std::size_t n = solution.accelerations.size();
  SeriesSolve solve;
  for (std::size_t i = 0; i < n; ++i) solve.unknowns.push_back(equations.model().coordinates()[i].a);
  std::vector<Value> outputs(rates.begin(), rates.end() - static_cast<std::ptrdiff_t>(n));
  const std::vector<Value> forces = equations.inverse_dynamics();
  const std::vector<Value> inputs = equations.of_inputs();
  for (std::size_t i = 0; i < n; ++i) outputs.push_back(program.bind(forces[i] - inputs[i]));
  SeriesResult result{SeriesProgram(program, outputs), state, {}};
  const std::vector<bool> with_unknowns = result.program.depending_on(solve.unknowns);
  if (!result.program.linear_in(with_unknowns)) return std::nullopt;
  const double twice = static_cast<double>(std::count(with_unknowns.begin(), with_unknowns.end(), true));
  const double cost = result.program.nonlinear_count() + cost_of_term * static_cast<double>(n * n) +
                      cost_of_second_pass * twice;
  if (cost >= convolutions) return std::nullopt;
  solve.start = solution.accelerations;
  const Factorisation factors(program, equations.mass());
  solve.lower = factors.lower();
  solve.inverse_pivots = factors.inverse_pivots();
  result.solve = std::move(solve);
  return result;
}

}  // namespace

std::string no_jets(const Equations& equations) {
  return equations.model().positions().empty() && equations.model().unknown_count() == 0 ? "nothing moves" : "";
}

Kernel make_jets(const Equations& equations) {
  Kernel kernel;
  const Model& model = equations.model();
  std::vector<SymbolPointer> state = model.positions();
  std::vector<Value> rates;
  for (const SymbolPointer& position : state) rates.push_back(rate_of(equations.program(), position));
  const ForwardSolution& solution = equations.forward();
  for (std::size_t i = 0; i < solution.accelerations.size(); ++i) {
    state.push_back(model.coordinates()[i].v);
    rates.push_back(solution.accelerations[i]);
  }
  clear_identically_zero(rates);
  kernel.arguments = {Argument::inputs};
  kernel.pivots = solution.pivots;
  kernel.series = SeriesResult{SeriesProgram(equations.program(), rates), state, {}};
  auto other = by_inverse_dynamics(equations, state, rates, kernel.series->program.nonlinear_count());
  if (other) kernel.series = std::move(other);
  kernel.documentation = fmt::format(
      "Taylor coefficients of the motion: coefficients[k] = y^(k)/k! for k = 0..order, 1 <= order <= 30, y positions\n"
      "then velocities, the inputs being constant. {} operations take a convolution at each order{}.\n"
      "Returns singular where forward_dynamics does.",
      kernel.series->program.nonlinear_count(),
      kernel.series->solve ? "; accelerations\nare solved for, in the inverse dynamics, by the factors of M at the start" : "");
  return kernel;
}

}  // namespace torsor
