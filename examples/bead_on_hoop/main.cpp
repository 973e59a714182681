// SPDX-License-Identifier: MIT
#include <cmath>
#include <filesystem>
#include <iostream>
#include <numbers>
#include <string>
#include <vector>

#include "generated/bead_on_hoop.hpp"
#include "torsor/runtime/integration/demonstration.hpp"
#include "torsor/runtime/integration/work_precision.hpp"
#include "torsor/runtime/mechanism.hpp"
#include "torsor/runtime/records/plot.hpp"

namespace {

using namespace torsor::runtime;
using Bead = bead_on_hoop::Mechanism<double>;

/// What would have to hold the bead still at an angle.
double holding(const Bead::Precomputed& hoop, double theta) {
  Bead::State state{};
  state.q.theta = theta;
  Bead::GeneralizedForces forces{};
  Bead::bias(hoop, state, forces);
  return forces.theta;
}

/// The angles in (0, pi) at which the bead stays on the turning hoop: changes of sign, halved down.
std::vector<double> rests_aside(const Bead::Precomputed& hoop) {
  std::vector<double> found;
  constexpr int pieces = 64;
  constexpr double least = 1e-6, most = std::numbers::pi - 1e-6;
  for (int i = 0; i < pieces; ++i) {
    double from = least + (most - least) * i / pieces, to = least + (most - least) * (i + 1) / pieces;
    const bool sign = holding(hoop, from) > 0.0;
    if (sign == (holding(hoop, to) > 0.0)) continue;
    for (int halving = 0; halving < 60; ++halving) {
      const double middle = 0.5 * (from + to);
      ((holding(hoop, middle) > 0.0) == sign ? from : to) = middle;
    }
    found.push_back(from);
  }
  return found;
}

/// "2.41 rad/s" of small oscillations, or that there are none.
std::string frequency(const Bead::Precomputed& hoop, double theta) {
  Bead::State state{};
  state.q.theta = theta;
  Bead::Linearisation linear{};
  if (Bead::linearisation(hoop, state, {}, {}, {}, linear) != torsor::Status::ok) return "singular";
  const double square = linear.K[0] / linear.M[0];
  return square > 0.0 ? scientific(std::sqrt(square), 10) : "unstable";
}

void show(const Reference<double>& reference, const PlotFolder& plots) {
  std::cout << "Bead on a hoop that turns at 5 rad/s\n\n"
            << work_precision(equations_of_motion<Bead>(), reference, Midpoint{.step = 1e-3}, RungeKutta4{.step = 1e-3},
                              DormandPrince54{.relative_tolerance = 1e-6, .absolute_tolerance = 1e-6},
                              DormandPrince54{.relative_tolerance = 1e-9, .absolute_tolerance = 1e-9},
                              DormandPrince54{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12});
  Table table({"omega [rad/s]", "bottom [rad/s]", "rest aside [rad]", "there [rad/s]"});
  for (const double omega : {1.0, 2.0, 3.0, 3.13, 3.14, 4.0, 5.0, 8.0}) {
    const auto hoop = Bead::precompute({.omega = omega});
    const auto aside = rests_aside(hoop);
    table.add({scientific(omega), frequency(hoop, 0.0), aside.empty() ? "none" : scientific(aside[0], 10),
               aside.empty() ? "" : frequency(hoop, aside[0])});
  }
  std::cout << "\nWhere the bead rests on the hoop, and the frequency of small oscillations\n\n" << table;

  if (!plots) return;
  Table branches({"speed", "stable", "other side"});
  Table unstable({"speed", "bottom"});
  for (int i = 0; i <= 400; ++i) {
    const double omega = 1.0 + 0.02 * i;
    const auto hoop = Bead::precompute({.omega = omega});
    const auto aside = rests_aside(hoop);
    const double theta = aside.empty() ? 0.0 : aside[0];
    branches.add({scientific(omega, 6), scientific(theta, 6), scientific(-theta, 6)});
    if (!aside.empty()) unstable.add({scientific(omega, 6), "0"});
  }
  const std::filesystem::path stable_csv = plots.file("bead_on_hoop_stable.csv");
  const std::filesystem::path unstable_csv = plots.file("bead_on_hoop_unstable.csv");
  const std::filesystem::path picture = plots.file("bead_on_hoop.svg");
  branches.write_csv(stable_csv);
  unstable.write_csv(unstable_csv);
  write_plot({.title = "Relative equilibria of a bead on a turning hoop",
              .x_title = "rate of the hoop [rad/s]",
              .y_title = "angle from the lowest point [rad]",
              .curves = {{stable_csv, "speed", "stable", "stable"},
                         {stable_csv, "speed", "other side", "stable, other side"},
                         {unstable_csv, "speed", "bottom", "unstable", "points"}}},
             picture);
  std::cout << "\nplot: " << std::filesystem::absolute(picture).string() << '\n';
}

}  // namespace

int main(int argc, char** argv) {
  return demonstrate_with_plots(argc, argv,
                                {.name = "bead_on_hoop", .about = "relative equilibria and their bifurcation"}, show);
}
