// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <iostream>
#include <numbers>
#include <string>

#include "generated/mutual_gravitation.hpp"
#include "torsor/runtime/integration/demonstration.hpp"
#include "torsor/runtime/integration/work_precision.hpp"
#include "torsor/runtime/mechanism.hpp"

namespace {

using namespace torsor::runtime;
using Pair = mutual_gravitation::Mechanism<double>;

constexpr double Gm = 4.0, closest = 0.4;  // of the scene
constexpr DormandPrince54 precise{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12};

/// Laplace's vector (v ∧ L)/Gm − r/|r| of the relative motion: along the line of the closest approach, as long as the
/// eccentricity.
std::array<double, 2> laplace(const Pair::State& state) {
  const double c = std::cos(state.q.phi), s = std::sin(state.q.phi);
  const double across = state.q.r * state.v.phi;
  const double momentum = state.q.r * across;
  const double vx = state.v.r * c - across * s, vy = state.v.r * s + across * c;
  return {vy * momentum / Gm - c, -vx * momentum / Gm - s};
}

/// A conic r = p/(1 + e cos(phi)) for every speed at the closest approach.
void add_conic(Table& table, const std::string& name, double turning, double end) {
  const auto motion = equations_of_motion<Pair>();
  auto start = Pair::initial_state();
  start.v.phi = turning;
  const double e = std::pow(closest, 3) * turning * turning / Gm - 1.0, p = closest * (1.0 + e);
  auto y = pack<Pair>(start);
  double worst = 0.0;
  const auto result = integrate(motion, y, 0.0, end, precise, [&](double, const StateVector<Pair>& now) {
    worst = std::fmax(worst, std::abs(p / now[2] - 1.0 - e * std::cos(now[3])));
  });
  if (!result) throw FileError(describe(result));
  const auto vector = laplace(unpack<Pair>(end, y));
  table.add({name, scientific(turning * closest, 5), scientific(e, 5), scientific(vector[0], 12),
             scientific(vector[1], 2), scientific(worst, 2)});
}

void show(const Reference<double>& reference) {
  std::cout << "Two masses under their mutual gravitation\n\n"
            << work_precision(equations_of_motion<Pair>(), reference, Midpoint{.step = 1e-3}, RungeKutta4{.step = 1e-2},
                              RungeKutta4{.step = 1e-3},
                              DormandPrince54{.relative_tolerance = 1e-6, .absolute_tolerance = 1e-6},
                              DormandPrince54{.relative_tolerance = 1e-9, .absolute_tolerance = 1e-9},
                              DormandPrince54{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12});

  const auto motion = equations_of_motion<Pair>();
  auto y = motion.initial();
  Table invariants({"period", "energy [J]", "momentum x [kg m/s]", "momentum y", "angular momentum [kg m^2/s]"});
  for (int period = 0; period <= 10; period += 2) {
    const double end = period * std::numbers::pi;  // 2 pi sqrt(a³/Gm), a = 1
    const auto result = integrate(motion, y, end - (period > 0 ? 2.0 * std::numbers::pi : 0.0), end, precise);
    if (!result) throw FileError(describe(result));
    Pair::FirstIntegrals kept{};
    Pair::first_integrals(motion.precomputed(), unpack<Pair>(end, y), kept);
    invariants.add({std::to_string(period), scientific(kept.energy, 12), scientific(kept.momentum_X, 12),
                    scientific(kept.momentum_Y, 12), scientific(kept.momentum_phi, 12)});
  }
  std::cout << "\nWhat the generator found to be conserved, along ten revolutions\n\n" << invariants;

  Table conics({"orbit", "closest speed [m/s]", "eccentricity", "Laplace's vector x", "y", "off the conic"});
  add_conic(conics, "ellipse", 10.0, 10.0 * std::numbers::pi);
  add_conic(conics, "parabola", std::sqrt(2.0 * Gm / closest) / closest, 20.0);
  add_conic(conics, "hyperbola", 14.0, 20.0);
  std::cout << "\nConics r = p/(1 + e cos(phi))\n\n" << conics;
}

}  // namespace

int main(int argc, char** argv) {
  return demonstrate(argc, argv,
                     {.name = "mutual_gravitation", .about = "two masses on conics about their centre of mass"}, show);
}
