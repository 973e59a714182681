// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace torsor::runtime {

/// All zeros of a trigonometric polynomial of degree 3, F(α) = Σ a_k cos kα + b_k sin kα, given by its values at eight
/// equally spaced angles from 0. An interval without zero is told by a bound of the slope, one with a single zero by a
/// bound of the curvature; others are halved. At most six; zeros that touch are given where |F| is smallest.
class CircleRoots {
 public:
  explicit CircleRoots(const std::array<double, 8>& values) noexcept {
    constexpr double half = std::numbers::sqrt2 / 2;
    constexpr std::array<double, 8> cosines{1, half, 0, -half, -1, -half, 0, half};
    for (std::size_t k = 0; k < 4; ++k) {
      for (std::size_t j = 0; j < 8; ++j) {
        a_[k] += values[j] * cosines[k * j % 8] / (k == 0 ? 8 : 4);
        b_[k] += values[j] * cosines[(k * j + 6) % 8] / (k == 0 ? 8 : 4);  // a sine is the cosine of a quarter turn less
      }
      const double size = std::hypot(a_[k], b_[k]), order = static_cast<double>(k);
      size_ += size;
      steepest_ += order * size;
      bent_ += order * order * size;
    }
    if (!(size_ > 0) || !std::isfinite(size_)) return;
    constexpr int parts = 16;
    for (int i = 0; i < parts; ++i) search(turn * i / parts, turn * (i + 1) / parts, 0);
  }

  [[nodiscard]] std::size_t count() const noexcept { return count_; }
  [[nodiscard]] double operator[](std::size_t i) const noexcept { return roots_[i]; }

 private:
  static constexpr double turn = 2 * std::numbers::pi;

  [[nodiscard]] double value(double angle, int derivative = 0) const noexcept {
    // The end of the circle is its beginning: with two roundings of one value a zero there would be on neither side.
    if (angle == turn) angle = 0;
    const double c = std::cos(angle), s = std::sin(angle);
    double ck = 1, sk = 0, sum = derivative == 0 ? a_[0] : 0;  // cos kα, sin kα
    for (std::size_t k = 1; k < 4; ++k) {
      const double turned = c * ck - s * sk;
      sk = s * ck + c * sk;
      ck = turned;
      sum += derivative == 0 ? a_[k] * ck + b_[k] * sk : static_cast<double>(k) * (b_[k] * ck - a_[k] * sk);
    }
    return sum;
  }

  void search(double from, double to, int depth) noexcept {
    const double middle = (from + to) / 2, half = (to - from) / 2;
    if (std::abs(value(middle)) > steepest_ * half) return;
    if (std::abs(value(middle, 1)) > bent_ * half) {
      double low = from, high = to, value_low = value(low);
      if ((value_low > 0) == (value(high) > 0) && value_low != 0) return;
      for (int i = 0; i < 60 && high - low > 0; ++i) {
        const double next = (low + high) / 2, there = value(next);
        if (next <= low || next >= high) break;
        ((there > 0) == (value_low > 0) ? low : high) = next;
      }
      add((low + high) / 2);
    } else if (depth < 24) {
      search(from, middle, depth + 1);
      search(middle, to, depth + 1);
    } else if (std::abs(value(middle)) <= 1e-13 * size_) {
      add(middle);
    }
  }

  void add(double angle) noexcept {
    for (std::size_t i = 0; i < count_; ++i) {
      if (std::abs(std::remainder(roots_[i] - angle, turn)) < 1e-7) return;
    }
    if (count_ < roots_.size()) roots_[count_++] = angle;
  }

  std::array<double, 4> a_{}, b_{};
  double size_ = 0, steepest_ = 0, bent_ = 0;
  std::array<double, 8> roots_{};
  std::size_t count_ = 0;
};

}  // namespace torsor::runtime
