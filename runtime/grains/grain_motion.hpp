// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "torsor/runtime/batch/thread_team.hpp"
#include "torsor/runtime/grains/grain_check.hpp"
#include "torsor/runtime/grains/grain_islands.hpp"
#include "torsor/runtime/grains/grain_passage.hpp"
#include "torsor/runtime/grains/grain_solver.hpp"

namespace torsor::runtime {

/// What a step found.
struct GrainStep {
  GrainStatus status = GrainStatus::ok;
  GrainFault fault;        ///< what is refused where the status is `invalid`
  bool converged = false;  ///< the status is `ok`
  int sweeps = 0;
  double residual = 0;
  double deepest = 0;  ///< overlap at the middle of the step [m]
  std::size_t contacts = 0;
  std::size_t asleep = 0;  ///< grains
  bool ambiguous = false;  ///< grains rest from now on, but another solution of the laws moves them
};

/// Moves grains by the scheme of Moreau and Jean with θ = 1/2:
///   x_m = x + h v/2;  v+ = v + h g + M^-1 J^T P;  0 <= w_N+ + e w_N-, P_N >= 0, |P_T| <= f P_N;  x+ = x_m + h v+/2,
/// contacts being those whose gap at x_m is closed; where e = 0 also those that would close by x+, 0 <= w_N+ + 2 g/h.
/// P by sweeps (`GrainSolver`) from the impulses of the last step. Grains that stand keep standing where impulses exist
/// that hold them, and islands that have not moved for a while sleep (`GrainIslands`). Overlaps are put back by
/// displacements that do not become velocities. Grains that pass through others, for a step that is too long, are told by
/// the status `too_fast` (`GrainPassage`). The bits do not depend on the number of threads. Nothing is allocated
/// after the first step, and the first in which grains move by more than a radius, while contacts are few enough
/// (`GrainContacts::usual`). Source: Acary & Brogliato 2008,
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
    GrainStep result;
    result.fault = fault_of(grains_, options_, h);
    if (result.fault) {
      result.status = GrainStatus::invalid;
      result.residual = NAN;
      return result;
    }
    const std::size_t count = grains_.count();
    look_for_changes();
    islands_.wake_touched(grains_, contacts_.all());
    double least = INFINITY;
    for (const double R : grains_.radius) least = std::min(least, R);
    // Of the way that the last step foresaw this has been asked.
    bool passes = !(h == asked_h_ && grains_.v == asked_v_) && passage_.happens(grains_, h / 2);
    for (std::size_t i = 0; i < count; ++i) {
      grains_.x[i] += h / 2 * grains_.v[i];
      grains_.turned[i] += h / 2 * grains_.w[i];
    }
    // No further than two grains may come nearer in half a step.
    double fastest = 0;
    for (const Vector& v : grains_.v) fastest = std::max(fastest, v.squaredNorm());
    const double touch = 1e-9 * least;  // gaps up to it are closed: rounding decides nothing
    contacts_.find(grains_, grains_.x, touch + std::min(least, h * std::sqrt(fastest)));
    islands_.wake(grains_, contacts_.all());
    prepare(h, touch, result);
    hold_what_rests(h, result);
    for (std::size_t i = 0; i < count; ++i) {
      if (takes_part(i)) grains_.v[i] += h * grains_.gravity;
    }
    contacts_.colour(static_cast<std::uint32_t>(count), [this](std::uint32_t i) { return takes_part(i); });
    const auto solved = solver_.solve(grains_, contacts_, sweeps());
    result.sweeps += solved.sweeps;
    const bool finite = std::isfinite(solved.residual) && std::isfinite(result.residual);
    result.residual = finite ? std::max(solved.residual, result.residual) : NAN;
    result.converged = finite && solved.converged;
    result.status = !finite            ? GrainStatus::not_finite
                    : solved.converged ? GrainStatus::ok
                                       : GrainStatus::not_converged;
    if (std::find(held_.begin(), held_.end(), 1) != held_.end()) {
      contacts_.colour(static_cast<std::uint32_t>(count), [this](std::uint32_t i) { return !islands_.asleep(i); });
    }
    project(count, result);
    asked_h_ = h;
    asked_v_ = grains_.v;
    passes = passage_.happens(grains_, h) || passes;  // until contacts are looked for again, in the middle of the next step
    if (passes && result.status == GrainStatus::ok) {
      result.status = GrainStatus::too_fast;
      result.converged = false;
    }
    for (std::size_t i = 0; i < count; ++i) {
      grains_.x[i] += h / 2 * grains_.v[i];
      grains_.turned[i] += h / 2 * grains_.w[i];
    }
    if (options_.rest > 0) {
      const double unit = h * grains_.gravity.norm();
      islands_.settle(grains_, contacts_.all(), options_.rest * unit, 10 * options_.tolerance * unit);
    }
    result.asleep = islands_.sleepers();
    return result;
  }

  [[nodiscard]] const GrainContacts<dim>& contacts() const noexcept { return contacts_; }

 private:
  [[nodiscard]] typename GrainSolver<dim>::Sweeps sweeps() noexcept {
    return {.tolerance = options_.tolerance, .most = options_.sweeps, .team = team_};
  }

  // Neither asleep nor held at rest in this step.
  [[nodiscard]] bool takes_part(std::size_t i) const noexcept { return !islands_.asleep(i) && held_[i] == 0; }

  // The velocity of separation that contacts ask for: e times that of approach; without restitution one that closes
  // what is left of the gap is let pass.
  void prepare(double h, double touch, GrainStep& result) noexcept {
    const std::size_t count = grains_.count();
    result.contacts = contacts_.all().size();
    for (Contact& c : contacts_.all()) {
      if (islands_.asleep(c.a) && (c.b >= count || islands_.asleep(c.b))) continue;
      result.deepest = std::max(result.deepest, -c.gap);
      if (c.gap <= touch) {
        c.bounce *= -std::min(0.0, relative_velocity(c).dot(c.n));
        continue;
      }
      c.open = c.bounce > 0;
      c.bounce = c.open ? 0 : -2 * c.gap / h;
      if (c.open) c.P.setZero();
    }
  }

  [[nodiscard]] bool still(std::size_t i) const noexcept { return grains_.v[i].isZero(0) && grains_.w[i].isZero(0); }

  // Rest persists where it can: islands whose grains all stand, on walls that do, stay where impulses exist that hold
  // them. What is elsewhere does not matter. Whether they could move as well is asked when they begin to rest.
  void hold_what_rests(double h, GrainStep& result) {
    const std::size_t count = grains_.count();
    rested_.swap(held_);
    rested_.resize(count);
    held_.assign(count, 0);
    stands_.resize(count);
    bool any = false;
    for (std::size_t i = 0; i < count; ++i) {
      stands_[i] = options_.rest > 0 && !islands_.asleep(i) && still(i);
      any = any || stands_[i] != 0;
    }
    if (!any) return;
    find_standing_islands();
    for (std::size_t i = 0; i < count; ++i) {
      if (stands_[i] != 0) grains_.v[i] = h * grains_.gravity;
    }
    contacts_.colour(static_cast<std::uint32_t>(count), [this](std::uint32_t i) { return stands_[i] != 0; });
    if (!contacts_.order().empty()) {
      const auto found =
          solver_.rest(grains_, contacts_, sweeps(), {.islands = groups_, .stands = stands_, .rests = held_});
      result.sweeps += found.sweeps;
      bool holds = false, begins = false;
      for (std::size_t i = 0; i < count; ++i) {
        holds = holds || held_[i] != 0;
        begins = begins || (held_[i] != 0 && rested_[i] == 0);
      }
      if (holds || !std::isfinite(found.residual)) result.residual = found.residual;
      result.ambiguous = begins && solver_.moves(grains_, contacts_, sweeps(), held_);
    }
    for (std::size_t i = 0; i < count; ++i) {
      if (stands_[i] != 0) grains_.v[i].setZero();
    }
  }

  // Of grains that stand those are left whose whole island does: all that they touch, one by the other.
  void find_standing_islands() {
    const std::size_t count = grains_.count();
    groups_.reset(count);
    restless_.assign(count, 0);
    for (const Contact& c : contacts_.all()) {
      if (!c.open && c.b < count && !islands_.asleep(c.a)) groups_.join(c.a, c.b);
    }
    for (std::uint32_t i = 0; i < count; ++i) {
      if (stands_[i] == 0) restless_[groups_.root(i)] = 1;
    }
    for (const Contact& c : contacts_.all()) {
      if (c.b >= count && !c.surface.isZero(0)) restless_[groups_.root(c.a)] = 1;
    }
    for (std::uint32_t i = 0; i < count; ++i) {
      if (restless_[groups_.root(i)] != 0) stands_[i] = 0;
    }
  }

  // What sleeps under other conditions wakes.
  void look_for_changes() {
    const bool same = known_.size() == grains_.walls.size() && gravity_ == grains_.gravity &&
                      friction_ == grains_.friction && restitution_ == grains_.restitution &&
                      known_count_ == grains_.count() &&
                      std::equal(known_.begin(), known_.end(), grains_.walls.begin());
    if (same) return;
    known_ = grains_.walls;
    gravity_ = grains_.gravity;
    friction_ = grains_.friction;
    restitution_ = grains_.restitution;
    known_count_ = grains_.count();
    contacts_.reserve(known_count_);
    solver_.reserve(known_count_);
    shift_.reserve(known_count_);
    for (auto* all : {&stands_, &held_, &rested_, &restless_}) all->reserve(known_count_);
    groups_.reset(known_count_);
    held_.assign(known_count_, 0);
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
  GrainPassage<dim> passage_;
  double asked_h_ = 0;  ///< of the last question whether grains pass, with their velocities
  std::vector<Vector> asked_v_;
  std::vector<GrainWall<dim>> known_;
  Vector gravity_ = Vector::Zero();
  double friction_ = 0, restitution_ = 0;
  std::size_t known_count_ = 0;
  GrainGroups groups_;
  std::vector<std::uint8_t> stands_, held_, rested_, restless_;  // of grains, in a step
  std::vector<Vector> shift_;
};

}  // namespace torsor::runtime
