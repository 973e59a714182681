// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "runtime/batch/thread_team.hpp"
#include "runtime/grains/grain_islands.hpp"
#include "runtime/grains/grain_solver.hpp"

namespace torsor::runtime {

struct GrainOptions {
  double tolerance = 1e-6;  ///< of the natural map, over the largest impulse
  int sweeps = 2000;        ///< at most, in a step
  int projections = 20;     ///< sweeps that put overlaps back, at most
  unsigned threads = 1;
  double rest = 1e-3;  ///< islands no faster than this part of h |gravity| fall asleep; 0: none does
};

/// What a step found.
struct GrainStep {
  bool converged = false;  ///< the residual is below the tolerance
  int sweeps = 0;
  double residual = 0;
  double deepest = 0;  ///< overlap at the middle of the step [m]
  std::size_t contacts = 0;
  std::size_t asleep = 0;  ///< grains
  bool ambiguous = false;  ///< the grains rest from now on, but another solution of the laws moves them
};

/// Moves grains by the scheme of Moreau and Jean with θ = 1/2:
///   x_m = x + h v/2;  v+ = v + h g + M^-1 J^T P;  0 <= w_N+ + e w_N-, P_N >= 0, |P_T| <= f P_N;  x+ = x_m + h v+/2,
/// contacts being those whose gap at x_m is closed; where e = 0 also those that would close by x+, 0 <= w_N+ + 2 g/h.
/// P by sweeps (`GrainSolver`) from the impulses of the last step. Grains that stand keep standing where impulses exist
/// that hold them, and islands that have not moved for a while sleep (`GrainIslands`). Overlaps are put back by
/// displacements that do not become velocities. The bits do not depend on the number of threads. Nothing is allocated
/// after the first step while contacts are few enough (`GrainContacts::usual`). Source: Acary & Brogliato 2008,
/// chapter 10.
template <int dim>
class GrainMotion {
 public:
  using Vector = typename Grains<dim>::Vector;
  using Spin = typename Grains<dim>::Spin;
  using Contact = GrainContact<dim>;

  explicit GrainMotion(Grains<dim>& grains, const GrainOptions& options = {})
      : grains_(grains), options_(options), team_(options.threads) {}

  GrainStep step(double h) {
    const std::size_t count = grains_.count();
    look_for_changes();
    double least = INFINITY;
    for (const double R : grains_.radius) least = std::min(least, R);
    for (std::size_t i = 0; i < count; ++i) {
      grains_.x[i] += h / 2 * grains_.v[i];
      grains_.turned[i] += h / 2 * grains_.w[i];
    }
    // No further than two grains may come nearer in half a step.
    double fastest = 0;
    for (const Vector& v : grains_.v) fastest = std::max(fastest, v.squaredNorm());
    contacts_.find(grains_, grains_.x, 1e-9 * least + std::min(least, h * std::sqrt(fastest)));
    auto& all = contacts_.all();
    islands_.wake(grains_, all);
    contacts_.colour(static_cast<std::uint32_t>(count), [this](std::uint32_t i) { return islands_.asleep(i); });
    GrainStep result;
    result.contacts = all.size();
    for (const std::uint32_t k : contacts_.order()) {
      Contact& c = all[k];
      result.deepest = std::max(result.deepest, -c.gap);
      // The velocity of separation asked for: e times that of approach; without restitution one that closes what is
      // left of the gap is let pass.
      if (c.gap <= 0) {
        c.bounce *= -std::min(0.0, relative_velocity(c).dot(c.n));
      } else {
        c.bounce = c.bounce > 0 ? -never : -2 * c.gap / h;
      }
    }
    const bool at_rest = options_.rest > 0 && stands(all);
    for (std::size_t i = 0; i < count; ++i) {
      if (!islands_.asleep(i)) grains_.v[i] += h * grains_.gravity;
    }
    const bool stays = at_rest && rests(h, result);
    if (!stays) {
      const auto solved = solver_.solve(grains_, contacts_, options_.tolerance, options_.sweeps, team_);
      result.converged = solved.converged;
      result.sweeps += solved.sweeps;
      result.residual = solved.residual;
    }
    rested_ = stays;
    project(count, result);
    for (std::size_t i = 0; i < count; ++i) {
      grains_.x[i] += h / 2 * grains_.v[i];
      grains_.turned[i] += h / 2 * grains_.w[i];
    }
    if (options_.rest > 0) islands_.settle(grains_, all, options_.rest * h * grains_.gravity.norm());
    result.asleep = islands_.sleepers();
    return result;
  }

  [[nodiscard]] const GrainContacts<dim>& contacts() const noexcept { return contacts_; }

 private:
  static constexpr double never = 1e300;  // a velocity of approach

