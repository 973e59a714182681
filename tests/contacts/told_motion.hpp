// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <vector>

#include "tests/contacts/simple_systems.hpp"

// A motion with the events that its observer is told of.
namespace told_motion {

using namespace simple_systems;

struct Told {
  ContactEventKind kind;
  double time;
  std::vector<double> state;
  ContactRegime regime;
};

// What happened, and the least gap of the first coordinate.
struct Log {
  std::vector<Told>& events;
  bool operator()(const ContactEvent& e) const {
    EXPECT_LE(e.residual, 1e-13);
    EXPECT_GE(e.energy_lost, -1e-13);
    events.push_back({e.kind, e.time, {e.state.begin(), e.state.end()}, e.contacts[0].regime});
    return true;
  }
};

struct Motion {
  ContactResult result;
  std::vector<Told> events;
  [[nodiscard]] std::vector<Told> all(ContactEventKind kind) const {
    std::vector<Told> chosen;
    for (const Told& told : events) {
      if (told.kind == kind) chosen.push_back(told);
    }
    return chosen;
  }
};

constexpr DormandPrince853 precise{.relative_tolerance = 1e-13, .absolute_tolerance = 1e-13};

template <class S, std::size_t size>
Motion move(const S& system, std::array<double, size>& y, double end, bool reaches = true) {
  Motion motion;
  motion.result = integrate_contacts(system, y, 0, end, precise, {}, Log{motion.events});
  EXPECT_TRUE(motion.result || !reaches) << describe(motion.result.status);
  EXPECT_LE(motion.result.worst_residual, 1e-13);
  return motion;
}

}  // namespace told_motion
