// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/expression/piecewise.hpp"

#include <cstddef>

#include <fmt/format.h>

#include "torsor/generator/base/decimal.hpp"
#include "torsor/generator/base/error.hpp"
#include "torsor/generator/base/high_precision.hpp"

namespace torsor {

Condition operator<(const Expression& a, const Expression& b) { return {b - a, true}; }
Condition operator<=(const Expression& a, const Expression& b) { return {b - a, false}; }
Condition operator>(const Expression& a, const Expression& b) { return b < a; }
Condition operator>=(const Expression& a, const Expression& b) { return b <= a; }

Expression piecewise(const std::vector<std::pair<Condition, Expression>>& rows, const Expression& otherwise) {
  Expression value = otherwise;
  for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
    const auto& [condition, form] = *row;
    // A select takes its first form where its condition is not negative: a > 0 is not (-a >= 0).
    value = condition.strict ? call(Function::select, {-condition.difference, value, form})
                             : call(Function::select, {condition.difference, form, value});
  }
  return value;
}

namespace {

constexpr int digits_of_slopes = 30;

/// A cubic between two abscissae, or a straight line beyond the last: value, slope, half the curvature, a sixth of the
/// third derivative at `from`.
struct Piece {
  Number from, value, slope, square, cube;
};

Number rounded(const Number& number) {
  return number.is_zero() ? number : parse_decimal(Real(number, digits_of_slopes + 10).to_string(digits_of_slopes));
}

/// Slopes at the points, of which the tridiagonal system says that y'' is continuous.
std::vector<Number> slopes(const std::vector<Number>& h, const std::vector<Number>& secant,
                           const std::optional<std::array<double, 2>>& ends) {
  const std::size_t n = h.size() + 1;
  std::vector<Number> diagonal(n), after(n), right(n), slope(n);
  if (ends) {
    diagonal[0] = diagonal[n - 1] = Number(1);
    right[0] = from_double((*ends)[0]);
    right[n - 1] = from_double((*ends)[1]);
  } else {
    diagonal[0] = diagonal[n - 1] = Number(2);
    after[0] = Number(1);
    right[0] = Number(3) * secant[0];
    right[n - 1] = Number(3) * secant[n - 2];
  }
  const auto before = [&](std::size_t i) { return i + 1 == n ? Number(ends ? 0 : 1) : h[i]; };
  for (std::size_t i = 1; i + 1 < n; ++i) {
    diagonal[i] = Number(2) * (h[i - 1] + h[i]);
    after[i] = h[i - 1];
    right[i] = Number(3) * (h[i] * secant[i - 1] + h[i - 1] * secant[i]);
  }
  for (std::size_t i = 1; i < n; ++i) {
    // Rounded on the way, or the fractions would grow without end; far finer than the slopes are.
    const Number factor = rounded(before(i) / diagonal[i - 1]);
    diagonal[i] = rounded(diagonal[i] - factor * after[i - 1]);
    right[i] = rounded(right[i] - factor * right[i - 1]);
  }
  for (std::size_t i = n; i-- > 0;) {
    const Number rest = i + 1 < n ? right[i] - after[i] * slope[i + 1] : right[i];
    slope[i] = rounded(rest / diagonal[i]);
  }
  return slope;
}

std::vector<Piece> pieces(const std::vector<std::array<double, 2>>& points,
                          const std::optional<std::array<double, 2>>& ends) {
  std::vector<Number> x, y, h, secant;
  for (const auto& [abscissa, ordinate] : points) {
    x.push_back(from_double(abscissa));
    y.push_back(from_double(ordinate));
    if (x.size() == 1) continue;
    h.push_back(x.back() - x[x.size() - 2]);
    if (h.back().sign() <= 0) {
      throw Error(fmt::format("the abscissae of a spline must grow, and {} comes after {}", abscissa,
                              x[x.size() - 2].to_double()));
    }
    secant.push_back((y.back() - y[y.size() - 2]) / h.back());
  }
  const std::vector<Number> slope = slopes(h, secant, ends);
  std::vector<Piece> all{{x[0], y[0], slope[0], Number(), Number()}};
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    const Number square = (Number(3) * secant[i] - Number(2) * slope[i] - slope[i + 1]) / h[i];
    const Number cube = (slope[i] + slope[i + 1] - Number(2) * secant[i]) / (h[i] * h[i]);
    all.push_back({x[i], y[i], slope[i], square, cube});
  }
  all.push_back({x.back(), y.back(), slope.back(), Number(), Number()});
  return all;
}

}  // namespace

Expression spline(const Expression& x, const std::vector<std::array<double, 2>>& points, std::string_view unit,
                  const std::optional<std::array<double, 2>>& end_slopes) {
  if (points.size() < 2) throw Error(fmt::format("a spline needs at least two points and has {}", points.size()));
  const std::vector<Piece> all = pieces(points, end_slopes);
  const Unit of_x = x.unit(), of_y = Unit::parse(unit);
  // One coefficient of the piece that x lies in, out of pieces first to last: halved again and again, so that few
  // selections wait for each other.
  const auto chosen = [&](const auto& self, Number Piece::*coefficient, const Unit& its_unit, std::size_t first,
                          std::size_t last) -> Expression {
    if (first == last) return Expression::quantity(all[first].*coefficient, its_unit);
    const std::size_t middle = first + (last - first + 1) / 2;
    const Expression beyond = x - Expression::quantity(all[middle].from, of_x);
    const Expression after = self(self, coefficient, its_unit, middle, last);
    return call(Function::select, {beyond, after, self(self, coefficient, its_unit, first, middle - 1)});
  };
  const auto coefficient = [&](Number Piece::*which, const Unit& its_unit) {
    return chosen(chosen, which, its_unit, 0, all.size() - 1);
  };
  const Expression value = coefficient(&Piece::value, of_y);
  const Expression slope = coefficient(&Piece::slope, of_y / of_x);
  const Expression square = coefficient(&Piece::square, of_y / of_x.pow(2));
  const Expression cube = coefficient(&Piece::cube, of_y / of_x.pow(3));
  const Expression t = x - coefficient(&Piece::from, of_x);
  return value + t * (slope + t * (square + t * cube));
}

}  // namespace torsor
