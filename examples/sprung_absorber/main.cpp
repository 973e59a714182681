// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <complex>
#include <filesystem>
#include <iostream>
#include <string>

#include "generated/sprung_absorber.hpp"
#include "torsor/runtime/integration/demonstration.hpp"
#include "torsor/runtime/integration/work_precision.hpp"
#include "torsor/runtime/mechanism.hpp"
#include "torsor/runtime/records/plot.hpp"

namespace {

using namespace torsor::runtime;
using Absorber = sprung_absorber::Mechanism<double>;

/// Amplitude of the machine in its steady motion: (K + i omega C - omega^2 M) X = F.
double amplitude(const Absorber::Parameters& p) {
  Absorber::Linearisation linear{};
  if (Absorber::linearisation(Absorber::precompute(p), {}, {}, {}, {}, linear) != torsor::Status::ok) return NAN;
  std::array<std::complex<double>, 4> z;
  for (std::size_t i = 0; i < 4; ++i) z[i] = {linear.K[i] - p.omega * p.omega * linear.M[i], p.omega * linear.C[i]};
  return std::abs((z[3] * linear.F[0] - z[2] * linear.F[1]) / (z[0] * z[3] - z[1] * z[2]));
}

void show(const Reference<double>& reference, const PlotFolder& plots) {
  std::cout << "Sprung absorber, shaken at 10 rad/s, at its own frequency\n\n"
            << work_precision(equations_of_motion<Absorber>(), reference, Midpoint{.step = 1e-3},
                              RungeKutta4{.step = 1e-3},
                              DormandPrince54{.relative_tolerance = 1e-6, .absolute_tolerance = 1e-6},
                              DormandPrince54{.relative_tolerance = 1e-9, .absolute_tolerance = 1e-9},
                              DormandPrince54{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12});
  // Den Hartog's rule for m2/m1 = 0.1: tuning 1/1.1, damping ratio 0.168.
  const double own = 10.0 / 1.1, k2 = 0.1 * own * own, critical = 2.0 * 0.1 * 10.0;
  const std::array<double, 3> ratios{0.05, 0.1678520331536355, 0.5};
  Table sweep({"speed", "tuned", "little", "best", "much"});
  std::array<double, 3> top{};
  for (int i = 0; i < 1000; ++i) {
    const double omega = 5.005 + 0.01 * i;  // 10 rad/s itself, where the logarithm of 0 has no place, is stepped over
    std::array<double, 3> damped{};
    for (std::size_t j = 0; j < 3; ++j) {
      damped[j] = 100.0 * amplitude({.k2 = k2, .c2 = ratios[j] * critical, .f = 1.0, .omega = omega});
      top[j] = std::fmax(top[j], damped[j]);
    }
    sweep.add({scientific(omega, 9),
               scientific(100.0 * amplitude({.k2 = 10.0, .c2 = 0.0, .f = 1.0, .omega = omega}), 9),
               scientific(damped[0], 9), scientific(damped[1], 9), scientific(damped[2], 9)});
  }
  Table table({"absorber", "largest amplitude of the machine, in static deflections"});
  table.add({"tuned by the rule, damping ratio 0.05", scientific(top[0], 4)});
  table.add({"tuned by the rule, damping ratio 0.168", scientific(top[1], 4)});
  table.add({"tuned by the rule, damping ratio 0.5", scientific(top[2], 4)});
  std::cout << "\nAt 10 rad/s without damping: " << scientific(100.0 * amplitude(Absorber::default_parameters()))
            << "\nFrom 5 to 15 rad/s\n\n"
            << table;
  if (!plots) return;
  const std::filesystem::path csv = plots.file("sprung_absorber.csv"), picture = plots.file("sprung_absorber.svg");
  sweep.write_csv(csv);
  Plot plot{.title = "A machine and its absorber",
            .x_title = "rate of the shaking [rad/s]",
            .y_title = "amplitude of the machine / static deflection",
            .curves = {{csv, "speed", "tuned", "no damping, tuned to 10 rad/s"},
                       {csv, "speed", "little", "Den Hartog's tuning, damping ratio 0.05"},
                       {csv, "speed", "best", "0.168"},
                       {csv, "speed", "much", "0.5"}}};
  plot.log_y = true;
  write_plot(plot, picture);
  std::cout << "\nplot: " << std::filesystem::absolute(picture).string() << '\n';
}

}  // namespace

int main(int argc, char** argv) {
  return demonstrate_with_plots(
      argc, argv, {.name = "sprung_absorber", .about = "a mass on a spring keeps a machine still; how to damp it"},
      show);
}
