// SPDX-License-Identifier: MIT
#include "torsor/runtime/contacts/gap_rounding.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace torsor::runtime {
namespace {

std::size_t as(int i) noexcept { return static_cast<std::size_t>(i); }

}  // namespace

GapRounding::GapRounding(const ContactMechanism& mechanism) : mechanism_(mechanism) {
  int rows = 0, bearings = 0;
  for (int i = 0; i < mechanism.sizes().contacts; ++i) {
    const ContactRule rule = mechanism.rule(i);
    first_row_.push_back(rule.normal ? rows : -1);
    rows += std::clamp(rule.rows(), 0, 3);  // a rule may be impossible
    bearings += std::clamp(rule.bearing, 0, 2);
  }
  const ContactSizes& sizes = mechanism.sizes();
  here_ = there_ = ContactReading(sizes, rows, bearings);
  y_.resize(as(sizes.coordinates + sizes.velocities));
  moved_ = y_;
  rates_.resize(as(sizes.coordinates));
  rounding_.resize(first_row_.size());
  ahead_ = behind_ = before_ = rounding_;
  follows_.resize(first_row_.size());
}

bool GapRounding::displaced(double t, double h, std::vector<double>& gaps) {
  moved_ = y_;
  for (std::size_t i = 0; i < rates_.size(); ++i) moved_[i] += h * rates_[i];
  if (mechanism_.read(t, moved_, there_) != Evaluation::ok) return false;
  std::copy_n(there_.gap.begin(), gaps.size(), gaps.begin());
  return true;
}

bool GapRounding::measure_anew(double t, std::span<const double> y) {
  before_ = rounding_;
  measure(t, y);
  bool grown = false;
  for (std::size_t i = 0; i < rounding_.size(); ++i) {
    grown = grown || rounding_[i] > 2 * before_[i];
    rounding_[i] = std::max(rounding_[i], before_[i]);
  }
  return grown;
}

void GapRounding::measure(double t, std::span<const double> y) {
  constexpr int directions = 6;
  constexpr double step = 1e-12, almost_none = 0x1p-500;
  std::fill(rounding_.begin(), rounding_.end(), 0);
  const auto nq = rates_.size();
  std::fill(y_.begin(), y_.end(), 0);
  // Not zero: quaternions keep their directions.
  for (std::size_t i = 0; i < nq; ++i) y_[i] = almost_none * y[i];
  mechanism_.normalise(y_);
  if (mechanism_.read(t, y_, here_) != Evaluation::ok) return;
  std::uint32_t random = 1;
  for (int k = 0; k < directions; ++k) {
    for (std::size_t j = nq; j < y_.size(); ++j) {
      random = 1664525U * random + 1013904223U;
      y_[j] = (static_cast<double>(random >> 8) / 0x1p23 - 1);  // between -1 and 1
    }
    mechanism_.coordinate_rates(t, y_, rates_);
    // As long as a gap does not follow, its rounding is larger than the displacement.
    for (std::size_t i = 0; i < rounding_.size(); ++i) follows_[i] = first_row_[i] < 0;
    double h = step;
    for (int times = 0; times < 4; ++times, h *= 1e3) {
      if (!displaced(t, h, ahead_) || !displaced(t, -h, behind_)) return;
      for (std::size_t i = 0; i < rounding_.size(); ++i) {
        if (follows_[i]) continue;
        double change = 0;
        for (std::size_t j = nq; j < y_.size(); ++j) {
          change += 2 * h * here_.J(first_row_[i], static_cast<Eigen::Index>(j - nq)) * y_[j];
        }
        const double noise = std::abs(ahead_[i] - behind_[i] - change);
        follows_[i] = noise <= std::abs(change) / 4;
        if (follows_[i]) rounding_[i] = std::max(rounding_[i], 2 * noise);
      }
      if (std::find(follows_.begin(), follows_.end(), false) == follows_.end()) break;
    }
  }
}

}  // namespace torsor::runtime
