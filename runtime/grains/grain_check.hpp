// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <sstream>
#include <string>
#include <string_view>

#include "torsor/runtime/grains/grains.hpp"

namespace torsor::runtime {

struct GrainOptions {
  double tolerance = 1e-6;  ///< of the natural map, over the largest impulse
  int sweeps = 2000;        ///< at most, for each question of a step: what rests, whether it could move, how all moves
  int projections = 20;     ///< sweeps that put overlaps back, at most
  unsigned threads = 1;
  double rest = 1e-3;  ///< islands no faster than this part of h |gravity| fall asleep; 0: none does, and rest is not held
};

/// How a step ended.
enum class GrainStatus : int {
  ok = 0,
  not_converged,  ///< the residual is above the tolerance: the grains moved, less exactly than was asked for
  invalid,        ///< a grain, a wall, a parameter or an option is refused: nothing moved
  not_finite,     ///< numbers overflowed in the step: what moved is of no use
  too_fast,       ///< grains pass, or may, through each other or a segment before contacts are looked for again
};

[[nodiscard]] constexpr std::string_view describe(GrainStatus status) noexcept {
  switch (status) {
    case GrainStatus::ok:
      return "the laws are fulfilled to the tolerance";
    case GrainStatus::not_converged:
      return "the sweeps did not reach the tolerance: allow more of them, shorten the step, or accept the residual";
    case GrainStatus::invalid:
      return "a grain, a wall, a parameter or an option is refused, see `fault`";
    case GrainStatus::not_finite:
      return "numbers overflowed: look for sizes, masses or velocities that are far apart";
    case GrainStatus::too_fast:
      return "grains move by so many radii in a step that they pass through each other or a segment, or may: shorten the step";
  }
  return "unknown status of grains";
}

/// What a step refuses: the object, its value, and what to do.
struct GrainFault {
  const char* object = nullptr;  ///< nullptr: nothing is refused
  std::size_t index = none;      ///< of the grain or wall
  const char* quantity = "";
  double value = 0;
  const char* remedy = "";

  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  [[nodiscard]] explicit constexpr operator bool() const noexcept { return object != nullptr; }
};

[[nodiscard]] inline std::string describe(const GrainFault& fault) {
  if (!fault) return "nothing is refused";
  std::ostringstream text;
  text << fault.object;
  if (fault.index != GrainFault::none) text << ' ' << fault.index;
  text << ": " << fault.quantity << " is " << fault.value << "; " << fault.remedy;
  return text.str();
}

namespace grain_check {

inline bool positive(double value) noexcept { return value > 0 && std::isfinite(value); }

template <int dim>
[[nodiscard]] GrainFault of_wall(const GrainWall<dim>& wall, std::size_t index, double widest) noexcept {
  using Shape = typename GrainWall<dim>::Shape;
  const auto refused = [index](const char* quantity, double value, const char* remedy) {
    return GrainFault{"wall", index, quantity, value, remedy};
  };
  const double place = wall.point.sum() + wall.velocity.sum() + wall.spin;
  if (!std::isfinite(place)) return refused("the sum of point, velocity and spin", place, "give finite numbers");
  if (!(wall.friction >= 0) || !std::isfinite(wall.friction)) {
    return refused("friction", wall.friction, "give a finite number of at least 0");
  }
  if (!(wall.restitution >= 0 && wall.restitution <= 1)) {
    return refused("restitution", wall.restitution, "give a number from 0 to 1");
  }
  if (wall.shape == Shape::plane && !(std::abs(wall.normal.norm() - 1) <= 1e-9)) {
    return refused("the length of normal", wall.normal.norm(), "give a unit vector");
  }
  if (wall.shape == Shape::segment) {
    const double length = (wall.end - wall.point).norm();
    if (!positive(length)) return refused("the segment's length", length, "give an end apart from the point");
  }
  if (wall.shape == Shape::drum && !(wall.radius > widest && std::isfinite(wall.radius))) {
    return refused("the drum's radius", wall.radius, "give one above that of every grain");
  }
  return {};
}

template <int dim>
[[nodiscard]] GrainFault of_grain(const Grains<dim>& grains, std::size_t i) noexcept {
  const auto refused = [i](const char* quantity, double value, const char* remedy) {
    return GrainFault{"grain", i, quantity, value, remedy};
  };
  const auto finite = [](const auto& vector) { return std::isfinite(vector.sum()); };
  if (!finite(grains.x[i])) return refused("the sum of its coordinates", grains.x[i].sum(), "give a finite place");
  if (!finite(grains.v[i])) return refused("the sum of its velocities", grains.v[i].sum(), "give finite ones");
  if (!finite(grains.w[i])) return refused("its angular velocity", grains.w[i].sum(), "give a finite one");
  if (!positive(grains.radius[i])) return refused("radius", grains.radius[i], "give a length above 0");
  if (!positive(grains.inverse_mass[i]) || !positive(1 / grains.inverse_mass[i])) {
    return refused("the inverse of its mass", grains.inverse_mass[i], "give a finite mass above 0");
  }
  if (!positive(grains.inverse_inertia[i]) || !positive(1 / grains.inverse_inertia[i])) {
    return refused("the inverse of its inertia", grains.inverse_inertia[i], "give a finite inertia above 0");
  }
  return {};
}

}  // namespace grain_check

/// The first thing that cannot be moved, if any. Allocates nothing.
template <int dim>
[[nodiscard]] GrainFault fault_of(const Grains<dim>& grains, const GrainOptions& options, double h) noexcept {
  const auto refused = [](const char* object, const char* quantity, double value, const char* remedy) {
    return GrainFault{object, GrainFault::none, quantity, value, remedy};
  };
  if (!grain_check::positive(h)) return refused("step", "h", h, "give a finite time above 0");
  if (!(options.tolerance > 0)) return refused("options", "tolerance", options.tolerance, "give a number above 0");
  if (options.sweeps < 1) return refused("options", "sweeps", options.sweeps, "allow one at least");
  if (options.projections < 0) return refused("options", "projections", options.projections, "give 0 or more");
  if (!(options.rest >= 0)) return refused("options", "rest", options.rest, "give 0 or more");
  const double gravity = grains.gravity.sum();
  if (!std::isfinite(gravity)) return refused("grains", "gravity", gravity, "give finite components");
  if (!(grains.friction >= 0) || !std::isfinite(grains.friction)) {
    return refused("grains", "friction", grains.friction, "give a finite number of at least 0");
  }
  if (!(grains.restitution >= 0 && grains.restitution <= 1)) {
    return refused("grains", "restitution", grains.restitution, "give a number from 0 to 1");
  }
  const std::size_t count = grains.count();
  for (const std::size_t size : {grains.v.size(), grains.turned.size(), grains.w.size(), grains.radius.size(),
                                 grains.inverse_mass.size(), grains.inverse_inertia.size()}) {
    if (size != count) {
      return refused("grains", "the length of one of the lists", static_cast<double>(size),
                     "make all as long as that of places: `add` does");
    }
  }
  if (count >= std::numeric_limits<std::uint32_t>::max() - grains.walls.size()) {
    return refused("grains", "their number", static_cast<double>(count), "take fewer than 2^32 with the walls");
  }
  double widest = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (const GrainFault fault = grain_check::of_grain(grains, i)) return fault;
    widest = grains.radius[i] > widest ? grains.radius[i] : widest;
  }
  for (std::size_t k = 0; k < grains.walls.size(); ++k) {
    if (const GrainFault fault = grain_check::of_wall(grains.walls[k], k, widest)) return fault;
  }
  return {};
}

}  // namespace torsor::runtime
