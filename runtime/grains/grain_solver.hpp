// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "runtime/batch/thread_team.hpp"
#include "runtime/grains/grain_row.hpp"

namespace torsor::runtime {

/// Impulses of all contacts of a step,
///   v = v_free + M^-1 J^T P,  0 <= w_N - b, P_N >= 0, |P_T| <= f P_N,
/// by sweeps of Gauss and Seidel in which each contact is solved exactly, with Coulomb's disc. Sweeps are combined as
/// conjugate gradients are (Silcowitz-Hansen, Niebe & Erleben 2010): with d the change that a sweep makes, the next one
/// starts at P + d + β p, then p = β p + d, β = |d|²/|d before|²; anew where β > 1. W is never assembled.
///
/// What a sweep reads lies in the order in which it is read: rows of contacts colour by colour, v and R ω of a grain
/// side by side.
template <int dim>
class GrainSolver {
 public:
  using Row = GrainRow<dim>;
  using Local = typename Row::Local;

  struct Outcome {
    bool converged = false;
    int sweeps = 0;
    double residual = 0;  ///< the largest defect of the laws over the largest impulse
  };

  void reserve(std::size_t count) {
    const std::size_t contacts = GrainContacts<dim>::usual(count);
    rows_.reserve(contacts);
    for (auto* all : {&P_, &change_, &along_}) all->reserve(contacts);
    for (auto* all : {&v_, &v_before_, &v_along_}) all->reserve(stride * count);
    parts_.reserve(contacts / piece + 1);
  }

  /// Velocities that know nothing of the contacts' impulses, where sweeps start, become those after the step.
  Outcome solve(Grains<dim>& grains, GrainContacts<dim>& contacts, double tolerance, int most, ThreadTeam& team) {
    load(grains, contacts, true);
    const Outcome outcome = iterate<GrainLaw::coulomb>(contacts, tolerance, most, team);
    store(grains, contacts);
    return outcome;
  }

  /// Rest, where impulses exist that keep all grains from moving faster than `slow`: a convex problem, so that sweeps
  /// find them. Else nothing is changed.
  Outcome rest(Grains<dim>& grains, GrainContacts<dim>& contacts, double tolerance, int most, double slow,
               ThreadTeam& team) {
    load(grains, contacts, true);
    Outcome outcome = iterate<GrainLaw::cone>(contacts, tolerance, most, team);
    outcome.converged = outcome.converged && fastest() <= slow;
    if (outcome.converged) store(grains, contacts);
    return outcome;
  }

  /// Whether sweeps that start without impulses find a motion faster than `slow`. Changes nothing.
  bool moves(const Grains<dim>& grains, const GrainContacts<dim>& contacts, double tolerance, int most, double slow,
             ThreadTeam& team) {
    load(grains, contacts, false);
    return iterate<GrainLaw::coulomb>(contacts, tolerance, most, team).converged && fastest() > slow;
  }

 private:
  static constexpr std::size_t piece = 256;
  static constexpr std::size_t stride = Row::stride;

  void load(const Grains<dim>& grains, const GrainContacts<dim>& contacts, bool warm) {
    const std::size_t count = grains.count();
    v_.assign(stride * count, 0.0);
    for (std::size_t i = 0; i < count; ++i) Row::put(&v_[stride * i], grains.v[i], grains.radius[i] * grains.w[i]);
    rows_.resize(contacts.order().size());
    P_.resize(rows_.size());
    change_.resize(rows_.size());
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      const GrainContact<dim>& c = contacts.all()[contacts.order()[k]];
      rows_[k] = Row(grains, c);
      P_[k] = warm ? rows_[k].start(Row::local(c, c.P)) : Local(Local::Zero());
      rows_[k].apply(v_.data(), P_[k]);
    }
    along_.assign(rows_.size(), Local::Zero());
    v_along_.assign(v_.size(), 0.0);
    v_before_ = v_;
  }

  // |v| or R |ω|, whichever is most.
  [[nodiscard]] double fastest() const noexcept {
    double most = 0;
    for (std::size_t i = 0; i < v_.size(); i += stride) most = std::max(most, Row::speed(&v_[i]));
    return most;
  }

