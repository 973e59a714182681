// SPDX-License-Identifier: MIT
#include <cmath>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "generated/woodpecker_toy.hpp"
#include "torsor/runtime/contacts/integrate_contacts.hpp"
#include "torsor/runtime/contacts/mechanism_with_contacts.hpp"
#include "torsor/runtime/integration/presentation.hpp"
#include "torsor/runtime/records/plot.hpp"
#include "torsor/runtime/records/table.hpp"

namespace {

using namespace torsor::runtime;
using Toy = MechanismWithContacts<woodpecker_toy::Mechanism<double>>;
constexpr DormandPrince853 precise{.relative_tolerance = 1e-10, .absolute_tolerance = 1e-10};

/// Friction that holds the sleeve with the bird at rest on its lower edge, both level: N h + T r = m_bird g (l_spring + l_bird)
/// and T = (m_sleeve + m_bird) g <= f N.
double least_friction() {
  constexpr double m_sleeve = 0.0003, m_bird = 0.0045, h = 0.0058, r = 0.0031, l_spring = 0.01, l_bird = 0.015;
  return (m_sleeve + m_bird) * h / (m_bird * (l_spring + l_bird) - (m_sleeve + m_bird) * r);
}

/// When the beak strikes the pole, and at which height of the sleeve.
struct Descent {
  std::vector<double> times, heights;
  double lost = 0;  ///< by all impacts [J]
  ContactResult result;
};
Descent descend(double f, double end) {
  const Toy toy({.f = f, .e = 0.5});
  Toy::State y = toy.initial();
  Descent descent;
  descent.result = integrate_contacts(toy, y, 0, end, precise, {}, [&](const ContactEvent& event) {
    if (event.kind != ContactEventKind::impact) return true;
    descent.lost += event.energy_lost;
    if (event.contact == 0) {
      descent.times.push_back(event.time);
      descent.heights.push_back(event.state[0]);
    }
    return true;
  });
  return descent;
}

void show(const PlotFolder& plots) {
  std::cout << "A woodpecker on a pole: how it comes down within 10 s\n"
            << "The sleeve holds at rest from a friction of " << scientific(least_friction(), 4) << " on.\n\n";
  Table table({"friction f", "pecks", "period [s]", "fall in it [mm]", "mean speed [mm/s]", "lost by impacts [mJ]", "worst residual"});
  for (const double f : {0.25, 0.3, 0.35, 0.4, 0.45}) {
    const Descent done = descend(f, 10);
    if (!done.result) throw FileError("the motion ended: " + std::string(describe(done.result.status)));
    std::vector<std::string> cycle{"none: it slides for good", "", ""};
    if (const std::size_t count = done.times.size(); count > 20) {
      // Of the last ten periods: nothing is left of the start.
      const double period = (done.times[count - 1] - done.times[count - 11]) / 10;
      const double fall = (done.heights[count - 11] - done.heights[count - 1]) / 10;
      cycle = {scientific(period, 6), scientific(1e3 * fall, 5), scientific(1e3 * fall / period, 4)};
    }
    table.add({scientific(f, 2), std::to_string(done.times.size()), cycle[0], cycle[1], cycle[2], scientific(1e3 * done.lost, 4),
               scientific(done.result.worst_residual, 0)});
  }
  std::cout << table;
  if (!plots) return;
  const Toy toy;
  Toy::State y = toy.initial();
  Table motion({"t", "z", "phi", "theta"});
  for (int i = 0; i <= 1000; ++i) {
    motion.add({scientific(0.001 * i, 6), scientific(y[0], 8), scientific(y[1], 8), scientific(y[2], 8)});
    const auto result = integrate_contacts(toy, y, 0.001 * i, 0.001 * (i + 1), precise);
    if (!result) throw FileError("the motion ended: " + std::string(describe(result.status)));
  }
  const std::filesystem::path csv = plots.file("woodpecker_toy.csv"), picture = plots.file("woodpecker_toy.svg");
  motion.write_csv(csv);
  write_plot({.title = "A woodpecker comes down its pole",
              .x_title = "t [s]",
              .y_title = "angles [rad], height [m]",
              .curves = {{csv, "t", "theta", "bird"}, {csv, "t", "phi", "sleeve"}, {csv, "t", "z", "height"}}},
             picture);
  std::cout << "\nplot: " << std::filesystem::absolute(picture).string() << '\n';
}

}  // namespace

int main(int argc, char** argv) {
  return present(argc, argv, {.name = "woodpecker_toy", .about = "a woodpecker slides down its pole in jerks"}, show);
}
