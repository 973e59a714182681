// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <numbers>
#include <string>
#include <vector>

#include "generated/elastic_wing.hpp"
#include "torsor/runtime/integration/demonstration.hpp"
#include "torsor/runtime/integration/work_precision.hpp"
#include "torsor/runtime/mechanism.hpp"
#include "torsor/runtime/records/plot.hpp"
#include "torsor/runtime/records/trajectory.hpp"
#include "torsor/runtime/small_motions/linear_system.hpp"
#include "torsor/runtime/small_motions/modes.hpp"

namespace {

using namespace torsor::runtime;
using Wing = elastic_wing::Mechanism<double>;
constexpr double root_stiffness = 3e7;

/// Prints the modes about steady flight. Returns what the gust makes of beta_1 once all oscillations have died out
/// while the aircraft rises faster and faster: its share in every mode but the free one.
double show_modes() {
  Wing::Linearisation linear{};
  if (Wing::linearisation(Wing::precompute(Wing::default_parameters()), Wing::State{}, {}, {}, {}, linear) !=
      torsor::Status::ok)
    return NAN;
  const LinearSystem system = linear_system(linear);
  const NaturalModes modes = natural_modes(system);
  double settled = 0.0;
  for (Eigen::Index k = 1; k < 6; ++k) {
    settled += modes.shapes(1, k) * modes.shapes.col(k).dot(system.F) / modes.squared_frequencies(k);
  }
  Table table({"mode", "frequency [Hz]", "z", "beta_1", "beta_2", "beta_3", "beta_4", "gamma"});
  for (Eigen::Index k = 0; k < 6; ++k) {
    const Eigen::VectorXd shape = modes.shapes.col(k) / modes.shapes.col(k).cwiseAbs().maxCoeff();
    std::vector<std::string> row{
        std::to_string(k + 1),
        k == 0 ? "0 (free)" : scientific(modes.angular_frequency(k) / (2.0 * std::numbers::pi), 4)};
    for (Eigen::Index i = 0; i < 6; ++i) row.push_back(scientific(shape(i)));
    table.add(row);
  }
  std::cout << "\nModes about steady flight (z in m, angles in rad, the largest is 1)\n\n" << table;
  return settled;
}

/// Height of the wing's tip above the fuselage, and moment at its root, after a gust has set in.
void show_gust(double settled, const PlotFolder& plots) {
  const auto motion = equations_of_motion<Wing>();
  auto y = motion.initial();
  std::vector<double> times;
  for (int i = 0; i <= 1500; ++i) times.push_back(0.002 * i);
  std::vector<Sample<double, 3>> storage(times.size());
  Trajectory<double, 3> record(storage, {"tip", "moment", "engine"});
  double tip = 0.0, moment = 0.0;
  const auto result = integrate_through(motion, y, 0.0, times, DormandPrince54{.relative_tolerance = 1e-10},
                                        [&](double t, const StateVector<Wing>& now) {
                                          const auto s = unpack<Wing>(t, now);
                                          Wing::Kinematics at{};
                                          Wing::kinematics(motion.precomputed(), s, at);
                                          const double rise = at.tip_position[2] - s.q.z;
                                          const double root = root_stiffness * s.q.beta_1;
                                          tip = std::max(tip, rise);
                                          moment = std::max(moment, root);
                                          record(t, {rise, 1e-3 * root, s.q.gamma});
                                        });
  if (!result) throw FileError(describe(result));
  std::cout << "\nA gust adds 10 kN to each panel. Highest rise of the tip: " << scientific(tip, 4)
            << " m; largest additional moment at the root: " << scientific(1e-3 * moment, 4)
            << " kN m, settled: " << scientific(1e-3 * root_stiffness * settled, 4) << " kN m\n";
  if (!plots) return;
  const std::filesystem::path csv = plots.file("elastic_wing.csv"), picture = plots.file("elastic_wing.svg");
  record.write_csv(csv);
  write_plot({.title = "A gust strikes an elastic wing",
              .x_title = "time [s]",
              .y_title = "rise of the tip above the fuselage [m]",
              .curves = {{csv, "time", "tip", "tip"}}},
             picture);
  std::cout << "\nplot: " << std::filesystem::absolute(picture).string() << '\n';
}

void show(const Reference<double>& reference, const PlotFolder& plots) {
  std::cout << "Elastic wing, struck by a gust\n\n"
            << work_precision(equations_of_motion<Wing>(), reference, Midpoint{.step = 1e-4}, RungeKutta4{.step = 1e-3},
                              DormandPrince54{.relative_tolerance = 1e-6, .absolute_tolerance = 1e-6},
                              DormandPrince54{.relative_tolerance = 1e-9, .absolute_tolerance = 1e-9},
                              DormandPrince54{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12});
  show_gust(show_modes(), plots);
}

}  // namespace

int main(int argc, char** argv) {
  return demonstrate_with_plots(
      argc, argv, {.name = "elastic_wing", .about = "modes of a wing with an engine, and its answer to a gust"}, show);
}
