// SPDX-License-Identifier: MIT
#include <cmath>
#include <iostream>
#include <numbers>
#include <string>

#include "generated/plumb_line.hpp"
#include "torsor/runtime/integration/demonstration.hpp"
#include "torsor/runtime/integration/work_precision.hpp"
#include "torsor/runtime/mechanism.hpp"

namespace {

using namespace torsor::runtime;
using Plumb = plumb_line::Mechanism<double>;

/// Apparent gravity where a plumb line of 1 kg rests: its parts along the radius and northwards.
struct Gravity {
  double normal = 0.0, tangential = 0.0;
};

Gravity measure(double altitude, double latitude) {
  const auto place = Plumb::precompute({.r = 6371000.0 + altitude, .latitude = latitude});
  Plumb::State state{};
  for (int i = 0; i < 20; ++i) {  // Newton's method on the generated equations
    Plumb::Linearisation linear{};
    if (Plumb::linearisation(place, state, {}, {}, {}, linear) != torsor::Status::ok) return {};
    state.q.delta += linear.F[0] / linear.K[0];
  }
  Plumb::Reactions reactions{};
  Plumb::reactions(place, state, {}, {}, {}, reactions);
  return {-reactions.tension * std::cos(state.q.delta), reactions.tension * std::sin(state.q.delta)};
}

void show(const Reference<double>& reference) {
  std::cout << "Plumb line let go at 0.1 rad, latitude 45 degrees\n\n"
            << work_precision(equations_of_motion<Plumb>(), reference, Midpoint{.step = 1e-3},
                              RungeKutta4{.step = 1e-3},
                              DormandPrince54{.relative_tolerance = 1e-6, .absolute_tolerance = 1e-6},
                              DormandPrince54{.relative_tolerance = 1e-9, .absolute_tolerance = 1e-9},
                              DormandPrince54{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12});
  Table table({"altitude [km]", "latitude [deg]", "g normal [m/s^2]", "g tangential [m/s^2]", "ratio [%]"});
  for (const double kilometres : {0.0, 1000.0, 5000.0, 5100.0}) {
    for (const double degrees : {0.0, 30.0, 45.0, 60.0, 90.0}) {
      if (kilometres > 0.0 && degrees != 45.0) continue;
      const Gravity g = measure(1000.0 * kilometres, degrees * std::numbers::pi / 180.0);
      table.add({scientific(kilometres), scientific(degrees), scientific(g.normal, 7), scientific(g.tangential, 7),
                 scientific(100.0 * g.tangential / g.normal, 4)});
    }
  }
  std::cout << "\nApparent gravity, along n (upwards) and t (northwards)\n\n" << table;
}

}  // namespace

int main(int argc, char** argv) {
  return demonstrate(argc, argv, {.name = "plumb_line", .about = "apparent gravity on the turning earth"}, show);
}
