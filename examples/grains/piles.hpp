// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "examples/grains/machines.hpp"
#include "torsor/runtime/records/record_file.hpp"

namespace grains_example {

/// An ensemble of piles: discs of other sizes in each fall into a bin and come to lie there. The friction of pile i is
/// `pile_friction(i)`. A record has these numbers in their order.
struct PileRecord {
  double height = 0;    ///< of the highest disc [m]
  double centre = 0;    ///< height of the centre of mass [m]
  double moves = 0;     ///< kinetic energy that is left [J]
  double unsolved = 0;  ///< steps whose contacts fulfil the laws less exactly than asked for
};
inline constexpr std::array<double, 3> pile_frictions{0.1, 0.3, 0.8};
inline double pile_friction(std::uint64_t index) { return pile_frictions[index % pile_frictions.size()]; }

/// The question is a digest of all that records depend on: whoever changes the piles takes another number.
inline torsor::runtime::RecordHead pile_head(std::uint64_t count) {
  return {.question = 20, .count = count, .numbers = 4};
}

/// Writes the record of pile `index`. It depends on the index alone, and so on no thread, process or order.
inline void compute_pile(std::uint64_t index, std::span<double> record) {
  constexpr int columns = 5, rows = 8, steps = 800;
  constexpr double cell = 2.2 * most_radius;
  Grains<2> grains;
  grains.friction = pile_friction(index);
  GrainWall<2> floor{.friction = grains.friction}, left = floor, right = floor;
  left.normal = {1, 0};
  right.normal = {-1, 0};
  right.point = {columns * cell, 0};
  grains.walls = {floor, left, right};
  Radii radii(index + 1);
  for (int i = 0; i < columns * rows; ++i) {
    // Each row stands a little aside of that below.
    const double aside = cell * (0.45 + i % columns) + 0.1 * most_radius * (i / columns % 2);
    add_disc(grains, {aside, cell * (1 + i / columns)}, radii.next());
  }
  GrainMotion<2> motion(grains, options);
  PileRecord pile;
  for (int k = 0; k < steps; ++k) {
    if (motion.step(step).status != torsor::runtime::GrainStatus::ok) pile.unsolved += 1;
  }
  double mass = 0;
  for (std::size_t i = 0; i < grains.count(); ++i) {
    pile.height = std::max(pile.height, grains.x[i](1) + grains.radius[i]);
    pile.centre += grains.x[i](1) / grains.inverse_mass[i];
    mass += 1 / grains.inverse_mass[i];
  }
  pile.centre /= mass;
  pile.moves = grains.kinetic_energy();
  std::ranges::copy(std::array{pile.height, pile.centre, pile.moves, pile.unsolved}, record.begin());
}

}  // namespace grains_example
