// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/base/printable.hpp"
#include "torsor/generator/cli/report.hpp"

namespace torsor {
namespace {

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells(1);
  for (const char c : line) {
    if (c == ',') cells.emplace_back();
    else if (c != '\r') cells.back() += c;
  }
  return cells;
}

}  // namespace

std::string report_reference(const SceneContent& scene, const std::string& path) {
  if (!scene.contacts.empty()) {
    throw UsageError(fmt::format("'{}' has contacts, and a reference is of a motion without: leave --reference out", scene.name));
  }
  std::ifstream file(path);
  if (!file) throw FileError(fmt::format("cannot read the reference '{}': write one by the command reference", path));
  std::vector<std::string> names;
  nlohmann::ordered_json rows = nlohmann::ordered_json::array(), printed = nlohmann::ordered_json::array();
  const std::string title = fmt::format("# Reference motion of the scene {}:", scene.name);
  bool titled = false;
  int number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    titled = titled || line.starts_with(title);
    if (line.empty() || line[0] == '#') continue;
    const std::vector<std::string> cells = cells_of(line);
    if (names.empty()) {
      names = cells;
      continue;
    }
    nlohmann::ordered_json row = nlohmann::ordered_json::array();
    for (const std::string& cell : cells) {
      double value = std::nan("");
      const auto [end, failure] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
      if (failure != std::errc() || end != cell.data() + cell.size() || !std::isfinite(value)) {
        throw FileError(fmt::format("{}:{}: '{}' is no number", path, number, printable(cell)));
      }
      row.push_back(value);
    }
    if (row.size() != names.size()) {
      throw FileError(fmt::format("{}:{}: {} numbers for {} columns", path, number, row.size(), names.size()));
    }
    rows.push_back(std::move(row));
  }
  if (names.empty() || names[0] != "time" || rows.empty()) {
    throw FileError(fmt::format("'{}' is no reference: its first column must be time, with rows below; the command reference writes one", path));
  }
  if (!titled) {
    throw FileError(fmt::format("'{}' does not say that it is of '{}', by the line '{}': the command reference writes it", path,
                                scene.name, title));
  }
  for (const CoordinateContent& coordinate : scene.coordinates) {
    if (!coordinate.unknown() || std::find(names.begin(), names.end(), coordinate.q->name) != names.end()) continue;
    throw FileError(fmt::format("the reference '{}' has no column '{}': it is of another scene than '{}'", path,
                                coordinate.q->name, scene.name));
  }
  for (const std::string& name : names) printed.push_back(printable(name));
  return nlohmann::ordered_json{{"names", printed}, {"rows", rows}}.dump();
}

}  // namespace torsor
