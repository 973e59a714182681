// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "torsor/runtime/contacts/integrate_contacts.hpp"

/// What random motions have in common, in the plane and in space.
namespace random_watch {

using namespace torsor::runtime;

constexpr DormandPrince853 precise{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12};

template <std::size_t size>
double distance(const std::array<double, size>& a, const std::array<double, size>& b) {
  double most = 0;
  for (std::size_t i = 0; i < size; ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

/// What happens along a motion: energy that comes from nowhere, and the deepest gap.
template <class Scene>
struct Along {
  const Scene& scene;
  double energy = INFINITY, gained = 0, deepest = 0, size = 0;
  bool operator()(double, const typename Scene::State& y) {
    const auto [kinetic, potential] = scene.energies(y);
    size = std::max({size, std::abs(kinetic), std::abs(potential)});
    gained = std::max(gained, kinetic + potential - energy);
    energy = kinetic + potential;
    for (const double gap : scene.gaps(y)) deepest = std::max(deepest, -gap);
    return true;
  }
};

/// Moves a scene, which must neither gain energy nor sink, and ends early only where a law of impact gives energy.
template <class Scene>
ContactResult move_watched(const Scene& scene, typename Scene::State& y, double end) {
  Along<Scene> along{scene};
  const ContactResult result = integrate_contacts(scene, y, 0, end, precise, {}, along);
  EXPECT_TRUE(result || result.status == ContactStatus::energy_gained)
      << describe(result.status) << ": " << describe(result.integration_event) << " at " << result.time;
  EXPECT_LE(result.worst_residual, 1e-13);
  EXPECT_LE(along.gained, 1e-10);  // some hundred steps within 1e-12 of energies of some 10 J
  EXPECT_LE(along.deepest, 1e-14);
  return result;
}

/// Every second body times as heavy.
template <class Scene>
void make_uneven(Scene& scene, double ratio) {
  for (std::size_t i = 1; i < scene.bodies.size(); i += 2) {
    scene.bodies[i].mass *= ratio;
    scene.bodies[i].inertia *= ratio;
  }
}

/// Moves a scene whose masses are far apart. It must neither gain energy nor sink, and where light bodies jam between heavy
/// ones it says so.
template <class Scene>
ContactResult move_uneven(const Scene& scene, typename Scene::State& y, double end) {
  Along<Scene> along{scene};
  const ContactResult result = integrate_contacts(scene, y, 0, end, precise, {}, along);
  EXPECT_TRUE(result || result.status == ContactStatus::energy_gained || result.status == ContactStatus::jams ||
              result.status == ContactStatus::no_solution || result.status == ContactStatus::no_impact)
      << describe(result.status) << ": " << describe(result.integration_event) << " at " << result.time;
  EXPECT_LE(result.worst_residual, 1e-13);
  EXPECT_LE(along.gained, 1e-11 * along.size);  // the errors of a step, 1e-12 of velocities, counted ten times
  EXPECT_LE(along.deepest, 1e-14);
  return result;
}

}  // namespace random_watch
