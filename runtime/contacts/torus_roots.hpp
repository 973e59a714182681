// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace torsor::runtime {

/// All common zeros of two trigonometric polynomials F_k(α, β) of degree 3 in each angle, given by their values at
/// eight by eight equally spaced angles from 0. A cell without zero is told by bounds of the first derivatives at its
/// middle and of the second ones; one with a single zero by the inverse of the slopes there, times F, whose own slopes
/// are then within 1 of the identity (Newton and Kantorovich). Others are quartered. Source: Neumaier, Interval Methods
/// for Systems of Equations, 5.1.
class TorusRoots {
 public:
  static constexpr std::size_t samples = 8;
  using Values = std::array<std::array<double, 2>, samples * samples>;  ///< at α_j, β_k in place samples j + k

  explicit TorusRoots(const Values& values) noexcept {
    for (std::size_t which = 0; which < 2; ++which) take(values, which);
    if (!(bent_[0] > 0 && bent_[1] > 0 && std::isfinite(bent_[0] + bent_[1]))) return;
    constexpr int parts = 8;
    constexpr double half = std::numbers::pi / parts;
    for (int j = 0; j < parts; ++j) {
      for (int k = 0; k < parts; ++k) search(half * (2 * j + 1), half * (2 * k + 1), half, 0);
    }
  }

  [[nodiscard]] std::size_t count() const noexcept { return count_; }
  [[nodiscard]] const std::array<double, 2>& operator[](std::size_t i) const noexcept { return roots_[i]; }
  /// Whether these are all: no more cells were needed than are tried, as where zeros lie on curves, and no more zeros
  /// found.
  [[nodiscard]] bool complete() const noexcept { return cells_ <= most_cells && count_ < roots_.size(); }

 private:
  static constexpr std::size_t terms = 7;  ///< 1, cos, sin, cos 2, sin 2, cos 3, sin 3
  static constexpr int most_cells = 8192;
  using Wave = std::array<double, terms>;
  static constexpr double order(std::size_t term) noexcept { return static_cast<double>((term + 1) / 2); }

  static Wave wave(double angle) noexcept {
    const double c = std::cos(angle), s = std::sin(angle);
    Wave w{1, c, s};
    for (std::size_t k = 3; k < terms; k += 2) {
      w[k] = c * w[k - 2] - s * w[k - 1];
      w[k + 1] = s * w[k - 2] + c * w[k - 1];
    }
    return w;
  }

  // Sums over the samples: 8 times the mean, 4 times each other coefficient, in each direction.
  void take(const Values& values, std::size_t which) noexcept {
    std::array<Wave, samples> at;
    for (std::size_t j = 0; j < samples; ++j) at[j] = wave(std::numbers::pi / 4 * static_cast<double>(j));
    for (std::size_t p = 0; p < terms; ++p) {
      for (std::size_t q = 0; q < terms; ++q) {
        double sum = 0;
        for (std::size_t j = 0; j < samples; ++j) {
          for (std::size_t k = 0; k < samples; ++k) sum += values[samples * j + k][which] * at[j][p] * at[k][q];
        }
        const double share = (p == 0 ? 8 : 4) * (q == 0 ? 8 : 4), orders = order(p) + order(q);
        factors_[which][p][q] = sum / share;
        bent_[which] += orders * orders * std::abs(sum / share);
      }
    }
  }

  struct Local {
    std::array<double, 2> value{}, by_a{}, by_b{};
    [[nodiscard]] double determinant() const noexcept { return by_a[0] * by_b[1] - by_a[1] * by_b[0]; }
    /// By how much Newton's method changes both angles.
    [[nodiscard]] std::array<double, 2> step() const noexcept {
      const double d = determinant();
      return {(by_b[1] * value[0] - by_b[0] * value[1]) / d, (by_a[0] * value[1] - by_a[1] * value[0]) / d};
    }
  };
  [[nodiscard]] Local local(double a, double b) const noexcept {
    const Wave u = wave(a), v = wave(b);
    Local l;
    for (std::size_t which = 0; which < 2; ++which) {
      std::array<double, terms> sums{}, slopes{};
      for (std::size_t p = 0; p < terms; ++p) {
        const Wave& f = factors_[which][p];
        sums[p] = f[0];
        for (std::size_t q = 1; q < terms; q += 2) {
          sums[p] += f[q] * v[q] + f[q + 1] * v[q + 1];
          slopes[p] += order(q) * (f[q + 1] * v[q] - f[q] * v[q + 1]);
        }
      }
      l.value[which] = sums[0];
      l.by_b[which] = slopes[0];
      for (std::size_t p = 1; p < terms; p += 2) {
        l.value[which] += sums[p] * u[p] + sums[p + 1] * u[p + 1];
        l.by_b[which] += slopes[p] * u[p] + slopes[p + 1] * u[p + 1];
        l.by_a[which] += order(p) * (sums[p + 1] * u[p] - sums[p] * u[p + 1]);
      }
    }
    return l;
  }

  void search(double a, double b, double half, int depth) noexcept {
    if (++cells_ > most_cells) return;
    const Local l = local(a, b);
    for (std::size_t k = 0; k < 2; ++k) {
      if (std::abs(l.value[k]) > half * (std::abs(l.by_a[k]) + std::abs(l.by_b[k])) + half * half / 2 * bent_[k])
        return;
    }
    const double d = std::abs(l.determinant());
    const double off_a = half * (std::abs(l.by_b[1]) * bent_[0] + std::abs(l.by_b[0]) * bent_[1]);
    const double off_b = half * (std::abs(l.by_a[1]) * bent_[0] + std::abs(l.by_a[0]) * bent_[1]);
    if (d > 0) {
      // The inverse of the slopes times F: what was nearly parallel no longer is.
      const auto step = l.step();
      if (std::abs(step[0]) > half * (1 + off_a / d / 2) || std::abs(step[1]) > half * (1 + off_b / d / 2)) return;
      if (std::max(off_a, off_b) < 0.9 * d) return approach(a, b);
    }
    if (depth >= 20) return add(a, b);  // zeros that touch
    const double part = half / 2;
    for (const double x : {a - part, a + part}) {
      for (const double y : {b - part, b + part}) search(x, y, part, depth + 1);
    }
  }

  void approach(double a, double b) noexcept {
    for (int k = 0; k < 30; ++k) {
      const auto step = local(a, b).step();
      if (!std::isfinite(step[0] + step[1])) return;
      a -= step[0];
      b -= step[1];
      if (std::max(std::abs(step[0]), std::abs(step[1])) <= 1e-12) break;
    }
    add(a, b);
  }

  void add(double a, double b) noexcept {
    constexpr double turn = 2 * std::numbers::pi;
    const auto apart = [](double x, double y) {
      const double d = std::abs(x - y);
      return d <= turn ? std::min(d, turn - d) : std::abs(std::remainder(d, turn));  // which is slow
    };
    for (std::size_t i = 0; i < count_; ++i) {
      if (apart(roots_[i][0], a) + apart(roots_[i][1], b) < 1e-7) return;
    }
    if (count_ < roots_.size()) roots_[count_++] = {a, b};
  }

  std::array<std::array<Wave, terms>, 2> factors_{};
  std::array<double, 2>
      bent_{};  ///< no second derivative along any direction of both angles by h is larger than this h²
  std::array<std::array<double, 2>, 64> roots_{};
  std::size_t count_ = 0;
  int cells_ = 0;
};

}  // namespace torsor::runtime
