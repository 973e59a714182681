// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/theorems/flat_polynomials.hpp"

#include <fmt/format.h>

#include <optional>
#include <unordered_map>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/program/paired_signs.hpp"

namespace torsor {
namespace {

Polynomial one() { return Polynomial(Number(1)); }

/// Multiplies flat polynomials; sums that were bound stay behind their value numbers.
class Multiplication {
 public:
  Multiplication(const Program& program, std::size_t limit) : program_(program), limit_(limit) {}

  Polynomial product(const Polynomial& a, const Polynomial& b) const {
    Polynomial result;
    for (const Term& left : a.terms()) {
      for (const Term& right : b.terms()) result.add(torsor::product(program_, left, right));
      if (result.terms().size() > limit_) {
        throw UsageError(
            fmt::format("a formula has more than {} terms when it is multiplied out: give the parameters that need no "
                        "symbol their values, or ask for numbers",
                        limit_));
      }
    }
    return result;
  }

  /// With bound sums put back.
  Polynomial expanded(const Polynomial& polynomial) {
    Polynomial result;
    for (const Term& term : polynomial.terms()) {
      Polynomial factor{Term{{}, term.coefficient}};
      for (const Factor& each : term.monomial) {
        const Definition& definition = program_[each.value_number];
        const bool sum = !definition.symbol && !definition.function;
        if (!sum || each.exponent < 0) {
          factor = product(factor, Polynomial(Term{{each}, Number(1)}));
          continue;
        }
        const Polynomial base = definition_of(each.value_number);
        for (int i = 0; i < each.exponent; ++i) factor = product(factor, base);
      }
      result += factor;
    }
    program_.simplify(result);
    return result;
  }

 private:
  const Polynomial& definition_of(ValueNumber value_number) {
    const auto known = known_.find(value_number);
    if (known != known_.end()) return known->second;
    Polynomial made = expanded(program_[value_number].polynomial);
    return known_.emplace(value_number, std::move(made)).first->second;
  }

  const Program& program_;
  std::size_t limit_;
  std::unordered_map<ValueNumber, Polynomial> known_;  ///< looked up only
};

std::string name_of(const Program& program, ValueNumber value_number);

std::string text_of(const Program& program, const Polynomial& polynomial) {
  std::string text;
  for (const Term& term : polynomial.terms()) {
    std::string above, below;
    for (const Factor& factor : term.monomial) {
      std::string& side = factor.exponent > 0 ? above : below;
      if (!side.empty()) side += " ";
      side += name_of(program, factor.value_number);
      const int power = factor.exponent > 0 ? factor.exponent : -factor.exponent;
      if (power != 1) side += fmt::format("^{}", power);
    }
    const bool rational = term.coefficient.is_rational();
    const bool negative = rational && term.coefficient.sign() < 0;
    const std::string number = rational ? term.coefficient.abs().to_string() : "(" + term.coefficient.to_string() + ")";
    if (above.empty()) {
      above = number;
    } else if (number != "1") {
      above = number + " " + above;
    }
    if (!below.empty()) above += below.find(' ') == std::string::npos ? "/" + below : "/(" + below + ")";
    if (text.empty()) {
      text = negative ? "-" + above : above;
    } else {
      text += (negative ? " - " : " + ") + above;
    }
  }
  return text.empty() ? "0" : text;
}

std::string name_of(const Program& program, ValueNumber value_number) {
  const Definition& definition = program[value_number];
  if (definition.symbol) return definition.symbol->name;
  if (definition.function) {
    std::string inside;
    for (const ValueNumber each : definition.arguments) inside += (inside.empty() ? "" : ", ") + name_of(program, each);
    return fmt::format("{}({})", to_string(*definition.function), inside);
  }
  const Polynomial& sum = definition.polynomial;
  const std::string text = text_of(program, sum);
  return sum.terms().size() > 1 ? "(" + text + ")" : text;
}

}  // namespace

Value multiplied_out(const Value& value, std::size_t limit) {
  if (value.program() == nullptr || value.is_constant()) return value;
  const Polynomial flat = Multiplication(*value.program(), limit).expanded(value.polynomial());
  return Value(*value.program(), flat, value.unit());
}

Value determinant(Program& program, const ValueMatrix& matrix) {
  const std::size_t n = matrix.size();
  for (const std::vector<Value>& row : matrix) {
    if (row.size() != n) {
      throw UsageError(
          fmt::format("a determinant is asked of a matrix with {} rows and a row of {} entries", n, row.size()));
    }
  }
  if (n == 0 || n > 10) {
    throw UsageError(fmt::format("a determinant of {} rows is not written out: 1 to 10 are", n));
  }
  constexpr std::size_t limit = 20000;
  Multiplication multiplication(program, limit);
  std::vector<std::vector<Polynomial>> flat(n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) flat[i].push_back(multiplication.expanded(matrix[i][j].polynomial()));
  }
  // minors[S]: the determinant of the first |S| rows and the columns of S, developed along its last row.
  std::vector<Polynomial> minors(std::size_t(1) << n);
  minors[0] = one();
  for (std::size_t columns = 1; columns < minors.size(); ++columns) {
    std::size_t row = 0;
    for (std::size_t j = 0; j < n; ++j) row += (columns >> j) & 1U;
    std::size_t place = 0;
    for (std::size_t j = 0; j < n; ++j) {
      if (((columns >> j) & 1U) == 0) continue;
      Polynomial term = multiplication.product(flat[row - 1][j], minors[columns & ~(std::size_t(1) << j)]);
      if ((row - 1 + place) % 2 == 1) term *= Number(-1);
      minors[columns] += term;
      ++place;
    }
  }
  Polynomial result = minors.back();
  program.simplify(result);
  if (result.is_zero()) return Value();
  // Any product that does not vanish has the unit; the diagonal may hold zeros, which have none.
  std::optional<Unit> unit;
  const auto search = [&](const auto& self, std::size_t i, std::size_t used, const Unit& so_far) -> void {
    if (unit) return;
    if (i == n) {
      unit = so_far;
      return;
    }
    for (std::size_t j = 0; j < n && !unit; ++j) {
      if (((used >> j) & 1U) != 0 || matrix[i][j].is_zero()) continue;
      self(self, i + 1, used | (std::size_t(1) << j), so_far * matrix[i][j].unit());
    }
  };
  search(search, 0, 0, Unit());
  return Value(program, result, unit.value_or(Unit()));
}

std::string readable(const Value& value) {
  if (value.program() == nullptr) return value.is_zero() ? "0" : value.polynomial().constant().to_string();
  return text_of(*value.program(), value.polynomial());
}

}  // namespace torsor
