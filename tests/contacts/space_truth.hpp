// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "torsor/runtime/contacts/contact_problem.hpp"

// All solutions of one or two contacts in space, by another way than the runtime's: directions of slips that begin are scanned,
// and where a cell of directions may hold a zero it is refined.
namespace space_truth {

using namespace torsor::runtime;
using MatrixXd = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 6, 6>;  // two contacts have six rows
using VectorXd = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 6, 1>;

class SpaceTruth {
 public:
  /// `cells` of directions for one slip that begins, and `grid` of them for each of two.
  SpaceTruth(const ContactProblem& problem, int cells, int grid) : problem_(&problem), cells_(cells), grid_(grid) {
    std::vector<Piece> pieces(static_cast<std::size_t>(problem.count));
    try_pieces(pieces, 0);
  }

  [[nodiscard]] ContactVerdict verdict() const {
    if (found_.empty()) return ContactVerdict::none;
    bool several = false, many = false;
    for (const Found& each : found_) {
      several = several || far(each.u, found_[0].u);
      many = many || each.family || far(each.r, found_[0].r);
    }
    return several ? ContactVerdict::several : many ? ContactVerdict::indeterminate : ContactVerdict::unique;
  }
  [[nodiscard]] bool has_motion(const VectorXd& u) const {
    return std::any_of(found_.begin(), found_.end(), [&](const Found& each) { return !far(each.u, u); });
  }
  /// How near the problem is to one that is decided otherwise: the least part by which an inequality holds or fails.
  [[nodiscard]] double margin() const { return margin_; }

 private:
  enum class Piece { open, sticks, slides, slides_to };
  struct Found {
    VectorXd r, u;
    bool family;
  };

  static std::size_t as(int i) { return static_cast<std::size_t>(i); }
  static bool far(const VectorXd& a, const VectorXd& b) { return (a - b).norm() > 1e-6 * (1 + a.norm()); }

  void try_pieces(std::vector<Piece>& pieces, int contact) {
    if (contact == problem_->count) return visit(pieces);
    const bool given = problem_->law(contact).slips;
    for (const Piece piece : {Piece::open, Piece::sticks, Piece::slides, Piece::slides_to}) {
      if (piece != Piece::open && given != (piece == Piece::slides)) continue;
      pieces[as(contact)] = piece;
      try_pieces(pieces, contact + 1);
    }
  }

  /// r = B x: N of contacts that press, T of those that stick; those that slide pull by f N against their direction.
  struct Equations {
    MatrixXd B, E;
    VectorXd e;
    double determinant = 1;
    VectorXd r, u;
  };
  Equations solve(const std::vector<Piece>& pieces, const std::array<double, 2>& angles) const {
    Equations s;
    const int rows = 3 * problem_->count;
    std::vector<int> held;
    held.reserve(6);
    for (int i = 0; i < problem_->count; ++i) {
      if (pieces[as(i)] == Piece::open) continue;
      held.push_back(3 * i);
      if (pieces[as(i)] == Piece::sticks) {
        held.push_back(3 * i + 1);
        held.push_back(3 * i + 2);
      }
    }
    const auto n = static_cast<Eigen::Index>(held.size());
    s.B = MatrixXd::Zero(rows, n);
    for (Eigen::Index k = 0; k < n; ++k) {
      const int row = held[static_cast<std::size_t>(k)], i = row / 3;
      s.B(row, k) = 1;
      const ContactLaw& law = problem_->law(i);
      if (row % 3 != 0 || pieces[as(i)] == Piece::sticks) continue;
      const bool given = pieces[as(i)] == Piece::slides;
      s.B(row + 1, k) = -law.friction * (given ? law.slip[0] : std::cos(angles[as(i)]));
      s.B(row + 2, k) = -law.friction * (given ? law.slip[1] : std::sin(angles[as(i)]));
    }
    const MatrixXd WB = problem_->W * s.B;
    s.E.resize(n, n);
    s.e.resize(n);
    for (Eigen::Index k = 0; k < n; ++k) {
      s.E.row(k) = WB.row(held[static_cast<std::size_t>(k)]);
      s.e(k) = -problem_->q(held[static_cast<std::size_t>(k)]);
    }
    s.r = VectorXd::Zero(rows);
    if (n > 0) {
      const Eigen::PartialPivLU<MatrixXd> lu(s.E);
      s.determinant = lu.determinant();
      s.r = s.B * lu.solve(s.e);
    }
    s.u = problem_->W * s.r + problem_->q;
    return s;
  }

  /// u_T across the direction of a slip that begins, times the determinant: a polynomial of sines and cosines.
  double across(const Equations& s, int i, double angle) const {
    return s.determinant * (std::cos(angle) * s.u(3 * i + 2) - std::sin(angle) * s.u(3 * i + 1));
  }

