// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <numbers>
#include <string>
#include <vector>

#include "generated/vibration_absorber.hpp"
#include "torsor/runtime/integration/demonstration.hpp"
#include "torsor/runtime/integration/work_precision.hpp"
#include "torsor/runtime/mechanism.hpp"
#include "torsor/runtime/records/plot.hpp"
#include "torsor/runtime/records/trajectory.hpp"
#include "torsor/runtime/small_motions/equilibrium_stability.hpp"
#include "torsor/runtime/small_motions/forced_response.hpp"
#include "torsor/runtime/small_motions/steady_states.hpp"

namespace {

using namespace torsor::runtime;
using Absorber = vibration_absorber::Mechanism<double>;

/// The two pendulums that are compared: g / d = omega^2 at 10 rad/s, and half as long again.
constexpr double design_speed = 10.0, tuned_length = 0.0981, detuned_length = 0.15;

/// Support at the spring's rest length, pendulum hanging: the rest about which everything is linearised.
constexpr double rest_position = 0.1;

Absorber::Parameters parameters_with(double length, double speed) {
  Absorber::Parameters parameters = Absorber::default_parameters();
  parameters.d = length;
  parameters.omega = speed;
  return parameters;
}

/// M x'' + K x = F sin(omega t) about the hanging rest: the unbalance reaches its largest force, F, a quarter of a turn
/// after t = 0.
LinearSystem about_rest(double length, double speed) {
  FoundState<Absorber> rest;
  rest.state.time = std::numbers::pi / (2.0 * speed);
  rest.state.q.X = rest_position;
  return linearised_at<Absorber>(Absorber::precompute(parameters_with(length, speed)), rest);
}

/// Steady forced motion of the linearised equations, (X - X0, theta) = amplitude * sin(omega t). Without friction the
/// amplitudes are in phase with the force or opposed to it.
std::array<double, 2> steady_amplitude(double length, double speed) {
  const LinearSystem system = about_rest(length, speed);
  const auto amplitude = FrequencyResponse(system, system.F)(speed);
  if (!amplitude) return {NAN, NAN};
  return {(*amplitude)(0).real(), (*amplitude)(1).real()};
}

/// Where the machine can stand when the rotor does not turn, and whether it stays there.
Table rests() {
  Table table({"rest", "X", "theta", "verdict", "roots"});
  const Absorber::Precomputed precomputed = Absorber::precompute(parameters_with(tuned_length, 0.0));
  const CoordinateBox box{Eigen::Vector2d(0.0, -1.0), Eigen::Vector2d(1.0, 5.0), {1}};
  for (const FoundState<Absorber>& rest : find_equilibria<Absorber>(precomputed, box).found) {
    const LinearSystem system = linearised_at<Absorber>(precomputed, rest);
    std::string roots;
    for (const DampedMode& mode : damped_modes(system)) {
      if (mode.eigenvalue.imag() < 0.0) continue;
      const bool turns = mode.eigenvalue.imag() > 0.0;
      roots += (roots.empty() ? "" : ", ") + scientific(turns ? mode.eigenvalue.imag() : mode.eigenvalue.real(), 4) +
               (turns ? " i" : "");
    }
    table.add({std::cos(rest.state.q.theta) > 0.0 ? "hanging" : "upside down", scientific(rest.state.q.X) + " m",
               scientific(rest.state.q.theta, 4) + " rad", std::string(describe(stability(system, true).verdict)),
               roots});
  }
  return table;
}

/// The support's amplitude against the speed of the rotor, for both pendulums.
void plot_amplitudes(const PlotFolder& plots) {
  Table sweep({"speed", "tuned", "detuned"});
  for (int i = 0; i < 1500; ++i) {
    const double speed = 5.005 + 0.01 * i;  // 10 rad/s itself, where the logarithm of 0 has no place, is stepped over
    const auto millimetres = [speed](double length) {
      return scientific(1e3 * std::abs(steady_amplitude(length, speed)[0]), 9);
    };
    sweep.add({scientific(speed, 9), millimetres(tuned_length), millimetres(detuned_length)});
  }
  const std::filesystem::path csv = plots.file("vibration_absorber_amplitude.csv");
  const std::filesystem::path picture = plots.file("vibration_absorber_amplitude.svg");
  sweep.write_csv(csv);
  Plot plot{.title = "Amplitude of the support against the speed of the rotor",
            .x_title = "speed of the rotor, omega [rad/s]",
            .y_title = "amplitude of the support [mm]",
            .curves = {{csv, "speed", "tuned", "pendulum tuned to 10 rad/s: g / d = omega^2"},
                       {csv, "speed", "detuned", "pendulum half as long again"}}};
  plot.log_y = true;
  write_plot(plot, picture);
  std::cout << "\nplot: " << std::filesystem::absolute(picture).string() << '\n';
}

/// The motion with one pendulum, by the full equations, started on the steady motion of the linearised ones; one sample
/// every 5 ms. Returns the largest |X - X0|.
double record_motion(double length, std::vector<double>& positions) {
  const auto motion = equations_of_motion<Absorber>(parameters_with(length, design_speed));
  const std::array<double, 2> amplitude = steady_amplitude(length, design_speed);
  StateVector<Absorber> y{rest_position, 0.0, design_speed * amplitude[0], design_speed * amplitude[1]};
  std::vector<double> times;
  for (int i = 0; i <= 2000; ++i) times.push_back(0.005 * i);
  double largest = 0.0;
  const auto result = integrate_through(motion, y, 0.0, times, DormandPrince54{.relative_tolerance = 1e-10},
                                        [&](double, const StateVector<Absorber>& state) {
                                          const double displacement = state[0] - rest_position;
                                          largest = std::fmax(largest, std::abs(displacement));
                                          positions.push_back(1e3 * displacement);
                                        });
  if (!result) throw FileError(describe(result));
  return largest;
}

/// Displacements of the support [mm], every 5 ms.
struct Motions {
  std::vector<double> tuned, detuned;
};

Motions record_motions(Table& table) {
  Motions motions;
  for (const double length : {tuned_length, detuned_length}) {
    const double largest = record_motion(length, length == tuned_length ? motions.tuned : motions.detuned);
    table.add({length == tuned_length ? "tuned" : "detuned", std::to_string(length) + " m",
               scientific(1e3 * std::abs(steady_amplitude(length, design_speed)[0])) + " mm",
               scientific(1e3 * largest) + " mm"});
  }
  return motions;
}

void plot_motions(const Motions& motions, const PlotFolder& plots) {
  const auto& [tuned, detuned] = motions;
  std::vector<Sample<double, 2>> storage(tuned.size());
  Trajectory<double, 2> motion(storage, {"tuned", "detuned"});
  for (std::size_t i = 0; i < tuned.size(); ++i) motion(0.005 * static_cast<double>(i), {tuned[i], detuned[i]});
  const std::filesystem::path csv = plots.file("vibration_absorber_motion.csv");
  const std::filesystem::path picture = plots.file("vibration_absorber_motion.svg");
  motion.write_csv(csv);
  write_plot({.title = "Motion of the support, rotor at 10 rad/s",
              .x_title = "time [s]",
              .y_title = "displacement of the support [mm]",
              .curves = {{csv, "time", "detuned", "pendulum half as long again"},
                         {csv, "time", "tuned", "pendulum tuned: g / d = omega^2"}}},
             picture);
  std::cout << "plot: " << std::filesystem::absolute(picture).string() << '\n';
}

void show(const Reference<double>& reference, const PlotFolder& plots) {
  std::cout << "Vibration absorber, pendulum released from 0.3 rad\n\n"
            << work_precision(equations_of_motion<Absorber>(), reference, Midpoint{.step = 1e-3},
                              Midpoint{.step = 1e-4}, RungeKutta4{.step = 1e-2}, RungeKutta4{.step = 1e-3},
                              DormandPrince54{.relative_tolerance = 1e-6, .absolute_tolerance = 1e-8},
                              DormandPrince54{.relative_tolerance = 1e-9, .absolute_tolerance = 1e-11},
                              DormandPrince54{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-14});
  std::cout << "\nThe machine with the rotor stopped, pendulum of " << tuned_length << " m\n\n" << rests();
  const LinearSystem tuned = about_rest(tuned_length, design_speed);
  for (const double still : antiresonances(tuned, tuned.F, 0)) {
    std::cout << "\nThe support stands still at " << still << " rad/s.\n";
  }
  Table table({"pendulum", "length d", "amplitude, linearised", "largest |X - X0| in 10 s"});
  const Motions motions = record_motions(table);
  std::cout << "\nThe support with the rotor at 10 rad/s\n\n" << table;
  if (!plots) return;
  plot_amplitudes(plots);
  plot_motions(motions, plots);
}

}  // namespace

int main(int argc, char** argv) {
  return demonstrate_with_plots(argc, argv,
                                {.name = "vibration_absorber",
                                 .about = "a pendulum keeps an unbalanced machine still: reference, amplitudes, plots"},
                                show);
}
