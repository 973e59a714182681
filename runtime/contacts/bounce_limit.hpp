// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace torsor::runtime {

/// The time to which the impacts of one contact tend. Along a sequence of impacts that fades, the time is a smooth
/// function of the speed of approach w, t = t_end - c1 w - c2 w² - ..., because each flight is a smooth function of the
/// speed that it starts with. So t_end is the polynomial through some impacts, taken at w = 0 (Neville's scheme).
/// Impacts are kept whose speeds are some factor of two apart, so that their errors are not made larger. A late impact
/// is located within (rounding of the gap)/w, an early one needs more terms: the scheme that is estimated best counts.
class BounceLimit {
 public:
  /// An impact at a time, with the speed of approach w > 0 and the rounding of the gap.
  void operator()(double time, double speed, double rounding_of_gap) noexcept {
    if (!(speed > 0)) return;
    if (seen_ > 0 && speed >= last_speed_) seen_ = 0;  // it gains: another sequence
    last_speed_ = speed;
    if (seen_ > 0 && speed > 0.55 * at(seen_ - 1).speed) return;
    nodes_[seen_++ % kept] = {time, speed, rounding_of_gap / speed + std::numeric_limits<double>::epsilon() * time};
  }

  /// The end, or `otherwise` where too few impacts are known. `latest` is a time before which it cannot be.
  [[nodiscard]] double operator()(double otherwise, double latest) const noexcept {
    double best = otherwise, doubt = std::numeric_limits<double>::infinity();
    const std::size_t count = std::min(seen_, kept);
    for (std::size_t last = seen_ - count; last < seen_; ++last) {
      std::array<double, most + 1> row{};  // extrapolations from nodes last - k, ..., last, along k
      double amplified = 0;
      for (std::size_t k = 0; k <= most && k <= last - (seen_ - count); ++k) {
        const Node& far = at(last - k);
        double value = far.time;
        std::array<double, most + 1> next{};
        next[0] = value;
        amplified = std::max(amplified, far.doubt);
        // Neville: row[j] holds the value through nodes last - k + 1, ..., last - k + 1 + j.
        for (std::size_t j = 0; j < k; ++j) {
          const Node& near = at(last - k + j + 1);
          next[j + 1] = row[j] + (row[j] - next[j]) * near.speed / (far.speed - near.speed);
        }
        if (k >= 3) {
          const double change = std::abs(next[k] - next[k - 1]) / 16 + std::abs(next[k] - row[k - 1]) / 16;
          const double here = change + 4 * amplified;
          if (here < doubt && next[k] >= latest) {
            doubt = here;
            best = next[k];
          }
        }
        row = next;
      }
    }
    return best;
  }

  void clear() noexcept { seen_ = 0; }

 private:
  struct Node {
    double time, speed, doubt;
  };
  static constexpr std::size_t kept = 40, most = 6;
  [[nodiscard]] const Node& at(std::size_t i) const noexcept { return nodes_[i % kept]; }

  std::array<Node, kept> nodes_{};
  std::size_t seen_ = 0;
  double last_speed_ = 0;
};

}  // namespace torsor::runtime