  void visit(const std::vector<Piece>& pieces) {
    std::vector<int> free;
    for (int i = 0; i < problem_->count; ++i) {
      if (pieces[as(i)] == Piece::slides_to && problem_->law(i).friction > 0) free.push_back(i);
    }
    if (free.empty()) return visit_known(pieces);
    if (free.size() == 1) return visit_circle(pieces, free[0]);
    visit_torus(pieces);
  }

  void visit_known(const std::vector<Piece>& pieces) {
    const Equations s = solve(pieces, {});
    if (s.E.cols() == 0) return accept(pieces, {}, s.r, false);
    const Eigen::FullPivLU<MatrixXd> lu(s.E);
    const double pivot = std::abs(lu.matrixLU().diagonal().tail<1>()(0)) / lu.maxPivot();
    if (pivot > 1e-9) {
      margin_ = std::min(margin_, pivot);
      return accept(pieces, {}, s.r, false);
    }
    // What may be added is one vector: the discs cut an interval out of its line.
    Eigen::FullPivLU<MatrixXd> singular(s.E);
    singular.setThreshold(1e-9);
    const VectorXd x = singular.solve(s.e);
    const double left = (s.E * x - s.e).norm() / (1 + x.norm());
    if (left > 1e-9) {
      margin_ = std::min(margin_, left);
      return;
    }
    const MatrixXd kernel = singular.kernel();
    if (kernel.cols() != 1) {
      margin_ = 0;  // not for this program
      return;
    }
    const VectorXd r = s.B * x, along = s.B * kernel.col(0);
    double low = -1e9, high = 1e9;
    const auto keep = [&](double a, double b, double c) {  // a z² + b z + c <= 0, convex or a cone's line
      const double root = b * b - 4 * a * c;
      if (a <= 0 || root <= 0) return false;
      low = std::max(low, (-b - std::sqrt(root)) / (2 * a));
      high = std::min(high, (-b + std::sqrt(root)) / (2 * a));
      return true;
    };
    for (int i = 0; i < problem_->count; ++i) {
      const ContactLaw& law = problem_->law(i);
      const double f = law.static_friction;
      const double n = along(3 * i), N = r(3 * i);
      if (n > 0) low = std::max(low, -N / n);
      if (n < 0) high = std::min(high, -N / n);
      if (pieces[as(i)] != Piece::sticks) continue;
      const Eigen::Vector2d t = along.segment<2>(3 * i + 1), T = r.segment<2>(3 * i + 1);
      const double a = t.squaredNorm() - f * f * n * n, b = 2 * (t.dot(T) - f * f * n * N), c = T.squaredNorm() - f * f * N * N;
      if (a > 0) {
        if (!keep(a, b, c)) {
          margin_ = std::min(margin_, std::abs(b * b - 4 * a * c) / (b * b + std::abs(4 * a * c)));
          return;
        }
      } else {
        // The line runs within the cone's asymptotes: inside it from one root on, to the side where N >= 0.
        const double root = b * b - 4 * a * c;
        if (root < 0) {
          margin_ = 0;
          return;
        }
        const double one = (-b - std::sqrt(root)) / (2 * a), other = (-b + std::sqrt(root)) / (2 * a);
        if (n > 0) low = std::max(low, std::max(one, other));
        else high = std::min(high, std::min(one, other));
      }
    }
    const double least = std::min(std::abs(low), std::abs(high));
    margin_ = std::min(margin_, std::abs(high - low) / (1 + least));
    const double inside = high >= 1e9 ? low + 1 + std::abs(low) : low <= -1e9 ? high - 1 - std::abs(high) : (low + high) / 2;
    if (high > low) accept(pieces, {}, r + inside * along, true);
  }

  void visit_circle(const std::vector<Piece>& pieces, int i) {
    std::array<double, 2> angles{};
    const auto value = [&](double angle) {
      angles[as(i)] = angle;
      return across(solve(pieces, angles), i, angle);
    };
    double before = value(0);
    for (int k = 1; k <= cells_; ++k) {
      double a = 2 * std::numbers::pi * (k - 1) / cells_, b = 2 * std::numbers::pi * k / cells_;
      const double after = value(b);
      if ((after > 0) != (before > 0)) {
        const bool rises = after > 0;
        for (int step = 0; step < 60; ++step) {
          const double middle = (a + b) / 2;
          ((value(middle) > 0) == rises ? b : a) = middle;
        }
        angles[as(i)] = (a + b) / 2;
        accept(pieces, angles, solve(pieces, angles).r, false);
      }
      before = after;
    }
  }

