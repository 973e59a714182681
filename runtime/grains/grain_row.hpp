// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "torsor/runtime/grains/grain_contacts.hpp"

namespace torsor::runtime {

/// How a contact's impulse is brought into its bounds: Coulomb's law, or the nearest point of the cone |T| <= f N in
/// the metric of W. The latter is not friction, which does not lift what slides, but makes all contacts one convex
/// problem: the least |v| in the metric of the masses. Where that is zero nothing slides, and Coulomb's law is
/// fulfilled too: rest.
enum class GrainLaw { coulomb, cone };

/// What a contact's row is in the plane and in space alike: who takes part, and how far impulses move them. W has the
/// diagonal 1/N_step, 1/T_step. A contact that takes no part has steps of zero, so that its impulse stays zero.
struct GrainRowBase {
  static constexpr std::uint32_t wall = std::numeric_limits<std::uint32_t>::max();

  std::uint32_t a = 0, b = wall;
  double friction = 0, N_step = 0, T_step = 0;
  double mobility_a = 0, mobility_b = 0, spin_a = 0, spin_b = 0;  // 1/m, R²/J

  GrainRowBase() = default;
  template <int dim>
  GrainRowBase(const Grains<dim>& grains, const GrainContact<dim>& c) noexcept
      : a(c.a), friction(c.friction), mobility_a(grains.inverse_mass[c.a]), spin_a(spin_of(grains, c.a)) {
    if (!c.open) {
      N_step = 1 / c.normal_weight;
      T_step = 1 / c.tangent_weight;
    }
    if (c.b >= grains.count()) return;
    b = c.b;
    mobility_b = grains.inverse_mass[b];
    spin_b = spin_of(grains, b);
  }

 private:
  template <int dim>
  static double spin_of(const Grains<dim>& grains, std::uint32_t i) noexcept {
    return grains.radius[i] * grains.radius[i] * grains.inverse_inertia[i];
  }
};

/// A contact as a sweep needs it, beside numbers v and s = R ω of all grains, `stride` of them for each. Its relative
/// velocity is w = v_a - v_b - (s_a + s_b) × n. What is no number stays so: limits compare it second.
template <int dim>
struct GrainRow;

/// In the plane impulses and velocities are (N, T): along n and along n turned by a quarter.
template <>
struct GrainRow<2> : GrainRowBase {
  using Local = Eigen::Vector2d;
  static constexpr std::size_t stride = 3;

  double nx = 0, ny = 0;
  double N_given = 0, T_given = 0;  // w - given fulfils the laws

  GrainRow() = default;
  GrainRow(const Grains<2>& grains, const GrainContact<2>& c) noexcept
      : GrainRowBase(grains, c),
        nx(c.n(0)),
        ny(c.n(1)),
        N_given(c.bounce + c.surface.dot(c.n)),
        T_given(nx * c.surface(1) - ny * c.surface(0)) {}

  static Local local(const GrainContact<2>& c, const Eigen::Vector2d& P) noexcept {
    return {P.dot(c.n), c.n(0) * P(1) - c.n(1) * P(0)};
  }
  static Eigen::Vector2d global(const GrainContact<2>& c, const Local& P) noexcept {
    return {c.n(0) * P(0) - c.n(1) * P(1), c.n(1) * P(0) + c.n(0) * P(1)};
  }
  static void put(double* to, const Eigen::Vector2d& v, const Eigen::Matrix<double, 1, 1>& s) noexcept {
    to[0] = v(0);
    to[1] = v(1);
    to[2] = s(0);
  }
  static void take(const double* from, double radius, Eigen::Vector2d& v, Eigen::Matrix<double, 1, 1>& w) noexcept {
    v = {from[0], from[1]};
    w(0) = from[2] / radius;
  }

  template <GrainLaw law = GrainLaw::coulomb>
  [[nodiscard]] Local bounded(double N, double T) const noexcept {
    if constexpr (law == GrainLaw::coulomb) {
      N = std::max(N, 0.0);
    } else if (!(std::abs(T) <= friction * N)) {
      const double f = friction * N_step;  // weights 1/N_step of N, 1/T_step of T, times both steps
      N = std::max((N * T_step + f * std::abs(T)) / (T_step + f * friction), 0.0);
    }
    const double bound = friction * N;
    return {N, std::min(std::max(T, -bound), bound)};
  }

  [[nodiscard]] Local start(const Local& P) const noexcept { return bounded(P(0), P(1)); }

  /// w - given.
  [[nodiscard]] Local velocity(const double* velocities) const noexcept {
    const double* va = velocities + stride * a;
    double x = va[0], y = va[1], s = va[2];
    if (b != wall) {
      const double* vb = velocities + stride * b;
      x -= vb[0];
      y -= vb[1];
      s += vb[2];
    }
    return {nx * x + ny * y - N_given, nx * y - ny * x - s - T_given};
  }
  static double normal_part(const Local& u) noexcept { return u(0); }
  static double tangent_part(const Local& u) noexcept { return std::abs(u(1)); }

  /// The impulse that fulfils the laws with the other contacts held.
  template <GrainLaw law>
  [[nodiscard]] Local solved(const double* velocities, const Local& P) const noexcept {
    const Local u = velocity(velocities);
    return bounded<law>(P(0) - N_step * u(0), P(1) - T_step * u(1));
  }

