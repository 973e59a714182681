// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdlib>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace torsor::testing_programs {

/// What `simulate` writes.
struct MotionTable {
  std::map<std::string, std::size_t> column;
  std::vector<std::vector<double>> rows;
  std::vector<std::string> notes;  ///< lines of the head
  double at(std::size_t row, const std::string& name) const { return rows.at(row).at(column.at(name)); }
  double end(const std::string& name) const { return at(rows.size() - 1, name); }
};

inline MotionTable table(const std::string& csv) {
  MotionTable result;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("# ")) {
      result.notes.push_back(line);
      continue;
    }
    std::istringstream cells(line);
    std::vector<double> row;
    const bool names = result.column.empty();
    for (std::string cell; std::getline(cells, cell, ',');) {
      if (names) result.column.emplace(cell, result.column.size());
      else row.push_back(std::strtod(cell.c_str(), nullptr));  // what decays may be below the least normal number
    }
    if (!names) result.rows.push_back(row);
  }
  return result;
}

}  // namespace torsor::testing_programs
