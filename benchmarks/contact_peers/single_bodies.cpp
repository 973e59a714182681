// SPDX-License-Identifier: GPL-3.0-or-later
// Motions with a closed form: a ball that bounces, and one that slides and then rolls.
#include <cmath>
#include <vector>

#include "benchmarks/contact_peers/closed_forms.hpp"
#include "benchmarks/contact_peers/ours.hpp"
#include "benchmarks/contact_peers/peers.hpp"
#include "benchmarks/contact_peers/problems.hpp"
#include "bouncing_ball.hpp"
#include "generated/billiard.hpp"
#include "torsor/runtime/contacts/mechanism_with_contacts.hpp"

namespace torsor::contact_peers {
namespace {

void append(std::vector<Way>& ways, const std::vector<Way>& more) { ways.insert(ways.end(), more.begin(), more.end()); }

/// The ball on its cloth, struck in its middle.
struct Struck : runtime::MechanismWithContacts<::billiard::Mechanism<double>> {
  using MechanismWithContacts::MechanismWithContacts;
  State initial() const { return {0, 0, billiard::radius, 1, 0, 0, 0, billiard::speed, 0, 0, 0, 0, 0}; }
};

}  // namespace

Problem bouncing_ball() {
  static const runtime::MechanismWithContacts<::bouncing_ball::Mechanism<double>> ball;
  const auto error = [](const auto& y) { return std::abs(y[0] - bouncing::height()); };
  Problem problem{"A ball that bounces from 1 m, e = 0.8, after 3 s: closed form", "height off [m]", {}};
  problem.ways.push_back(with_events(ball, bouncing::end, 1e-10, error));
  for (const double h : {1e-2, 1e-3, 1e-4}) problem.ways.push_back(with_steps(ball, bouncing::end, h, error));
#if defined(PEER_SICONOS)
  append(problem.ways, siconos_bouncing());
#endif
  return problem;
}

Problem billiard_ball() {
  static const Struck ball;
  const auto error = [](const auto& y) { return std::abs(y[0] - billiard::place()); };
  Problem problem{"A billiard ball that slides, then rolls, after 1 s: closed form", "place off [m]", {}};
  problem.ways.push_back(with_events(ball, billiard::end, 1e-10, error));
  for (const double h : {1e-2, 1e-3, 1e-4}) problem.ways.push_back(with_steps(ball, billiard::end, h, error));
#if defined(PEER_MUJOCO)
  append(problem.ways, mujoco_billiard());
#endif
#if defined(PEER_SIMBODY)
  append(problem.ways, simbody_billiard());
#endif
  return problem;
}

}  // namespace torsor::contact_peers
