// SPDX-License-Identifier: GPL-3.0-or-later
// Discs that settle in a box, and a pile of six that must collapse.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "benchmarks/contact_peers/ours.hpp"
#include "benchmarks/contact_peers/problems.hpp"
#include "benchmarks/contacts/box_of_discs.hpp"
#include "torsor/runtime/grains/grain_motion.hpp"
#if defined(PEER_BOX2D)
#include <box2d/box2d.h>
#endif
#if defined(PEER_CHIPMUNK)
#include <chipmunk/chipmunk.h>
#endif

namespace torsor::contact_peers {
namespace {

using namespace runtime;
// Peers are made for bodies of some decimetres to metres: lengths and gravity are given to them in this unit.
constexpr double unit = 0.02;

/// Moves the grains by a step.
using Stepper = std::function<void(double)>;

#if defined(PEER_BOX2D)
class Box2d {
 public:
  Box2d(Grains<2>& grains, int iterations) : grains_(grains), iterations_(iterations), world_({0, 0}) {
    world_.SetGravity({static_cast<float>(grains.gravity(0) / unit), static_cast<float>(grains.gravity(1) / unit)});
    for (const auto& wall : grains.walls) {
      b2BodyDef definition;
      const Eigen::Vector2d along(-wall.normal(1), wall.normal(0)), a = (wall.point - 100 * along) / unit,
                                                                    b = (wall.point + 100 * along) / unit;
      b2EdgeShape edge;
      edge.SetTwoSided({static_cast<float>(a(0)), static_cast<float>(a(1))},
                       {static_cast<float>(b(0)), static_cast<float>(b(1))});
      world_.CreateBody(&definition)->CreateFixture(&edge, 0)->SetFriction(static_cast<float>(wall.friction));
    }
    for (std::size_t i = 0; i < grains.count(); ++i) {
      b2BodyDef definition;
      definition.type = b2_dynamicBody;
      definition.position = {static_cast<float>(grains.x[i](0) / unit), static_cast<float>(grains.x[i](1) / unit)};
      b2CircleShape circle;
      circle.m_radius = static_cast<float>(grains.radius[i] / unit);
      b2FixtureDef fixture;
      fixture.shape = &circle;
      fixture.density = static_cast<float>(1 / grains.inverse_mass[i] / (b2_pi * circle.m_radius * circle.m_radius));
      fixture.friction = static_cast<float>(grains.friction);
      bodies_.push_back(world_.CreateBody(&definition));
      bodies_.back()->CreateFixture(&fixture);
    }
  }
  void operator()(double h) {
    world_.Step(static_cast<float>(h), iterations_, std::max(3, iterations_ / 3));
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const b2Vec2 x = bodies_[i]->GetPosition(), v = bodies_[i]->GetLinearVelocity();
      grains_.x[i] = {unit * x.x, unit * x.y};
      grains_.v[i] = {unit * v.x, unit * v.y};
      grains_.w[i](0) = bodies_[i]->GetAngularVelocity();
    }
  }

 private:
  Grains<2>& grains_;
  int iterations_;
  b2World world_;
  std::vector<b2Body*> bodies_;
};
#endif

#if defined(PEER_CHIPMUNK)
class Chipmunk {
 public:
  Chipmunk(Grains<2>& grains, int iterations) : grains_(grains), space_(cpSpaceNew()) {
    cpSpaceSetIterations(space_, iterations);
    cpSpaceSetCollisionSlop(space_, 1e-4);
    cpSpaceSetGravity(space_, cpv(grains.gravity(0) / unit, grains.gravity(1) / unit));
    for (const auto& wall : grains.walls) {
      const Eigen::Vector2d along(-wall.normal(1), wall.normal(0)), a = (wall.point - 100 * along) / unit,
                                                                    b = (wall.point + 100 * along) / unit;
      cpShape* shape =
          cpSpaceAddShape(space_, cpSegmentShapeNew(cpSpaceGetStaticBody(space_), cpv(a(0), a(1)), cpv(b(0), b(1)), 0));
      cpShapeSetFriction(shape, wall.friction / std::sqrt(grains.friction));  // the product of both is taken
    }
    for (std::size_t i = 0; i < grains.count(); ++i) {
      const double m = 1 / grains.inverse_mass[i], R = grains.radius[i] / unit;
      cpBody* body = cpSpaceAddBody(space_, cpBodyNew(m, cpMomentForCircle(m, 0, R, cpvzero)));
      cpBodySetPosition(body, cpv(grains.x[i](0) / unit, grains.x[i](1) / unit));
      cpShapeSetFriction(cpSpaceAddShape(space_, cpCircleShapeNew(body, R, cpvzero)), std::sqrt(grains.friction));
      bodies_.push_back(body);
    }
  }
  void operator()(double h) {
    cpSpaceStep(space_, h);
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const cpVect x = cpBodyGetPosition(bodies_[i]), v = cpBodyGetVelocity(bodies_[i]);
      grains_.x[i] = {unit * x.x, unit * x.y};
      grains_.v[i] = {unit * v.x, unit * v.y};
      grains_.w[i](0) = cpBodyGetAngularVelocity(bodies_[i]);
    }
  }

