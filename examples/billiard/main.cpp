// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <iostream>
#include <string>
#include <string_view>

#include "generated/billiard.hpp"
#include "generated/billiard_soft_cloth.hpp"
#include "generated/billiard_two_balls.hpp"
#include "torsor/runtime/contacts/integrate_contacts.hpp"
#include "torsor/runtime/contacts/mechanism_with_contacts.hpp"
#include "torsor/runtime/records/table.hpp"

namespace {

using namespace torsor::runtime;
using Ball = MechanismWithContacts<billiard::Mechanism<double>>;
using SoftCloth = MechanismWithContacts<billiard_soft_cloth::Mechanism<double>>;
using TwoBalls = MechanismWithContacts<billiard_two_balls::Mechanism<double>>;
using Triple = std::array<double, 3>;
constexpr double R = 0.028575, g = 9.81, f = 0.2;
constexpr DormandPrince853 precise{.relative_tolerance = 1e-13, .absolute_tolerance = 1e-13};

/// When and where a contact's sliding ended, and how fast the ball was then.
struct End { double time = 0, x = 0, y = 0, vx = 0, vy = 0; };

/// Where a ball is in the state, and the contact that slides.
struct SlidingBall {
  int contact = 0;
  std::size_t q = 0, v = 7;  ///< of its x, and of the velocity of that
};

template <class S>
End end_of_sliding(const S& system, typename S::State y, const SlidingBall& ball, double until) {
  End end;
  integrate_contacts(system, y, 0, until, precise, {}, [&](const ContactEvent& event) {
    if (event.kind != ContactEventKind::slip_ends || event.contact != ball.contact) return true;
    const std::size_t q = ball.q, v = ball.v;
    end = {event.time, event.state[q], event.state[q + 1], event.state[v], event.state[v + 1]};
    return false;
  });
  return end;
}

void add(Table& table, const std::string& shot, const Triple& V, const Triple& W) {
  const Ball ball;
  const End end = end_of_sliding(ball, {0, 0, R, 1, 0, 0, 0, V[0], V[1], V[2], W[0], W[1], W[2]}, {.contact = 0}, 10);
  table.add({shot, scientific(end.time, 10), scientific(end.x, 10), scientific(end.y, 10), scientific(end.vx, 10),
             scientific(end.vy, 10)});
}

void show() {
  std::cout << "Billiard ball that slides, then rolls: where sliding ends, and the velocity from then on\n\n";
  Table shots({"shot", "t [s]", "x [m]", "y [m]", "vx [m/s]", "vy [m/s]"});
  add(shots, "in the middle", {2, 0, 0}, {});
  add(shots, "follow", {2, 0, 0}, {0, 2 * 2 / R, 0});
  add(shots, "stop", {2, 0, 0}, {0, -2.5 * 2 / R, 0});
  add(shots, "draw", {2, 0, 0}, {0, -4 * 2 / R, 0});
  // Tip at (-0.48, 0.36, 0.8) R, impulse 0.85 N s along (0.6, 0, -0.8): the cloth's impulse is in it.
  add(shots, "masse", {3, 0, -4}, {-125.984251968503937, 41.994750656167979, -94.488188976377953});
  std::cout << shots << "\nStruck in its middle it slides for 2 V/(7 f g) = " << scientific(2 * 2 / (7 * f * g), 10)
            << " s and keeps 5/7 of its speed.\n\nA ball with side spin (30 rad/s) strikes another, 30 degrees off its way\n\n";
  Table two({"ball", "t [s]", "x [m]", "y [m]", "vx [m/s]", "vy [m/s]"});
  const TwoBalls balls;
  TwoBalls::State y = balls.initial();
  y[19] = 30;
  const std::array<std::array<std::size_t, 2>, 2> places{{{0, 14}, {7, 20}}};
  for (int i = 0; i < 2; ++i) {
    const auto& [q, v] = places[static_cast<std::size_t>(i)];
    const End end = end_of_sliding(balls, y, {.contact = i, .q = q, .v = v}, 1);
    two.add({std::to_string(i + 1), scientific(end.time, 10), scientific(end.x, 10), scientific(end.y, 10),
             scientific(end.vx, 10), scientific(end.vy, 10)});
  }
  std::cout << two << "\nOn a cloth that resists rolling by 0.5 mm N it does not roll for ever: with the follow of the table above\n\n";
  Table soft({"what ends", "t [s]", "x [m]", "y [m]", "vx [m/s]", "vy [m/s]"});
  const SoftCloth cloth;
  const std::array<const char*, 3> names{"sliding", "rolling", "spinning"};
  for (int i = 0; i < 3; ++i) {
    const End end = end_of_sliding(cloth, {0, 0, R, 1, 0, 0, 0, 2, 0, 0, 0, 2 * 2 / R, 40}, {.contact = i}, 30);
    soft.add({names[static_cast<std::size_t>(i)], scientific(end.time, 10), scientific(end.x, 10), scientific(end.y, 10),
              scientific(end.vx, 10), scientific(end.vy, 10)});
  }
  std::cout << soft;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 1) {
    const std::string_view argument = argv[1];
    const bool help = argument == "--help" || argument == "-h";
    (help ? std::cout : std::cerr) << "billiard: follow, stop, draw and masse, and what one ball does to another\nusage: billiard [--help]\n";
    return help ? 0 : 2;
  }
  show();
}
