// SPDX-License-Identifier: GPL-3.0-or-later
// One step's contact problem of a hundred spheres that settle in a box.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "benchmarks/contact_peers/ours.hpp"
#include "benchmarks/contact_peers/peers.hpp"
#include "benchmarks/contact_peers/problems.hpp"
#include "torsor/runtime/batch/thread_team.hpp"
#include "torsor/runtime/grains/grain_motion.hpp"

namespace torsor::contact_peers {
namespace {

using namespace runtime;
using Block = Eigen::Matrix3d;
constexpr double step = 1e-3;

/// Columns of five by five spheres of 8 to 12 mm, each a little aside, over a floor between four walls.
Grains<3> box_of_spheres() {
  Grains<3> grains;
  unsigned long long state = 1;
  const auto random = [&state] {  // from -1 to 1
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<double>(state >> 40) / static_cast<double>(1 << 23) - 1;
  };
  for (int i = 0; i < 100; ++i) {
    const double R = 0.01 + 0.002 * random(), x = 0.0125 + 0.025 * (i % 5), y = 0.0125 + 0.025 * (i / 5 % 5);
    const double aside_x = (0.0125 - R) * random(), aside_y = (0.0125 - R) * random();
    grains.add({x + aside_x, y + aside_y, 0.0125 + 0.025 * (i / 25)}, R, 1e4 * R * R * R);
  }
  grains.walls.emplace_back();
  for (const int axis : {0, 1}) {
    for (const double side : {0.0, 0.125}) {
      GrainWall<3> wall;
      wall.point = side * Eigen::Vector3d::Unit(axis);
      wall.normal = (side > 0 ? -1 : 1) * Eigen::Vector3d::Unit(axis);
      grains.walls.push_back(wall);
    }
  }
  return grains;
}

/// The grains with the velocities they would have without contacts, and the contacts, without impulses.
struct Instant {
  Grains<3> grains;
  GrainContacts<3> contacts;
};

Instant instant() {
  Instant result{box_of_spheres(), {}};
  Grains<3>& grains = result.grains;
  GrainMotion<3> motion(grains, {.tolerance = 1e-4, .sweeps = 300, .rest = 0});
  for (int k = 0; k < 300; ++k) (void)motion.step(step);
  result.contacts.reserve(grains.count());
  result.contacts.find(grains, grains.x, 1e-6);
  for (auto& contact : result.contacts.all()) contact.bounce = 0;
  for (auto& v : grains.v) v += step * grains.gravity;
  result.contacts.colour(static_cast<std::uint32_t>(grains.count()), [](std::uint32_t) { return true; });
  return result;
}

/// Columns n and two tangents.
Block axes(const Eigen::Vector3d& n) {
  Block of;
  const Eigen::Vector3d across = n.unitOrthogonal();
  of << n, across, n.cross(across);
  return of;
}

/// u = B v, of the velocity and the turn of one grain: at a contact with normal n, R along -n from a, along n from b.
struct Part {
  std::uint32_t grain;
  Block by_velocity, by_turn;
};

std::vector<Part> parts(const Grains<3>& grains, const GrainContact<3>& contact) {
  const Block of = axes(contact.n);
  std::vector<Part> both;
  for (const bool first : {true, false}) {
    const std::uint32_t grain = first ? contact.a : contact.b;
    if (grain >= grains.count()) continue;
    const Eigen::Vector3d arm = (first ? -1 : 1) * grains.radius[grain] * contact.n;
    Block turn;  // w x arm
    turn << 0, arm(2), -arm(1), -arm(2), 0, arm(0), arm(1), -arm(0), 0;
    const double sign = first ? 1 : -1;
    both.push_back({grain, sign * of.transpose(), sign * of.transpose() * turn});
  }
  return both;
}

ContactSolve assembled(const Instant& at) {
  const auto& all = at.contacts.all();
  ContactSolve problem;
  std::vector<std::vector<Part>> of;
  for (const auto& contact : all) {
    of.push_back(parts(at.grains, contact));
    Eigen::Vector3d u = Eigen::Vector3d::Zero();
    for (const Part& part : of.back())
      u += part.by_velocity * at.grains.v[part.grain] + part.by_turn * at.grains.w[part.grain];
    problem.q.insert(problem.q.end(), u.data(), u.data() + 3);
    problem.friction.push_back(contact.friction);
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = 0; j < all.size(); ++j) {
      Block W = Block::Zero();
      for (const Part& p : of[i]) {
        for (const Part& r : of[j]) {
          if (p.grain != r.grain) continue;
          W += at.grains.inverse_mass[p.grain] * p.by_velocity * r.by_velocity.transpose() +
               at.grains.inverse_inertia[p.grain] * p.by_turn * r.by_turn.transpose();
        }
      }
      if (W.isZero(0)) continue;
      problem.blocks.push_back({static_cast<int>(i), static_cast<int>(j)});
      std::array<double, 9> values;
      for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) values[static_cast<std::size_t>(3 * row + column)] = W(row, column);
      }
      problem.values.push_back(values);
    }
  }
  return problem;
}

}  // namespace

