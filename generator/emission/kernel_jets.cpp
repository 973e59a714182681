// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/emission/kernel_jets.hpp"

#include <fmt/format.h>

#include "generator/expression/derivative.hpp"
#include "generator/expression/evaluation.hpp"

namespace torsor {

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
  if (state.empty()) {
    kernel.skipped = "nothing moves";
    return kernel;
  }
  const std::vector<bool> zero = vanish(rates);
  for (std::size_t i = 0; i < rates.size(); ++i) {
    if (zero[i]) rates[i] = Value();
  }
  kernel.arguments = {Argument::inputs};
  kernel.pivots = solution.pivots;
  kernel.series = SeriesResult{SeriesProgram(equations.program(), rates), std::move(state)};
  kernel.documentation = fmt::format(
      "Taylor coefficients of the motion: coefficients[k] = y^(k)/k! for k = 0..order, 1 <= order <= 30, y positions\n"
      "then velocities, the inputs being constant. {} operations take a convolution at each order.\n"
      "Returns singular where forward_dynamics does.",
      kernel.series->program.nonlinear_count());
  return kernel;
}

}  // namespace torsor
