// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "torsor/runtime/batch/thread_team.hpp"
#include "torsor/runtime/grains/grain_groups.hpp"
#include "torsor/runtime/grains/grain_row.hpp"

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
  using Vector = typename Grains<dim>::Vector;

  struct Outcome {
    bool converged = false;
    int sweeps = 0;
    double residual = 0;  ///< the largest defect of the laws over the largest impulse
  };

  /// How far sweeps go, and on which threads.
  struct Sweeps {
    double tolerance;  ///< of the residual
    int most;
    ThreadTeam& team;
  };

  /// Grains that stand, in groups that touch, and which of them rest.
  struct Standing {
    GrainGroups& islands;
    const std::vector<std::uint8_t>& stands;  ///< 1 for each grain that stands
    std::vector<std::uint8_t>& rests;         ///< gets 1 for each of an island that rests
  };

  void reserve(std::size_t count) {
    const std::size_t contacts = GrainContacts<dim>::usual(count);
    rows_.reserve(contacts);
    for (auto* all : {&P_, &change_, &along_}) all->reserve(contacts);
    for (auto* all : {&v_, &v_before_, &v_along_}) all->reserve(stride * count);
    parts_.reserve(contacts / piece + 1);
    verdicts_.reserve(count);
  }

  /// Velocities that know nothing of the contacts' impulses, where sweeps start, become those after the step,
  /// unless numbers overflowed.
  Outcome solve(Grains<dim>& grains, GrainContacts<dim>& contacts, const Sweeps& sweeps) {
    load(grains, contacts, true);
    const Outcome outcome = iterate<GrainLaw::coulomb>(grains, contacts, sweeps);
    if (std::isfinite(outcome.residual)) store(grains, contacts);
    return outcome;
  }

  /// Which of the islands that stand rest. Impulses in the cones are looked for that hold all their grains: the least
  /// |v| in the metric of the masses, a convex problem, so that sweeps find them. An island
  /// * rests where they leave no grain more momentum than the tolerance allows defects of impulses;
  /// * moves where v itself proves it: vᵀ M v_free = |v|² - Σ w · P is the power of the load on a motion that no
  ///   contact resists, w_N >= f |w_T|. What is missing there, d, counts with ten times the largest impulse;
  /// * is taken to move where the sweeps end before either is seen.
  /// The contacts of an island that rests get its impulses. The residual is the largest momentum left to a grain that
  /// rests, over the largest impulse of its island.
  Outcome rest(const Grains<dim>& grains, GrainContacts<dim>& contacts, const Sweeps& sweeps,
               const Standing& standing) {
    const auto& [islands, stands, rests] = standing;
    load(grains, contacts, true);
    Outcome outcome;
    for (double goal = sweeps.tolerance;; goal /= 10) {
      const int left = sweeps.most - outcome.sweeps;
      const Outcome part = iterate<GrainLaw::cone>(grains, contacts, {goal, left, sweeps.team});
      outcome.sweeps += part.sweeps;
      outcome.residual = part.residual;
      const bool decided = judge(grains, sweeps.tolerance, standing);
      if (decided || !part.converged || outcome.sweeps >= sweeps.most || goal < 1e-15) break;
    }
    rests.assign(grains.count(), 0);
    if (std::isfinite(outcome.residual)) outcome.residual = 0;
    for (std::uint32_t i = 0; i < grains.count(); ++i) {
      const Verdict& island = verdicts_[islands.root(i)];
      rests[i] = stands[i] != 0 && island.rests;
      if (rests[i] != 0 && island.momentum2 > 0) grow(outcome.residual, std::sqrt(island.momentum2 / island.impulse2));
    }
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      GrainContact<dim>& c = contacts.all()[contacts.order()[k]];
      if (rests[c.a] != 0) c.P = Row::global(c, P_[k]);
    }
    return outcome;
  }

  /// Whether sweeps that start without impulses find a motion in which a grain that rests gets more momentum than a
  /// thousand times what the tolerance allows defects of impulses. Changes nothing.
  bool moves(const Grains<dim>& grains, const GrainContacts<dim>& contacts, const Sweeps& sweeps,
             const std::vector<std::uint8_t>& rests) {
    load(grains, contacts, false);
    if (!iterate<GrainLaw::coulomb>(grains, contacts, sweeps).converged) return false;
    const double tolerance = sweeps.tolerance;
    double largest2 = 0;
    for (const Local& P : P_) largest2 = std::max(largest2, P.squaredNorm());
    for (std::size_t i = 0; i < grains.count(); ++i) {
      if (rests[i] != 0 && momentum2(grains, i) > 1e6 * tolerance * tolerance * largest2) return true;
    }
    return false;
  }

 private:
  static constexpr std::size_t piece = 256;
  static constexpr std::size_t stride = Row::stride;

  // The larger one, or what is no number for good.
  static void grow(double& most, double value) noexcept {
    if (!(value <= most) && !std::isnan(most)) most = value;
  }

  void load(const Grains<dim>& grains, const GrainContacts<dim>& contacts, bool warm) {
    const std::size_t count = grains.count();
    v_.resize(stride * count);
    rows_.resize(contacts.order().size());
    P_.resize(rows_.size());
    change_.resize(rows_.size());
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      const GrainContact<dim>& c = contacts.all()[contacts.order()[k]];
      rows_[k] = Row(grains, c);
      P_[k] = warm ? rows_[k].start(Row::local(c, c.P)) : Local(Local::Zero());
    }
    along_.assign(rows_.size(), Local::Zero());
    v_along_.assign(v_.size(), 0.0);
    move(grains);
  }

  // v = v_free + M^-1 J^T P anew: sweeps add up rounding.
  void move(const Grains<dim>& grains) noexcept {
    for (std::size_t i = 0; i < grains.count(); ++i) {
      Row::put(&v_[stride * i], grains.v[i], grains.radius[i] * grains.w[i]);
    }
    for (std::size_t k = 0; k < rows_.size(); ++k) rows_[k].apply(v_.data(), P_[k]);
    v_before_ = v_;
  }

  // What tells whether an island rests: its largest momentum and impulse (squared), the power of the load on the
  // motion found, and the sum of what that motion lacks of w_N >= f |w_T|.
  struct Verdict {
    double momentum2 = 0, impulse2 = 0, power = 0, missing = 0;
    bool rests = false;
  };

  // The larger of |m v|² and |J ω/R|².
  [[nodiscard]] double momentum2(const Grains<dim>& grains, std::size_t i) const noexcept {
    Vector v;
    typename Grains<dim>::Spin w;
    Row::take(&v_[stride * i], grains.radius[i], v, w);
    const double m = 1 / grains.inverse_mass[i], turning = 1 / (grains.inverse_inertia[i] * grains.radius[i]);
    double most = m * m * v.squaredNorm();
    grow(most, turning * turning * w.squaredNorm());
    return most;
  }

  // Whether all is decided.
  [[nodiscard]] bool judge(const Grains<dim>& grains, double tolerance, const Standing& standing) {
    auto& islands = standing.islands;
    const auto& stands = standing.stands;
    verdicts_.assign(grains.count(), Verdict());
    for (std::uint32_t i = 0; i < grains.count(); ++i) {
      if (stands[i] == 0) continue;
      Verdict& island = verdicts_[islands.root(i)];
      Vector v;
      typename Grains<dim>::Spin w;
      Row::take(&v_[stride * i], grains.radius[i], v, w);
      grow(island.momentum2, momentum2(grains, i));
      island.power += v.dot(grains.v[i]) / grains.inverse_mass[i] + w.dot(grains.w[i]) / grains.inverse_inertia[i];
    }
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      if (stands[rows_[k].a] == 0 || rows_[k].N_step == 0) continue;
      Verdict& island = verdicts_[islands.root(rows_[k].a)];
      const Local u = rows_[k].velocity(v_.data());
      grow(island.impulse2, P_[k].squaredNorm());
      island.missing += std::max(rows_[k].friction * rows_[k].tangent_part(u) - rows_[k].normal_part(u), 0.0);
    }
    bool decided = true;
    for (std::uint32_t i = 0; i < grains.count(); ++i) {
      if (stands[i] == 0 || islands.root(i) != i) continue;
      Verdict& island = verdicts_[i];
      const bool finite = std::isfinite(island.momentum2 + island.impulse2);
      island.rests = finite && island.momentum2 <= tolerance * tolerance * island.impulse2;
      const bool moves = island.power > 10 * std::sqrt(island.impulse2) * island.missing;
      decided = decided && (island.rests || moves);
    }
    return decided;
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
  Outcome iterate(const Grains<dim>& grains, const GrainContacts<dim>& contacts, const Sweeps& sweeps) {
    const auto& [tolerance, most, team] = sweeps;
    Outcome outcome;
    for (outcome.residual = residual<law>(team);; outcome.residual = residual<law>(team)) {
      outcome.converged = outcome.residual <= tolerance;
      if (outcome.converged || !std::isfinite(outcome.residual) || outcome.sweeps >= most) return outcome;
      for (double last = 0;;) {
        sweep<law>(contacts, team);
        const Size size = size_of_change(team);
        ++outcome.sweeps;
        if (!(size.most > tolerance * tolerance * size.largest) || outcome.sweeps >= most) break;
        const double beta = last > 0 ? size.sum / last : 0.0;
        last = beta > 1 ? 0.0 : size.sum;
        go_on(beta > 1 ? 0.0 : beta, team);
      }
      move(grains);
    }
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
    double sum = 0, most = 0, largest = 0;  // of squares: changes or defects, and the largest impulse
  };
  [[nodiscard]] Size collected() const noexcept {
    Size size;
    for (const Size& each : parts_) {
      size.sum += each.sum;
      grow(size.most, each.most);
      grow(size.largest, each.largest);
    }
    return size;
  }

  [[nodiscard]] Size size_of_change(ThreadTeam& team) {
    parts_.resize((rows_.size() + piece - 1) / piece);
    in_pieces(rows_.size(), team, [&](std::size_t p, std::size_t first, std::size_t count) {
      Size size;
      for (std::size_t i = first; i < first + count; ++i) {
        const double change = change_[i].squaredNorm();
        size.sum += change;
        grow(size.most, change);
        grow(size.largest, P_[i].squaredNorm());
      }
      parts_[p] = size;
    });
    return collected();
  }

  // The largest defect over the largest impulse.
  template <GrainLaw law>
  [[nodiscard]] double residual(ThreadTeam& team) {
    parts_.resize((rows_.size() + piece - 1) / piece);
    in_pieces(rows_.size(), team, [&](std::size_t p, std::size_t first, std::size_t count) {
      Size size;
      for (std::size_t i = first; i < first + count; ++i) {
        const double defect = (rows_[i].template solved<law>(v_.data(), P_[i]) - P_[i]).squaredNorm();
        grow(size.most, defect);
        grow(size.largest, P_[i].squaredNorm());
      }
      parts_[p] = size;
    });
    const Size size = collected();
    if (!std::isfinite(size.most + size.largest)) return NAN;
    return size.largest > 0 ? std::sqrt(size.most / size.largest) : size.most > 0 ? 1.0 : 0.0;
  }

  std::vector<Row> rows_;
  std::vector<Local> P_, change_, along_;
  std::vector<double> v_, v_before_, v_along_;
  std::vector<Size> parts_;
  std::vector<Verdict> verdicts_;
};

}  // namespace torsor::runtime
