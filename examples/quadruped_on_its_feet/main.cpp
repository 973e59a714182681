// SPDX-License-Identifier: MIT
#include <array>
#include <cstddef>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

#include "generated/quadruped_on_its_feet.hpp"
#include "torsor/runtime/contacts/integrate_contacts.hpp"
#include "torsor/runtime/contacts/mechanism_with_contacts.hpp"
#include "torsor/runtime/mechanism.hpp"
#include "torsor/runtime/records/table.hpp"

namespace {

using namespace torsor::runtime;
using Robot = quadruped_on_its_feet::Mechanism<double>;
constexpr int first_joint = 7, first_rate = 6;

/// Motors that hold the crouch, each a spring of 60 N m/rad with a damper of 2 N m s/rad.
struct Hold {
  Robot::Inputs operator()(const Robot::State& state) const {
    constexpr std::array crouch{0.0, 0.7, -1.4};
    Robot::Inputs torques{};
    for (int j = 0; j < Robot::input_count; ++j) {
      torques[j] = 60 * (crouch[static_cast<std::size_t>(j % 3)] - state.q[first_joint + j]) - 2 * state.v[first_rate + j];
    }
    return torques;
  }
};
using OnItsFeet = MechanismWithContacts<Robot, Hold>;
constexpr DormandPrince853 precise{.relative_tolerance = 1e-10, .absolute_tolerance = 1e-10};

/// What happens, as rows of a table.
struct Happenings {
  Table& table;
  void operator()(const ContactEvent& event) const {
    constexpr std::array<std::string_view, 5> kinds{"impact", "opens", "begins to slip", "slip ends", "bounces end"};
    constexpr std::array<std::string_view, 4> feet{"front left", "front right", "rear left", "rear right"};
    std::string regimes;
    for (const ContactState& foot : event.contacts) {
      regimes += (regimes.empty() ? "" : ", ") + std::string(describe(foot.touches ? foot.regime : ContactRegime::open));
    }
    table.add({scientific(event.time, 9), std::string(feet[static_cast<std::size_t>(event.contact)]),
               std::string(kinds[static_cast<std::size_t>(event.kind)]), scientific(event.energy_lost, 5), regimes});
  }
};

bool show(double friction) {
  Robot::Parameters parameters = Robot::default_parameters();
  parameters.ground_friction = friction;
  const OnItsFeet robot(parameters);
  OnItsFeet::State y = robot.initial();
  Table table({"t [s]", "foot", "what", "energy lost [J]", "front left, front right, rear left, rear right"});
  Happenings happenings{table};
  const ContactMechanismOf<OnItsFeet> mechanism(robot);
  ContactRun<OnItsFeet::nq + OnItsFeet::nv, OnItsFeet::contacts, DormandPrince853, Happenings> run(mechanism, y, precise,
                                                                                                {}, happenings);
  if (!run.start(0) || !run.advance(5) || run.motion().solve(5, y) != Evaluation::ok) {
    std::cerr << "quadruped_on_its_feet: " << describe(run.result().status) << " at " << run.result().time << " s\n";
    return false;
  }
  std::cout << "\nFriction " << friction << ", let fall from 0.45 m at 0.5 m/s\n\n" << table << "\nStanding after 5 s, trunk "
            << scientific(y[2], 5) << " m high, " << scientific(y[0], 5) << " m along; a front foot carries "
            << scientific(run.motion().reactions()(0), 5) << " N, a rear foot " << scientific(run.motion().reactions()(6), 5)
            << " N; certificate " << scientific(run.result().worst_residual, 2) << "\n";
  return true;
}

}  // namespace

int main() { return show(0.6) && show(0.1) ? 0 : 1; }