  /// Solves the contact with the others held: P, its change, and the velocities after. All is read before it is
  /// written.
  template <GrainLaw law>
  void solve(double* velocities, Local& P, Local& change) const noexcept {
    const bool pair = b != wall;
    double* const va = velocities + stride * a;
    double* const vb = pair ? velocities + stride * b : va;
    const double ax = va[0], ay = va[1], as = va[2];
    const double bx = pair ? vb[0] : 0.0, by = pair ? vb[1] : 0.0, bs = pair ? vb[2] : 0.0;
    const double cx = nx, cy = ny, x = ax - bx, y = ay - by, N_before = P(0), T_before = P(1);
    const Local after = bounded<law>(N_before - N_step * (cx * x + cy * y - N_given),
                                     T_before - T_step * (cx * y - cy * x - (as + bs) - T_given));
    const double dN = after(0) - N_before, dT = after(1) - T_before, px = cx * dN - cy * dT, py = cy * dN + cx * dT;
    const double ma = mobility_a, mb = mobility_b, sa = spin_a, sb = spin_b;
    P = after;
    change(0) = dN;
    change(1) = dT;
    va[0] = ax + ma * px;
    va[1] = ay + ma * py;
    va[2] = as - sa * dT;
    if (!pair) return;
    vb[0] = bx - mb * px;
    vb[1] = by - mb * py;
    vb[2] = bs - sb * dT;
  }

  void apply(double* velocities, const Local& P) const noexcept {
    const double x = nx * P(0) - ny * P(1), y = ny * P(0) + nx * P(1);
    double* va = velocities + stride * a;
    va[0] += mobility_a * x;
    va[1] += mobility_a * y;
    va[2] -= spin_a * P(1);
    if (b == wall) return;
    double* vb = velocities + stride * b;
    vb[0] -= mobility_b * x;
    vb[1] -= mobility_b * y;
    vb[2] -= spin_b * P(1);
  }
};

/// In space impulses and velocities are vectors.
template <>
struct GrainRow<3> : GrainRowBase {
  using Local = Eigen::Vector3d;
  static constexpr std::size_t stride = 6;

  Local n, given;

  GrainRow() = default;
  GrainRow(const Grains<3>& grains, const GrainContact<3>& c) noexcept
      : GrainRowBase(grains, c), n(c.n), given(c.surface + c.bounce * c.n) {}

  static const Local& local(const GrainContact<3>&, const Local& P) noexcept { return P; }
  static const Local& global(const GrainContact<3>&, const Local& P) noexcept { return P; }
  static void put(double* to, const Local& v, const Local& s) noexcept {
    Eigen::Map<Local>{to} = v;
    Eigen::Map<Local>{to + 3} = s;
  }
  static void take(const double* from, double radius, Local& v, Local& w) noexcept {
    v = Eigen::Map<const Local>(from);
    w = Eigen::Map<const Local>(from + 3) / radius;
  }

  template <GrainLaw law = GrainLaw::coulomb>
  [[nodiscard]] Local bounded(const Local& P) const noexcept {
    const double along = P.dot(n);
    Local T = P - along * n;
    double N = std::max(along, 0.0);
    const double length2 = T.squaredNorm();
    const double length = std::sqrt(length2);
    if (length <= friction * N) return N * n + T;
    if constexpr (law == GrainLaw::cone) {
      const double f = friction * N_step;
      N = std::max((along * T_step + f * length) / (T_step + f * friction), 0.0);
    }
    return N * n + friction * N / length * T;
  }

  [[nodiscard]] Local start(const Local& P) const noexcept { return bounded(P); }
  [[nodiscard]] Local velocity(const double* velocities) const noexcept {
    const double* va = velocities + stride * a;
    Local u = Eigen::Map<const Local>(va) - given, s = Eigen::Map<const Local>(va + 3);
    if (b != wall) {
      const double* vb = velocities + stride * b;
      u -= Eigen::Map<const Local>(vb);
      s += Eigen::Map<const Local>(vb + 3);
    }
    return u - s.cross(n);
  }
  [[nodiscard]] double normal_part(const Local& u) const noexcept { return u.dot(n); }
  [[nodiscard]] double tangent_part(const Local& u) const noexcept { return (u - u.dot(n) * n).norm(); }

  template <GrainLaw law>
  [[nodiscard]] Local solved(const double* velocities, const Local& P) const noexcept {
    const Local u = velocity(velocities);
    return bounded<law>(P - T_step * u - ((N_step - T_step) * u.dot(n)) * n);
  }

  template <GrainLaw law>
  void solve(double* velocities, Local& P, Local& change) const noexcept {
    const Local after = solved<law>(velocities, P);
    change = after - P;
    P = after;
    apply(velocities, change);
  }

  void apply(double* velocities, const Local& P) const noexcept {
    const Local twist = n.cross(P);
    double* va = velocities + stride * a;
    Eigen::Map<Local>{va} += mobility_a * P;
    Eigen::Map<Local>{va + 3} -= spin_a * twist;
    if (b == wall) return;
    double* vb = velocities + stride * b;
    Eigen::Map<Local>{vb} -= mobility_b * P;
    Eigen::Map<Local>{vb + 3} -= spin_b * twist;
  }
};

}  // namespace torsor::runtime
