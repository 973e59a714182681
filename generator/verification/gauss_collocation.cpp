// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/verification/gauss_collocation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace torsor {
namespace {

const double root15 = std::sqrt(15.0);
const std::array<double, 3> gauss_nodes{0.5 - root15 / 10, 0.5, 0.5 + root15 / 10}, gauss_weights{5.0 / 18, 4.0 / 9, 5.0 / 18};
const std::array<std::array<double, 3>, 3> gauss_matrix{{{5.0 / 36, 2.0 / 9 - root15 / 15, 5.0 / 36 - root15 / 30},
                                                   {5.0 / 36 + root15 / 24, 2.0 / 9, 5.0 / 36 - root15 / 24},
                                                   {5.0 / 36 + root15 / 30, 2.0 / 9 + root15 / 15, 5.0 / 36}}};

}  // namespace

GaussCollocation6::GaussCollocation6(Slope slope, Settle settle, std::vector<double> y, double step)
    : MotionIntegrator(std::move(slope), std::move(settle), std::move(y)), step_(step) {
  for (std::vector<double>& stage : stages_) stage.resize(y_.size());
  if (!slope_(t_, y_, stages_[0])) fail("there is no acceleration");
  stages_[1] = stages_[2] = stages_[0];
}

bool GaussCollocation6::advance(double end) {
  if (!status_.empty()) return false;
  const double start = t_;
  const auto count = static_cast<long>(std::ceil((end - start) / step_ * (1 - 1e-9)));
  const double h = (end - start) / static_cast<double>(std::max(1L, count));
  for (long k = 1; k <= count; ++k) {
    if (!step(h)) return false;
    t_ = k == count ? end : start + static_cast<double>(k) * h;
    if (settle_ && !settle_(t_, y_)) return fail("the constraints cannot be closed");
    ++steps_;
  }
  return true;
}

/// The stages of the step before are the first guess.
bool GaussCollocation6::step(double h) {
  const std::size_t n = y_.size();
  std::array<std::vector<double>, 3> next = stages_;
  std::vector<double> at(n);
  double before = std::numeric_limits<double>::infinity();
  constexpr int patience = 100;
  for (int sweep = 0;; ++sweep) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < n; ++k) {
        at[k] = y_[k] + h * (gauss_matrix[i][0] * stages_[0][k] + gauss_matrix[i][1] * stages_[1][k] + gauss_matrix[i][2] * stages_[2][k]);
      }
      if (!slope_(t_ + gauss_nodes[i] * h, at, next[i])) return fail("there is no acceleration");
    }
    double change = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < n; ++k) {
        change = std::max(change, std::abs(h * (next[i][k] - stages_[i][k])) / (1 + std::abs(y_[k])));
      }
    }
    stages_.swap(next);
    constexpr double rounding = 1e-14;
    if (change == 0.0 || (change < rounding && change >= before)) break;
    if (sweep == patience || !std::isfinite(change)) {
      return fail("the stages of a step do not converge: a shorter --step resolves faster motions");
    }
    before = change;
  }
  for (std::size_t k = 0; k < n; ++k) {
    y_[k] += h * (gauss_weights[0] * stages_[0][k] + gauss_weights[1] * stages_[1][k] + gauss_weights[2] * stages_[2][k]);
  }
  return true;
}

}  // namespace torsor
