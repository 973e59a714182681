// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace torsor::runtime {

/// A function over a part of a step by its values at nine Chebyshev nodes: the polynomial of degree 8 through them in
/// Bernstein's form. It lies between its least and its largest coefficient, and has at most as many roots inside as
/// these change their sign (Descartes' rule for Bernstein's form), which is how events are excluded and counted.
/// Exact, to rounding, for guards that are affine in y on interpolants of degree 8 or less; otherwise its error is
/// estimated from its last two Chebyshev coefficients and its difference from the function at two more points.
/// Source: Farouki & Rajan, Computer Aided Geometric Design 4 (1987) 191-216; Trefethen, Approximation Theory, 4.
template <class Scalar>
class StepPolynomial {
 public:
  static constexpr std::size_t degree = 8, nodes = degree + 1, samples = nodes + 2;
  using Values = std::array<Scalar, samples>;

  /// Where the function is to be known, as parts of the interval: the nodes in order, then the two that check.
  static constexpr std::array<double, samples> places{0.0,
                                                      0.038060233744356624,
                                                      0.14644660940672624,
                                                      0.30865828381745512,
                                                      0.5,
                                                      0.69134171618254492,
                                                      0.85355339059327373,
                                                      0.96193976625564337,
                                                      1.0,
                                                      0.2172,
                                                      0.6079};

  explicit StepPolynomial(const Values& values) noexcept {
    for (std::size_t i = 0; i < nodes; ++i) {
      coefficients_[i] = Scalar(0);
      for (std::size_t j = 0; j < nodes; ++j) coefficients_[i] += static_cast<Scalar>(bernstein[i][j]) * values[j];
      largest_ = std::max(largest_, std::abs(values[i]));
    }
    Scalar last = (values[0] + values[degree]) / Scalar(2), last_but_one = (values[0] - values[degree]) / Scalar(2);
    for (std::size_t j = 1; j < degree; ++j) {
      const Scalar sign = j % 2 == 0 ? Scalar(1) : Scalar(-1);
      last += sign * values[j];
      // cos(7 π j/8) = (-1)^j cos(π j/8)
      last_but_one += sign * static_cast<Scalar>(1.0 - 2.0 * places[j]) * values[j];
    }
    const Scalar tail = (std::abs(last) + Scalar(2) * std::abs(last_but_one)) / static_cast<Scalar>(degree);
    const Scalar missed = std::max(std::abs(value(static_cast<Scalar>(places[nodes])) - values[nodes]),
                                   std::abs(value(static_cast<Scalar>(places[nodes + 1])) - values[nodes + 1]));
    error_ = Scalar(2) * (tail + missed) + rounding * largest_;
  }

  /// The time of a sample in an interval, which its ends meet exactly.
  [[nodiscard]] static Scalar time(std::size_t sample, Scalar start, Scalar end) noexcept {
    if (sample == 0 || sample == degree) return sample == 0 ? start : end;
    return start + static_cast<Scalar>(places[sample]) * (end - start);
  }

  /// Largest difference from the function, an estimate.
  [[nodiscard]] Scalar error() const noexcept { return error_; }
  /// Whether the polynomial is the function but for rounding.
  [[nodiscard]] bool resolved() const noexcept { return error_ <= Scalar(16) * rounding * largest_; }
  [[nodiscard]] Scalar largest() const noexcept { return largest_; }

  /// No value is below this.
  [[nodiscard]] Scalar least() const noexcept { return *std::min_element(coefficients_.begin(), coefficients_.end()); }
  /// How often sign · p + offset changes its sign from coefficient to coefficient.
  [[nodiscard]] int sign_changes(Scalar sign, Scalar offset) const noexcept {
    int changes = 0;
    bool positive = sign * coefficients_[0] + offset > Scalar(0);
    for (std::size_t i = 1; i < nodes; ++i) {
      const bool next = sign * coefficients_[i] + offset > Scalar(0);
      changes += next != positive ? 1 : 0;
      positive = next;
    }
    return changes;
  }
  [[nodiscard]] bool stays_above(Scalar sign, Scalar offset) const noexcept {
    for (const Scalar& c : coefficients_) {
      if (!(sign * c + offset > error_)) return false;
    }
    return true;
  }

  [[nodiscard]] Scalar value(Scalar part) const noexcept { return casteljau(coefficients_, nodes, part); }
  /// Derivative by the part of the interval.
  [[nodiscard]] Scalar slope(Scalar part) const noexcept {
    std::array<Scalar, nodes> differences{};
    for (std::size_t i = 0; i < degree; ++i) {
      differences[i] = static_cast<Scalar>(degree) * (coefficients_[i + 1] - coefficients_[i]);
    }
    return casteljau(differences, degree, part);
  }

 private:
  // The coefficients grow by at most a factor of some hundred over the values.
  static constexpr Scalar rounding = Scalar(64) * std::numeric_limits<Scalar>::epsilon();

  static Scalar casteljau(std::array<Scalar, nodes> c, std::size_t count, Scalar part) noexcept {
    for (std::size_t level = count - 1; level > 0; --level) {
      for (std::size_t i = 0; i < level; ++i) c[i] += part * (c[i + 1] - c[i]);
    }
    return c[0];
  }

  using Matrix = std::array<std::array<double, nodes>, nodes>;
  // The inverse of the matrix of Bernstein's polynomials at the nodes, by elimination with exchange of rows.
  static constexpr Matrix invert_bernstein() noexcept {
    std::array<std::array<long double, 2 * nodes>, nodes> work{};
    constexpr long double choose[nodes] = {1, 8, 28, 56, 70, 56, 28, 8, 1};
    for (std::size_t row = 0; row < nodes; ++row) {
      const long double x = places[row], rest = 1.0L - x;
      for (std::size_t k = 0; k < nodes; ++k) {
        long double term = choose[k];
        for (std::size_t i = 0; i < k; ++i) term *= x;
        for (std::size_t i = k; i < degree; ++i) term *= rest;
        work[row][k] = term;
      }
      work[row][nodes + row] = 1.0L;
    }
    for (std::size_t column = 0; column < nodes; ++column) {
      std::size_t pivot = column;
      const auto size = [&](std::size_t row) { return work[row][column] < 0 ? -work[row][column] : work[row][column]; };
      for (std::size_t row = column + 1; row < nodes; ++row) pivot = size(row) > size(pivot) ? row : pivot;
      for (std::size_t k = 0; k < 2 * nodes; ++k) {
        const long double kept = work[pivot][k];
        work[pivot][k] = work[column][k];
        work[column][k] = kept;
      }
      const long double scale = 1.0L / work[column][column];
      for (auto& entry : work[column]) entry *= scale;
      for (std::size_t row = 0; row < nodes; ++row) {
        const long double factor = row == column ? 0.0L : work[row][column];
        for (std::size_t k = 0; k < 2 * nodes; ++k) work[row][k] -= factor * work[column][k];
      }
    }
    Matrix inverse{};
    for (std::size_t row = 0; row < nodes; ++row) {
      for (std::size_t k = 0; k < nodes; ++k) inverse[row][k] = static_cast<double>(work[row][nodes + k]);
    }
    return inverse;
  }
  static constexpr Matrix bernstein = invert_bernstein();

  std::array<Scalar, nodes> coefficients_{};
  Scalar largest_ = Scalar(0), error_ = Scalar(0);
};

}  // namespace torsor::runtime
