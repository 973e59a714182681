// SPDX-License-Identifier: MIT
#include "torsor/runtime/numerics/root_search.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "torsor/runtime/numerics/decompositions.hpp"

namespace torsor::runtime {

namespace {

/// Newton's method on equations scaled by their size over a box.
class NewtonSearch {
 public:
  NewtonSearch(const RootEquations& equations, const SearchBox& box, const RootSearchOptions& options)
      : f_(equations.f), derivative_(equations.derivative), box_(box), options_(options), boxed_(box.lower.size()) {
    width_ = Eigen::VectorXd::Ones(equations.unknowns);
    width_.head(boxed_) = box.upper - box.lower;
  }

  /// The k-th of an additive sequence of low discrepancy in the box, the first in its middle: multiples of the powers
  /// of 1/φ with φ^{d+1} = φ + 1 (Roberts 2018, after Kronecker), the same on every machine.
  [[nodiscard]] Eigen::VectorXd start(int k) const {
    double phi = 2.0;
    for (int i = 0; i < 60; ++i) phi = std::pow(1.0 + phi, 1.0 / (static_cast<double>(boxed_) + 1.0));
    Eigen::VectorXd x = Eigen::VectorXd::Zero(width_.size());
    double step = 1.0;
    for (Eigen::Index i = 0; i < boxed_; ++i) {
      step /= phi;
      const double position = 0.5 + k * step;
      x(i) = box_.lower(i) + width_(i) * (position - std::floor(position));
    }
    return x;
  }

  /// Sizes of the equations: the largest value or change over the width of the box, over all starts.
  void measure() {
    for (int k = 0; k < options_.starts; ++k) {
      const Eigen::VectorXd x = start(k);
      const Eigen::VectorXd values = f_(x);
      if (size_.size() == 0) size_ = Eigen::VectorXd::Zero(values.size());
      const Eigen::MatrixXd slope = derivative_(x);
      if (!values.allFinite() || !slope.allFinite()) continue;
      const Eigen::VectorXd change = slope.leftCols(boxed_).cwiseAbs() * width_.head(boxed_);
      size_ = size_.cwiseMax(values.cwiseAbs()).cwiseMax(change);
    }
    for (Eigen::Index i = 0; i < size_.size(); ++i) {
      if (!(size_(i) > 0.0)) size_(i) = 1.0;
    }
  }

  /// Follows one start; true when x ends on a root.
  [[nodiscard]] bool follow(Eigen::VectorXd& x, double& residual, StartFailure& reason) const {
    Eigen::VectorXd values = scaled(x);
    residual = values.cwiseAbs().maxCoeff();
    bool stalled = false;
    for (int i = 0; i < options_.iterations && !stalled && std::isfinite(residual); ++i) {
      const bool at_root = residual <= options_.tolerance;
      const Eigen::MatrixXd slope = scaled_slope(x);
      if (!slope.allFinite()) {
        residual = std::nan("");
        break;
      }
      const Eigen::VectorXd step = newton_step(slope, values);
      const double before = values.norm();
      double shortening = 1.0;
      stalled = true;
      for (int halving = 0; halving < 30 && stalled; ++halving, shortening *= 0.5) {
        const Eigen::VectorXd next = x + shortening * step;
        const Eigen::VectorXd next_values = scaled(next);
        // On a root only steps that still halve what is left are worth taking: the rest is rounding.
        const double enough = at_root ? 0.5 : 1.0 - 1e-4 * shortening;
        if (next_values.allFinite() && next_values.norm() < enough * before) {
          x = next;
          values = next_values;
          stalled = false;
        }
        if (at_root) break;
      }
      residual = values.cwiseAbs().maxCoeff();
    }
    if (!std::isfinite(residual)) {
      reason = StartFailure::not_finite;
      return false;
    }
    if (residual > options_.tolerance) {
      reason = stalled ? StartFailure::stalled : StartFailure::too_many_iterations;
      return false;
    }
    reason = StartFailure::left_box;
    return bring_into_box(x);
  }

  [[nodiscard]] bool isolated(const Eigen::VectorXd& x) const {
    Eigen::MatrixXd slope = scaled_slope(x);
    slope = slope * inverse_column_scale(slope).asDiagonal();
    if (slope.rows() < slope.cols()) return false;
    // The scaled slope is of the size of 1 somewhere in the box; at a multiple root it is known to 1e-8.
    return singular_values(slope).values.minCoeff() > 1e-7;
  }

