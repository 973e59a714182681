// SPDX-License-Identifier: MIT
#include "torsor/runtime/small_motions/forced_response.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>

namespace torsor::runtime {

FrequencyResponse::FrequencyResponse(const LinearSystem& system, const Eigen::VectorXcd& force)
    : normal_(normalised(system)) {
  if (force.size() != system.size()) {
    throw std::invalid_argument("the force has " + std::to_string(force.size()) + " entries for " +
                                std::to_string(system.size()) + " coordinates");
  }
  force_ = normal_.force(force);
}

std::optional<Eigen::VectorXcd> FrequencyResponse::operator()(double omega) const {
  const double ratio = omega / normal_.sigma;
  Eigen::MatrixXcd dynamic = normal_.S.cast<std::complex<double>>();
  dynamic += std::complex<double>(0.0, ratio) * normal_.D.cast<std::complex<double>>();
  dynamic.diagonal().array() -= ratio * ratio;
  const Eigen::FullPivLU<Eigen::MatrixXcd> factor(dynamic);
  if (!factor.isInvertible()) return std::nullopt;
  return normal_.coordinates(Eigen::VectorXcd(factor.solve(force_)));
}

std::vector<ResonancePoint> resonance_curve(const LinearSystem& system, const Eigen::VectorXcd& force,
                                            const std::vector<double>& grid) {
  const FrequencyResponse response(system, force);
  std::vector<ResonancePoint> curve;
  curve.reserve(grid.size());
  for (const double omega : grid) curve.push_back({omega, response(omega)});
  return curve;
}

std::vector<double> antiresonances(const LinearSystem& system, const Eigen::VectorXd& force, Eigen::Index coordinate) {
  const NormalisedSystem normal = normalised(system);
  const Eigen::Index n = system.size();
  if (coordinate < 0 || coordinate >= n || force.size() != n) {
    throw std::invalid_argument("the antiresonance of coordinate " + std::to_string(coordinate) + " under a force of " +
                                std::to_string(force.size()) + " entries is asked of " + std::to_string(n) +
                                " coordinates");
  }
  // In units without dimension: x_i = y_i / sqrt(M_ii), and the force at the size of the stiffness.
  const Eigen::VectorXd scale = system.M.diagonal().cwiseSqrt().cwiseInverse();
  const double square = normal.sigma * normal.sigma;
  Eigen::MatrixXd K = scale.asDiagonal() * system.K * scale.asDiagonal();
  Eigen::MatrixXd M = scale.asDiagonal() * system.M * scale.asDiagonal();
  K /= square;
  const Eigen::MatrixXd M_whole = M, K_whole = K;
  const Eigen::VectorXd load = scale.asDiagonal() * force;
  const double size = load.norm();
  if (size == 0.0) return {};
  K.col(coordinate) = load / size;
  M.col(coordinate).setZero();
  const Eigen::GeneralizedEigenSolver<Eigen::MatrixXd> solver(K, M, false);
  std::vector<double> result;
  for (Eigen::Index k = 0; k < n; ++k) {
    const std::complex<double> alpha = solver.alphas()(k);
    const double beta = solver.betas()(k);
    // A double infinite eigenvalue shows at the square root of rounding.
    if (std::abs(beta) < 1e-7 * std::abs(alpha) || beta == 0.0) continue;
    const std::complex<double> value = alpha / beta;
    if (std::abs(value.imag()) > 1e-9 * std::abs(value) || value.real() < 0.0) continue;
    const Eigen::FullPivLU<Eigen::MatrixXd> whole(K_whole - value.real() * M_whole);
    // The estimate of a condition leaves out what a pivot of zero should show.
    if (!whole.isInvertible() || whole.rcond() < 1e-12) continue;
    result.push_back(normal.sigma * std::sqrt(value.real()));
  }
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<ResonancePeak> resonance_peaks(const LinearSystem& system, const Eigen::VectorXcd& force,
                                           const PeakSearch& search) {
  const auto [coordinate, from, to, samples] = search;
  const FrequencyResponse response(system, force);
  if (samples < 3 || !(from < to) || coordinate < 0 || coordinate >= system.size()) {
    throw std::invalid_argument("peaks need a coordinate of the system, an interval and at least three samples");
  }
  const auto height = [&](double omega) {
    const auto amplitude = response(omega);
    return amplitude ? std::abs((*amplitude)(search.coordinate)) : std::numeric_limits<double>::infinity();
  };
  const double step = (to - from) / (samples - 1);
  std::vector<double> heights;
  for (int i = 0; i < samples; ++i) heights.push_back(height(from + i * step));
  std::vector<ResonancePeak> peaks;
  for (int i = 1; i + 1 < samples; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (!(heights[k] > heights[k - 1]) || !(heights[k] >= heights[k + 1])) continue;
    if (std::isinf(heights[k])) {
      peaks.push_back({from + i * step, heights[k]});
      continue;
    }
    double a = from + (i - 1) * step, b = from + (i + 1) * step;
    const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
    while (b - a > 1e-9 * (to - from)) {
      const double left = b - golden * (b - a), right = a + golden * (b - a);
      if (!(a < left && left < right && right < b)) break;  // no speeds are left between
      const double of_left = height(left), of_right = height(right);
      if (std::isinf(of_left) || std::isinf(of_right)) {
        a = b = std::isinf(of_left) ? left : right;
      } else if (of_left < of_right) {
        a = left;
      } else {
        b = right;
      }
    }
    const double omega = 0.5 * (a + b);
    peaks.push_back({omega, height(omega)});
  }
  return peaks;
}

}  // namespace torsor::runtime
