// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "runtime/grains/grain_contacts.hpp"

namespace torsor::runtime {

/// Which grains sleep. Grains that press on each other are an island. It falls asleep where none of its grains has
/// moved for some steps and no wall under it moves: it then stands still, its impulses stay, and no sweep visits it. It
/// wakes as a whole where a grain that is awake comes near, where one of its grains is given a velocity, and everything
/// wakes where gravity or walls are changed.
template <int dim>
class GrainIslands {
 public:
  static constexpr std::uint16_t steps = 20;

  [[nodiscard]] bool asleep(std::size_t grain) const noexcept { return quiet_[grain] == sleeps; }
  [[nodiscard]] std::size_t sleepers() const noexcept { return sleepers_; }
  void wake_all(std::size_t count) {
    quiet_.assign(count, 0);
    above_.resize(count);
    restless_.resize(count);
    sleepers_ = 0;
  }

  /// Before a step's impulses: who is woken.
  void wake(const Grains<dim>& grains, const std::vector<GrainContact<dim>>& contacts) {
    if (sleepers_ == 0) return;
    gather(grains.count(), contacts);
    const auto stir = [&](std::uint32_t grain) { restless_[root(grain)] = 1; };
    for (std::uint32_t i = 0; i < grains.count(); ++i) {
      if (asleep(i) && !(grains.v[i].isZero(0) && grains.w[i].isZero(0))) stir(i);
    }
    for (const GrainContact<dim>& c : contacts) {
      const bool pair = c.b < grains.count();
      if (pair ? asleep(c.a) != asleep(c.b) : asleep(c.a) && moves(grains.walls[c.b - grains.count()])) {
        stir(asleep(c.a) ? c.a : c.b);
      }
    }
    for (std::uint32_t i = 0; i < grains.count(); ++i) {
      if (!asleep(i) || restless_[root(i)] == 0) continue;
      quiet_[i] = 0;
      --sleepers_;
    }
  }

  /// After a step: who falls asleep, having moved no faster than `speed`.
  void settle(Grains<dim>& grains, const std::vector<GrainContact<dim>>& contacts, double speed) {
    bool any = false;
    for (std::size_t i = 0; i < grains.count(); ++i) {
      if (asleep(i)) continue;
      const bool still = grains.v[i].squaredNorm() <= speed * speed &&
                         grains.radius[i] * grains.radius[i] * grains.w[i].squaredNorm() <= speed * speed;
      quiet_[i] = still ? std::min<std::uint16_t>(quiet_[i] + 1, steps) : std::uint16_t{0};
      any = any || quiet_[i] == steps;
    }
    if (!any) return;
    gather(grains.count(), contacts);
    for (std::uint32_t i = 0; i < grains.count(); ++i) {
      if (quiet_[i] < steps) restless_[root(i)] = 1;
    }
    for (const GrainContact<dim>& c : contacts) {
      if (c.b >= grains.count() && moves(grains.walls[c.b - grains.count()])) restless_[root(c.a)] = 1;
    }
    for (std::uint32_t i = 0; i < grains.count(); ++i) {
      if (quiet_[i] != steps || restless_[root(i)] != 0) continue;
      quiet_[i] = sleeps;
      ++sleepers_;
      grains.v[i].setZero();
      grains.w[i].setZero();
    }
  }

 private:
  static constexpr std::uint16_t sleeps = steps + 1;

  static bool moves(const GrainWall<dim>& wall) noexcept { return wall.spin != 0 || !wall.velocity.isZero(0); }

  // Trees of grains that press on each other, the least one on top.
  void gather(std::size_t count, const std::vector<GrainContact<dim>>& contacts) {
    above_.resize(count);
    for (std::uint32_t i = 0; i < count; ++i) above_[i] = i;
    restless_.assign(count, 0);
    for (const GrainContact<dim>& c : contacts) {
      if (c.b >= count || c.P.isZero(0)) continue;
      const std::uint32_t p = root(c.a), q = root(c.b);
      above_[std::max(p, q)] = std::min(p, q);
    }
  }
  [[nodiscard]] std::uint32_t root(std::uint32_t i) noexcept {
    while (above_[i] != i) i = above_[i] = above_[above_[i]];
    return i;
  }

  std::vector<std::uint16_t> quiet_;
  std::vector<std::uint32_t> above_;
  std::vector<std::uint8_t> restless_;
  std::size_t sleepers_ = 0;
};

}  // namespace torsor::runtime
