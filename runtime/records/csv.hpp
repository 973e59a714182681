// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <charconv>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "torsor/runtime/records/file.hpp"

namespace torsor::runtime {

/// Appends the shortest decimal that reads back as the same value.
template <std::floating_point Scalar>
void append_number(std::string& text, Scalar value) {
  char digits[64];
  const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
  text.append(digits, end);
}

/// The cells of a line of comma-separated values; no quoting, blanks around a cell and a carriage return do not count.
[[nodiscard]] inline std::vector<std::string_view> split_cells(std::string_view line) {
  std::vector<std::string_view> cells;
  for (std::size_t start = 0;;) {
    const std::size_t comma = line.find(',', start);
    std::string_view cell = line.substr(start, comma == std::string_view::npos ? comma : comma - start);
    constexpr std::string_view blank = " \t\r";
    const std::size_t first = cell.find_first_not_of(blank);
    cells.push_back(first == std::string_view::npos ? std::string_view{}
                                                    : cell.substr(first, cell.find_last_not_of(blank) - first + 1));
    if (comma == std::string_view::npos) return cells;
    start = comma + 1;
  }
}

namespace detail {

/// Whether a decimal, which has the form of one, is less than 1.
[[nodiscard]] inline bool less_than_one(std::string_view decimal) {
  const std::size_t e = decimal.find_first_of("eE");
  long long exponent = 0;
  if (e != std::string_view::npos) {
    std::string_view power = decimal.substr(e + 1);
    if (!power.empty() && power.front() == '+') power.remove_prefix(1);
    const auto read = std::from_chars(power.data(), power.data() + power.size(), exponent);
    if (read.ec == std::errc::result_out_of_range) return power.front() == '-';
  }
  const std::string_view digits = decimal.substr(0, e);
  const std::size_t first = digits.find_first_of("123456789"), point = std::min(digits.find('.'), digits.size());
  if (first == std::string_view::npos) return true;
  const auto place = first < point ? static_cast<long long>(point - first - 1) : -static_cast<long long>(first - point);
  return exponent < -place;  // of the first digit: 0 for units; both are far from the ends of their range here
}

}  // namespace detail

/// Reads a decimal of any length, rounded once to the nearest Scalar: what is nearer to zero than the least number is a
/// zero with its sign. False when the cell is anything else; what is beyond the largest number leaves an infinite value.
template <std::floating_point Scalar>
[[nodiscard]] bool parse_number(std::string_view cell, Scalar& value) {
  if (!cell.empty() && cell.front() == '+') cell.remove_prefix(1);
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (end != cell.data() + cell.size() || cell.empty()) return false;
  if (error != std::errc::result_out_of_range) return error == std::errc{};
  const bool small = detail::less_than_one(cell);
  value = std::copysign(small ? Scalar(0) : std::numeric_limits<Scalar>::infinity(), Scalar(cell.front() == '-' ? -1 : 1));
  return small;
}

/// A column's name as it may stand in a header line; throws FileError for one that would break the line apart.
inline void append_name(std::string& text, std::string_view name, const std::filesystem::path& path) {
  if (name.empty() || name.find_first_of(",\"\n\r#") != std::string_view::npos) {
    throw FileError("cannot write '" + path.string() + "': the column name '" + std::string(name) +
                    "' is empty or has a comma, quote, hash or line break; rename the column");
  }
  text.append(name);
}

/// The column names of a CSV file: its first line that is neither empty nor a comment (#).
[[nodiscard]] inline std::vector<std::string> read_header(const std::filesystem::path& path) {
  std::ifstream stream = open_file(path);
  for (std::string line; std::getline(stream, line);) {
    if (line.empty() || line.front() == '#' || line == "\r") continue;
    const auto cells = split_cells(line);
    return {cells.begin(), cells.end()};
  }
  throw FileError("'" + path.string() + "' has no header line; its first line must name the columns");
}

}  // namespace torsor::runtime
