// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <charconv>
#include <concepts>
#include <cstddef>
#include <filesystem>
#include <ostream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "torsor/runtime/records/csv.hpp"
#include "torsor/runtime/records/file.hpp"

namespace torsor::runtime {

/// A number in scientific notation with so many digits after the point, for tables: 1.25e-09.
template <std::floating_point Scalar>
[[nodiscard]] std::string scientific(Scalar value, int digits = 2) {
  std::string text(64 + static_cast<std::size_t>(std::max(digits, 0)), ' ');  // sign, point, exponent; "nan"
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::scientific, digits).ptr;
  text.resize(static_cast<std::size_t>(end - text.data()));
  return text;
}

/// A text table: the first column flush left, the others flush right.
///   Table table({"integrator", "step or tolerance", "error", "steps", "time"});
///   table.add({"Runge-Kutta 4", "1e-03", scientific(error), std::to_string(steps), "1.2 ms"});
///   std::cout << table;
class Table {
 public:
  explicit Table(std::vector<std::string> titles) : rows_{std::move(titles)} {}

  /// One cell a column, or std::invalid_argument.
  void add(std::vector<std::string> cells) {
    if (cells.size() != rows_.front().size()) {
      throw std::invalid_argument("a table row has " + std::to_string(cells.size()) + " cells for " +
                                  std::to_string(rows_.front().size()) + " columns; give one cell a column");
    }
    rows_.push_back(std::move(cells));
  }

  /// The same table as comma-separated values, for a plot. Throws FileError.
  void write_csv(const std::filesystem::path& path) const {
    std::string text;
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      for (std::size_t i = 0; i < rows_[r].size(); ++i) {
        if (i > 0) text += ',';
        if (r == 0) append_name(text, rows_[r][i], path);
        if (r > 0) append_cell(text, r, i, path);
      }
      text += '\n';
    }
    write_file(path, text);
  }

  friend std::ostream& operator<<(std::ostream& stream, const Table& table) {
    std::vector<std::size_t> widths(table.rows_.front().size(), 0);
    for (const auto& row : table.rows_) {
      for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width_of(row[i]));
    }
    for (std::size_t r = 0; r < table.rows_.size(); ++r) {
      std::string line;
      for (std::size_t i = 0; i < widths.size(); ++i) {
        const std::string& cell = table.rows_[r][i];
        const std::string padding(widths[i] - width_of(cell), ' ');
        if (i > 0)
          line.append("  ").append(padding).append(cell);
        else
          line.append(cell).append(widths.size() > 1 ? padding : std::string());
      }
      stream << line << '\n';
      if (r == 0) stream << std::string(width_of(line), '-') << '\n';
    }
    return stream;
  }

 private:
  // As append_name, of a value; one that is empty is read back as it is, but alone in its row it would be no row.
  void append_cell(std::string& text, std::size_t row, std::size_t column, const std::filesystem::path& path) const {
    const std::string& cell = rows_[row][column];
    if (cell.find_first_of(",\"\n\r#") != std::string::npos || (cell.empty() && rows_[row].size() == 1)) {
      throw FileError("cannot write '" + path.string() + "': '" + cell + "' in row " + std::to_string(row) + " of the column '" +
                      rows_.front()[column] + "' is empty or has a comma, quote, hash or line break; write it otherwise");
    }
    text.append(cell);
  }

  // Characters, not bytes: continuation bytes of UTF-8 take no column.
  static std::size_t width_of(std::string_view text) noexcept {
    return static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
  }

  std::vector<std::vector<std::string>> rows_;
};

}  // namespace torsor::runtime
