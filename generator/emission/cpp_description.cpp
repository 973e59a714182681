// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/emission/cpp_description.hpp"

#include <fmt/format.h>

#include "generator/base/wrapped_line.hpp"
#include "generator/emission/description.hpp"
#include "generator/emission/formula_printer.hpp"

namespace torsor {
namespace {

std::string array(const std::string& type, const std::string& name, std::size_t size, const std::string& entries) {
  const std::string value = size == 0 ? "{}" : "{{" + entries + "}}";
  return wrapped(fmt::format("static constexpr std::array<torsor::{}, {}> {}{};", type, size, name, value), 2) + "\n";
}

void append(std::string& list, const std::string& entry) { list += (list.empty() ? "" : ", ") + entry; }

}  // namespace

std::string cpp_description(const MechanismListing& mechanism) {
  std::string text;
  for (const DescribedTable& described : described_tables) {
    std::string entries;
    const std::vector<NamedUnit> all = named_units(mechanism.layout.of(described.table));
    for (const auto& [name, unit] : all) append(entries, fmt::format("{{\"{}\", \"{}\"}}", name, unit));
    text += array("QuantityDescription", described.name, all.size(), entries);
  }
  std::string results, kernels;
  std::size_t count = 0;
  for (const KernelListing& given : mechanism.kernels) {
    const KernelSignature& kernel = given.kernel;
    const std::size_t first = count;
    for (const ResultShape& each : result_shapes(mechanism, given)) {
      append(results, fmt::format("{{\"{}\", \"{}\", {}, {}}}", each.result, each.member, each.rows, each.columns));
      ++count;
    }
    append(kernels, fmt::format("{{\"{}\", {}, {}, {}, {}, results.data() + {}, {}}}", kernel.name,
                                reads(kernel, Argument::accelerations), reads(kernel, Argument::multipliers),
                                reads(kernel, Argument::inputs), given.listing.has_status, first, count - first));
  }
  return text + array("ResultDescription", "results", count, results) +
         array("KernelDescription", "kernels", mechanism.kernels.size(), kernels);
}

std::string cpp_tables(const Structure& structure) {
  std::string text;
  for (const ConstantTable& table : structure.tables) {
    const bool number = std::holds_alternative<std::size_t>(table.value);
    const bool factors = std::holds_alternative<ConstantTable::Factors>(table.value);
    const std::string numbers = numbers_text(table);
    text += documentation_comment(table.documentation);
    if (numbers.empty()) continue;
    text += wrapped(fmt::format("static constexpr {} {}{};", factors ? "double" : "int", table.name,
                                number ? " = " + numbers : "[] = {" + numbers + "}"),
                    2) +
            "\n";
  }
  return text;
}

}  // namespace torsor
