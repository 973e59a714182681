// SPDX-License-Identifier: MIT
#include <cmath>
#include <iostream>
#include <string>

#include "generated/kapitza_pendulum.hpp"
#include "torsor/runtime/integration/demonstration.hpp"
#include "torsor/runtime/integration/work_precision.hpp"
#include "torsor/runtime/mechanism.hpp"

namespace {

using namespace torsor::runtime;
using Pendulum = kapitza_pendulum::Mechanism<double>;

/// How far the pendulum, let go at 0.05 rad from the top, leans within ten seconds.
double largest_lean(double omega) {
  Pendulum::Parameters parameters = Pendulum::default_parameters();
  parameters.omega = omega;
  const auto motion = equations_of_motion<Pendulum>(parameters);
  StateVector<Pendulum> y{0.05, 0.0};
  double largest = 0.0;
  const auto result =
      integrate(motion, y, 0.0, 10.0, DormandPrince54{.relative_tolerance = 1e-10, .absolute_tolerance = 1e-12},
                [&largest](double, const StateVector<Pendulum>& state) {
                  largest = std::fmax(largest, std::abs(state[0]));
                  return largest < 3.2;  // it has passed the lowest point
                });
  if (!result && result.status != IntegrationStatus::stopped_by_observer) throw FileError(describe(result));
  return largest;
}

void show(const Reference<double>& reference) {
  std::cout << "Kapitza's pendulum, its pivot shaken at 100 rad/s\n\n"
            << work_precision(equations_of_motion<Pendulum>(), reference, Midpoint{.step = 1e-4},
                              RungeKutta4{.step = 1e-3},
                              DormandPrince54{.relative_tolerance = 1e-6, .absolute_tolerance = 1e-6},
                              DormandPrince54{.relative_tolerance = 1e-9, .absolute_tolerance = 1e-9},
                              DormandPrince54{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12});
  Table table({"shaking [rad/s]", "a omega [m/s]", "largest lean in 10 s [rad]", ""});
  for (const double omega : {30.0, 40.0, 44.0, 45.0, 46.0, 60.0, 100.0, 200.0}) {
    const double lean = largest_lean(omega);
    table.add({scientific(omega), scientific(0.1 * omega), scientific(lean), lean < 1.0 ? "stands" : "falls"});
  }
  std::cout << "\nLet go at 0.05 rad from the top; averaging asks for a omega > sqrt(2 g L) = 4.43 m/s\n\n" << table;
}

}  // namespace

int main(int argc, char** argv) {
  return demonstrate(argc, argv, {.name = "kapitza_pendulum", .about = "a shaken pendulum stands upside down"}, show);
}
