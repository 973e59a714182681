// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <iostream>

#include "generated/shaker.hpp"
#include "generated/shaker_damped.hpp"
#include "generated/shaker_from_mass.hpp"
#include "torsor/runtime/integration/demonstration.hpp"
#include "torsor/runtime/integration/work_precision.hpp"
#include "torsor/runtime/mechanism.hpp"

namespace {

using namespace torsor::runtime;
using Shaker = shaker::Mechanism<double>;
using FromMass = shaker_from_mass::Mechanism<double>;
using Damped = shaker_damped::Mechanism<double>;

constexpr double M = 1.0, k = 400.0, c = 4.0, h = 0.01;  // of the scenes
constexpr DormandPrince54 precise{.relative_tolerance = 1e-11, .absolute_tolerance = 1e-11};

/// T, U, and the work done from outside, by `power(state)`, at a time.
template <class M, class Power>
std::array<double, 3> energies_at(double end, Power power) {
  constexpr std::size_t n = coordinates_of<M> + velocities_of<M>;
  const auto motion = equations_of_motion<M>();
  std::array<double, n + 1> y{};
  const auto start = motion.initial();
  std::copy(start.begin(), start.end(), y.begin());
  const auto state_of = [](const std::array<double, n + 1>& extended) {
    StateVector<M> state;
    std::copy_n(extended.begin(), n, state.begin());
    return state;
  };
  const auto system = [&](double t, const std::array<double, n + 1>& extended, std::array<double, n + 1>& rates) {
    const StateVector<M> state = state_of(extended);
    StateVector<M> head;
    const Evaluation evaluation = motion(t, state, head);
    std::copy(head.begin(), head.end(), rates.begin());
    rates[n] = power(motion, unpack<M>(t, state));
    return evaluation;
  };
  const auto result = integrate(system, y, 0.0, end, precise);
  if (!result) throw FileError(describe(result));
  typename M::Energy energy{};
  M::energy(motion.precomputed(), unpack<M>(end, state_of(y)), {}, energy);
  return {energy.kinetic, energy.force_function, y[n]};
}

/// The shaker's force, by the reaction along its motion, times its velocity.
double shaker_power(const EquationsOfMotion<Shaker>& motion, const Shaker::State& state) {
  Shaker::Accelerations a{};
  Shaker::Multipliers none{};
  (void)motion.accelerations(state, a, none);
  Shaker::Reactions reactions{};
  Shaker::reactions(motion.precomputed(), state, a, none, {}, reactions);
  const double omega = motion.precomputed().parameters.omega;
  return reactions.drive * h * omega * std::cos(omega * state.time);
}

/// The power of spring and weight on the mass.
double power_on_mass(const EquationsOfMotion<FromMass>& motion, const FromMass::State& state) {
  FromMass::GeneralizedForces bias{};
  FromMass::bias(motion.precomputed(), state, bias);
  return -bias.y * state.v.y;
}

/// Half the range of the mass's motion, once the start is forgotten.
double amplitude(double omega) {
  const auto motion = equations_of_motion<Damped>({.c = c, .omega = omega});
  auto y = motion.initial();
  double lowest = 1e9, highest = -1e9;
  const auto result = integrate(motion, y, 0.0, 12.0, RungeKutta4{.step = 1e-3}, [&](double t, const auto& state) {
    if (t < 10.0) return;  // exp(-c t/2M) = 2e-9
    lowest = std::fmin(lowest, state[0]);
    highest = std::fmax(highest, state[0]);
  });
  if (!result) throw FileError(describe(result));
  return (highest - lowest) / 2.0;
}

void show(const Reference<double>& reference) {
  std::cout << "Mass on a spring from a shaken support\n\n"
            << work_precision(equations_of_motion<Shaker>(), reference, Midpoint{.step = 1e-3},
                              RungeKutta4{.step = 1e-2}, RungeKutta4{.step = 1e-3},
                              DormandPrince54{.relative_tolerance = 1e-9, .absolute_tolerance = 1e-9},
                              DormandPrince54{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12});

  const auto none = [](const auto&, const auto&) { return 0.0; };
  const auto before = energies_at<Shaker>(0.0, none);
  const auto before_mass = energies_at<FromMass>(0.0, none);
  Table both({"t [s]", "T + Ep gained [J]", "work of the shaker [J]"});
  Table alone({"t [s]", "T gained [J]", "work on the mass [J]", "U gained [J]"});
  for (const double t : {0.5, 1.0, 2.0, 5.0}) {
    const auto now = energies_at<Shaker>(t, shaker_power);
    both.add({scientific(t, 2), scientific(now[0] - now[1] - before[0] + before[1], 10), scientific(now[2], 10)});
    const auto mass = energies_at<FromMass>(t, power_on_mass);
    alone.add({scientific(t, 2), scientific(mass[0] - before_mass[0], 10), scientific(mass[2], 10),
               scientific(mass[1] - before_mass[1], 10)});
  }
  std::cout << "\nBoth ends of the spring: a potential energy Ep = -U, and the shaker supplies the difference\n\n"
            << both;
  std::cout << "\nThe mass alone: U gives the force on it, but its work is not the gain of U\n\n" << alone;

  Table response({"omega [rad/s]", "amplitude [m]", "closed form [m]"});
  for (const double omega : {5.0, 10.0, 15.0, 20.0, 25.0, 40.0}) {
    const double exact =
        h * std::sqrt((k * k + c * c * omega * omega) / (std::pow(k - M * omega * omega, 2) + c * c * omega * omega));
    response.add({scientific(omega, 2), scientific(amplitude(omega), 5), scientific(exact, 5)});
  }
  std::cout << "\nSpring and damper (not in the course): no force function, as the force depends on y'\n\n" << response;
}

}  // namespace

int main(int argc, char** argv) {
  return demonstrate(
      argc, argv,
      {.name = "shaker", .about = "a spring seen from both its ends and from the mass alone; with a damper"}, show);
}
