// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstddef>

#include "tests/runtime/mechanisms.hpp"

namespace mechanisms {

/// A loop of revolutes by hand, to the contract of generated headers: the angles of all joints but the last along the chain,
/// whose end meets the axis of the last one (three equations for a point, two for a direction). A unit mass at the end of
/// each link, rotors of inertia J about each joint; gravity along -z, the first axis. `Linkage` has the number of joints in
/// the chain, lengths of links, sines and cosines of their twists, and rows of the end's place and direction.
template <class Linkage>
struct RevoluteLoop : Contract<Linkage::joints, 5> {
  using Base = Contract<Linkage::joints, 5>;
  using typename Base::Constraints;
  using typename Base::GeneralizedForces;
  using typename Base::Precomputed;
  using typename Base::State;
  static constexpr int nv = Base::velocity_count, m = Base::multiplier_count;
  static constexpr double rotor = 0.1;

  using Vector = Eigen::Vector3d;
  /// Axes and places of the joints, ends of the links, and accelerations at q'' = 0.
  struct Chain {
    std::array<Vector, nv> axis, joint, end, rest;
    Vector last_axis, last_axis_rest;
  };
  static Chain chain(const State& s) noexcept {
    Chain c;
    Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
    Vector p = Vector::Zero(), omega = p, alpha = p, a = p;
    for (int i = 0; i < nv; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const Vector z = R.col(2);
      c.axis[k] = z;
      c.joint[k] = p;
      alpha += omega.cross(z) * s.v[i];
      omega += z * s.v[i];
      const double cosine = std::cos(s.q[i]), sine = std::sin(s.q[i]);
      const double length = Linkage::length(i), level = Linkage::cosine(i), turn = Linkage::sine(i);
      const Vector x = cosine * R.col(0) + sine * R.col(1), y = cosine * R.col(1) - sine * R.col(0);
      p += length * x;
      a += length * (alpha.cross(x) + omega.cross(omega.cross(x)));
      c.end[k] = p;
      c.rest[k] = a;
      R.col(0) = x;
      R.col(1) = level * y + turn * z;  // the twist about x
      R.col(2) = level * z - turn * y;
    }
    c.last_axis = R.col(2);
    c.last_axis_rest = alpha.cross(c.last_axis) + omega.cross(omega.cross(c.last_axis));
    return c;
  }

  static void mass_matrix(const Precomputed&, const State& s, std::array<double, std::size_t{nv} * nv>& mass) noexcept {
    const Chain c = chain(s);
    mass.fill(0.0);
    for (std::size_t i = 0; i < nv; ++i) {
      for (std::size_t j = 0; j < nv; ++j) {
        for (std::size_t k = std::max(i, j); k < nv; ++k) {
          mass[j * nv + i] += c.axis[i].cross(c.end[k] - c.joint[i]).dot(c.axis[j].cross(c.end[k] - c.joint[j]));
        }
      }
      mass[i * nv + i] += rotor;
    }
  }
  static void bias(const Precomputed&, const State& s, GeneralizedForces& h) noexcept {
    const Chain c = chain(s);
    for (std::size_t i = 0; i < nv; ++i) {
      h[static_cast<int>(i)] = 0.0;
      for (std::size_t k = i; k < nv; ++k) {
        const Vector force = c.rest[k] + Vector(0, 0, gravity<double>);
        h[static_cast<int>(i)] += c.axis[i].cross(c.end[k] - c.joint[i]).dot(force);
      }
    }
  }
  static void constraints(const Precomputed&, const State& s, Constraints& result) noexcept {
    const Chain c = chain(s);
    const auto fill = [](std::array<double, m>& to, const Vector& point, const Vector& direction) {
      to = {point.x(), point.y(), point.z(), direction.x(), direction.dot(Linkage::across)};
    };
    fill(result.value, c.end[nv - 1] + Vector(Linkage::length(nv), 0, 0), c.last_axis);
    fill(result.gamma, c.rest[nv - 1], c.last_axis_rest);
    result.rate.fill(0.0);
    for (std::size_t i = 0; i < nv; ++i) {
      std::array<double, m> column;
      fill(column, c.axis[i].cross(c.end[nv - 1] - c.joint[i]), c.axis[i].cross(c.last_axis));
      for (std::size_t j = 0; j < m; ++j) {
        result.jacobian[i * m + j] = column[j];
        result.rate[j] += column[j] * s.v[static_cast<int>(i)];
      }
    }
  }
  /// T - U
  static double energy(const State& s) noexcept {
    std::array<double, std::size_t{nv} * nv> mass;
    mass_matrix({}, s, mass);
    double sum = 0.0;
    for (std::size_t i = 0; i < nv; ++i) {
      for (std::size_t j = 0; j < nv; ++j) {
        sum += 0.5 * mass[j * nv + i] * s.v[static_cast<int>(i)] * s.v[static_cast<int>(j)];
      }
    }
    for (const Vector& end : chain(s).end) sum += gravity<double> * end.z();
    return sum;
  }
};

/// Bricard's threefold symmetric linkage: six revolutes, common normals of length 1, twists of a quarter turn to either
/// side in turn. Six equations of closure for six angles, of which one is implied by the others, leave it one freedom.
/// Its motion: cos θ + cos φ + cos θ cos φ = 0 for the angles θ, φ, θ, φ, θ (Chen, You & Tarnai, Int. J. Solids Struct.
/// 42 (2005) 2287-2301, (7) with a twist of a quarter turn), θ between ±2π/3.
struct BricardLinkage {
  static constexpr int joints = 5;
  static constexpr double length(int) noexcept { return 1; }
  static constexpr double cosine(int) noexcept { return 0; }
  static constexpr double sine(int i) noexcept { return i % 2 == 0 ? 1 : -1; }
  static inline const Eigen::Vector3d across{0, 0, 1};  // the sixth joint's axis is along -y
};
struct Bricard : RevoluteLoop<BricardLinkage> {
  /// Both angles a quarter turn, θ' = 1: then φ' = -1, from sin θ θ' + sin φ φ' = 0 there.
  static State initial_state() noexcept {
    const double quarter = std::acos(0.0);
    return {0.0, {{quarter, quarter, quarter, quarter, quarter}}, {{1, -1, 1, -1, 1}}};
  }
};

/// Bennett's linkage: links 2, 1, 2, 1 long, twists of 90 and 30 degrees in turn, so that length over sine of the twist is the
/// same. Where it is closed, three of its five equations repeat the others, and one of them vanishes as a whole.
/// Its motion: tan(θ1/2) tan(θ2/2) is constant, θ3 = -θ1 (Bennett, Engineering 76 (1903) 777).
struct BennettLinkage {
  static constexpr int joints = 3;
  static constexpr double length(int i) noexcept { return i % 2 == 0 ? 2 : 1; }
  static double cosine(int i) noexcept { return i % 2 == 0 ? 0 : std::sqrt(0.75); }
  static constexpr double sine(int i) noexcept { return i % 2 == 0 ? 1 : 0.5; }
  static inline const Eigen::Vector3d across{0, std::sqrt(0.75), -0.5};  // the last axis is along (0, 1/2, √3/2)
};
struct Bennett : RevoluteLoop<BennettLinkage> {
  static State initial_state() noexcept { return {0.0, {{0.7, 3.5570121281631747, -0.7}}, {{0, 0, 0}}}; }
};
/// As generated: with the list of equations that repeat the others.
struct BennettAsGenerated : Bennett {
  static constexpr int redundant_count = 3;
  static constexpr int redundant_multipliers[redundant_count] = {0, 3, 4};
};

}  // namespace mechanisms
