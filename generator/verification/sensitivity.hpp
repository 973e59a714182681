// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "generator/expression/evaluation.hpp"

namespace torsor {

/// A number with what it moves by, to first order, when every input x_j is moved by ± x_j: forward derivatives along a
/// few fixed sequences of signs that look random. The mean square of what they give is an unbiased estimate of
/// Σ_j (x_j ∂f/∂x_j)², for the mixed products have the mean 0. (Hutchinson, 1990, for the trace of g gᵀ.)
///
/// That sum's root is what an error of one unit, relative, in each input does to a result, so rounding a result whose
/// terms cancel, or that comes from a nearly singular solve, may fairly be compared with it.
class Sensitivity {
 public:
  static constexpr std::size_t directions = 8;

  Sensitivity(double value = 0) : value_(value) {}

  /// An input: `number` tells its signs.
  static Sensitivity input(double value, std::uint64_t number) {
    // Finaliser of splitmix64 (Steele, Lea, Flood, 2014): bits of neighbouring numbers are unrelated.
    std::uint64_t bits = (number + 1) * 0x9E3779B97F4A7C15U;
    bits = (bits ^ (bits >> 30U)) * 0xBF58476D1CE4E5B9U;
    bits = (bits ^ (bits >> 27U)) * 0x94D049BB133111EBU;
    bits ^= bits >> 31U;
    Sensitivity result(value);
    for (std::size_t d = 0; d < directions; ++d) result.along_[d] = ((bits >> d) & 1U) != 0 ? value : -value;
    return result;
  }

  double value() const { return value_; }

  double mean_square() const {
    double sum = 0;
    for (const double each : along_) sum += each * each;
    return sum / static_cast<double>(directions);
  }

  Sensitivity operator-() const { return chain(-value_, -1); }
  friend Sensitivity operator+(const Sensitivity& a, const Sensitivity& b) {
    return combine(a.value_ + b.value_, a, 1, b, 1);
  }
  friend Sensitivity operator-(const Sensitivity& a, const Sensitivity& b) {
    return combine(a.value_ - b.value_, a, 1, b, -1);
  }
  friend Sensitivity operator*(const Sensitivity& a, const Sensitivity& b) {
    return combine(a.value_ * b.value_, a, b.value_, b, a.value_);
  }
  friend Sensitivity operator/(const Sensitivity& a, const Sensitivity& b) {
    const double quotient = a.value_ / b.value_;
    return combine(quotient, a, 1 / b.value_, b, -quotient / b.value_);
  }

  friend Sensitivity sin(const Sensitivity& x) { return x.chain(std::sin(x.value_), std::cos(x.value_)); }
  friend Sensitivity cos(const Sensitivity& x) { return x.chain(std::cos(x.value_), -std::sin(x.value_)); }
  friend Sensitivity exp(const Sensitivity& x) { return x.chain(std::exp(x.value_), std::exp(x.value_)); }
  friend Sensitivity log(const Sensitivity& x) { return x.chain(std::log(x.value_), 1 / x.value_); }
  friend Sensitivity sqrt(const Sensitivity& x) {
    const double root = std::sqrt(x.value_);
    return x.chain(root, 0.5 / root);
  }

 private:
  Sensitivity chain(double value, double slope) const {
    Sensitivity result(value);
    for (std::size_t d = 0; d < directions; ++d) result.along_[d] = slope * along_[d];
    return result;
  }
  static Sensitivity combine(double value, const Sensitivity& a, double of_a, const Sensitivity& b, double of_b) {
    Sensitivity result(value);
    for (std::size_t d = 0; d < directions; ++d) result.along_[d] = of_a * a.along_[d] + of_b * b.along_[d];
    return result;
  }

  double value_;
  std::array<double, directions> along_{};
};

}  // namespace torsor
