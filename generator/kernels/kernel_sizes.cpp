// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/kernels/kernel_sizes.hpp"

#include "torsor/generator/kernels/kernel_parts.hpp"

namespace torsor {

Kernel make_sizes(const Equations& equations, const std::vector<SizeBound>& bounds) {
  std::vector<Value> values;
  for (const SizeBound& each : bounds) {
    for (const Expression& formula : each.formulas()) values.push_back(equations.program().lower(formula));
  }
  Kernel kernel;
  kernel.documentation = "Sizes that run-time parameters bear on, each with the number that it is compared with.";
  kernel.results = {{"", "sizes", values.size()}};
  assign_vector(kernel, {"sizes"}, values, values.size());
  return kernel;
}

}  // namespace torsor
