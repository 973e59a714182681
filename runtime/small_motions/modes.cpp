// SPDX-License-Identifier: MIT
#include "torsor/runtime/small_motions/modes.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include "torsor/runtime/numerics/decompositions.hpp"

namespace torsor::runtime {

namespace {

/// Turns a mode round, or divides it, so that its entry of the largest √M_ii |x_i| is positive or 1.
template <class Column>
[[nodiscard]] Eigen::Index leading_entry(const Column& shape, const Eigen::MatrixXd& M) {
  Eigen::Index place = 0;
  (shape.cwiseAbs().array() * M.diagonal().array().sqrt()).maxCoeff(&place);
  return place;
}

}  // namespace

NaturalModes natural_modes(const LinearSystem& system) {
  const NormalisedSystem normal = normalised(system);
  const double asymmetry = (normal.S - normal.S.transpose()).cwiseAbs().maxCoeff();
  if (asymmetry > 1e-9) {
    throw std::invalid_argument(
        "the stiffness is not symmetric (by " + std::to_string(asymmetry) +
        " of its size): such a system has no natural modes with real shapes in general; ask for damped_modes");
  }
  const SymmetricEigenpairs pairs = symmetric_eigenpairs(0.5 * (normal.S + normal.S.transpose()));
  // Of xᵀ S x nothing is left but rounding where it is below some n ε of |x|ᵀ |S| |x|: of that mode's own stiffnesses, not of
  // the largest ones of all.
  const Eigen::MatrixXd shapes = pairs.vectors.cwiseAbs();
  const Eigen::VectorXd terms = shapes.cwiseProduct(normal.S.cwiseAbs() * shapes).colwise().sum();
  const double part = 4.0 * static_cast<double>(system.size()) * std::numeric_limits<double>::epsilon();
  const Eigen::VectorXd values = (pairs.values.array().abs() <= part * terms.array()).select(0.0, pairs.values);
  NaturalModes modes{values * (normal.sigma * normal.sigma), normal.coordinates(pairs.vectors)};
  for (Eigen::Index k = 0; k < modes.shapes.cols(); ++k) {
    if (modes.shapes(leading_entry(modes.shapes.col(k), system.M), k) < 0.0) modes.shapes.col(k) *= -1.0;
  }
  return modes;
}

std::vector<DampedMode> damped_modes(const LinearSystem& system) {
  const NormalisedSystem normal = normalised(system);
  const Eigen::Index n = system.size();
  Eigen::MatrixXd state = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  state.topRightCorner(n, n).setIdentity();
  state.bottomLeftCorner(n, n) = -normal.S;
  state.bottomRightCorner(n, n) = -normal.D;
  const Eigenpairs pairs = eigenpairs(state);
  std::vector<Eigen::Index> order(static_cast<std::size_t>(2 * n));
  std::iota(order.begin(), order.end(), Eigen::Index(0));
  const Eigen::VectorXcd& values = pairs.values;
  std::stable_sort(order.begin(), order.end(), [&values](Eigen::Index a, Eigen::Index b) {
    const double first = std::abs(values(a)), second = std::abs(values(b));
    return first != second ? first < second : values(a).imag() > values(b).imag();
  });
  std::vector<DampedMode> modes;
  for (const Eigen::Index k : order) {
    const std::complex<double> mu = values(k);
    Eigen::VectorXcd y = pairs.vectors.col(k).head(n);
    y /= y.norm();
    DampedMode mode;
    mode.residual = (mu * mu * y + mu * (normal.D * y) + normal.S * y).norm();
    mode.eigenvalue = normal.sigma * mu;
    mode.shape = normal.coordinates(y);
    const std::complex<double> leading = mode.shape(leading_entry(mode.shape, system.M));
    mode.shape /= leading;
    modes.push_back(std::move(mode));
  }
  return modes;
}

ProportionalDamping proportional_damping(const LinearSystem& system) {
  const NormalisedSystem normal = normalised(system);
  const double size = normal.D.norm();
  ProportionalDamping result;
  if (size == 0.0) return result;
  // Projections on 1 and on the part of S that is orthogonal to it; a K proportional to M leaves nothing of that part.
  const auto n = static_cast<double>(system.size());
  const double mean = normal.S.trace() / n;
  const Eigen::MatrixXd deviator = normal.S - mean * Eigen::MatrixXd::Identity(system.size(), system.size());
  const double square = deviator.squaredNorm();
  const double beta = square > 1e-24 * normal.S.squaredNorm() ? normal.D.cwiseProduct(deviator).sum() / square : 0.0;
  const double alpha = normal.D.trace() / n - beta * mean;
  const Eigen::MatrixXd rest =
      normal.D - alpha * Eigen::MatrixXd::Identity(system.size(), system.size()) - beta * normal.S;
  result.alpha = alpha * normal.sigma;
  result.beta = beta / normal.sigma;
  result.residual = rest.norm() / size;
  return result;
}

ModalDamping modal_damping(const NaturalModes& modes, const Eigen::MatrixXd& C) {
  Eigen::MatrixXd modal = modes.shapes.transpose() * C * modes.shapes;
  ModalDamping result{modal.diagonal(), Eigen::VectorXd(modal.rows()), 0.0};
  for (Eigen::Index i = 0; i < modal.rows(); ++i) {
    const double square = modes.squared_frequencies(i);
    result.ratios(i) =
        square > 0.0 ? result.rates(i) / (2.0 * std::sqrt(square)) : std::numeric_limits<double>::quiet_NaN();
  }
  modal.diagonal().setZero();
  const double largest = result.rates.cwiseAbs().maxCoeff(), coupled = modal.cwiseAbs().maxCoeff();
  if (coupled > 0.0) result.coupling = largest > 0.0 ? coupled / largest : std::numeric_limits<double>::infinity();
  return result;
}

}  // namespace torsor::runtime
