// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/theorems/routh.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/dynamics/theorems/flat_polynomials.hpp"
#include "torsor/generator/program/identically_zero.hpp"

namespace torsor {
namespace {

bool is_zero(const Value& value) { return value.is_zero() || (!value.is_constant() && identically_zero(value)); }

/// The row below two others: r_{j+1} − (r_0/p_0) p_{j+1}.
std::vector<Value> next_row(Program& program, const std::vector<Value>& r, const std::vector<Value>& p,
                            std::size_t count) {
  const Value ratio = r[0] / p[0];
  std::vector<Value> result;
  for (std::size_t j = 0; j < count; ++j) {
    Value entry = r[j + 1];
    if (j + 1 < p.size() && !p[j + 1].is_zero()) entry -= ratio * p[j + 1];
    result.push_back(is_zero(entry) ? Value() : program.bind(entry));
  }
  return result;
}

/// Changes of sign in a column of numbers from one row to another.
int changes(const RouthTable& table, std::size_t from) {
  int count = 0;
  for (std::size_t k = from + 1; k < table.rows.size(); ++k) {
    const Number& above = table.rows[k - 1].entries[0].polynomial().constant();
    const Number& below = table.rows[k].entries[0].polynomial().constant();
    count += above.sign() != below.sign();
  }
  return count;
}

}  // namespace

std::vector<Value> characteristic_polynomial(Program& program, const ValueMatrix& M, const ValueMatrix& C,
                                             const ValueMatrix& K) {
  const std::size_t n = M.size();
  const auto square = [n](const ValueMatrix& matrix) {
    return matrix.size() == n &&
           std::all_of(matrix.begin(), matrix.end(), [n](const auto& r) { return r.size() == n; });
  };
  if (n == 0 || !square(M) || !square(C) || !square(K)) {
    throw UsageError(
        fmt::format("a characteristic polynomial needs square M, C and K of one size, not of {}, {} and {} rows", n,
                    C.size(), K.size()));
  }
  // Row by row, each from M, C or K: the determinants whose choices add up to one power of s belong to its coefficient.
  std::size_t choices = 1;
  for (std::size_t i = 0; i < n; ++i) choices *= 3;
  std::vector<Value> coefficients(2 * n + 1);
  for (std::size_t choice = 0; choice < choices; ++choice) {
    ValueMatrix mixed;
    std::size_t power = 0, rest = choice;
    bool empty_row = false;
    for (std::size_t i = 0; i < n; ++i, rest /= 3) {
      const std::size_t which = rest % 3;
      power += which;
      mixed.push_back(which == 2 ? M[i] : which == 1 ? C[i] : K[i]);
      empty_row =
          empty_row || std::all_of(mixed[i].begin(), mixed[i].end(), [](const Value& v) { return v.is_zero(); });
    }
    if (empty_row) continue;
    const Value part = determinant(program, mixed);
    coefficients[2 * n - power] += part;
  }
  for (Value& coefficient : coefficients) coefficient = multiplied_out(coefficient);
  return coefficients;
}

RouthTable routh_table(Program& program, const std::vector<Value>& coefficients) {
  if (coefficients.empty() || is_zero(coefficients.front())) {
    throw UsageError("Routh's table needs coefficients from that of the highest power down, and that one not zero");
  }
  std::vector<Value> a = coefficients;
  const bool numbers = std::all_of(a.begin(), a.end(), [](const Value& value) { return value.is_constant(); });
  if (numbers && a.front().polynomial().constant().sign() < 0) {
    for (Value& value : a) value = -value;
  }
  RouthTable table;
  while (a.size() > 1 && is_zero(a.back())) {
    a.pop_back();
    ++table.zero_roots;
  }
  const int degree = static_cast<int>(a.size()) - 1;
  // A turned coefficient counts 1 s^2p, so that units fit; roots may also be pure numbers.
  Unit time;
  for (const Value& value : a) {
    if (!value.is_zero() && !(value.unit() == a.front().unit())) time = units::second;
  }
  std::optional<std::size_t> even_factor;
  for (int k = 0; k <= degree; ++k) {
    const auto row_index = static_cast<std::size_t>(k);
    RouthRow row{degree - k, RouthRowKind::regular, {}};
    const auto count = static_cast<std::size_t>(row.power / 2 + 1);
    if (k < 2) {
      for (std::size_t j = 0; j < count; ++j)
        row.entries.push_back(is_zero(a[row_index + 2 * j]) ? Value() : a[row_index + 2 * j]);
    } else {
      row.entries = next_row(program, table.rows[row_index - 2].entries, table.rows[row_index - 1].entries, count);
    }
    const auto first =
        std::find_if(row.entries.begin(), row.entries.end(), [](const Value& entry) { return !entry.is_zero(); });
    if (first == row.entries.end()) {
      row.kind = RouthRowKind::zero_row;
      if (!even_factor) even_factor = row_index - 1;
      const std::vector<Value>& above = table.rows.back().entries;
      for (std::size_t j = 0; j < count; ++j) {
        row.entries[j] = Number(row.power + 1 - 2 * static_cast<int>(j)) * above[j];
      }
    } else if (first != row.entries.begin()) {
      row.kind = RouthRowKind::zero_pivot;
      const auto p = static_cast<std::size_t>(first - row.entries.begin());
      const std::vector<Value> entries = row.entries;
      for (std::size_t j = 0; j + p < count; ++j) {
        if (entries[j + p].is_zero()) continue;
        const Value turned = program.number(Number(1), time.pow(2 * static_cast<int>(p))) * entries[j + p];
        if (p % 2 == 0) {
          row.entries[j] += turned;
        } else {
          row.entries[j] -= turned;
        }
      }
    }
    table.rows.push_back(std::move(row));
  }
  if (numbers) {
    RootCount roots{changes(table, 0), 0, table.zero_roots, 0};
    if (even_factor) roots.imaginary = table.rows[*even_factor].power - 2 * changes(table, *even_factor);
    roots.left = degree - roots.right - roots.imaginary;
    table.count = roots;
  }
  return table;
}

std::vector<Value> hurwitz_conditions(Program& program, const std::vector<Value>& coefficients) {
  if (coefficients.empty() || is_zero(coefficients.front())) {
    throw UsageError(
        "Hurwitz's conditions need coefficients from that of the highest power down, and that one not zero");
  }
  const std::size_t n = coefficients.size() - 1;
  std::vector<Value> conditions{multiplied_out(coefficients.front())};
  ValueMatrix hurwitz(n, std::vector<Value>(n));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      // Entry (i, j) is a_{n−1−2j+i}: place 1 + 2 j − i among the coefficients.
      if (2 * j + 1 < i || 2 * j + 1 - i > n) continue;
      hurwitz[i][j] = coefficients[2 * j + 1 - i];
    }
  }
  for (std::size_t size = 1; size <= n; ++size) {
    ValueMatrix leading;
    for (std::size_t i = 0; i < size; ++i) {
      leading.emplace_back(hurwitz[i].begin(), hurwitz[i].begin() + static_cast<std::ptrdiff_t>(size));
    }
    conditions.push_back(determinant(program, leading));
  }
  return conditions;
}

std::string readable_conditions(const std::vector<Value>& conditions) {
  std::string text;
  for (const Value& condition : conditions) {
    if (condition.is_constant() && !condition.is_zero() && condition.polynomial().constant().sign() > 0) continue;
    text += readable(condition) + " > 0\n";
  }
  return text;
}

}  // namespace torsor