  /// Distance of two points, the largest over the unknowns of the box, relative to its width.
  [[nodiscard]] double distance(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const {
    double largest = 0.0;
    for (Eigen::Index i = 0; i < boxed_; ++i) {
      double difference = a(i) - b(i);
      if (is_angle(i)) difference = std::remainder(difference, 2.0 * std::numbers::pi);
      largest = std::max(largest, std::abs(difference) / width_(i));
    }
    return largest;
  }

 private:
  [[nodiscard]] Eigen::VectorXd scaled(const Eigen::VectorXd& x) const { return f_(x).cwiseQuotient(size_); }

  [[nodiscard]] Eigen::MatrixXd scaled_slope(const Eigen::VectorXd& x) const {
    return size_.cwiseInverse().asDiagonal() * derivative_(x) * width_.asDiagonal();
  }

  /// Turns the unknowns of a scaled slope into x: its columns already count in widths of the box, those without bounds
  /// are brought to the length 1 besides.
  [[nodiscard]] Eigen::VectorXd inverse_column_scale(const Eigen::MatrixXd& slope) const {
    Eigen::VectorXd scale = Eigen::VectorXd::Ones(width_.size());
    for (Eigen::Index j = boxed_; j < width_.size(); ++j) {
      const double length = slope.col(j).norm();
      if (length > 0.0) scale(j) = 1.0 / length;
    }
    return scale;
  }

  /// The shortest solution by least squares, by a rank-revealing orthogonal decomposition; in unknowns of equal size.
  [[nodiscard]] Eigen::VectorXd newton_step(const Eigen::MatrixXd& slope, const Eigen::VectorXd& values) const {
    const Eigen::VectorXd scale = inverse_column_scale(slope);
    const Eigen::MatrixXd even = slope * scale.asDiagonal();
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
    decomposition.setThreshold(1e-13);
    decomposition.compute(even);
    const Eigen::VectorXd solution = decomposition.solve(values);
    return -width_.cwiseProduct(scale).cwiseProduct(solution);
  }

  [[nodiscard]] bool is_angle(Eigen::Index i) const {
    return std::find(box_.angles.begin(), box_.angles.end(), i) != box_.angles.end();
  }

  [[nodiscard]] bool bring_into_box(Eigen::VectorXd& x) const {
    for (Eigen::Index i = 0; i < boxed_; ++i) {
      const double margin = options_.merge * width_(i);
      if (is_angle(i)) {
        const double turn = 2.0 * std::numbers::pi;
        x(i) -= turn * std::floor((x(i) - box_.lower(i) + margin) / turn);
      }
      if (!(x(i) >= box_.lower(i) - margin && x(i) <= box_.upper(i) + margin)) return false;
    }
    return true;
  }

  const VectorFunction& f_;
  const MatrixFunction& derivative_;
  const SearchBox& box_;
  const RootSearchOptions& options_;
  Eigen::Index boxed_;
  Eigen::VectorXd width_, size_;
};

}  // namespace

RootSearch find_roots(const RootEquations& equations, const SearchBox& box, const RootSearchOptions& options) {
  if (box.lower.size() != box.upper.size() || box.lower.size() == 0 || box.lower.size() > equations.unknowns ||
      options.starts < 1) {
    throw std::invalid_argument("a search for roots needs a lower and an upper bound for each unknown, and a start");
  }
  for (Eigen::Index i = 0; i < box.lower.size(); ++i) {
    if (!(box.lower(i) < box.upper(i)) || !std::isfinite(box.upper(i) - box.lower(i))) {
      throw std::invalid_argument("the bounds of unknown " + std::to_string(i) + " are " +
                                  std::to_string(box.lower(i)) + " and " + std::to_string(box.upper(i)) +
                                  "; the lower one must be below the upper one, and both finite");
    }
  }
  NewtonSearch search(equations, box, options);
  search.measure();
  RootSearch result;
  result.starts = options.starts;
  for (int k = 0; k < options.starts; ++k) {
    const Eigen::VectorXd start = search.start(k);
    FoundRoot root{start};
    StartFailure reason{};
    if (!search.follow(root.x, root.residual, reason)) {
      result.failures.push_back({reason, start, root.x, root.residual});
      continue;
    }
    root.isolated = search.isolated(root.x);
    const auto known = std::find_if(result.roots.begin(), result.roots.end(), [&](const FoundRoot& other) {
      const double near = root.isolated && other.isolated ? options.merge : options.degenerate_merge;
      return search.distance(root.x, other.x) <= near;
    });
    if (known == result.roots.end()) {
      result.roots.push_back(root);
    } else {
      ++known->found;
      if (root.residual < known->residual) {
        root.found = known->found;
        *known = root;
      }
    }
  }
  std::sort(result.roots.begin(), result.roots.end(), [](const FoundRoot& a, const FoundRoot& b) {
    return std::lexicographical_compare(a.x.begin(), a.x.end(), b.x.begin(), b.x.end());
  });
  return result;
}

Eigen::MatrixXd central_differences(const VectorFunction& f, const Eigen::VectorXd& x, const Eigen::VectorXd& widths) {
  Eigen::MatrixXd slope;
  for (Eigen::Index j = 0; j < x.size(); ++j) {
    const double step = 6e-6 * (j < widths.size() ? std::min(widths(j), 1.0) : 1.0);
    Eigen::VectorXd before = x, after = x;
    before(j) -= step;
    after(j) += step;
    const Eigen::VectorXd difference = f(after) - f(before);
    if (slope.size() == 0) slope.resize(difference.size(), x.size());
    slope.col(j) = difference / (after(j) - before(j));
  }
  return slope;
}

}  // namespace torsor::runtime
