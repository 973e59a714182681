// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/kernels/kernel_sizes.hpp"

#include <fmt/format.h>

#include "torsor/generator/kernels/kernel_parts.hpp"

namespace torsor {
namespace {

/// As a literal of C. Names of joints may have any letters.
std::string literal_text(const std::string& text) {
  std::string literal = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') literal += '\\';
    literal += c == SizeBound::number ? "\\001" : std::string(1, c == '%' ? '_' : c);
  }
  return literal + "\"";
}

}  // namespace

Kernel make_sizes(const Equations& equations, const std::vector<SizeBound>& bounds) {
  std::vector<Value> values;
  for (const SizeBound& each : bounds) {
    values.push_back(equations.program().lower(each.value));
    values.push_back(equations.program().lower(each.bound));
  }
  Kernel kernel;
  kernel.documentation = "Sizes that run-time parameters bear on, each with the number that it is compared with.";
  kernel.results = {{"", "sizes", values.size()}};
  assign_vector(kernel, {"sizes"}, values, values.size());
  return kernel;
}

std::string size_table(const std::vector<SizeBound>& bounds) {
  std::string entries;
  for (const SizeBound& each : bounds) {
    entries += fmt::format("{}\n    {{{}, {}}}", entries.empty() ? "" : ",", static_cast<int>(each.relation),
                           literal_text(each.said));
  }
  return entries;
}

}  // namespace torsor
