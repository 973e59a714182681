// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

#include "generated/newton_cradle.hpp"
#include "torsor/runtime/contacts/integrate_contacts.hpp"
#include "torsor/runtime/contacts/mechanism_with_contacts.hpp"
#include "torsor/runtime/records/table.hpp"

namespace {

using namespace torsor::runtime;
using Cradle = MechanismWithContacts<newton_cradle::Mechanism<double>>;
constexpr DormandPrince853 precise{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12};
constexpr std::array laws{ImpactLaw::newton_moreau, ImpactLaw::poisson, ImpactLaw::sequential};

/// Velocities of the balls to the right after the first impact, over that of those let go.
bool add_first_impact(Table& table, ImpactLaw law, double e, int let_go) {
  const Cradle cradle({.e = e});
  Cradle::State y = cradle.initial();
  for (int i = 1; i < let_go; ++i) y[static_cast<std::size_t>(i)] = y[0];
  const double speed = std::sqrt(2 * 9.81 * (1 - std::cos(y[0])));
  std::array<double, Cradle::nv> after{};
  double lost = 0;
  const auto result = integrate_contacts(cradle, y, 0, 1, precise, {.law = law}, [&](const ContactEvent& event) {
    for (std::size_t i = 0; i < after.size(); ++i) after[i] = -event.state[Cradle::nq + i] / speed;
    lost = event.energy_lost;
    return false;
  });
  if (result.status != ContactStatus::stopped_by_observer) {
    std::cerr << "newton_cradle: " << describe(result.status) << '\n';
    return false;
  }
  std::vector<std::string> row{std::to_string(let_go), std::string(describe(law)), scientific(e, 2)};
  for (const double v : after) row.push_back(scientific(v, 6));
  row.push_back(scientific(lost, 6));
  table.add(row);
  return true;
}

bool show() {
  std::cout << "Newton's cradle: velocities after the first impact, 1 is that of the balls let go\n\n";
  Table table({"let go", "law", "e", "ball 1", "ball 2", "ball 3", "ball 4", "ball 5", "energy lost [J]"});
  for (const int let_go : {1, 2}) {
    for (const double e : {1.0, 0.8}) {
      for (const ImpactLaw law : laws) {
        if (!add_first_impact(table, law, e, let_go)) return false;
      }
    }
  }
  std::cout << table;
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 1) {
    const std::string_view argument = argv[1];
    const bool help = argument == "--help" || argument == "-h";
    (help ? std::cout : std::cerr) << "newton_cradle: what each law of impact says of five balls in a row\nusage: newton_cradle [--help]\n";
    return help ? 0 : 2;
  }
  return show() ? 0 : 1;
}
