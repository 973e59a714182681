// SPDX-License-Identifier: GPL-3.0-or-later
// Mechanisms whose truth is our own motion at a much smaller tolerance.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "benchmarks/contact_peers/ours.hpp"
#include "benchmarks/contact_peers/peers.hpp"
#include "benchmarks/contact_peers/problems.hpp"
#include "chain_on_floor.hpp"
#include "generated/quadruped_on_its_feet.hpp"
#include "torsor/runtime/contacts/mechanism_with_contacts.hpp"
#include "torsor/runtime/integration/radau_iia_5.hpp"

namespace torsor::contact_peers {
namespace {

using namespace runtime;
using Robot = quadruped_on_its_feet::Mechanism<double>;

/// Motors that hold the crouch, as in the example: each a spring of 60 N m/rad with a damper of 2 N m s/rad.
struct Hold {
  Robot::Inputs operator()(const Robot::State& state) const {
    constexpr std::array crouch{0.0, 0.7, -1.4};
    Robot::Inputs torques{};
    for (int j = 0; j < Robot::input_count; ++j) {
      torques[j] = 60 * (crouch[static_cast<std::size_t>(j % 3)] - state.q[7 + j]) - 2 * state.v[6 + j];
    }
    return torques;
  }
  /// What steps of equal length take implicitly.
  std::array<double, 18> damping(const Robot::State&) const {
    std::array<double, 18> rates{};
    for (std::size_t j = 6; j < rates.size(); ++j) rates[j] = 2;
    return rates;
  }
};
using OnItsFeet = MechanismWithContacts<Robot, Hold>;

template <class Method>
Path walked(const OnItsFeet& robot, double tolerance) {
  OnItsFeet::State y = robot.initial();
  const ContactMechanismOf<OnItsFeet> mechanism(robot);
  IgnoreSteps ignore;
  const Method method{.relative_tolerance = tolerance, .absolute_tolerance = tolerance};
  ContactRun<OnItsFeet::nq + OnItsFeet::nv, OnItsFeet::contacts, Method, IgnoreSteps> run(mechanism, y, method, {}, ignore);
  Path path;
  if (!run.start(0)) return path;
  for (int k = 1; k <= 100 && run.advance(0.1 * k); ++k) path.push_back({y[0], y[1], y[2]});
  return path;
}

Path stepped(const OnItsFeet& robot, int steps) {
  OnItsFeet::State y = robot.initial();
  MoreauJean scheme(robot);
  const double h = 0.1 / steps;
  Path path;
  for (int k = 0; k < 100; ++k) {
    for (int j = 0; j < steps; ++j) {
      if (!scheme.step(0.1 * k + h * j, h, y)) return path;
    }
    path.push_back({y[0], y[1], y[2]});
  }
  return path;
}

}  // namespace

double distance(const Path& path, const Path& truth) {
  if (path.size() != truth.size()) return INFINITY;
  double most = 0;
  for (std::size_t k = 0; k < path.size(); ++k) {
    const auto off = [&](std::size_t i) { return path[k][i] - truth[k][i]; };
    most = std::max(most, std::hypot(off(0), off(1), off(2)));
  }
  return most;
}

Problem chain_on_floor() {
  static const MechanismWithContacts<::chain_on_floor::Mechanism<double>> chain;
  auto y = chain.initial();
  constexpr double end = 2;
  // A hundred times below the smallest tolerance that is measured.
  const auto result =
      integrate_contacts(chain, y, 0, end, DormandPrince853{.relative_tolerance = 1e-13, .absolute_tolerance = 1e-13});
  std::array<double, 4> truth{};
  for (std::size_t i = 0; i < truth.size(); ++i) truth[i] = result.status == ContactStatus::reached_end ? y[i] : NAN;
  const auto error = [truth](const auto& at) {
    double most = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) most = std::max(most, std::abs(at[i] - truth[i]));
    return most;
  };
  Problem problem{"Four rods fall on a floor, f = 0.3, and rest after 2 s: ours at 1e-13", "angle off [rad]", {}};
  for (const double tolerance : {1e-4, 1e-7, 1e-11}) problem.ways.push_back(with_events(chain, end, tolerance, error));
  for (const double h : {1e-2, 1e-3}) problem.ways.push_back(with_steps(chain, end, h, error));
#if defined(PEER_SICONOS)
  for (const Way& way : siconos_chain(truth)) problem.ways.push_back(way);
#endif
  return problem;
}

Problem quadruped() {
  static const OnItsFeet robot;
  const Path truth = walked<DormandPrince853>(robot, 1e-12);
  Problem problem{"A quadruped lands on its feet, 10 s: ours at 1e-12", "trunk off [m]", {}};
  for (const double tolerance : {1e-4, 1e-7, 1e-10}) {
    problem.ways.push_back(
        {"torsor", "events, tolerance " + number("%.0e", tolerance), [tolerance, truth]() -> Outcome {
           const Stopwatch watch;
           const Path path = walked<DormandPrince853>(robot, tolerance);
           return {watch.seconds(), distance(path, truth)};
         }});
  }
  for (const double tolerance : {1e-2, 1e-4}) {
    problem.ways.push_back(
        {"torsor", "events, RadauIia5, tolerance " + number("%.0e", tolerance), [tolerance, truth]() -> Outcome {
           const Stopwatch watch;
           const Path path = walked<RadauIia5>(robot, tolerance);
           return {watch.seconds(), distance(path, truth)};
         }});
  }
  for (const int steps : {20, 100}) {
    problem.ways.push_back({"torsor", "steps of " + number("%.0e s", 0.1 / steps), [steps, truth]() -> Outcome {
                              const Stopwatch watch;
                              const Path path = stepped(robot, steps);
                              return {watch.seconds(), distance(path, truth)};
                            }});
  }
#if defined(PEER_MUJOCO)
  for (const Way& way : mujoco_quadruped(truth)) problem.ways.push_back(way);
#endif
  return problem;
}

}  // namespace torsor::contact_peers
