// SPDX-License-Identifier: MIT
#include <cmath>
#include <filesystem>
#include <iostream>
#include <numbers>
#include <string>
#include <vector>

#include "generated/clock_escapement.hpp"
#include "torsor/runtime/contacts/integrate_contacts.hpp"
#include "torsor/runtime/contacts/mechanism_with_contacts.hpp"
#include "torsor/runtime/integration/presentation.hpp"
#include "torsor/runtime/records/plot.hpp"
#include "torsor/runtime/records/table.hpp"

namespace {

using namespace torsor::runtime;
using Clock = MechanismWithContacts<clock_escapement::Mechanism<double>>;
constexpr DormandPrince853 precise{.relative_tolerance = 1e-9, .absolute_tolerance = 1e-9};
constexpr double g = 9.81, l = 0.25, d = 0.0015, r_drum = 0.0015;
constexpr int pins = 10;

/// Work of the weight while the wheel goes on by one pin: one swing to and fro.
double work(double weight) { return weight * g * r_drum * 2 * std::numbers::pi / pins; }
/// If the pallets always touched and nothing rubbed, the air alone would take that work: π d ω A².
double amplitude_without_drops(double weight) {
  return std::sqrt(work(weight) / (std::numbers::pi * d * std::sqrt(g / l)));
}
/// By Fourier's series of the pendulum's period: 1 + A²/16 + 11 A⁴/3072.
double free_period(double A) {
  return 2 * std::numbers::pi * std::sqrt(l / g) * (1 + A * A / 16 + 11 * A * A * A * A / 3072);
}

/// A run of 60 s. Contacts count entry1, exit1, entry2 and so on.
struct Going {
  std::vector<double> turns;     ///< when the pendulum turns back on the entry's side
  std::vector<double> extremes;  ///< and how far out
  std::vector<double> losses;    ///< of each impact [J]
  Clock::State end{};
  ContactResult result;
};
Going run(double weight, double f) {
  const Clock clock({.weight = weight, .f = f});
  Clock::State y = clock.initial();
  Going going;
  going.result = integrate_contacts(clock, y, 0, 60, precise, {}, [&](const ContactEvent& event) {
    if (event.kind == ContactEventKind::impact) going.losses.push_back(event.energy_lost);
    // The slip of a pin that is pushed back ends where the pendulum turns.
    if (event.kind == ContactEventKind::slip_ends && event.state[1] < 0) {
      going.turns.push_back(event.time);
      going.extremes.push_back(-event.state[1]);
    }
    return true;
  });
  going.end = y;
  return going;
}

void show(const PlotFolder& plots) {
  std::cout << "A clock with a recoil escapement, driven by a weight, after 60 s\n\n";
  Table table({"weight [kg]", "friction f", "period [s]", "swings freely in [s]", "amplitude [rad]", "without drops",
               "lost by drops [%]", "by air [%]", "worst residual"});
  struct Case {
    double weight, f;
  };
  for (const auto& [weight, f] : {Case{0.03, 0.1}, Case{0.04, 0.1}, Case{0.1, 0.1}, Case{0.1, 0.2}, Case{0.2, 0.1}}) {
    const Going done = run(weight, f);
    if (!done.result) throw FileError("the clock broke: " + std::string(describe(done.result.status)));
    std::vector<std::string> cycle{"it stops at " + scientific(done.end[1], 3) + " rad", "", "", "", "", ""};
    if (const std::size_t count = done.turns.size(); count > 50) {
      const double period = (done.turns[count - 1] - done.turns[count - 11]) / 10, A = done.extremes.back();
      double lost = 0;
      for (std::size_t i = done.losses.size() - 20; i < done.losses.size(); ++i) lost += done.losses[i] / 10;
      const double without = amplitude_without_drops(weight), by_air = std::pow(A / without, 2);
      cycle = {scientific(period, 6),
               scientific(free_period(A), 6),
               scientific(A, 4),
               scientific(without, 4),
               scientific(100 * lost / work(weight), 2),
               scientific(100 * by_air, 2)};
    }
    table.add({scientific(weight, 1), scientific(f, 1), cycle[0], cycle[1], cycle[2], cycle[3], cycle[4], cycle[5],
               scientific(done.result.worst_residual, 0)});
  }
  std::cout << table;
  if (!plots) return;
  const Clock clock;
  Clock::State y = clock.initial();
  Table motion({"t", "theta", "psi"});
  for (int i = 0; i <= 1500; ++i) {
    motion.add({scientific(0.002 * i, 6), scientific(y[1], 8), scientific(y[0], 8)});
    const auto result = integrate_contacts(clock, y, 0.002 * i, 0.002 * (i + 1), precise);
    if (!result) throw FileError("the clock broke: " + std::string(describe(result.status)));
  }
  const std::filesystem::path csv = plots.file("clock_escapement.csv"), picture = plots.file("clock_escapement.svg");
  motion.write_csv(csv);
  write_plot({.title = "A wheel that a pendulum lets go on by half a pin at a time",
              .x_title = "t [s]",
              .y_title = "angles [rad]",
              .curves = {{csv, "t", "theta", "pendulum"}, {csv, "t", "psi", "wheel"}}},
             picture);
  std::cout << "\nplot: " << std::filesystem::absolute(picture).string() << '\n';
}

}  // namespace

int main(int argc, char** argv) {
  return present(argc, argv, {.name = "clock_escapement", .about = "an escapement keeps a pendulum swinging"}, show);
}
