// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/emission/cpp_description.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "torsor/generator/base/wrapped_line.hpp"
#include "torsor/generator/emission/description.hpp"
#include "torsor/generator/emission/formula_printer.hpp"

namespace torsor {
namespace {

std::string array(const std::string& type, const std::string& name, const std::vector<std::string>& entries) {
  const std::string value = entries.empty() ? "{}" : fmt::format("{{{{{}}}}}", fmt::join(entries, ", "));
  return wrapped(fmt::format("static constexpr std::array<torsor::{}, {}> {}{};", type, entries.size(), name, value), 2) +
         "\n";
}

}  // namespace

std::string cpp_description(const MechanismListing& mechanism) {
  std::string text;
  for (const DescribedTable& described : described_tables) {
    text += array("QuantityDescription", described.name, quantity_entries(mechanism.layout.of(described.table)));
  }
  const KernelEntries entries = kernel_entries(mechanism, "results.data()", {"false", "true"});
  return text + array("ResultDescription", "results", entries.results) +
         array("KernelDescription", "kernels", entries.kernels);
}

std::string cpp_tables(const Structure& structure) {
  std::string text;
  for (const ConstantTable& table : structure.tables) {
    const bool number = std::holds_alternative<std::size_t>(table.value);
    const bool factors = std::holds_alternative<ConstantTable::Factors>(table.value);
    const std::string numbers = numbers_text(table);
    text += documentation_comment(table.documentation);
    if (numbers.empty()) continue;
    // With its length: clang 14 reads no element of an array without one in a constant expression of a template.
    const auto length = std::count(numbers.begin(), numbers.end(), ',') + 1;
    text += wrapped(fmt::format("static constexpr {} {}{};", factors ? "double" : "int", table.name,
                                number ? " = " + numbers : fmt::format("[{}] = {{{}}}", length, numbers)),
                    2) +
            "\n";
  }
  return text;
}

}  // namespace torsor
