// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "torsor/runtime/status.hpp"

namespace torsor::runtime {

/// A complex number whose product is the four of school, without std::complex's care for infinities, which costs a
/// call.
template <class Scalar>
struct Complex {
  Scalar re{}, im{};

  friend constexpr Complex operator+(const Complex& x, const Complex& y) noexcept { return {x.re + y.re, x.im + y.im}; }
  friend constexpr Complex operator-(const Complex& x, const Complex& y) noexcept { return {x.re - y.re, x.im - y.im}; }
  friend constexpr Complex operator*(const Complex& x, const Complex& y) noexcept {
    return {x.re * y.re - x.im * y.im, x.re * y.im + x.im * y.re};
  }
  friend constexpr Complex operator*(Scalar x, const Complex& y) noexcept { return {x * y.re, x * y.im}; }
};

namespace detail {
template <class Scalar>
[[nodiscard]] Scalar size_of(const Scalar& x) noexcept {
  return std::abs(x);
}
template <class Scalar>
[[nodiscard]] Scalar size_of(const Complex<Scalar>& x) noexcept {
  return std::abs(x.re) + std::abs(x.im);
}
template <class Scalar>
[[nodiscard]] Scalar reciprocal(const Scalar& x) noexcept {
  return Scalar(1) / x;
}
// By the larger part first (R. L. Smith 1962): the sum of squares would overflow or vanish long before the number does.
template <class Scalar>
[[nodiscard]] Complex<Scalar> reciprocal(const Complex<Scalar>& x) noexcept {
  if (std::abs(x.re) >= std::abs(x.im)) {
    const Scalar ratio = x.im / x.re, scale = Scalar(1) / (x.re + x.im * ratio);
    return {scale, -ratio * scale};
  }
  const Scalar ratio = x.re / x.im, scale = Scalar(1) / (x.re * ratio + x.im);
  return {ratio * scale, -scale};
}
}  // namespace detail

/// P A = L U of a general square matrix, real or complex, rows exchanged for the largest pivot; nothing is allocated.
/// Columns run first (column-major), as everywhere here. Source: Golub-Van Loan, Matrix Computations, algorithm 3.4.1.
template <class Field, std::size_t n>
class Lu {
 public:
  using Matrix = std::array<Field, n * n>;
  using Vector = std::array<Field, n>;

  /// The matrix to be factorised, to be filled before `factorise`, which overwrites it.
  Matrix& matrix() noexcept { return entries_; }

  /// `singular` when a pivot is zero, `not_finite` when one is not a number or infinite.
  [[nodiscard]] Evaluation factorise() noexcept {
    for (std::size_t k = 0; k < n; ++k) {
      Field* const column = &entries_[k * n];
      std::size_t pivot = k;
      for (std::size_t i = k + 1; i < n; ++i) {
        if (detail::size_of(column[i]) > detail::size_of(column[pivot])) pivot = i;
      }
      pivots_[k] = pivot;
      const auto size = detail::size_of(column[pivot]);
      if (!std::isfinite(size)) return Evaluation::not_finite;
      if (!(size > 0)) return Evaluation::singular;
      if (pivot != k) {
        for (std::size_t j = 0; j < n; ++j) std::swap(entries_[j * n + k], entries_[j * n + pivot]);
      }
      inverses_[k] = detail::reciprocal(column[k]);
      for (std::size_t i = k + 1; i < n; ++i) column[i] = column[i] * inverses_[k];
      for (std::size_t j = k + 1; j < n; ++j) {
        Field* const other = &entries_[j * n];
        const Field factor = other[k];
        for (std::size_t i = k + 1; i < n; ++i) other[i] = other[i] - factor * column[i];
      }
    }
    return Evaluation::ok;
  }

  /// The smallest size of a pivot: of a matrix with rows of size 1, how far it is from a singular one.
  [[nodiscard]] auto smallest_pivot() const noexcept {
    auto smallest = detail::size_of(entries_[0]);
    for (std::size_t k = 1; k < n; ++k) smallest = std::min(smallest, detail::size_of(entries_[k * n + k]));
    return smallest;
  }

  /// Overwrites b with the solution of A x = b; only after `factorise` said `ok`.
  void solve(Vector& b) const noexcept {
    for (std::size_t k = 0; k < n; ++k) std::swap(b[k], b[pivots_[k]]);
    for (std::size_t k = 0; k < n; ++k) {
      const Field* const column = &entries_[k * n];
      const Field factor = b[k];
      for (std::size_t i = k + 1; i < n; ++i) b[i] = b[i] - factor * column[i];
    }
    for (std::size_t k = n; k-- > 0;) {
      const Field* const column = &entries_[k * n];
      b[k] = b[k] * inverses_[k];
      const Field factor = b[k];
      for (std::size_t i = 0; i < k; ++i) b[i] = b[i] - factor * column[i];
    }
  }

 private:
  Matrix entries_{};
  Vector inverses_{};
  std::array<std::size_t, n> pivots_{};
};

}  // namespace torsor::runtime
