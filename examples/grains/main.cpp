// SPDX-License-Identifier: MIT
#include <filesystem>
#include <iostream>
#include <numbers>
#include <string>

#include "examples/grains/machines.hpp"
#include "torsor/runtime/integration/presentation.hpp"
#include "torsor/runtime/records/plot.hpp"
#include "torsor/runtime/records/table.hpp"

namespace {

using namespace torsor::runtime;
using namespace grains_example;

void show(const PlotFolder& plots) {
  std::cout << "240 discs of 8 to 12 mm in a drum of 24 cm that turns at 0.4 rad/s, in 3 s\n\n";
  Table angles({"f", "angle [deg]", "drum's torque [N m]", "weight times lever [N m]"});
  for (const double f : {0.0, 0.1, 0.2, 0.3, 0.5, 0.8}) {
    Drum drum(240, f);
    (void)drum.run(1);
    const Drum::Shown shown = drum.run(3);
    angles.add({scientific(f, 1), scientific(shown.angle * 180 / std::numbers::pi, 3), scientific(shown.torque, 3),
                scientific(shown.weight, 3)});
  }
  std::cout << angles << "\nA silo of 20 cm with 300 such discs: what falls through its opening, f = 0.5\n\n";
  Table flow({"opening [m]", "first second [kg/s]", "second", "third"});
  for (const double opening : {0.03, 0.04, 0.05, 0.06, 0.08}) {
    Silo silo(300, 0.5, opening);
    (void)silo.run(0.5);
    const double first = silo.run(1), second = silo.run(1), third = silo.run(1);
    flow.add({scientific(opening, 0), scientific(first, 3), scientific(second, 3), scientific(third, 3)});
  }
  std::cout << flow;
  if (!plots) return;
  const std::filesystem::path angle_csv = plots.file("grains_angle.csv"),
                              angle_picture = plots.file("grains_angle.svg");
  angles.write_csv(angle_csv);
  write_plot({.title = "Angle of repose in a drum",
              .x_title = "coefficient of friction",
              .y_title = "angle [deg]",
              .curves = {{angle_csv, "f", "angle [deg]", "240 discs", "linespoints"}}},
             angle_picture);
  const std::filesystem::path flow_csv = plots.file("grains_silo.csv"), flow_picture = plots.file("grains_silo.svg");
  flow.write_csv(flow_csv);
  write_plot({.title = "Flow out of a silo",
              .x_title = "opening [m]",
              .y_title = "mass [kg/s]",
              .curves = {{flow_csv, "opening [m]", "first second [kg/s]", "first second", "linespoints"},
                         {flow_csv, "opening [m]", "third", "third second", "linespoints"}}},
             flow_picture);
  for (const auto& picture : {angle_picture, flow_picture}) {
    std::cout << "\nplot: " << std::filesystem::absolute(picture).string() << '\n';
  }
}

}  // namespace

int main(int argc, char** argv) {
  return present(argc, argv, {.name = "grains", .about = "the angle of repose in a drum, and the flow out of a silo"},
                 show);
}
