// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/verification/radau_iia_5.hpp"

#include <algorithm>
#include <cmath>

namespace torsor {
namespace {

using RadauMatrix = std::vector<std::vector<double>>;

const double root6 = std::sqrt(6.0);
const std::array<double, 3> radau_nodes{(4 - root6) / 10, (4 + root6) / 10, 1.0};
const std::array<std::array<double, 3>, 3> radau_matrix{
    {{(88 - 7 * root6) / 360, (296 - 169 * root6) / 1800, (-2 + 3 * root6) / 225},
     {(296 + 169 * root6) / 1800, (88 + 7 * root6) / 360, (-2 - 3 * root6) / 225},
     {(16 - root6) / 36, (16 + root6) / 36, 1.0 / 9}}};
/// The inverse of the matrix's real eigenvalue, and the weights of the stages in the estimate.
const double real_shift = 30 / (6 + std::cbrt(81.0) - std::cbrt(9.0));
const std::array<double, 3> estimate_weights{-(13 + 7 * root6) / 3, (-13 + 7 * root6) / 3, -1.0 / 3};

/// The estimate has order 3: held to this, the solution of order 5 meets the tolerance.
double of_estimate(double tolerance) { return 0.1 * std::pow(tolerance, 2.0 / 3); }

/// Gauss elimination with the largest pivot of each column; the columns stay in place.
class RadauFactors {
 public:
  explicit RadauFactors(RadauMatrix m) : m_(std::move(m)) {
    const std::size_t n = m_.size();
    for (std::size_t k = 0; k < n; ++k) {
      std::size_t best = k;
      for (std::size_t i = k; i < n; ++i) {
        if (std::abs(m_[i][k]) > std::abs(m_[best][k])) best = i;
      }
      order_.push_back(best);
      std::swap(m_[k], m_[best]);
      regular_ = regular_ && std::abs(m_[k][k]) > 0;
      if (!regular_) return;
      for (std::size_t i = k + 1; i < n; ++i) {
        m_[i][k] /= m_[k][k];
        for (std::size_t j = k + 1; j < n; ++j) m_[i][j] -= m_[i][k] * m_[k][j];
      }
    }
  }
  bool regular() const { return regular_; }
  void solve(std::vector<double>& b) const {
    const std::size_t n = m_.size();
    for (std::size_t k = 0; k < n; ++k) std::swap(b[k], b[order_[k]]);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < i; ++j) b[i] -= m_[i][j] * b[j];
    }
    for (std::size_t i = n; i-- > 0;) {
      for (std::size_t j = i + 1; j < n; ++j) b[i] -= m_[i][j] * b[j];
      b[i] /= m_[i][i];
    }
  }

 private:
  RadauMatrix m_;
  std::vector<std::size_t> order_;
  bool regular_ = true;
};

}  // namespace

RadauIia5::RadauIia5(Slope slope, Settle settle, std::vector<double> y, double tolerance)
    : MotionIntegrator(std::move(slope), std::move(settle), std::move(y)), tolerance_(tolerance) {
  next_ = slope_here_ = y_;
  if (!slope_(t_, y_, slope_here_)) fail("there is no acceleration");
}

bool RadauIia5::linearise() {
  const std::size_t n = y_.size();
  jacobian_.assign(n, std::vector<double>(n));
  std::vector<double> moved = y_, rates(n);
  for (std::size_t j = 0; j < n; ++j) {
    const double step = 1e-7 * (1 + std::abs(y_[j]));
    moved[j] = y_[j] + step;
    if (!slope_(t_, moved, rates)) return false;
    for (std::size_t i = 0; i < n; ++i) jacobian_[i][j] = (rates[i] - slope_here_[i]) / step;
    moved[j] = y_[j];
  }
  return true;
}

