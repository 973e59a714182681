// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstddef>

#include "tests/runtime/mechanisms.hpp"

namespace mechanisms {

/// Bricard's threefold symmetric linkage: six revolutes, common normals of length 1, twists of a quarter turn to either
/// side in turn. Six equations of closure for six angles leave it one freedom all the same. By hand, to the contract of
/// generated headers: the angles of five joints along the chain, whose end meets the axis of the sixth (three equations
/// for a point, two for a direction, one of which the others imply). A unit mass at the end of each link, rotors of
/// inertia J about each joint; gravity along -z, the first axis.
/// Its motion: cos θ + cos φ + cos θ cos φ = 0 for the angles θ, φ, θ, φ, θ (Chen, You & Tarnai, Int. J. Solids Struct.
/// 42 (2005) 2287-2301, (7) with a twist of a quarter turn), θ between ±2π/3.
struct Bricard : Contract<5, 5> {
  static constexpr int nv = velocity_count, m = multiplier_count;
  static constexpr double rotor = 0.1;
  /// Both angles a quarter turn, θ' = 1: then φ' = -1, from sin θ θ' + sin φ φ' = 0 there.
  static State initial_state() noexcept {
    const double quarter = std::acos(0.0);
    return {0.0, {{quarter, quarter, quarter, quarter, quarter}}, {{1, -1, 1, -1, 1}}};
  }

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
      const double cosine = std::cos(s.q[i]), sine = std::sin(s.q[i]), turn = i % 2 == 0 ? 1.0 : -1.0;
      const Vector x = cosine * R.col(0) + sine * R.col(1), y = cosine * R.col(1) - sine * R.col(0);
      p += x;
      a += alpha.cross(x) + omega.cross(omega.cross(x));
      c.end[k] = p;
      c.rest[k] = a;
      R.col(0) = x;
      R.col(1) = turn * z;  // a quarter turn about x
      R.col(2) = -turn * y;
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
  /// The sixth joint's axis is at (-1, 0, 0) along -y.
  static void constraints(const Precomputed&, const State& s, Constraints& result) noexcept {
    const Chain c = chain(s);
    const auto fill = [](std::array<double, m>& to, const Vector& point, const Vector& direction) {
      to = {point.x(), point.y(), point.z(), direction.x(), direction.z()};
    };
    fill(result.value, c.end[nv - 1] + Vector(1, 0, 0), c.last_axis);
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

}  // namespace mechanisms
