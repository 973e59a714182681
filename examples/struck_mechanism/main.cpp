// SPDX-License-Identifier: MIT
#include <array>
#include <cstddef>
#include <iostream>
#include <string_view>

#include "generated/struck_mechanism.hpp"
#include "generated/struck_mechanism_two_rods.hpp"
#include "torsor/runtime/contacts/integrate_contacts.hpp"
#include "torsor/runtime/contacts/mechanism_with_contacts.hpp"
#include "torsor/runtime/records/table.hpp"

namespace {

using namespace torsor::runtime;
using Rod = MechanismWithContacts<struck_mechanism::Mechanism<double>>;
using TwoRods = MechanismWithContacts<struck_mechanism_two_rods::Mechanism<double>>;

/// What the first impact of a motion changes: the impulse, the velocities and the energy lost.
template <class S>
struct Blow {
  double impulse = 0, energy_lost = 0;
  std::array<double, S::nv> change{};

  /// The ball, at coordinate `ball`, starts a nanometre off.
  Blow(const S& system, std::size_t ball) {
    typename S::State y = system.initial();
    y[ball] -= 1e-9;
    integrate_contacts(system, y, 0, 1e-3, DormandPrince853{}, {}, [&](const ContactEvent& event) {
      impulse = event.impulses(0);
      energy_lost = event.energy_lost;
      for (std::size_t i = 0; i < S::nv; ++i) change[i] = event.state[S::nq + i] - event.before[S::nq + i];
      return false;
    });
  }
};

void show() {
  std::cout << "A ball of 0.3 kg strikes a hanging rod of 2 kg, 1.2 m long, at 4 m/s\n\n";
  Table hanging({"depth [m]", "e", "impulse [N s]", "rod [rad/s]", "ball [m/s]", "hinge [N s]", "energy lost [J]"});
  for (const double d : {0.2, 0.8, 0.9, 1.2}) {
    for (const double e : {0.0, 0.5, 1.0}) {
      const Blow<Rod> blow(Rod({.d = d, .e = e}), 1);
      // Momentum of the rod, G at 0.6 m, less the ball's impulse.
      const double hinge = 2 * 0.6 * blow.change[0] - blow.impulse;
      hanging.add({scientific(d, 2), scientific(e, 2), scientific(blow.impulse, 10), scientific(blow.change[0], 10),
                   scientific(4 + blow.change[1], 10), scientific(hinge, 6), scientific(blow.energy_lost, 10)});
    }
  }
  std::cout << hanging << "\nA ball of 0.5 kg strikes the end A of two jointed rods AB, BC of 1 kg and 1 m at 1 m/s\n\n";
  Table jointed({"e", "impulse [N s]", "AB [rad/s]", "BC [rad/s]", "A [m/s]", "ball [m/s]", "B on BC [N s]"});
  for (const double e : {0.0, 0.5, 1.0}) {
    const Blow<TwoRods> blow(TwoRods({.e = e}), 6);
    const auto& v = blow.change;
    jointed.add({scientific(e, 2), scientific(blow.impulse, 10), scientific(v[2], 10), scientific(v[5], 10),
                 scientific(v[1] - v[2] / 2, 10), scientific(1 + v[6], 10), scientific(v[4], 10)});
  }
  std::cout << jointed;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 1) {
    const std::string_view argument = argv[1];
    const bool help = argument == "--help" || argument == "-h";
    (help ? std::cout : std::cerr) << "struck_mechanism: percussions on a hinged rod and on two jointed rods\nusage: struck_mechanism [--help]\n";
    return help ? 0 : 2;
  }
  show();
}
