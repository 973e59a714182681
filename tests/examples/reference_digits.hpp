// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "torsor/generator/base/high_precision.hpp"

namespace examples {

/// The row of generated/<name>.reference.csv at a time, coordinates then rates, with all its digits. Fails the test
/// when there is no such row.
[[nodiscard]] inline std::vector<torsor::Real> reference_digits(const std::string& name, const std::string& time) {
  std::ifstream stream(TORSOR_SOURCE_DIR "/generated/" + name + ".reference.csv");
  for (std::string line; std::getline(stream, line);) {
    if (line.rfind(time + ",", 0) != 0) continue;
    std::istringstream cells(line.substr(time.size() + 1));
    std::vector<torsor::Real> row;
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(torsor::Real::parse(cell));
    return row;
  }
  ADD_FAILURE() << "generated/" << name << ".reference.csv has no row at t = " << time;
  return {};
}

/// |a - b| as a double, for comparisons beyond the digits of double.
[[nodiscard]] inline double distance(const torsor::Real& a, const torsor::Real& b) {
  const double difference = (a - b).to_double();
  return difference < 0.0 ? -difference : difference;
}

/// Two numbers written with at least 20 digits, compared to the digits that both have.
inline void expect_digits(const torsor::Real& found, const std::string& expected, double tolerance,
                          const std::string& what) {
  EXPECT_LE(distance(found, torsor::Real::parse(expected)), tolerance)
      << what << ": " << found.to_string(30) << " instead of " << expected;
}

}  // namespace examples