  void visit_torus(const std::vector<Piece>& pieces) {
    const double width = 2 * std::numbers::pi / grid_;
    const auto size = static_cast<std::size_t>(grid_ + 1);
    std::vector<std::array<double, 2>> values(size * size);
    const auto values_at = [&](double a, double b) {
      const Equations s = solve(pieces, {a, b});
      return std::array<double, 2>{across(s, 0, a), across(s, 1, b)};
    };
    for (std::size_t j = 0; j < size; ++j) {
      for (std::size_t k = 0; k < size; ++k) {
        const std::size_t jj = j % as(grid_), kk = k % as(grid_);
        values[j * size + k] = jj != j || kk != k ? values[jj * size + kk]
                                                  : values_at(width * static_cast<double>(j), width * static_cast<double>(k));
      }
    }
    std::vector<std::array<double, 2>> zeros;
    for (std::size_t j = 0; j + 1 < size; ++j) {
      for (std::size_t k = 0; k + 1 < size; ++k) {
        bool possible = true;
        for (const std::size_t which : {0U, 1U}) {
          const std::array<double, 4> corner{values[j * size + k][which], values[(j + 1) * size + k][which],
                                             values[j * size + k + 1][which], values[(j + 1) * size + k + 1][which]};
          const auto [least, most] = std::minmax_element(corner.begin(), corner.end());
          // A zero in the cell, or within half of what the function changes across it.
          possible = possible && *least - (*most - *least) / 2 <= 0 && *most + (*most - *least) / 2 >= 0;
        }
        if (possible) refine(pieces, values_at, {width * (static_cast<double>(j) + 0.5), width * (static_cast<double>(k) + 0.5)}, 3 * width, zeros);
      }
    }
  }

  // Newton's method with slopes by differences, for a zero that is near.
  template <class Values>
  void refine(const std::vector<Piece>& pieces, const Values& values_at, std::array<double, 2> at, double reach,
              std::vector<std::array<double, 2>>& zeros) {
    const std::array<double, 2> start = at;
    for (int step = 0; step < 30; ++step) {
      constexpr double h = 1e-6;
      const auto g = values_at(at[0], at[1]);
      const auto a = values_at(at[0] + h, at[1]), b = values_at(at[0] - h, at[1]);
      const auto c = values_at(at[0], at[1] + h), d = values_at(at[0], at[1] - h);
      Eigen::Matrix2d slopes;
      slopes << a[0] - b[0], c[0] - d[0], a[1] - b[1], c[1] - d[1];
      slopes /= 2 * h;
      const Eigen::Vector2d change = slopes.partialPivLu().solve(Eigen::Vector2d(g[0], g[1]));
      if (!change.allFinite()) return;
      for (const int k : {0, 1}) at[as(k)] -= change(k);
      if (std::hypot(at[0] - start[0], at[1] - start[1]) > reach) return;
      if (change.norm() > 1e-13) continue;
      for (const auto& zero : zeros) {
        if (std::abs(std::remainder(zero[0] - at[0], 2 * std::numbers::pi)) + std::abs(std::remainder(zero[1] - at[1], 2 * std::numbers::pi)) < 1e-9) return;
      }
      zeros.push_back(at);
      const double scale = std::max({std::abs(slopes(0, 0)), std::abs(slopes(0, 1)), 1e-300}) * std::max({std::abs(slopes(1, 0)), std::abs(slopes(1, 1)), 1e-300});
      margin_zero_ = std::abs(slopes.determinant()) / scale;
      accept(pieces, at, solve(pieces, at).r, false);
      return;
    }
  }

  // Whether all inequalities hold; how near the nearest comes to its bound counts where no other fails by far.
  void accept(const std::vector<Piece>& pieces, const std::array<double, 2>& angles, const VectorXd& r, bool family) {
    const VectorXd u = problem_->W * r + problem_->q;
    const double force = 1 + r.norm(), motion = problem_->q.norm() + problem_->W.norm() * r.norm();
    double least = 1;
    for (int i = 0; i < problem_->count; ++i) {
      const ContactLaw& law = problem_->law(i);
      const Piece piece = pieces[as(i)];
      if (piece == Piece::open) least = std::min(least, u(3 * i) / motion);
      else least = std::min(least, r(3 * i) / force);
      if (piece == Piece::sticks) {
        least = std::min(least, (law.static_friction * r(3 * i) - std::hypot(r(3 * i + 1), r(3 * i + 2))) / force);
      }
      if (piece == Piece::slides_to) {
        const double a = angles[as(i)];
        // Without a slip it is the end of what sticks.
        if (std::hypot(u(3 * i + 1), u(3 * i + 2)) <= 1e-9 * motion) {
          margin_zero_ = 1;
          return;
        }
        least = std::min(least, (std::cos(a) * u(3 * i + 1) + std::sin(a) * u(3 * i + 2)) / motion);
        // A determinant that is zero makes zeros where nothing slides along its direction.
        if (!(std::abs(std::cos(a) * u(3 * i + 2) - std::sin(a) * u(3 * i + 1)) <= 1e-7 * motion)) {
          margin_zero_ = 1;
          return;
        }
      }
    }
    if (force > 1e6) least = std::min(least, 0.0);  // a solution that runs away
    margin_ = std::min({margin_, std::abs(least), least > 0 ? margin_zero_ : 1.0});
    margin_zero_ = 1;
    if (least > 0) found_.push_back({r, u, family});
  }

  const ContactProblem* problem_;
  int cells_, grid_;
  std::vector<Found> found_;
  double margin_ = 1, margin_zero_ = 1;
};

}  // namespace space_truth