  void store(Grains<dim>& grains, GrainContacts<dim>& contacts) const {
    for (std::size_t i = 0; i < grains.count(); ++i)
      Row::take(&v_[stride * i], grains.radius[i], grains.v[i], grains.w[i]);
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      GrainContact<dim>& c = contacts.all()[contacts.order()[k]];
      c.P = Row::global(c, P_[k]);
    }
  }

  template <GrainLaw law>
  Outcome iterate(const GrainContacts<dim>& contacts, double tolerance, int most, ThreadTeam& team) {
    Outcome outcome;
    double largest = 0, last = 0;
    outcome.residual = residual<law>(largest, team);
    while (!(outcome.converged = outcome.residual <= tolerance) && outcome.sweeps < most) {
      for (;;) {
        sweep<law>(contacts, team);
        const Size size = size_of_change(team);
        ++outcome.sweeps;
        if (size.most <= tolerance * tolerance * largest || outcome.sweeps == most) break;
        const double beta = last > 0 ? size.sum / last : 0.0;
        last = beta > 1 ? 0.0 : size.sum;
        go_on(beta > 1 ? 0.0 : beta, team);
      }
      outcome.residual = residual<law>(largest, team);
      last = 0;
    }
    return outcome;
  }

  template <GrainLaw law>
  void sweep(const GrainContacts<dim>& contacts, ThreadTeam& team) {
    constexpr std::size_t colours = GrainContacts<dim>::colours;
    const Row* const rows = rows_.data();
    Local *const P = P_.data(), *const change = change_.data();
    double* const v = v_.data();
    for (std::size_t k = 0; k < colours; ++k) {
      const std::size_t start = contacts.first_of(k), count = contacts.first_of(k + 1) - start;
      if (count == 0) continue;
      const auto range = [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = start + begin; i < start + end; ++i) rows[i].template solve<law>(v, P[i], change[i]);
      };
      if (k + 1 == colours) {
        range(0, count);
      } else {
        team.run(count, range);
      }
    }
  }

  // Work on pieces of a fixed length, whatever the number of threads; each has one thread and stays in its cache.
  template <class Work>
  static void in_pieces(std::size_t count, ThreadTeam& team, const Work& work) {
    team.run(count, [&](std::size_t first, std::size_t end) {
      for (std::size_t p = (first + piece - 1) / piece; p * piece < end; ++p) {
        work(p, p * piece, std::min(count, (p + 1) * piece) - p * piece);
      }
    });
  }
  static Eigen::Map<Eigen::ArrayXd> part(std::vector<double>& all, std::size_t first, std::size_t count) noexcept {
    return {all.data() + first, static_cast<Eigen::Index>(count)};
  }
  static Eigen::Map<Eigen::ArrayXd> part(std::vector<Local>& all, std::size_t first, std::size_t count) noexcept {
    return {all[first].data(), static_cast<Eigen::Index>(count) * dim};
  }

  // Starts the next sweep ahead of where the last one ended; β = 0 forgets the way.
  void go_on(double beta, ThreadTeam& team) {
    in_pieces(rows_.size(), team, [&](std::size_t, std::size_t first, std::size_t count) {
      auto along = part(along_, first, count);
      along *= beta;
      part(P_, first, count) += along;
      along += part(change_, first, count);
    });
    in_pieces(v_.size(), team, [&](std::size_t, std::size_t first, std::size_t count) {
      auto v = part(v_, first, count), along = part(v_along_, first, count), before = part(v_before_, first, count);
      before = v - before;
      along *= beta;
      v += along;
      along += before;
      before = v;
    });
  }

  struct Size {
    double sum = 0, most = 0;  // of squares
  };
  [[nodiscard]] Size size_of_change(ThreadTeam& team) {
    parts_.resize((rows_.size() + piece - 1) / piece);
    in_pieces(rows_.size(), team, [&](std::size_t p, std::size_t first, std::size_t count) {
      const auto change = part(change_, first, count);
      const double most = change.matrix().template lpNorm<Eigen::Infinity>();
      parts_[p] = {change.matrix().squaredNorm(), most * most};
    });
    Size size;
    for (const Size& each : parts_) {
      size.sum += each.sum;
      if (!(each.most <= size.most)) size.most = each.most;  // what is no number too
    }
    return size;
  }

  // Here most is that of the defects, sum the largest impulse.
  template <GrainLaw law>
  [[nodiscard]] double residual(double& largest, ThreadTeam& team) {
    parts_.resize((rows_.size() + piece - 1) / piece);
    in_pieces(rows_.size(), team, [&](std::size_t p, std::size_t first, std::size_t count) {
      Size size;
      for (std::size_t i = first; i < first + count; ++i) {
        const double defect = (rows_[i].template solved<law>(v_.data(), P_[i]) - P_[i]).squaredNorm();
        if (!(defect <= size.most)) size.most = defect;
        size.sum = std::max(size.sum, P_[i].squaredNorm());
      }
      parts_[p] = size;
    });
    double defect = 0;
    largest = 0;
    for (const Size& each : parts_) {
      if (!(each.most <= defect)) defect = each.most;
      largest = std::max(largest, each.sum);
    }
    if (!std::isfinite(defect)) return defect;
    return largest > 0 ? std::sqrt(defect / largest) : defect > 0 ? 1.0 : 0.0;
  }

  std::vector<Row> rows_;
  std::vector<Local> P_, change_, along_;
  std::vector<double> v_, v_before_, v_along_;
  std::vector<Size> parts_;
};

}  // namespace torsor::runtime
