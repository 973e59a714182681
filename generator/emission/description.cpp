// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/emission/description.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "generator/emission/comment_text.hpp"
#include "generator/emission/cpp_structures.hpp"
#include "generator/emission/javascript_language.hpp"
#include "generator/listing/local_names.hpp"

namespace torsor {
namespace {

using Json = nlohmann::ordered_json;

/// One entry on each line.
std::string lines_of(const Json& list) {
  std::string text = "[";
  for (const Json& each : list) text += (text.size() > 1 ? ",\n  " : "\n  ") + each.dump();
  return text + (list.empty() ? "]" : "\n]");
}

Json result_json(const MechanismListing& mechanism, const Result& result) {
  const Structure* const structure = mechanism.structure(result.structure);
  Json json{{"name", result.name}, {"size", structure == nullptr ? result.size : size_of(*structure)}};
  if (structure == nullptr) return json;
  json["structure"] = structure->name;
  for (const Member& member : structure->members) {
    Json each{{"name", member.name}, {"offset", offset_of(*structure, member.name)}};
    if (!member.scalar) each["rows"] = member.rows, each["columns"] = member.columns;
    json["members"].push_back(std::move(each));
  }
  return json;
}

}  // namespace

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

std::string unit_of(const Symbol& symbol) {
  const bool angle =
      symbol.unit.is_dimensionless() && symbol.kind == SymbolKind::coordinate && symbol.attitude.expired();
  if (angle) return "rad";
  return symbol.unit.is_dimensionless() ? "1" : unit_text(symbol.unit);
}

std::string symbols_json(const MechanismListing& mechanism, Table table) {
  Json list = Json::array();
  for (const SymbolPointer& symbol : mechanism.layout.of(table)) {
    list.push_back({{"name", member_name(*symbol)}, {"unit", unit_of(*symbol)}});
  }
  return lines_of(list);
}

std::string kernels_json(const MechanismListing& mechanism) {
  Json list = Json::array();
  for (const KernelListing& each : mechanism.kernels) {
    const KernelSignature& kernel = each.kernel;
    Json json{{"name", kernel.name},
              {"arguments", Json::array()},
              {"results", Json::array()},
              {"status", each.listing.has_status}};
    for (const Argument argument : kernel.arguments) json["arguments"].push_back(name_of(argument));
    for (const Result& result : kernel.results) json["results"].push_back(result_json(mechanism, result));
    list.push_back(std::move(json));
  }
  return lines_of(list);
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

std::string quaternions_json(const MechanismListing& mechanism) { return Json(quaternion_places(mechanism)).dump(); }

std::string documentation_comment(const std::string& documentation) {
  std::string text;
  for (std::size_t begin = 0; begin < documentation.size();) {
    const std::size_t end = std::min(documentation.find('\n', begin), documentation.size());
    text += "/// " + comment_text(documentation.substr(begin, end - begin)) + "\n";
    begin = end + 1;
  }
  return text;
}

}  // namespace torsor
