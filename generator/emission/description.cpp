// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/emission/description.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "torsor/generator/base/comment_text.hpp"
#include "torsor/generator/emission/javascript_language.hpp"
#include "torsor/generator/listing/local_names.hpp"
#include "torsor/generator/program/written_unit.hpp"

namespace torsor {
namespace {

using Json = nlohmann::ordered_json;

Json result_json(const MechanismListing& mechanism, const Result& result, const std::vector<DescribedResult>& described) {
  const Structure* const structure = mechanism.structure(result.structure);
  const auto unit = [&](const std::string& member) {
    return std::find_if(described.begin(), described.end(), [&](const DescribedResult& each) {
             return each.result == result.name && each.member == member;
           })->unit;
  };
  Json json{{"name", result.name}, {"size", structure == nullptr ? result.size : size_of(*structure)}};
  if (structure == nullptr) {
    if (result.columns) json["rows"] = result.size / *result.columns, json["columns"] = *result.columns;
    json["unit"] = unit("");
    return json;
  }
  json["structure"] = structure->name;
  if (is_vector(mechanism, *structure)) json["unit"] = unit("");
  for (const Member& member : structure->members) {
    Json each{{"name", member.name}, {"offset", offset_of(*structure, member.name)}};
    if (!member.is_scalar()) each["rows"] = member.rows, each["columns"] = member.columns;
    if (!json.contains("unit")) each["unit"] = unit(member.name);
    json["members"].push_back(std::move(each));
  }
  return json;
}

/// Arrays of two dimensions are derivatives of quantities by quantities: a rate by a position is a 1/s where both are lengths,
/// and where both are angles too.
std::string written_unit(const Unit& unit, const DescribedResult& of) {
  const std::string text = torsor::written_unit(unit);
  return of.dimensions == 2 && text.starts_with("rad/") ? "1" + text.substr(3) : text;
}

/// From the units of what is written there, by the name that documentation gives them: a joule is a newton metre too.
void set_units(std::vector<DescribedResult>& results, const Listing& listing) {
  for (DescribedResult& result : results) {
    std::vector<std::optional<Unit>> units(result.rows * result.columns);
    for (const Output& output : listing.outputs) {
      if (output.target.result != result.result || output.target.member != result.member) continue;
      units.at(output.target.entry.value_or(0)) = output.unit;
    }
    std::set<std::string> different;
    for (const auto& unit : units) {
      if (unit) different.insert(written_unit(*unit, result));
    }
    if (different.empty()) continue;
    if (different.size() == 1) {
      const bool another_name = !result.unit.empty() && Unit::parse(result.unit) == Unit::parse(*different.begin());
      if (!another_name) result.unit = *different.begin();
      continue;
    }
    result.unit.clear();
    if (result.dimensions == 1) {
      for (const auto& unit : units) result.unit += (result.unit.empty() ? "" : ", ") + (unit ? written_unit(*unit) : "0");
    }
  }
}

}  // namespace

std::vector<NamedUnit> named_units(const std::vector<SymbolPointer>& symbols) {
  std::vector<NamedUnit> all;
  for (const SymbolPointer& symbol : symbols) all.push_back({member_name(*symbol), written_unit(*symbol)});
  return all;
}

std::vector<std::string> quantity_entries(const std::vector<SymbolPointer>& symbols) {
  std::vector<std::string> entries;
  for (const auto& [name, unit] : named_units(symbols)) entries.push_back(fmt::format("{{\"{}\", \"{}\"}}", name, unit));
  return entries;
}

KernelEntries kernel_entries(const MechanismListing& mechanism, const std::string& results, const char* const (&words)[2]) {
  KernelEntries entries;
  for (const KernelListing& given : mechanism.kernels) {
    const KernelSignature& kernel = given.kernel;
    const std::size_t first = entries.results.size();
    for (const DescribedResult& each : described_results(mechanism, given)) {
      entries.results.push_back(fmt::format("{{\"{}\", \"{}\", {}, {}, {}, \"{}\"}}", each.result, each.member, each.rows,
                                            each.columns, each.dimensions, each.unit));
    }
    const auto word = [&](bool is) { return words[is ? 1 : 0]; };
    entries.kernels.push_back(fmt::format(
        "{{\"{}\", {}, {}, {}, {}, {} + {}, {}}}", kernel.name, word(reads(kernel, Argument::accelerations)),
        word(reads(kernel, Argument::multipliers)), word(reads(kernel, Argument::inputs)), word(given.listing.has_status),
        results, first, entries.results.size() - first));
  }
  return entries;
}

bool is_vector(const MechanismListing& mechanism, const Structure& structure) {
  return std::any_of(mechanism.common.begin(), mechanism.common.end(),
                     [&structure](const Structure& each) { return each.name == structure.name; });
}

std::vector<DescribedResult> described_results(const MechanismListing& mechanism, const KernelListing& kernel) {
  std::vector<DescribedResult> all;
  for (const Result& result : kernel.kernel.results) {
    const Structure* const structure = mechanism.structure(result.structure);
    if (structure == nullptr) {
      const std::size_t columns = std::max<std::size_t>(result.columns.value_or(1), 1);
      all.push_back({result.name, "", result.size / columns, columns, result.columns ? 2 : 1});
    } else if (is_vector(mechanism, *structure)) {
      all.push_back({result.name, "", structure->members.size(), 1, 1});
    } else {
      for (const Member& member : structure->members) {
        all.push_back({result.name, member.name, static_cast<std::size_t>(member.rows),
                       static_cast<std::size_t>(member.columns), static_cast<int>(member.shape),
                       member.meaning.unit});
      }
    }
  }
  set_units(all, kernel.listing);
  if (kernel.listing.recurrence) all.push_back({"coefficients", "", kernel.listing.recurrence->rates.size(), 0, 2});
  return all;
}

bool reads(const KernelSignature& kernel, Argument argument) {
  return std::find(kernel.arguments.begin(), kernel.arguments.end(), argument) != kernel.arguments.end();
}

const char* name_of(Argument argument) {
  switch (argument) {
    case Argument::accelerations:
      return "accelerations";
    case Argument::multipliers:
      return "multipliers";
    case Argument::inputs:
      return "inputs";
  }
  return "";
}

std::string lines_of(const Json& list) {
  std::string text = "[";
  for (const Json& each : list) text += (text.size() > 1 ? ",\n  " : "\n  ") + each.dump();
  return text + (list.empty() ? "]" : "\n]");
}

Json quantities_json(const std::vector<SymbolPointer>& symbols) {
  Json list = Json::array();
  for (const auto& [name, unit] : named_units(symbols)) list.push_back({{"name", name}, {"unit", unit}});
  return list;
}

Json kernels_json(const MechanismListing& mechanism) {
  Json list = Json::array();
  for (const KernelListing& each : mechanism.kernels) {
    const KernelSignature& kernel = each.kernel;
    Json json{{"name", kernel.name},
              {"arguments", Json::array()},
              {"results", Json::array()},
              {"status", each.listing.has_status}};
    for (const Argument argument : kernel.arguments) json["arguments"].push_back(name_of(argument));
    const std::vector<DescribedResult> described = described_results(mechanism, each);
    for (const Result& result : kernel.results) json["results"].push_back(result_json(mechanism, result, described));
    if (each.listing.recurrence) json["coefficients"] = each.listing.recurrence->rates.size();
    list.push_back(std::move(json));
  }
  return list;
}

std::vector<std::size_t> quaternion_places(const MechanismListing& mechanism) {
  std::vector<std::size_t> places;
  const std::vector<SymbolPointer>& positions = mechanism.layout.coordinates;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const auto attitude = positions[i]->attitude.lock();
    if (attitude && attitude->e[0] == positions[i]) places.push_back(i);
  }
  return places;
}

std::string documentation_comment(const std::string& documentation) {
  std::string text;
  for (std::size_t begin = 0; begin < documentation.size();) {
    const std::size_t end = std::min(documentation.find('\n', begin), documentation.size());
    text += "/// " + comment_text(documentation.substr(begin, end - begin)) + "\n";
    begin = end + 1;
  }
  return text;
}

std::string numbers_text(const ConstantTable& table) {
  return std::visit(
      [](const auto& value) {
        if constexpr (std::is_same_v<decltype(value), const std::size_t&>) {
          return std::to_string(value);
        } else {
          return fmt::format("{}", fmt::join(value, ", "));
        }
      },
      table.value);
}

}  // namespace torsor