  // Whether no grain moves, and no wall that one touches.
  [[nodiscard]] bool stands(const std::vector<Contact>& contacts) const noexcept {
    for (std::size_t i = 0; i < grains_.count(); ++i) {
      if (!grains_.v[i].isZero(0) || !grains_.w[i].isZero(0)) return false;
    }
    for (const Contact& c : contacts) {
      if (c.b >= grains_.count() && !c.surface.isZero(0)) return false;
    }
    return !contacts.empty();
  }

  // Rest persists where it can: grains that stand stay where impulses exist that hold them all. Whether they could move
  // as well is asked when they begin to rest.
  [[nodiscard]] bool rests(double h, GrainStep& result) {
    const double slow = std::min(options_.rest, 1e3 * options_.tolerance) * h * grains_.gravity.norm();
    const std::size_t count = grains_.count();
    if (!rested_)
      result.ambiguous = solver_.moves(grains_, contacts_, options_.tolerance, options_.sweeps, slow, team_);
    const auto found = solver_.rest(grains_, contacts_, options_.tolerance, options_.sweeps, slow, team_);
    result.sweeps = found.sweeps;
    result.ambiguous = result.ambiguous && found.converged;
    if (!found.converged) return false;
    result.converged = true;
    result.residual = found.residual;
    for (std::size_t i = 0; i < count; ++i) {
      grains_.v[i].setZero();
      grains_.w[i].setZero();
    }
    return true;
  }

  // What sleeps under other conditions wakes.
  void look_for_changes() {
    const bool same = known_.size() == grains_.walls.size() && gravity_ == grains_.gravity &&
                      friction_ == grains_.friction && known_count_ == grains_.count() &&
                      std::equal(known_.begin(), known_.end(), grains_.walls.begin());
    if (same) return;
    known_ = grains_.walls;
    gravity_ = grains_.gravity;
    friction_ = grains_.friction;
    known_count_ = grains_.count();
    contacts_.reserve(known_count_);
    solver_.reserve(known_count_);
    shift_.reserve(known_count_);
    islands_.wake_all(known_count_);
  }

  // w_a - w_b of the points that touch, the wall's surface included.
  [[nodiscard]] Vector relative_velocity(const Contact& c) const noexcept {
    Spin spin = grains_.radius[c.a] * grains_.w[c.a];
    Vector u = grains_.v[c.a];
    if (c.b < grains_.count()) {
      spin += grains_.radius[c.b] * grains_.w[c.b];
      u -= grains_.v[c.b];
    } else {
      u -= c.surface;
    }
    return u - turn(spin, c.n);
  }

  template <class Work>
  void in_colours(const Work& work) {
    const auto& order = contacts_.order();
    for (std::size_t k = 0; k < GrainContacts<dim>::colours; ++k) {
      const std::size_t first = contacts_.first_of(k), count = contacts_.first_of(k + 1) - first;
      if (count == 0) continue;
      const auto range = [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) work(contacts_.all()[order[first + i]]);
      };
      if (k + 1 == GrainContacts<dim>::colours) {
        range(0, count);
      } else {
        team_.run(count, range);
      }
    }
  }

  // Displacements M^-1 J_N^T s, s >= 0, after which no gap is negative, by sweeps.
  void project(std::size_t count, const GrainStep& result) {
    if (!(result.deepest > 0)) return;
    shift_.assign(count, Vector::Zero());
    for (const std::uint32_t k : contacts_.order()) {
      Contact& c = contacts_.all()[k];
      if (c.gap < 0) {
        shift(c, c.push);
      } else {
        c.push = 0;
      }
    }
    for (int sweep = 0; sweep < options_.projections; ++sweep) {
      in_colours([&](Contact& c) {
        Vector apart = shift_[c.a];
        if (c.b < grains_.count()) apart -= shift_[c.b];
        const double push = std::max(0.0, c.push - (apart.dot(c.n) + c.gap) / c.normal_weight);
        shift(c, push - c.push);
        c.push = push;
      });
    }
    for (std::size_t i = 0; i < count; ++i) grains_.x[i] += shift_[i];
  }
  void shift(const Contact& c, double push) noexcept {
    shift_[c.a] += grains_.inverse_mass[c.a] * push * c.n;
    if (c.b < grains_.count()) shift_[c.b] -= grains_.inverse_mass[c.b] * push * c.n;
  }

  Grains<dim>& grains_;
  const GrainOptions options_;
  ThreadTeam team_;
  GrainContacts<dim> contacts_;
  GrainSolver<dim> solver_;
  GrainIslands<dim> islands_;
  std::vector<GrainWall<dim>> known_;
  Vector gravity_ = Vector::Zero();
  double friction_ = 0;
  std::size_t known_count_ = 0;
  bool rested_ = false;
  std::vector<Vector> shift_;
};

}  // namespace torsor::runtime
