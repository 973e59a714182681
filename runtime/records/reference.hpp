// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "torsor/runtime/records/csv.hpp"
#include "torsor/runtime/records/file.hpp"

namespace torsor::runtime {

/// States known to be true at given times, each number rounded once from its decimals to the nearest Scalar.
template <std::floating_point Scalar>
struct Reference {
  std::filesystem::path path;
  std::vector<std::string> names;  ///< of the values, without the time
  std::vector<Scalar> times;       ///< strictly increasing
  std::vector<Scalar> values;      ///< row after row, `names.size()` values a row

  [[nodiscard]] std::size_t rows() const noexcept { return times.size(); }
  [[nodiscard]] Scalar value(std::size_t row, std::size_t column) const noexcept {
    return values[row * names.size() + column];
  }

  /// One row as a state vector y = [q; v]. Throws FileError when it has not that many columns.
  template <std::size_t size>
  [[nodiscard]] std::array<Scalar, size> state(std::size_t row) const {
    require_columns(size);
    std::array<Scalar, size> y;
    for (std::size_t column = 0; column < size; ++column) y[column] = value(row, column);
    return y;
  }

  void require_columns(std::size_t count) const {
    if (names.size() == count) return;
    throw FileError("'" + path.string() + "' has " + std::to_string(names.size()) +
                    " columns after the time, not the " + std::to_string(count) +
                    " of the state; make the reference again from the same scene");
  }
};

namespace detail {

class ReferenceReader {
 public:
  explicit ReferenceReader(const std::filesystem::path& path) : path_(path) {}

  template <std::floating_point Scalar>
  [[nodiscard]] Reference<Scalar> read() {
    Reference<Scalar> reference;
    reference.path = path_;
    std::ifstream stream = open_file(path_);
    for (std::string line; std::getline(stream, line);) {
      ++line_number_;
      if (line.empty() || line.front() == '#' || line == "\r") continue;
      if (reference.names.empty())
        read_names(line, reference.names);
      else
        read_row(line, reference);
    }
    if (reference.names.empty()) fail("no header line", "the first line after the comments must be time,names...");
    if (reference.times.empty()) fail("no row after the header", "make the reference again");
    return reference;
  }

 private:
  [[noreturn]] void fail(const std::string& what, const std::string& remedy) const {
    throw FileError("'" + path_.string() + "', line " + std::to_string(line_number_) + ": " + what + "; " + remedy);
  }

  void read_names(const std::string& line, std::vector<std::string>& names) const {
    const auto cells = split_cells(line);
    if (cells.front() != "time") {
      fail("the first column is '" + std::string(cells.front()) + "'", "the header must begin with 'time'");
    }
    if (cells.size() < 2) fail("no column after 'time'", "name the coordinates and velocities after it");
    for (std::size_t i = 1; i < cells.size(); ++i) {
      if (cells[i].empty()) fail("column " + std::to_string(i + 1) + " has no name", "name every column");
      if (std::find(names.begin(), names.end(), cells[i]) != names.end()) {
        fail("the column '" + std::string(cells[i]) + "' occurs twice", "give every column its own name");
      }
      names.emplace_back(cells[i]);
    }
  }

  template <std::floating_point Scalar>
  void read_row(const std::string& line, Reference<Scalar>& reference) const {
    const auto cells = split_cells(line);
    if (cells.size() != reference.names.size() + 1) {
      fail(std::to_string(cells.size()) + " values for " + std::to_string(reference.names.size() + 1) + " columns",
           "give one value a column");
    }
    const Scalar time = read_cell<Scalar>(cells.front(), "time");
    if (!reference.times.empty() && !(time > reference.times.back())) {
      fail("time " + std::string(cells.front()) + " does not come after the row before", "sort the rows by time");
    }
    reference.times.push_back(time);
    for (std::size_t i = 1; i < cells.size(); ++i) {
      reference.values.push_back(read_cell<Scalar>(cells[i], reference.names[i - 1]));
    }
  }

  template <std::floating_point Scalar>
  [[nodiscard]] Scalar read_cell(std::string_view cell, std::string_view column) const {
    Scalar value{};
    const bool number = parse_number(cell, value);
    if (!number && std::isinf(value)) {
      fail("'" + std::string(cell) + "' in column '" + std::string(column) + "' is beyond the largest number of this type",
           "read the file in a wider one, or correct the value");
    }
    if (!number || !std::isfinite(value)) {
      fail("'" + std::string(cell) + "' in column '" + std::string(column) + "' is not a finite number",
           "write a decimal such as -1.25e-3");
    }
    return value;
  }

  std::filesystem::path path_;
  std::size_t line_number_ = 0;
};

}  // namespace detail

/// Reads a reference: lines beginning with # are comments, then a header `time,q names...,v names...`, then rows of
/// decimals of any length. Throws FileError naming file, line, value and remedy.
template <std::floating_point Scalar>
[[nodiscard]] Reference<Scalar> read_reference(const std::filesystem::path& path) {
  return detail::ReferenceReader(path).read<Scalar>();
}

/// Largest absolute differences between computed states and a reference, each column in its own unit. An observer for
/// `integrate_through(system, y, t0, reference.times, method, errors)`; comparing allocates nothing.
/// Keeps a reference to the `Reference`. A time that the reference does not have, and a value that is not finite, count
/// as an infinite error: a comparison that did not happen is never a good one.
template <std::floating_point Scalar, std::size_t size>
class ReferenceErrors {
 public:
  explicit ReferenceErrors(const Reference<Scalar>& reference) : reference_(reference) {
    reference.require_columns(size);
  }

  void operator()(const Scalar& time, const std::array<Scalar, size>& y) noexcept {
    const auto& times = reference_.times;
    const auto found = std::lower_bound(times.begin(), times.end(), time);
    const bool known = found != times.end() && *found == time;
    const auto row = static_cast<std::size_t>(found - times.begin());
    for (std::size_t column = 0; column < size; ++column) {
      const Scalar difference = known ? std::abs(y[column] - reference_.value(row, column)) : infinite;
      const Scalar error = std::isnan(difference) ? infinite : difference;
      columns_[column] = std::max(columns_[column], error);
    }
    ++compared_;
  }

  /// Largest error of one column, in its unit, and of all of them.
  [[nodiscard]] Scalar column(std::size_t index) const noexcept { return compared_ > 0 ? columns_[index] : infinite; }
  [[nodiscard]] Scalar largest() const noexcept {
    return compared_ > 0 ? *std::max_element(columns_.begin(), columns_.end()) : infinite;
  }
  /// How many states were compared.
  [[nodiscard]] std::size_t compared() const noexcept { return compared_; }

 private:
  static constexpr Scalar infinite = std::numeric_limits<Scalar>::infinity();
  const Reference<Scalar>& reference_;
  std::array<Scalar, size> columns_{};
  std::size_t compared_ = 0;
};

}  // namespace torsor::runtime
