// SPDX-License-Identifier: MIT
#include "torsor/runtime/small_motions/routh.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <utility>

#include "torsor/runtime/records/table.hpp"

namespace torsor::runtime {

RouthTable routh_table(std::span<const double> coefficients, std::span<const double> uncertainties) {
  constexpr double rounding = std::numeric_limits<double>::epsilon();
  if (coefficients.empty() ||
      !std::all_of(coefficients.begin(), coefficients.end(), [](double a) { return std::isfinite(a); })) {
    throw std::invalid_argument("Routh's table needs at least one coefficient, and all of them finite");
  }
  if (!uncertainties.empty() && uncertainties.size() != coefficients.size()) {
    throw std::invalid_argument("Routh's table got " + std::to_string(uncertainties.size()) + " uncertainties for " +
                                std::to_string(coefficients.size()) + " coefficients");
  }
  std::vector<double> a(coefficients.begin(), coefficients.end()), error;
  for (std::size_t i = 0; i < a.size(); ++i) {
    error.push_back(uncertainties.empty() ? rounding * std::abs(a[i]) : uncertainties[i]);
    if (std::abs(a[i]) <= error[i]) a[i] = 0.0;
  }
  if (a.front() == 0.0) {
    throw std::invalid_argument("the first coefficient of a polynomial in Routh's table vanishes; leave it out");
  }
  if (a.front() < 0.0) {
    for (double& value : a) value = -value;
  }
  RouthTable table;
  while (a.size() > 1 && a.back() == 0.0) {
    a.pop_back();
    error.pop_back();
    ++table.zero;
  }
  const int degree = static_cast<int>(a.size()) - 1;
  std::vector<std::vector<double>> errors;
  std::optional<int> even_factor;  // row of the even factor that the first vanishing row shows
  for (int k = 0; k <= degree; ++k) {
    RouthTable::Row row{degree - k, RouthRow::regular, {}};
    const auto count = static_cast<std::size_t>((degree - k) / 2 + 1);
    std::vector<double> doubt;
    if (k < 2) {
      for (std::size_t j = 0; j < count; ++j) {
        row.entries.push_back(a[static_cast<std::size_t>(k) + 2 * j]);
        doubt.push_back(error[static_cast<std::size_t>(k) + 2 * j]);
      }
    } else {
      const std::vector<double>&r = table.rows[static_cast<std::size_t>(k - 2)].entries,
            &p = table.rows[static_cast<std::size_t>(k - 1)].entries;
      const std::vector<double>&dr = errors[static_cast<std::size_t>(k - 2)],
            &dp = errors[static_cast<std::size_t>(k - 1)];
      const double ratio = r[0] / p[0];
      const double ratio_doubt = (dr[0] + std::abs(ratio) * dp[0]) / std::abs(p[0]) + rounding * std::abs(ratio);
      for (std::size_t j = 0; j < count; ++j) {
        const double next = j + 1 < p.size() ? p[j + 1] : 0.0, next_doubt = j + 1 < p.size() ? dp[j + 1] : 0.0;
        const double value = r[j + 1] - ratio * next;
        doubt.push_back(dr[j + 1] + std::abs(ratio) * next_doubt + ratio_doubt * std::abs(next) +
                        rounding * (std::abs(ratio * next) + std::abs(value)));
        row.entries.push_back(std::abs(value) <= doubt.back() ? 0.0 : value);
      }
    }
    const auto first = std::find_if(row.entries.begin(), row.entries.end(), [](double x) { return x != 0.0; });
    if (first == row.entries.end()) {
      row.kind = RouthRow::zero_row;
      if (!even_factor) even_factor = k - 1;
      for (std::size_t j = 0; j < count; ++j) {
        const double power = row.power + 1 - 2 * static_cast<int>(j);
        row.entries[j] = power * table.rows.back().entries[j];
        doubt[j] = power * errors.back()[j] + rounding * std::abs(row.entries[j]);
      }
    } else if (first != row.entries.begin()) {
      row.kind = RouthRow::zero_pivot;
      const auto p = static_cast<std::size_t>(first - row.entries.begin());
      const std::vector<double> entries = row.entries, doubts = doubt;
      for (std::size_t j = 0; j + p < count; ++j) {
        row.entries[j] += (p % 2 == 0 ? 1.0 : -1.0) * entries[j + p];
        doubt[j] += doubts[j + p] + rounding * std::abs(row.entries[j]);
      }
    }
    table.rows.push_back(std::move(row));
    errors.push_back(std::move(doubt));
  }
  int within_factor = 0;
  for (int k = 1; k <= degree; ++k) {
    const auto row = static_cast<std::size_t>(k);
    if ((table.rows[row].entries[0] < 0.0) == (table.rows[row - 1].entries[0] < 0.0)) continue;
    ++table.right;
    if (even_factor && k > *even_factor) ++within_factor;
  }
  if (even_factor) table.imaginary = table.rows[static_cast<std::size_t>(*even_factor)].power - 2 * within_factor;
  table.left = degree - table.right - table.imaginary;
  return table;
}

std::ostream& operator<<(std::ostream& stream, const RouthTable& table) {
  const std::size_t columns = table.rows.front().entries.size();
  std::vector<std::string> titles{"power"};
  for (std::size_t j = 0; j < columns; ++j) titles.push_back("column " + std::to_string(j + 1));
  titles.emplace_back("remark");
  Table text(titles);
  for (const RouthTable::Row& row : table.rows) {
    std::vector<std::string> cells{"s^" + std::to_string(row.power)};
    for (std::size_t j = 0; j < columns; ++j) {
      cells.push_back(j < row.entries.size() ? scientific(row.entries[j], 4) : std::string());
    }
    cells.emplace_back(row.kind == RouthRow::regular      ? ""
                       : row.kind == RouthRow::zero_pivot ? "zero pivot"
                                                          : "zero row");
    text.add(cells);
  }
  return stream << text;
}

}  // namespace torsor::runtime