double RadauIia5::attempt(double h) {
  const std::size_t n = y_.size();
  RadauMatrix whole(3 * n, std::vector<double>(3 * n));
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t p = 0; p < n; ++p) {
        for (std::size_t q = 0; q < n; ++q) whole[i * n + p][j * n + q] = -h * radau_matrix[i][j] * jacobian_[p][q];
        if (i == j) whole[i * n + p][j * n + p] += 1;
      }
    }
  }
  const RadauFactors newton(std::move(whole));
  if (!newton.regular()) return std::nan("");
  std::array<std::vector<double>, 3> slopes;
  for (auto& each : slopes) each.resize(n);
  std::vector<double> z(3 * n, 0.0), residual(3 * n), at(n);
  double before = 0.0;
  bool converged = false;
  constexpr int patience = 12;
  for (int sweep = 0; sweep < patience && !converged; ++sweep) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t p = 0; p < n; ++p) at[p] = y_[p] + z[i * n + p];
      if (!slope_(t_ + radau_nodes[i] * h, at, slopes[i])) return std::nan("");
    }
    double change = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t p = 0; p < n; ++p) {
        double& r = residual[i * n + p] = -z[i * n + p];
        for (std::size_t j = 0; j < 3; ++j) r += h * radau_matrix[i][j] * slopes[j][p];
      }
    }
    newton.solve(residual);
    for (std::size_t k = 0; k < z.size(); ++k) {
      z[k] += residual[k];
      change = std::max(change, std::abs(residual[k]) / (1 + std::abs(y_[k % n])));
    }
    if (!std::isfinite(change) || (sweep > 1 && change > 2 * before)) return std::nan("");
    converged = change <= std::max(1e-15, 1e-2 * tolerance_);
    before = change;
  }
  if (!converged) return std::nan("");
  for (std::size_t p = 0; p < n; ++p) next_[p] = y_[p] + z[2 * n + p];

  RadauMatrix shifted(n, std::vector<double>(n));
  std::vector<double> error = slope_here_;
  for (std::size_t p = 0; p < n; ++p) {
    for (std::size_t q = 0; q < n; ++q) shifted[p][q] = (p == q ? real_shift / h : 0.0) - jacobian_[p][q];
    for (std::size_t i = 0; i < 3; ++i) error[p] += estimate_weights[i] / h * z[i * n + p];
  }
  const RadauFactors filter(std::move(shifted));
  if (!filter.regular()) return std::nan("");
  filter.solve(error);
  const double allowed = of_estimate(tolerance_);
  double square = 0.0;
  for (std::size_t p = 0; p < n; ++p) {
    const double share = error[p] / (allowed * (1 + std::max(std::abs(y_[p]), std::abs(next_[p]))));
    square += share * share;
  }
  return std::sqrt(square / static_cast<double>(n));
}

bool RadauIia5::advance(double end) {
  if (!status_.empty()) return false;
  constexpr int patience = 60;
  int refused = 0;
  const double least = shortest_step(end);
  if (h_ == 0.0) h_ = 1e-4 * (end - t_);
  bool linear = false;
  while (end - t_ > least) {
    if (!linear && !linearise()) return fail("there is no acceleration");
    linear = true;
    const bool lands = h_ >= end - t_;
    const double h = lands ? end - t_ : h_;
    const double error = attempt(h), reached = lands ? end : t_ + h;
    const double factor = std::isfinite(error) ? std::clamp(0.9 * std::pow(std::max(error, 1e-12), -0.25), 0.2, 6.0) : 0.25;
    const double moved = error <= 1.0 ? settled(reached, next_, tolerance_) : 0.0;
    if (!(error <= 1.0) || !(moved <= 1.0)) {
      h_ = h * std::min(0.5, factor);
      if (++refused > patience || h_ < least) return moved > 1.0 ? fail_settling() : fail("the steps have become too short");
      continue;
    }
    const std::vector<double> slope_before = slope_here_;
    t_ = reached;
    y_ = next_;
    ++steps_;
    linear = false;
    if (!slope_(t_, y_, slope_here_)) return fail("there is no acceleration");
    double bend = 0.0;
    for (std::size_t p = 0; p < y_.size(); ++p) {
      bend = std::max(bend, h * std::abs(slope_here_[p] - slope_before[p]) / (of_estimate(tolerance_) * (1 + std::abs(y_[p]))));
    }
    if (creeps(h, bend)) return fail_creeping();
    h_ = refused > 0 ? h : h < 0.99 * h_ ? std::max(h * factor, h_) : h * factor;
    refused = 0;
  }
  return true;
}

}  // namespace torsor
