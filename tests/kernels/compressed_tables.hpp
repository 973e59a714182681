// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string>
#include <variant>
#include <vector>

#include "torsor/generator/kernels/kernel.hpp"

namespace torsor::testing_headers {

/// The value of the constant of this name; nothing that any has if there is none.
inline std::variant<std::size_t, ConstantTable::Indices, ConstantTable::Factors> constant(
    const std::vector<ConstantTable>& tables, const std::string& name) {
  const auto place =
      std::find_if(tables.begin(), tables.end(), [&name](const ConstantTable& each) { return each.name == name; });
  if (place == tables.end()) return ConstantTable::Factors{-12345.0};
  return place->value;
}

/// Numbers of a table of indices; none if there is no such table.
inline std::vector<std::size_t> numbers(const std::vector<ConstantTable>& tables, const std::string& name) {
  const auto value = constant(tables, name);
  const auto* const indices = std::get_if<ConstantTable::Indices>(&value);
  return indices == nullptr ? std::vector<std::size_t>{} : *indices;
}

}  // namespace torsor::testing_headers