double ContactSolve::residual(const std::vector<double>& impulses) const {
  std::vector<double> u = q;
  std::vector<double> weight(friction.size());
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    const auto i = static_cast<std::size_t>(blocks[k][0]), j = static_cast<std::size_t>(blocks[k][1]);
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t column = 0; column < 3; ++column)
        u[3 * i + row] += values[k][3 * row + column] * impulses[3 * j + column];
    }
    if (i == j) weight[i] = values[k][0];
  }
  double defect = 0, largest = 0;
  for (std::size_t i = 0; i < friction.size(); ++i) {
    const double N = impulses[3 * i], x = impulses[3 * i + 1], y = impulses[3 * i + 2], rho = 1 / weight[i];
    const double asked = std::max(0.0, N - rho * u[3 * i]);
    double tx = x - rho * u[3 * i + 1], ty = y - rho * u[3 * i + 2];
    const double size = std::hypot(tx, ty), bound = friction[i] * std::max(0.0, N);
    if (size > bound) tx *= bound / size, ty *= bound / size;
    defect = std::max({defect, std::abs(N - asked), std::hypot(x - tx, y - ty)});
    largest = std::max({largest, std::abs(N), std::hypot(x, y)});
  }
  return largest > 0 ? defect / largest : 0;
}

Problem spheres_in_a_box() {
  const Instant at = instant();
  const ContactSolve problem = assembled(at);
  Problem result{"100 spheres in a box, the problem of one step with " + std::to_string(problem.friction.size()) +
                     " contacts, solved from zero",
                 "residual",
                 {}};
  for (const double tolerance : {1e-3, 1e-5, 1e-7}) {
    result.ways.push_back({"torsor", "sweeps to " + number("%.0e", tolerance), [at, problem, tolerance]() -> Outcome {
                             Instant now = at;
                             GrainSolver<3> solver;
                             solver.reserve(now.grains.count());
                             ThreadTeam team(1);
                             const Stopwatch watch;
                             (void)solver.solve(now.grains, now.contacts,
                                                {.tolerance = tolerance, .most = 100000, .team = team});
                             const double seconds = watch.seconds();
                             std::vector<double> impulses;
                             for (const auto& contact : now.contacts.all()) {
                               const Eigen::Vector3d P = axes(contact.n).transpose() * contact.P;
                               impulses.insert(impulses.end(), P.data(), P.data() + 3);
                             }
                             return {seconds, problem.residual(impulses)};
                           }});
  }
#if defined(PEER_SICONOS)
  for (const Way& way : siconos_spheres(problem)) result.ways.push_back(way);
#endif
  return result;
}

}  // namespace torsor::contact_peers
