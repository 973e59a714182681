// SPDX-License-Identifier: MIT
#include <cmath>
#include <filesystem>
#include <iostream>
#include <numbers>
#include <string>
#include <vector>

#include "generated/stick_slip_belt.hpp"
#include "torsor/runtime/contacts/integrate_contacts.hpp"
#include "torsor/runtime/contacts/mechanism_with_contacts.hpp"
#include "torsor/runtime/integration/presentation.hpp"
#include "torsor/runtime/records/plot.hpp"
#include "torsor/runtime/records/table.hpp"

namespace {

using namespace torsor::runtime;
using Block = MechanismWithContacts<stick_slip_belt::Mechanism<double>>;
constexpr DormandPrince853 precise{.relative_tolerance = 1e-13, .absolute_tolerance = 1e-13};
constexpr double m = 2, k = 50, N = 2 * 9.81;

/// Where the block slips, where it sticks again, and how long it does each, in its fourth round.
struct Round {
  double slips_at = 0, sticks_at = 0, sticking = 0, slipping = 0;
};
Round round_of(const Block& block, double v0) {
  Block::State y = block.initial();
  y[2] = v0;  // with the belt: from rest a block on a fast belt slips for ever
  Round round;
  double slipped = 0, stuck = 0;
  int rounds = 0;
  const auto result = integrate_contacts(block, y, 0, 100, precise, {}, [&](const ContactEvent& event) {
    if (event.kind == ContactEventKind::slips) {
      round.slips_at = event.state[0];
      round.sticking = event.time - stuck;
      slipped = event.time;
    } else if (event.kind == ContactEventKind::slip_ends) {
      round.sticks_at = event.state[0];
      round.slipping = event.time - slipped;
      stuck = event.time;
      return ++rounds < 4;
    }
    return true;
  });
  if (result.status != ContactStatus::stopped_by_observer)
    throw FileError("the block has no fourth round: " + std::string(describe(result.status)));
  return round;
}

void show(const PlotFolder& plots) {
  std::cout << "A block on a spring that a belt carries along\n\n";
  Table table({"v0 [m/s]", "f", "f_s", "slips at [m]", "formula", "sticks at [m]", "formula", "sticks for [s]",
               "formula", "slips for [s]", "formula"});
  for (const double v0 : {0.05, 0.2, 0.8}) {
    for (const double f : {0.2, 0.35}) {
      const double fs = 0.5, d = (fs - f) * N / k, w = std::sqrt(k / m);
      const Round round = round_of(Block({.v0 = v0, .f = f, .f_static = fs}), v0);
      table.add({scientific(v0, 1), scientific(f), scientific(fs, 1), scientific(round.slips_at, 8),
                 scientific(fs * N / k, 8), scientific(round.sticks_at, 8), scientific(f * N / k - d, 8),
                 scientific(round.sticking, 8), scientific(2 * d / v0, 8), scientific(round.slipping, 8),
                 scientific((2 * std::numbers::pi - 2 * std::atan(d * w / v0)) / w, 8)});
    }
  }
  std::cout << table;
  if (!plots) return;
  const Block block;
  Block::State y = block.initial();
  Table motion({"t", "x", "velocity"});
  for (int i = 0; i <= 500; ++i) {
    motion.add({scientific(0.01 * i, 6), scientific(y[0], 8), scientific(y[2], 8)});
    if (const auto result = integrate_contacts(block, y, 0.01 * i, 0.01 * (i + 1), precise); !result) {
      throw FileError("the block stopped: " + std::string(describe(result.status)));
    }
  }
  const std::filesystem::path csv = plots.file("stick_slip_belt.csv"), picture = plots.file("stick_slip_belt.svg");
  motion.write_csv(csv);
  write_plot({.title = "A block that sticks to a belt and slips",
              .x_title = "x [m]",
              .y_title = "velocity [m/s]",
              .curves = {{csv, "x", "velocity", "from rest, the spring without load"}}},
             picture);
  std::cout << "\nplot: " << std::filesystem::absolute(picture).string() << '\n';
}

}  // namespace

int main(int argc, char** argv) {
  return present(argc, argv,
                 {.name = "stick_slip_belt", .about = "where a block on a belt sticks and slips, and for how long"},
                 show);
}
