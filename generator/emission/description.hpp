// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "torsor/generator/emission/mechanism_listing.hpp"

namespace torsor {

// What a generated text says of itself: what the vectors hold, and what kernels read and write.

/// A symbol as a generated text calls it, and its unit as a person writes it.
struct NamedUnit {
  std::string name, unit;
};
std::vector<NamedUnit> named_units(const std::vector<SymbolPointer>& symbols);

/// Tables of a layout that generated texts describe, each with the name of its list.
struct DescribedTable {
  Table table;
  const char* name;
};
inline constexpr DescribedTable described_tables[] = {{Table::coordinate, "coordinates"},
                                                      {Table::velocity, "velocities"},
                                                      {Table::input, "inputs"},
                                                      {Table::multiplier, "multipliers"},
                                                      {Table::parameter, "parameters"}};

/// Numbers that a kernel writes, rows x columns of them column by column: a result, or a member of it. Without columns:
/// one for each order that is asked for.
struct DescribedResult {
  std::string result, member;
  std::size_t rows = 1, columns = 1;
  int dimensions = 1;  ///< 0: a number, 1: a vector, 2: a matrix
  std::string unit{};  ///< of all entries that are not always zero; of each entry of a vector where they differ: "m, rad"
};
std::vector<DescribedResult> described_results(const MechanismListing& mechanism, const KernelListing& kernel);

bool reads(const KernelSignature& kernel, Argument argument);

/// Entries of tables as C and C++ initialise them: {"theta", "rad"} for each symbol.
std::vector<std::string> quantity_entries(const std::vector<SymbolPointer>& symbols);

/// The same of every result, and of every kernel with its place among them: `results` is the first. What a kernel reads
/// and whether it has a status are `words[false]` and `words[true]`.
struct KernelEntries {
  std::vector<std::string> results, kernels;
};
KernelEntries kernel_entries(const MechanismListing& mechanism, const std::string& results, const char* const (&words)[2]);

/// Whether all members of the structure are numbers of one vector, which has names and units of its own.
bool is_vector(const MechanismListing& mechanism, const Structure& structure);

/// [{"name": "theta", "unit": "rad"}, ...]
nlohmann::ordered_json quantities_json(const std::vector<SymbolPointer>& symbols);

/// Of each kernel its name, its arguments behind the state, whether it returns a status, and its results: of an array
/// its size and shape, of a structure its members with where each begins and its shape.
nlohmann::ordered_json kernels_json(const MechanismListing& mechanism);

/// A JSON list as text, an entry on each line.
std::string lines_of(const nlohmann::ordered_json& list);

/// Places in q of the first components (w) of the unit quaternions.
std::vector<std::size_t> quaternion_places(const MechanismListing& mechanism);

/// What an argument is called.
const char* name_of(Argument argument);

/// Text of several lines behind `///`.
std::string documentation_comment(const std::string& documentation);

/// A list of numbers as all languages have them: "1, 2, 3".
std::string numbers_text(const ConstantTable& table);

}  // namespace torsor
