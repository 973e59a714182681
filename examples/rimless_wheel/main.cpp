// SPDX-License-Identifier: MIT
#include <cmath>
#include <filesystem>
#include <iostream>
#include <numbers>
#include <string>
#include <vector>

#include "generated/rimless_wheel.hpp"
#include "torsor/runtime/contacts/integrate_contacts.hpp"
#include "torsor/runtime/contacts/mechanism_with_contacts.hpp"
#include "torsor/runtime/integration/presentation.hpp"
#include "torsor/runtime/records/plot.hpp"
#include "torsor/runtime/records/table.hpp"

namespace {

using namespace torsor::runtime;
using Wheel = MechanismWithContacts<rimless_wheel::Mechanism<double>>;
constexpr DormandPrince853 precise{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12};
constexpr double m = 2, J = 0.5, l = 1, g = 9.81, half = std::numbers::pi / 6;

/// Rates of turning right after each step, and why the walk ended.
struct Walk {
  std::vector<double> rates;
  ContactResult result;
};
Walk walk(double slope, double rate, double end) {
  const Wheel wheel({.slope = slope, .f = 1});
  Wheel::State y = wheel.initial();
  for (std::size_t i = Wheel::nq; i < y.size(); ++i) y[i] *= rate;  // the scene's is 1 rad/s
  Walk walk;
  walk.result = integrate_contacts(wheel, y, 0, end, precise, {}, [&](const ContactEvent& event) {
    if (event.kind == ContactEventKind::impact) walk.rates.push_back(event.state[5]);
    return true;
  });
  return walk;
}

/// Of the rate after a step: lost by the step, (1 - μ²), and won between two, 4 m g l sin α sin γ/(J + m l²).
double limit_cycle(double slope) {
  const double mu = (J + m * l * l * std::cos(2 * half)) / (J + m * l * l);
  const double won = 4 * m * g * l * std::sin(half) * std::sin(slope) / (J + m * l * l);
  return mu * std::sqrt(won / (1 - mu * mu));
}

void show(const PlotFolder& plots) {
  std::cout << "A rimless wheel of six spokes on a slope: rate of turning after a step\n\n";
  Table table({"slope [rad]", "start [rad/s]", "1st", "2nd", "5th", "last", "formula", "steps", "worst residual"});
  for (const double slope : {0.15, 0.18, 0.2}) {
    for (const double rate : {1.3, 1.7}) {
      const Walk done = walk(slope, rate, 8);
      if (!done.result || done.rates.size() < 5)
        throw FileError("the wheel stopped: " + std::string(describe(done.result.status)));
      table.add({scientific(slope, 1), scientific(rate, 1), scientific(done.rates[0], 6), scientific(done.rates[1], 6),
                 scientific(done.rates[4], 6), scientific(done.rates.back(), 10), scientific(limit_cycle(slope), 10),
                 std::to_string(done.rates.size()), scientific(done.result.worst_residual, 0)});
    }
  }
  std::cout << table;
  if (!plots) return;
  const Wheel wheel({.slope = 0.2, .f = 1});
  Plot plot{.title = "A rimless wheel finds its gait", .x_title = "t [s]", .y_title = "rate of turning [rad/s]"};
  for (const double rate : {1.3, 1.7}) {
    Wheel::State y = wheel.initial();
    for (std::size_t i = Wheel::nq; i < y.size(); ++i) y[i] *= rate;
    Table motion({"t", "rate"});
    for (int i = 0; i <= 600; ++i) {
      motion.add({scientific(0.005 * i, 6), scientific(y[5], 8)});
      const auto result = integrate_contacts(wheel, y, 0.005 * i, 0.005 * (i + 1), precise);
      if (!result) throw FileError("the wheel stopped: " + std::string(describe(result.status)));
    }
    const std::filesystem::path csv =
        plots.file("rimless_wheel_from_" + std::string(rate > 1.5 ? "fast" : "slow") + ".csv");
    motion.write_csv(csv);
    plot.curves.push_back({csv, "t", "rate", "from " + scientific(rate, 1) + " rad/s"});
  }
  const std::filesystem::path picture = plots.file("rimless_wheel.svg");
  write_plot(plot, picture);
  std::cout << "\nplot: " << std::filesystem::absolute(picture).string() << '\n';
}

}  // namespace

int main(int argc, char** argv) {
  return present(argc, argv,
                 {.name = "rimless_wheel", .about = "a wheel of spokes walks down a slope and finds its gait"}, show);
}
