// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <iostream>
#include <string>

#include "generated/helicopter_on_a_circle.hpp"
#include "generated/helicopter_on_a_circle_pitching_blades.hpp"
#include "torsor/runtime/integration/demonstration.hpp"
#include "torsor/runtime/integration/work_precision.hpp"
#include "torsor/runtime/mechanism.hpp"

namespace {

using namespace torsor::runtime;
using Rigid = helicopter_on_a_circle::Mechanism<double>;
using Pitching = helicopter_on_a_circle_pitching_blades::Mechanism<double>;
constexpr double m = 30.0, s = 0.5, l = 5.0, w = 0.4, R = 100.0;

/// The dynamic screw in A at a state of the motion, along x1, y1, z0 and along x, y, z of the tilted cell.
template <class Rotor>
void add_dynamic(Table& table, const std::string& name, const typename Rotor::State& state) {
  const auto motion = equations_of_motion<Rotor>();
  typename Rotor::Accelerations a{};
  typename Rotor::Multipliers none{};
  (void)motion.accelerations(state, a, none);
  typename Rotor::Reactions cell{};
  Rotor::reactions(motion.precomputed(), state, a, none, {}, cell);
  table.add({name, scientific(state.time), scientific(cell.X, 3), scientific(cell.Y, 0), scientific(cell.Z, 0),
             scientific(cell.M_x), scientific(cell.M_y, 6), scientific(cell.M_z)});
}

void show(const Reference<double>& reference) {
  const auto motion = equations_of_motion<Rigid>();
  std::cout << "The rotor of a helicopter on a circle\n\n"
            << work_precision(motion, reference, Midpoint{.step = 1e-3}, RungeKutta4{.step = 1e-2},
                              DormandPrince54{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12});
  const auto state = Rigid::initial_state();
  const auto p = Rigid::default_parameters();
  Rigid::Kinematics at{};
  Rigid::kinematics(motion.precomputed(), state, at);
  Rigid::Energy energy{};
  Rigid::energy(motion.precomputed(), state, {}, energy);
  // Omega = omega z0 + phi' z, z0 = sin(theta) x + cos(theta) z; J_A = diag(A, A, C) of four_blade_rotor.
  const double spans = s * s + s * l + l * l / 3.0, sine = std::sin(p.alpha);
  const double A = m * (2.0 * spans + w * w * (1.0 + sine * sine) / 6.0);
  const double C = m * (4.0 * spans + w * w * (1.0 - sine * sine) / 3.0);
  const double across = p.omega * std::sin(p.theta), along = p.omega * std::cos(p.theta) + state.v.phi;
  Table momentum({"4 m V_A along y1 [kg m/s]", "sigma_A along x [kg m^2/s]", "along z", "T [J]", "T by hand",
                  "delta_A along y by hand [N m]"});
  momentum.add({scientific(4.0 * m * at.A_velocity[1], 3), scientific(A * across, 6), scientific(C * along, 6),
                scientific(energy.kinetic, 8),
                scientific(2.0 * m * std::pow(R * p.omega, 2) + (A * across * across + C * along * along) / 2.0, 8),
                scientific(-across * (C * along - A * p.omega * std::cos(p.theta)), 6)});
  std::cout << "\nMomentum screw in A and kinetic energy, the blades' pitch constant\n\n" << momentum;

  Table dynamic({"blades", "t [s]", "force along x1 [N]", "y1", "z0", "moment in A along x [N m]", "y", "z"});
  add_dynamic<Rigid>(dynamic, "constant pitch", state);
  const auto swinging = equations_of_motion<Pitching>();
  auto y = swinging.initial();
  for (int i = 0; i <= 4; ++i) {
    const double t = 0.05 * i;
    if (i > 0) {
      const auto result = integrate(swinging, y, t - 0.05, t, DormandPrince54{.relative_tolerance = 1e-10});
      if (!result) throw FileError(describe(result));
    }
    add_dynamic<Pitching>(dynamic, "pitch swings", unpack<Pitching>(t, y));
  }
  std::cout << "\nDynamic screw in A\n\n" << dynamic;
}

}  // namespace

int main(int argc, char** argv) {
  return demonstrate(
      argc, argv,
      {.name = "helicopter_on_a_circle", .about = "momentum and dynamic screws of a rotor on a curved path"}, show);
}