 private:
  Grains<2>& grains_;
  cpSpace* space_;
  std::vector<cpBody*> bodies_;
};
#endif

double deepest(const Grains<2>& grains) {
  double depth = 0;
  for (std::size_t i = 0; i < grains.count(); ++i) {
    for (std::size_t j = i + 1; j < grains.count(); ++j) {
      depth = std::max(depth, grains.radius[i] + grains.radius[j] - (grains.x[i] - grains.x[j]).norm());
    }
    for (const auto& wall : grains.walls) depth = std::max(depth, -wall_gap(wall, grains.x[i], grains.radius[i]).gap);
  }
  return depth;
}

/// Six discs of 1 m and 1 kg in a pile, f = 0.4, g = 1: the top one's acceleration is known (tests/grains).
Grains<2> pile() {
  Grains<2> grains;
  grains.gravity = {0, -1};
  grains.friction = 0.4;
  grains.walls.push_back({.friction = 0.4});
  for (int row = 0; row < 3; ++row) {
    for (int i = 0; i < 3 - row; ++i) grains.add({i + 0.5 * row, 0.5 + row * std::sqrt(3.0) / 2}, 0.5, 1);
  }
  return grains;
}

/// What moves the grains, and how that is called.
struct Mover {
  std::string who, setting;
  std::function<Stepper(Grains<2>&)> with;
};

std::vector<Mover> movers() {
  std::vector<Mover> all;
  for (const auto& options :
       {GrainOptions{.tolerance = 1e-2, .sweeps = 30}, GrainOptions{.tolerance = 1e-4, .sweeps = 100},
        GrainOptions{.tolerance = 1e-6, .sweeps = 300}}) {
    const std::string setting =
        number("residual %.0e", options.tolerance) + number(", at most %.0f sweeps", options.sweeps);
    all.push_back({"torsor", setting, [options](Grains<2>& grains) -> Stepper {
                     const auto motion = std::make_shared<GrainMotion<2>>(grains, options);
                     return [motion](double h) { (void)motion->step(h); };
                   }});
  }
#if defined(PEER_BOX2D)
  for (const int iterations : {8, 30, 100}) {
    all.push_back({"Box2D", std::to_string(iterations) + " iterations", [iterations](Grains<2>& grains) -> Stepper {
                     const auto peer = std::make_shared<Box2d>(grains, iterations);
                     return [peer](double h) { (*peer)(h); };
                   }});
  }
#endif
#if defined(PEER_CHIPMUNK)
  for (const int iterations : {10, 30, 100}) {
    all.push_back({"Chipmunk", std::to_string(iterations) + " iterations", [iterations](Grains<2>& grains) -> Stepper {
                     const auto peer = std::make_shared<Chipmunk>(grains, iterations);
                     return [peer](double h) { (*peer)(h); };
                   }});
  }
#endif
  return all;
}

}  // namespace

Problem discs_that_settle(int discs, int steps) {
  Problem problem{std::to_string(discs) + " discs of 8 to 12 mm settle in " + std::to_string(steps) + " steps of 1 ms",
                  "overlap left [m]",
                  {}};
  for (const Mover& mover : movers()) {
    problem.ways.push_back({mover.who, mover.setting, [mover, discs, steps]() -> Outcome {
                              Grains<2> grains = box_of_discs(discs, static_cast<int>(1.5 * std::sqrt(discs)));
                              const Stepper step = mover.with(grains);
                              const Stopwatch watch;
                              for (int k = 0; k < steps; ++k) step(1e-3);
                              return {watch.seconds(), deepest(grains)};
                            }});
  }
  return problem;
}

Problem six_discs() {
  Problem problem{"A pile of six discs, f = 0.4, collapses: 100 times its first step of 10 ms; closed form",
                  "acceleration [m/s^2]",
                  {}};
  for (const Mover& mover : movers()) {
    problem.ways.push_back({mover.who, mover.setting, [mover]() -> Outcome {
                              constexpr double h = 0.01;
                              Outcome outcome{};
                              for (int k = 0; k < 100; ++k) {
                                Grains<2> grains = pile();
                                const Stepper step = mover.with(grains);
                                const Stopwatch watch;
                                step(h);
                                outcome.seconds += watch.seconds();
                                outcome.error = std::abs(grains.v[5](1) / h + 0.0605946584846100378);
                              }
                              return outcome;
                            }});
  }
  return problem;
}

}  // namespace torsor::contact_peers
