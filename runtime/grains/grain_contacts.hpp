// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "torsor/runtime/grains/grains.hpp"
#include "torsor/runtime/grains/neighbour_grid.hpp"

namespace torsor::runtime {

/// A contact of grain a with grain b, or with wall b - count. n goes from b to a.
template <int dim>
struct GrainContact {
  using Vector = Eigen::Matrix<double, dim, 1>;
  std::uint32_t a = 0, b = 0;
  Vector n, surface = Vector::Zero();            ///< the wall's own velocity there
  double gap = 0, friction = 0, bounce = 0;      ///< bounce: the velocity of separation asked for, -e w_N-
  bool open = false;                             ///< takes no part in this step: P = 0
  double normal_weight = 0, tangent_weight = 0;  ///< the diagonal of W: N, T
  Vector P = Vector::Zero();                     ///< impulse on a [N s]
  double push = 0;                               ///< of the gap's projection [kg m]
};

/// The contacts of a state: found by a grid, in the order of grains, with the impulses they had before; in groups
/// (colours) within which no two move the same grain, so that the contacts of a group may be solved at once.
template <int dim>
class GrainContacts {
 public:
  using Vector = Eigen::Matrix<double, dim, 1>;
  using Contact = GrainContact<dim>;
  static constexpr std::size_t colours = 64;

  /// As many contacts as discs or spheres of similar size have when they lie close.
  [[nodiscard]] static constexpr std::size_t usual(std::size_t count) noexcept {
    return (dim == 2 ? 4 : 8) * count + 64;
  }

  void reserve(std::size_t count) {
    contacts_.reserve(usual(count));
    before_.reserve(usual(count));
    order_.reserve(usual(count));
    colour_.reserve(usual(count));
    used_.reserve(count);
    first_.reserve(count + 1);
    first_before_.reserve(count + 1);
  }

  /// Contacts with gaps up to `reach` at the places `x`.
  void find(const Grains<dim>& grains, const std::vector<Vector>& x, double reach) {
    std::swap(contacts_, before_);
    std::swap(first_, first_before_);
    contacts_.clear();
    first_.clear();
    double widest = 0;
    for (const double R : grains.radius) widest = std::max(widest, R);
    grid_.sort(x, 2 * widest + reach);
    const auto count = static_cast<std::uint32_t>(grains.count());
    for (std::uint32_t i = 0; i < count; ++i) {
      first_.push_back(static_cast<std::uint32_t>(contacts_.size()));
      grid_.visit_later(i, [&](std::uint32_t j) {
        const Vector apart = x[i] - x[j];
        const double sum = grains.radius[i] + grains.radius[j], distance2 = apart.squaredNorm();
        if (distance2 > (sum + reach) * (sum + reach)) return;
        const double distance = std::sqrt(distance2);
        Contact& c = add(grains, i, j, distance > 0 ? Vector(apart / distance) : Vector(Vector::Unit(dim - 1)));
        c.gap = distance - sum;
        c.friction = grains.friction;
        c.bounce = grains.restitution;
      });
      for (std::size_t k = 0; k < grains.walls.size(); ++k) {
        const WallGap<dim> near = wall_gap(grains.walls[k], x[i], grains.radius[i], grains.v[i]);
        if (near.gap > reach) continue;
        Contact& c = add(grains, i, count + static_cast<std::uint32_t>(k), near.n);
        c.gap = near.gap;
        c.surface = near.surface;
        c.friction = grains.walls[k].friction;
        c.bounce = grains.walls[k].restitution;
      }
      const auto begin = contacts_.begin() + first_.back();
      std::sort(begin, contacts_.end(), [](const Contact& p, const Contact& q) { return p.b < q.b; });
    }
    first_.push_back(static_cast<std::uint32_t>(contacts_.size()));
    keep_impulses();
  }

  /// Gives colours to the contacts in which a grain takes part.
  template <class TakesPart>
  void colour(std::uint32_t count, const TakesPart& takes_part) {
    used_.assign(count, 0);
    colour_.resize(contacts_.size());
    first_of_.fill(0);
    std::size_t awake = 0;
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      const Contact& c = contacts_[k];
      const bool pair = c.b < count;
      if (!takes_part(c.a) && (!pair || !takes_part(c.b))) {
        colour_[k] = none;
        continue;
      }
      const std::uint64_t used = used_[c.a] | (pair ? used_[c.b] : 0);
      const auto free = std::min<std::size_t>(static_cast<std::size_t>(std::countr_one(used)), colours - 1);
      colour_[k] = static_cast<std::uint8_t>(free);
      used_[c.a] |= std::uint64_t{1} << free;
      if (pair) used_[c.b] |= std::uint64_t{1} << free;
      ++first_of_[free + 1];
      ++awake;
    }
    for (std::size_t k = 0; k < colours; ++k) first_of_[k + 1] += first_of_[k];
    order_.resize(awake);
    auto next = first_of_;
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      if (colour_[k] != none) order_[next[colour_[k]]++] = static_cast<std::uint32_t>(k);
    }
  }

  [[nodiscard]] std::vector<Contact>& all() noexcept { return contacts_; }
  [[nodiscard]] const std::vector<Contact>& all() const noexcept { return contacts_; }
  /// Contacts of a colour: order()[first_of(k)], ..., order()[first_of(k + 1) - 1]. The last colour holds what is left
  /// where a grain has more than 63 contacts: those are solved one after the other.
  [[nodiscard]] const std::vector<std::uint32_t>& order() const noexcept { return order_; }
  [[nodiscard]] std::size_t first_of(std::size_t colour) const noexcept { return first_of_[colour]; }

 private:
  Contact& add(const Grains<dim>& grains, std::uint32_t a, std::uint32_t b, const Vector& n) {
    Contact& c = contacts_.emplace_back();
    c.a = a;
    c.b = b;
    c.n = n;
    c.normal_weight = grains.inverse_mass[a];
    c.tangent_weight = c.normal_weight + grains.radius[a] * grains.radius[a] * grains.inverse_inertia[a];
    if (b < grains.count()) {
      c.normal_weight += grains.inverse_mass[b];
      c.tangent_weight += grains.inverse_mass[b] + grains.radius[b] * grains.radius[b] * grains.inverse_inertia[b];
    }
    return c;
  }

  // Impulses of the last step, for contacts that are still there: a good guess while little changes.
  void keep_impulses() noexcept {
    for (std::size_t i = 0; i + 1 < first_.size() && i + 1 < first_before_.size(); ++i) {
      std::size_t old = first_before_[i];
      for (std::size_t k = first_[i]; k < first_[i + 1]; ++k) {
        while (old < first_before_[i + 1] && before_[old].b < contacts_[k].b) ++old;
        if (old == first_before_[i + 1]) break;
        if (before_[old].b != contacts_[k].b) continue;
        contacts_[k].P = before_[old].P;
        contacts_[k].push = before_[old].push;
      }
    }
  }

  static constexpr std::uint8_t none = 255;

  NeighbourGrid<dim> grid_;
  std::vector<Contact> contacts_, before_;
  std::vector<std::uint32_t> first_, first_before_, order_;
  std::vector<std::uint64_t> used_;
  std::vector<std::uint8_t> colour_;
  std::array<std::uint32_t, colours + 1> first_of_{};
};

}  // namespace torsor::runtime
