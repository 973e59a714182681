// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "torsor/runtime/grains/grain_motion.hpp"

namespace grains_example {

using torsor::runtime::GrainMotion;
using torsor::runtime::GrainOptions;
using torsor::runtime::Grains;
using torsor::runtime::GrainWall;

inline constexpr double least_radius = 0.004, most_radius = 0.006, step = 1e-3;
/// Sweeps at most: in an avalanche more would not pay.
inline constexpr GrainOptions options{.tolerance = 1e-4, .sweeps = 100};

/// Radii between the least and the most, the same ones in every run with one seed.
class Radii {
 public:
  explicit Radii(unsigned long long seed = 1) : state_(seed) {}
  double next() {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return least_radius +
           (most_radius - least_radius) * static_cast<double>(state_ >> 40) / static_cast<double>(1 << 24);
  }

 private:
  unsigned long long state_;
};

inline void add_disc(Grains<2>& grains, const Eigen::Vector2d& centre, double R) {
  grains.add(centre, R, 2500 * 3.14159 * R * R);  // of 1 m length
}

/// A drum that turns slowly, so that the discs in it avalanche: how steep they lie is the angle of repose.
class Drum {
 public:
  Drum(int count, double friction, double radius = 0.12, double spin = 0.4) : motion_(grains_, options) {
    grains_.friction = friction;
    grains_.walls.push_back({.shape = GrainWall<2>::Shape::drum, .radius = radius, .spin = spin, .friction = friction});
    Radii radii;
    constexpr double cell = 2.2 * most_radius;
    const int reach = static_cast<int>(radius / cell);
    for (int row = -reach; row <= reach; ++row) {
      for (int column = -reach; column <= reach && static_cast<int>(grains_.count()) < count; ++column) {
        const Eigen::Vector2d centre(cell * column + 0.1 * most_radius * row, cell * row);
        if (centre.norm() < radius - 1.2 * most_radius) add_disc(grains_, centre, radii.next());
      }
    }
  }
  Drum(const Drum&) = delete;
  Drum& operator=(const Drum&) = delete;

  /// What a time showed on average.
  struct Shown {
    double angle = 0;   ///< of the line from the axis to the centre of mass, from the vertical [rad]
    double torque = 0;  ///< of the drum on the grains [N m]
    double weight = 0;  ///< times the lever of the centre of mass [N m]
  };
  Shown run(double time) {
    Shown shown;
    const int steps = static_cast<int>(std::lround(time / step));
    for (int k = 0; k < steps; ++k) {
      (void)motion_.step(step);
      Eigen::Vector2d moment = Eigen::Vector2d::Zero();
      for (std::size_t i = 0; i < grains_.count(); ++i) moment += grains_.x[i] / grains_.inverse_mass[i];
      shown.angle += std::atan2(moment(0), -moment(1)) / steps;
      shown.weight += -grains_.gravity(1) * moment(0) / steps;
      for (const auto& c : motion_.contacts().all()) {
        if (c.b < grains_.count()) continue;
        const Eigen::Vector2d point = grains_.x[c.a] - grains_.radius[c.a] * c.n;
        shown.torque += (point(0) * c.P(1) - point(1) * c.P(0)) / time;
      }
    }
    return shown;
  }

 private:
  Grains<2> grains_;
  GrainMotion<2> motion_;
};

/// A silo whose floor slopes down to an opening from both sides. What has fallen out is put back on top.
class Silo {
 public:
  Silo(int count, double friction, double opening, double width = 0.2) : motion_(grains_, options), width_(width) {
    grains_.friction = friction;
    const double half = width / 2, high = half - opening / 2;  // walls at 45 degrees
    GrainWall<2> left{.normal = {1, 0}, .friction = friction}, right{.normal = {-1, 0}, .friction = friction};
    left.point = {-half, 0};
    right.point = {half, 0};
    GrainWall<2> from_left{.shape = GrainWall<2>::Shape::segment, .friction = friction}, from_right = from_left;
    from_left.point = {-half, high};
    from_left.end = {-opening / 2, 0};
    from_right.point = {half, high};
    from_right.end = {opening / 2, 0};
    grains_.walls = {left, right, from_left, from_right};
    Radii radii;
    constexpr double cell = 2.2 * most_radius;
    const int columns = static_cast<int>(width / cell);
    for (int i = 0; i < count; ++i) {
      const double aside = 0.5 * cell + cell * (i % columns) - half, up = high + cell * (1 + i / columns);
      add_disc(grains_, {aside, up}, radii.next());
    }
  }
  Silo(const Silo&) = delete;
  Silo& operator=(const Silo&) = delete;

  /// Mass that fell out in a time [kg].
  double run(double time) {
    double fallen = 0;
    const int steps = static_cast<int>(std::lround(time / step));
    for (int k = 0; k < steps; ++k) {
      (void)motion_.step(step);
      for (std::size_t i = 0; i < grains_.count(); ++i) {
        if (grains_.x[i](1) > -0.05) continue;
        fallen += 1 / grains_.inverse_mass[i];
        lay_on_top(i);
      }
    }
    return fallen;
  }

 private:
  void lay_on_top(std::size_t i) {
    const double place = (static_cast<double>(turn_++ % 13) / 13 - 0.5) * (width_ - 4 * most_radius);
    double top = 0;
    for (std::size_t j = 0; j < grains_.count(); ++j) {
      if (j != i && std::abs(grains_.x[j](0) - place) < 2 * most_radius) top = std::max(top, grains_.x[j](1));
    }
    grains_.x[i] = {place, top + 2.1 * most_radius};
    grains_.v[i].setZero();
    grains_.w[i].setZero();
  }

  Grains<2> grains_;
  GrainMotion<2> motion_;
  double width_;
  unsigned turn_ = 0;
};

}  // namespace grains_example
