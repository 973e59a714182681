// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "torsor/runtime/grains/grain_contacts.hpp"
#include "torsor/runtime/grains/grain_groups.hpp"

namespace torsor::runtime {

/// Which grains sleep. Grains that press on each other are an island. It falls asleep where for some steps none of its
/// grains was fast nor gained speed, and no wall under it moves: it then stands still, its impulses stay, and no sweep
/// visits it. It wakes as a whole where a grain that is awake comes near, where one of its grains was written to, and
/// everything wakes where gravity, coefficients or walls are changed.
template <int dim>
class GrainIslands {
 public:
  using Vector = typename Grains<dim>::Vector;
  using Spin = typename Grains<dim>::Spin;
  static constexpr std::uint16_t steps = 20;

  [[nodiscard]] bool asleep(std::size_t grain) const noexcept { return quiet_[grain] == sleeps; }
  [[nodiscard]] std::size_t sleepers() const noexcept { return sleepers_; }
  void wake_all(std::size_t count) {
    quiet_.assign(count, 0);
    known_.resize(count);
    restless_.resize(count);
    groups_.reset(count);
    sleepers_ = 0;
  }

  /// Before a step: wakes the islands of grains that were written to while they slept, by the contacts they had.
  void wake_touched(const Grains<dim>& grains, const std::vector<GrainContact<dim>>& contacts) {
    if (sleepers_ == 0) return;
    const auto touched = [&](std::size_t i) { return asleep(i) && !(known_[i] == Known(grains, i)); };
    std::size_t i = 0;
    while (i < grains.count() && !touched(i)) ++i;
    if (i == grains.count()) return;
    gather(grains.count(), contacts);
    for (; i < grains.count(); ++i) {
      if (touched(i)) restless_[groups_.root(static_cast<std::uint32_t>(i))] = 1;
    }
    wake_restless(grains.count());
  }

  /// Before a step's impulses: who is woken by what comes near.
  void wake(const Grains<dim>& grains, const std::vector<GrainContact<dim>>& contacts) {
    if (sleepers_ == 0) return;
    gather(grains.count(), contacts);
    // Who is woken wakes others.
    for (std::size_t before = grains.count() + 1; sleepers_ != before;) {
      before = sleepers_;
      for (const GrainContact<dim>& c : contacts) {
        if (c.b < grains.count() && asleep(c.a) != asleep(c.b)) restless_[groups_.root(asleep(c.a) ? c.a : c.b)] = 1;
      }
      wake_restless(grains.count());
    }
  }

  /// After a step: who falls asleep, having moved no faster than `speed` and having gained no more than `gain` a step.
  void settle(Grains<dim>& grains, const std::vector<GrainContact<dim>>& contacts, double speed, double gain) {
    bool any = false;
    for (std::size_t i = 0; i < grains.count(); ++i) {
      if (asleep(i)) continue;
      const Spin spin = grains.radius[i] * grains.w[i];
      const bool still = grains.v[i].squaredNorm() <= speed * speed && spin.squaredNorm() <= speed * speed;
      quiet_[i] = still ? std::min<std::uint16_t>(quiet_[i] + 1, steps) : std::uint16_t{0};
      if (quiet_[i] == 1) known_[i] = Known(grains, i);
      // What is slow but goes on gaining speed, like a ball on a slope that is hardly one, does not rest.
      if (quiet_[i] == steps && known_[i].gained(grains, i) > steps * gain) {
        quiet_[i] = 1;
        known_[i] = Known(grains, i);
      }
      any = any || quiet_[i] == steps;
    }
    if (!any) return;
    gather(grains.count(), contacts);
    for (std::uint32_t i = 0; i < grains.count(); ++i) {
      if (quiet_[i] < steps) restless_[groups_.root(i)] = 1;
    }
    for (const GrainContact<dim>& c : contacts) {
      if (c.b >= grains.count() && moves(grains.walls[c.b - grains.count()])) restless_[groups_.root(c.a)] = 1;
    }
    for (std::uint32_t i = 0; i < grains.count(); ++i) {
      if (quiet_[i] != steps || restless_[groups_.root(i)] != 0) continue;
      quiet_[i] = sleeps;
      ++sleepers_;
      grains.v[i].setZero();
      grains.w[i].setZero();
      known_[i] = Known(grains, i);
    }
  }

 private:
  static constexpr std::uint16_t sleeps = steps + 1;

  // What a grain was like when it became quiet, or when it fell asleep.
  struct Known {
    Vector x = Vector::Zero(), v = Vector::Zero();
    Spin w = Spin::Zero();
    double radius = 0, inverse_mass = 0, inverse_inertia = 0;

    Known() = default;
    Known(const Grains<dim>& grains, std::size_t i)
        : x(grains.x[i]),
          v(grains.v[i]),
          w(grains.w[i]),
          radius(grains.radius[i]),
          inverse_mass(grains.inverse_mass[i]),
          inverse_inertia(grains.inverse_inertia[i]) {}
    [[nodiscard]] bool operator==(const Known&) const = default;
    [[nodiscard]] double gained(const Grains<dim>& grains, std::size_t i) const noexcept {
      return std::max((grains.v[i] - v).norm(), radius * (grains.w[i] - w).norm());
    }
  };

  static bool moves(const GrainWall<dim>& wall) noexcept { return wall.spin != 0 || !wall.velocity.isZero(0); }

  void wake_restless(std::size_t count) noexcept {
    for (std::uint32_t i = 0; i < count; ++i) {
      if (!asleep(i) || restless_[groups_.root(i)] == 0) continue;
      quiet_[i] = 0;
      --sleepers_;
    }
  }

  void gather(std::size_t count, const std::vector<GrainContact<dim>>& contacts) {
    groups_.reset(count);
    restless_.assign(count, 0);
    for (const GrainContact<dim>& c : contacts) {
      if (c.b < count && !c.P.isZero(0)) groups_.join(c.a, c.b);
    }
  }

  GrainGroups groups_;
  std::vector<Known> known_;
  std::vector<std::uint16_t> quiet_;
  std::vector<std::uint8_t> restless_;
  std::size_t sleepers_ = 0;
};

}  // namespace torsor::runtime
