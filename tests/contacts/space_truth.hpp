// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "tests/contacts/deepest_inside.hpp"
#include "torsor/runtime/contacts/contact_problem.hpp"

// All solutions of one to three contacts in space, by another way than the runtime's: directions of slips that begin are
// scanned, and where a cell of directions may hold a zero it is refined. Three that begin at once are sought from many starts.
// Whether reactions that are not unique have room inside their bounds is asked of the method of ellipsoids.
namespace space_truth {

using namespace torsor::runtime;
using MatrixXd = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 9, 9>;  // three contacts have nine rows
using VectorXd = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 9, 1>;

class SpaceTruth {
 public:
  /// `cells` of directions for one slip that begins, `grid` of them for each of two, and `starts` for each of three.
  struct Search {
    int cells, grid, starts;
  };
  SpaceTruth(const ContactProblem& problem, const Search& search) : problem_(&problem), search_(search), rank_(rank_of(problem.W)) {
    std::vector<Piece> pieces(static_cast<std::size_t>(problem.count));
    try_pieces(pieces, 0);
  }

  [[nodiscard]] ContactVerdict verdict() const {
    if (found_.empty()) return ContactVerdict::none;
    bool several = false, many = false;
    for (const Found& each : found_) {
      several = several || each.moves || far(each.u, found_[0].u);
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
    bool family, moves;  ///< other reactions do as well; and some of them give another motion
  };
  using Angles = std::array<double, 3>;

  static std::size_t as(int i) { return static_cast<std::size_t>(i); }
  static bool far(const VectorXd& a, const VectorXd& b) { return (a - b).norm() > 1e-6 * (1 + a.norm()); }
  static Eigen::Index rank_of(const MatrixXd& W) {
    Eigen::FullPivLU<MatrixXd> lu(W);
    lu.setThreshold(1e-9);
    return lu.rank();
  }

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
  std::vector<int> held_rows(const std::vector<Piece>& pieces) const {
    std::vector<int> held;
    held.reserve(9);
    for (int i = 0; i < problem_->count; ++i) {
      if (pieces[as(i)] == Piece::open) continue;
      held.push_back(3 * i);
      if (pieces[as(i)] == Piece::sticks) {
        held.push_back(3 * i + 1);
        held.push_back(3 * i + 2);
      }
    }
    return held;
  }
  Equations solve(const std::vector<Piece>& pieces, const Angles& angles) const {
    Equations s;
    const int rows = 3 * problem_->count;
    const std::vector<int> held = held_rows(pieces);
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
    bool open = false;
    for (int i = 0; i < problem_->count; ++i) {
      open = open || pieces[as(i)] == Piece::open;
      if (pieces[as(i)] == Piece::slides_to && problem_->law(i).friction > 0) free.push_back(i);
    }
    const std::vector<int> held = held_rows(pieces);
    const auto n = static_cast<Eigen::Index>(held.size());
    MatrixXd own(n, n);
    for (Eigen::Index j = 0; j < n; ++j) {
      for (Eigen::Index k = 0; k < n; ++k) own(j, k) = problem_->W(held[static_cast<std::size_t>(j)], held[static_cast<std::size_t>(k)]);
    }
    const Eigen::Index rank = n > 0 ? rank_of(own) : 0;
    // What is held may hold all: then what is open closes and what slides sticks, which other pieces say.
    if (rank == rank_ && (open || !free.empty())) return;
    if (free.empty()) return visit_known(pieces);
    if (rank < n) {
      margin_ = 0;  // not for this program
      return;
    }
    if (free.size() == 1) return visit_circle(pieces, free[0]);
    if (free.size() == 2) return visit_torus(pieces, free);
    visit_three(pieces, free);
  }

  void visit_known(const std::vector<Piece>& pieces) {
    const Equations s = solve(pieces, {});
    if (s.E.cols() == 0) return accept(pieces, {}, s.r, false, false);
    const Eigen::FullPivLU<MatrixXd> lu(s.E);
    const double pivot = std::abs(lu.matrixLU().diagonal().tail<1>()(0)) / lu.maxPivot();
    if (pivot > 1e-9) {
      margin_ = std::min(margin_, pivot);
      return accept(pieces, {}, s.r, false, false);
    }
    Eigen::FullPivLU<MatrixXd> singular(s.E);
    singular.setThreshold(1e-9);
    const VectorXd x = singular.solve(s.e);
    const double left = (s.E * x - s.e).norm() / (1 + x.norm());
    if (left > 1e-9) {
      margin_ = std::min(margin_, left);
      return;
    }
    const VectorXd r = s.B * x, u = problem_->W * r + problem_->q;
    const double force = 1 + r.norm(), motion = problem_->q.norm() + problem_->W.norm() * force;
    MatrixXd added = s.B * singular.kernel();
    for (Eigen::Index k = 0; k < added.cols(); ++k) added.col(k) *= force / added.col(k).norm();
    const MatrixXd moved = problem_->W * added;
    std::vector<deepest_inside::Bound> bounds;
    const Eigen::Matrix<double, 2, Eigen::Dynamic> none = Eigen::Matrix<double, 2, Eigen::Dynamic>::Zero(2, added.cols());
    for (int i = 0; i < problem_->count; ++i) {
      const int n = 3 * i;
      if (pieces[as(i)] == Piece::open) {
        bounds.push_back({u(n) / motion, moved.row(n).transpose() / motion, Eigen::Vector2d::Zero(), none});
        continue;
      }
      bounds.push_back({r(n) / force, added.row(n).transpose() / force, Eigen::Vector2d::Zero(), none});
      if (pieces[as(i)] != Piece::sticks) continue;
      const double f = problem_->law(i).static_friction / force;
      bounds.push_back({f * r(n), f * added.row(n).transpose(), r.segment<2>(n + 1) / force, added.middleRows(n + 1, 2) / force});
    }
    // The room may begin far away: it is looked for farther and farther.
    deepest_inside::Deepest inside{-INFINITY, {}};
    for (const double reach : {10.0, 1e2, 1e3, 1e4, 1e5}) {
      if (inside.least < 1e-4) inside = deepest_inside::deepest(bounds, added.cols(), reach, 1e-2);
    }
    // What has less room than a part in 1e5 counts as unique, as docs/contacts.md says of forces beside their bounds.
    margin_ = inside.least > 0 && inside.least < 1e-4 ? 0 : std::min(margin_, std::abs(inside.least));
    if (inside.least > 0) accept(pieces, {}, r + added * inside.z, true, moved.norm() > 1e-9 * motion);
  }

  void visit_circle(const std::vector<Piece>& pieces, int i) {
    Angles angles{};
    const auto value = [&](double angle) {
      angles[as(i)] = angle;
      return across(solve(pieces, angles), i, angle);
    };
    double before = value(0);
    for (int k = 1; k <= search_.cells; ++k) {
      double a = 2 * std::numbers::pi * (k - 1) / search_.cells, b = 2 * std::numbers::pi * k / search_.cells;
      const double after = value(b);
      if ((after > 0) != (before > 0)) {
        const bool rises = after > 0;
        for (int step = 0; step < 60; ++step) {
          const double middle = (a + b) / 2;
          ((value(middle) > 0) == rises ? b : a) = middle;
        }
        angles[as(i)] = (a + b) / 2;
        accept(pieces, angles, solve(pieces, angles).r, false, false);
      }
      before = after;
    }
  }

  /// What must be zero where the slips of these contacts begin along these angles.
  Angles across_of(const std::vector<Piece>& pieces, const std::vector<int>& free, const Angles& angles) const {
    const Equations s = solve(pieces, angles);
    Angles values{};
    for (const int i : free) values[as(i)] = across(s, i, angles[as(i)]);
    return values;
  }

  void visit_torus(const std::vector<Piece>& pieces, const std::vector<int>& free) {
    const int grid = search_.grid;
    const double width = 2 * std::numbers::pi / grid;
    const auto size = as(grid + 1);
    const auto angles_at = [&](double a, double b) {
      Angles angles{};
      angles[as(free[0])] = a;
      angles[as(free[1])] = b;
      return angles;
    };
    std::vector<Angles> values(size * size);
    for (std::size_t j = 0; j < size; ++j) {
      for (std::size_t k = 0; k < size; ++k) {
        const std::size_t jj = j % as(grid), kk = k % as(grid);
        values[j * size + k] =
            jj != j || kk != k ? values[jj * size + kk]
                               : across_of(pieces, free, angles_at(width * static_cast<double>(j), width * static_cast<double>(k)));
      }
    }
    std::vector<Angles> zeros;
    for (std::size_t j = 0; j + 1 < size; ++j) {
      for (std::size_t k = 0; k + 1 < size; ++k) {
        bool possible = true;
        for (const int i : free) {
          const std::array<double, 4> corner{values[j * size + k][as(i)], values[(j + 1) * size + k][as(i)],
                                             values[j * size + k + 1][as(i)], values[(j + 1) * size + k + 1][as(i)]};
          const auto [least, most] = std::minmax_element(corner.begin(), corner.end());
          // A zero in the cell, or within half of what the function changes across it.
          possible = possible && *least - (*most - *least) / 2 <= 0 && *most + (*most - *least) / 2 >= 0;
        }
        if (possible) {
          refine(pieces, free, angles_at(width * (static_cast<double>(j) + 0.5), width * (static_cast<double>(k) + 0.5)), 3 * width, zeros);
        }
      }
    }
  }

  void visit_three(const std::vector<Piece>& pieces, const std::vector<int>& free) {
    std::vector<Angles> zeros;
    const double width = 2 * std::numbers::pi / search_.starts;
    for (int j = 0; j < search_.starts; ++j) {
      for (int k = 0; k < search_.starts; ++k) {
        for (int l = 0; l < search_.starts; ++l) refine(pieces, free, {width * j, width * k, width * l}, INFINITY, zeros);
      }
    }
  }

  // Newton's method with slopes by differences, for a zero within reach.
  void refine(const std::vector<Piece>& pieces, const std::vector<int>& free, Angles at, double reach, std::vector<Angles>& zeros) {
    const auto n = static_cast<Eigen::Index>(free.size());
    const auto contact = [&](Eigen::Index k) { return as(free[static_cast<std::size_t>(k)]); };
    const Angles start = at;
    for (int step = 0; step < 30; ++step) {
      constexpr double h = 1e-6;
      const Angles here = across_of(pieces, free, at);
      Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 3, 3> slopes(n, n);
      Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 3, 1> value(n);
      for (Eigen::Index k = 0; k < n; ++k) {
        value(k) = here[contact(k)];
        Angles after = at, before = at;
        after[contact(k)] += h;
        before[contact(k)] -= h;
        const Angles b = across_of(pieces, free, after), a = across_of(pieces, free, before);
        for (Eigen::Index j = 0; j < n; ++j) slopes(j, k) = (b[contact(j)] - a[contact(j)]) / (2 * h);
      }
      const auto change = slopes.partialPivLu().solve(value).eval();
      if (!change.allFinite()) return;
      double moved = 0;
      for (Eigen::Index k = 0; k < n; ++k) {
        at[contact(k)] -= change(k);
        moved = std::hypot(moved, at[contact(k)] - start[contact(k)]);
      }
      if (moved > reach) return;
      if (change.norm() > 1e-13) continue;
      for (const Angles& zero : zeros) {
        double apart = 0;
        for (const int i : free) apart += std::abs(std::remainder(zero[as(i)] - at[as(i)], 2 * std::numbers::pi));
        if (apart < 1e-9) return;
      }
      zeros.push_back(at);
      double scale = 1;
      for (Eigen::Index j = 0; j < n; ++j) scale *= std::max(slopes.row(j).cwiseAbs().maxCoeff(), 1e-300);
      margin_zero_ = std::abs(slopes.determinant()) / scale;
      accept(pieces, at, solve(pieces, at).r, false, false);
      return;
    }
  }

  // Whether all inequalities hold; how near the nearest comes to its bound counts where no other fails by far.
  void accept(const std::vector<Piece>& pieces, const Angles& angles, const VectorXd& r, bool family, bool moves) {
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
    if (least > 0) found_.push_back({r, u, family, moves});
  }

  const ContactProblem* problem_;
  Search search_;
  Eigen::Index rank_;
  std::vector<Found> found_;
  double margin_ = 1, margin_zero_ = 1;
};

}  // namespace space_truth
