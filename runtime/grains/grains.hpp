// SPDX-License-Identifier: MIT
#pragma once
#include <Eigen/Geometry>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace torsor::runtime {

/// A fixed or moving surface that grains meet: a half-space, a part of a line, or the inside of a drum about the axis
/// through `point` (in space along y).
template <int dim>
struct GrainWall {
  using Vector = Eigen::Matrix<double, dim, 1>;
  enum class Shape : unsigned char { plane, segment, drum };
  Shape shape = Shape::plane;
  Vector point = Vector::Zero();          ///< on the plane, the start of the segment, the centre of the drum
  Vector normal = Vector::Unit(dim - 1);  ///< unit vector into the room of the grains; not of a segment
  Vector end = Vector::Zero();            ///< of the segment
  double radius = 0, spin = 0;            ///< of the drum [m], [rad/s]: positive from x to the last axis
  Vector velocity = Vector::Zero();       ///< of the surface [m/s]: a belt
  double friction = 0.5, restitution = 0;

  [[nodiscard]] bool operator==(const GrainWall&) const = default;
};

/// Discs (dim = 2) or spheres (dim = 3), walls, and what their contacts obey. Lengths in m, masses in kg; in the plane
/// the last axis is up too.
template <int dim>
struct Grains {
  static_assert(dim == 2 || dim == 3);
  using Vector = Eigen::Matrix<double, dim, 1>;
  using Spin = Eigen::Matrix<double, dim == 2 ? 1 : 3, 1>;

  std::vector<Vector> x, v;
  std::vector<Spin> turned, w;  ///< angle and angular velocity [rad], [rad/s]; in space the sum of small turns
  std::vector<double> radius, inverse_mass, inverse_inertia;
  std::vector<GrainWall<dim>> walls;
  Vector gravity = -9.81 * Vector::Unit(dim - 1);
  double friction = 0.5, restitution = 0;  ///< between grains

  [[nodiscard]] std::size_t count() const noexcept { return x.size(); }

  /// A homogeneous grain: I = m R²/2 of a disc, 2 m R²/5 of a sphere.
  void add(const Vector& centre, double R, double mass, const Vector& velocity = Vector::Zero()) {
    x.push_back(centre);
    v.push_back(velocity);
    turned.push_back(Spin::Zero());
    w.push_back(Spin::Zero());
    radius.push_back(R);
    inverse_mass.push_back(1 / mass);
    inverse_inertia.push_back((dim == 2 ? 2.0 : 2.5) / (mass * R * R));
  }

  /// T + U.
  [[nodiscard]] double energy() const noexcept {
    double sum = 0;
    for (std::size_t i = 0; i < count(); ++i) {
      sum +=
          (v[i].squaredNorm() / 2 - gravity.dot(x[i])) / inverse_mass[i] + w[i].squaredNorm() / 2 / inverse_inertia[i];
    }
    return sum;
  }
  [[nodiscard]] double kinetic_energy() const noexcept {
    double sum = 0;
    for (std::size_t i = 0; i < count(); ++i) {
      sum += v[i].squaredNorm() / 2 / inverse_mass[i] + w[i].squaredNorm() / 2 / inverse_inertia[i];
    }
    return sum;
  }
};

/// spin × n.
inline Eigen::Vector2d turn(const Eigen::Matrix<double, 1, 1>& spin, const Eigen::Vector2d& n) noexcept {
  return {-spin(0) * n(1), spin(0) * n(0)};
}
inline Eigen::Vector3d turn(const Eigen::Vector3d& spin, const Eigen::Vector3d& n) noexcept { return spin.cross(n); }

/// n × P.
inline Eigen::Matrix<double, 1, 1> moment(const Eigen::Vector2d& n, const Eigen::Vector2d& P) noexcept {
  return Eigen::Matrix<double, 1, 1>(n(0) * P(1) - n(1) * P(0));
}
inline Eigen::Vector3d moment(const Eigen::Vector3d& n, const Eigen::Vector3d& P) noexcept { return n.cross(P); }

/// The normal of a segment for a grain whose centre lies on it: against its velocity, and across the segment unless it came
/// along it, on an end.
template <class Vector>
[[nodiscard]] Vector across_a_segment(const Vector& along, const Vector& v) noexcept {
  const auto across = [&](const Vector& u) { return Vector(u - u.dot(along) / along.squaredNorm() * along); };
  const double speed = v.norm();
  if (const Vector against = across(-v); against.norm() > 1e-9 * speed) return against.normalized();
  if (speed > 0) return -v / speed;
  int axis = 0;
  along.cwiseAbs().minCoeff(&axis);
  return across(Vector::Unit(axis)).normalized();
}

/// Distance of a grain from a wall, the wall's normal towards it, and the velocity of the surface there.
template <int dim>
struct WallGap {
  Eigen::Matrix<double, dim, 1> n, surface;
  double gap;
};

template <int dim>
[[nodiscard]] WallGap<dim> wall_gap(const GrainWall<dim>& wall, const Eigen::Matrix<double, dim, 1>& x,
                                    double R,
                                    const Eigen::Matrix<double, dim, 1>& v = Eigen::Matrix<double, dim, 1>::Zero()) noexcept {
  using Vector = Eigen::Matrix<double, dim, 1>;
  using Shape = typename GrainWall<dim>::Shape;
  if (wall.shape == Shape::plane) return {wall.normal, wall.velocity, wall.normal.dot(x - wall.point) - R};
  if (wall.shape == Shape::segment) {
    const Vector along = wall.end - wall.point;
    const double part = std::fmin(1.0, std::fmax(0.0, along.dot(x - wall.point) / along.squaredNorm()));
    const Vector away = x - wall.point - part * along;
    const double distance = away.norm();
    const Vector n = distance > 1e-9 * R ? Vector(away / distance) : across_a_segment(along, v);  // its side is rounding
    return {n, wall.velocity, distance - R};
  }
  Vector out = x - wall.point;
  if constexpr (dim == 3) out(1) = 0;
  const double distance = out.norm();
  const Vector n = distance > 0 ? Vector(-out / distance) : Vector(Vector::Unit(dim - 1));
  Vector surface = wall.velocity;
  surface(0) += wall.spin * wall.radius * n(dim - 1);
  surface(dim - 1) -= wall.spin * wall.radius * n(0);
  return {n, surface, wall.radius - distance - R};
}

}  // namespace torsor::runtime
