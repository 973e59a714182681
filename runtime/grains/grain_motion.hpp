// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "runtime/batch/thread_team.hpp"
#include "runtime/grains/grain_contacts.hpp"

namespace torsor::runtime {

struct GrainOptions {
  double tolerance = 1e-6;  ///< of the natural map, over the largest impulse
  int sweeps = 2000;        ///< at most, in a step
  int projections = 20;     ///< sweeps that put overlaps back, at most
  unsigned threads = 1;
};

/// What a step found.
struct GrainStep {
  bool converged = false;  ///< the residual is below the tolerance
  int sweeps = 0;
  double residual = 0;
  double deepest = 0;  ///< overlap at the middle of the step [m]
  std::size_t contacts = 0;
};

/// Moves grains by the scheme of Moreau and Jean with θ = 1/2:
///   x_m = x + h v/2;  v+ = v + h g + M^-1 J^T P;  0 <= w_N+ + e w_N-, P_N >= 0, |P_T| <= f P_N;  x+ = x_m + h v+/2,
/// contacts being those whose gap at x_m is closed; where e = 0 also those that would close by x+, 0 <= w_N+ + 2 g/h.
/// P by sweeps of Gauss and Seidel in which each contact is solved
/// exactly, with Coulomb's disc, from the impulses of the last step; sweeps are combined as conjugate gradients are
/// (Silcowitz-Hansen, Niebe & Erleben 2010). W is never assembled: its blocks are read from the graph of contacts.
/// Overlaps are put back by displacements that do not become velocities. The bits do not depend on the number of
/// threads. Nothing is allocated once the vectors have their size. Source: Acary & Brogliato 2008, chapter 10.
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
    GrainStep result;
    result.contacts = all.size();
    for (Contact& c : all) {
      result.deepest = std::max(result.deepest, -c.gap);
      // The velocity of separation asked for: e times that of approach; without restitution one that closes what is
      // left of the gap is let pass.
      if (c.gap <= 0) {
        c.bounce *= -std::min(0.0, relative_velocity(c).dot(c.n));
      } else {
        c.bounce = c.bounce > 0 ? -never : -2 * c.gap / h;
      }
      const double normal = std::max(0.0, c.P.dot(c.n));
      const Vector tangent = c.P - c.P.dot(c.n) * c.n;
      const double length = tangent.norm(), bound = c.friction * normal;
      c.P = normal * c.n + (length > bound ? bound / length : 1.0) * tangent;
    }
    for (std::size_t i = 0; i < count; ++i) grains_.v[i] += h * grains_.gravity;
    for (const Contact& c : all) apply(c, c.P);
    solve(result);
    project(count, result);
    for (std::size_t i = 0; i < count; ++i) {
      grains_.x[i] += h / 2 * grains_.v[i];
      grains_.turned[i] += h / 2 * grains_.w[i];
    }
    return result;
  }

  [[nodiscard]] const GrainContacts<dim>& contacts() const noexcept { return contacts_; }

 private:
  static constexpr double never = 1e300;  // a velocity of approach

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

  void apply(const Contact& c, const Vector& P) noexcept {
    const Spin twist = moment(c.n, P);
    grains_.v[c.a] += grains_.inverse_mass[c.a] * P;
    grains_.w[c.a] -= grains_.radius[c.a] * grains_.inverse_inertia[c.a] * twist;
    if (c.b < grains_.count()) {
      grains_.v[c.b] -= grains_.inverse_mass[c.b] * P;
      grains_.w[c.b] -= grains_.radius[c.b] * grains_.inverse_inertia[c.b] * twist;
    }
  }

  // The impulse that fulfils the laws of one contact with the others held: W is diagonal, so that it is in closed form.
  [[nodiscard]] Vector solved(const Contact& c, const Vector& u) const noexcept {
    const double uN = u.dot(c.n), PN = c.P.dot(c.n);
    const double normal = std::max(0.0, PN - (uN - c.bounce) / c.normal_weight);
    Vector tangent = (c.P - PN * c.n) - (u - uN * c.n) / c.tangent_weight;
    const double bound = c.friction * normal, length = tangent.norm();
    if (length > bound) tangent *= bound / length;
    return normal * c.n + tangent;
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

  // Sum over pieces of a fixed length, whatever the number of threads.
  template <class Term>
  [[nodiscard]] double sum_of(std::size_t count, const Term& term) {
    constexpr std::size_t piece = 256;
    parts_.resize((count + piece - 1) / piece);
    team_.run(count, [&](std::size_t first, std::size_t end) {
      // Ranges are rounded to pieces, each of which has one thread.
      for (std::size_t p = (first + piece - 1) / piece; p * piece < end; ++p) {
        double sum = 0;
        for (std::size_t i = p * piece; i < std::min(count, (p + 1) * piece); ++i) sum += term(i);
        parts_[p] = sum;
      }
    });
    double sum = 0;
    for (const double part : parts_) sum += part;
    return sum;
  }

  void solve(GrainStep& result) {
    auto& all = contacts_.all();
    const std::size_t count = grains_.count();
    before_.resize(all.size());
    along_.assign(all.size(), Vector::Zero());
    v_along_.assign(count, Vector::Zero());
    w_along_.assign(count, Spin::Zero());
    v_before_.resize(count);
    w_before_.resize(count);
    double last = 0;
    for (result.sweeps = 0; result.sweeps < options_.sweeps;) {
      if (result.sweeps % 8 == 0) {
        result.residual = residual();
        result.converged = result.residual <= options_.tolerance;
        if (result.converged) return;
      }
      for (std::size_t i = 0; i < all.size(); ++i) before_[i] = all[i].P;
      v_before_ = grains_.v;
      w_before_ = grains_.w;
      in_colours([&](Contact& c) {
        const Vector P = solved(c, relative_velocity(c));
        apply(c, P - c.P);
        c.P = P;
      });
      ++result.sweeps;
      const double size = sum_of(all.size(), [&](std::size_t i) { return (all[i].P - before_[i]).squaredNorm(); });
      const double beta = last > 0 ? size / last : 0;
      last = size;
      // Not before a residual is looked at: an impulse then fulfils its bounds.
      const bool restarts = beta > 1 || result.sweeps % 8 == 0;
      team_.run(all.size(), [&](std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end; ++i) {
          const Vector change = all[i].P - before_[i];
          if (restarts) {
            along_[i].setZero();
          } else {
            all[i].P += beta * along_[i];
            along_[i] = beta * along_[i] + change;
          }
        }
      });
      team_.run(count, [&](std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end; ++i) {
          const Vector change = grains_.v[i] - v_before_[i];
          const Spin turning = grains_.w[i] - w_before_[i];
          if (restarts) {
            v_along_[i].setZero();
            w_along_[i].setZero();
          } else {
            grains_.v[i] += beta * v_along_[i];
            grains_.w[i] += beta * w_along_[i];
            v_along_[i] = beta * v_along_[i] + change;
            w_along_[i] = beta * w_along_[i] + turning;
          }
        }
      });
      if (beta > 1) last = 0;
    }
    result.residual = residual();
    result.converged = result.residual <= options_.tolerance;
  }

  // The largest defect of the laws over the largest impulse.
  [[nodiscard]] double residual() noexcept {
    double defect = 0, size = 0;
    for (const Contact& c : contacts_.all()) {
      const double off = (solved(c, relative_velocity(c)) - c.P).squaredNorm();
      if (!(off <= defect)) defect = off;  // what is no number too
      size = std::max(size, c.P.squaredNorm());
    }
    if (!std::isfinite(defect)) return defect;
    return size > 0 ? std::sqrt(defect / size) : defect > 0 ? 1.0 : 0.0;
  }

  // Displacements M^-1 J_N^T s, s >= 0, after which no gap is negative, by sweeps.
  void project(std::size_t count, const GrainStep& result) {
    if (!(result.deepest > 0)) return;
    shift_.assign(count, Vector::Zero());
    for (Contact& c : contacts_.all()) {
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
  std::vector<Vector> before_, along_, v_along_, v_before_, shift_;
  std::vector<Spin> w_along_, w_before_;
  std::vector<double> parts_;
};

}  // namespace torsor::runtime
