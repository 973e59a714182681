// SPDX-License-Identifier: GPL-3.0-or-later
// Discs that settle in a box and a pile of six discs that must collapse: ours beside Box2D and Chipmunk where they are
// installed. Times are of the processor, in one run.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "benchmarks/contacts/box_of_discs.hpp"
#include "runtime/grains/grain_motion.hpp"
#if defined(TORSOR_BOX2D)
#include <box2d/box2d.h>
#endif
#if defined(TORSOR_CHIPMUNK)
#include <chipmunk/chipmunk.h>
#endif

namespace {

using namespace torsor::runtime;

// Peers are made for bodies of some decimetres to metres: lengths and gravity are given to them in this unit.
constexpr double unit = 0.02;

/// Moves the grains by a step.
using Stepper = std::function<void(double)>;

#if defined(TORSOR_BOX2D)
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

#if defined(TORSOR_CHIPMUNK)
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
Grains<2> six_discs() {
  Grains<2> grains;
  grains.gravity = {0, -1};
  grains.friction = 0.4;
  grains.walls.push_back({.friction = 0.4});
  for (int row = 0; row < 3; ++row) {
    for (int i = 0; i < 3 - row; ++i) grains.add({i + 0.5 * row, 0.5 + row * std::sqrt(3.0) / 2}, 0.5, 1);
  }
  return grains;
}

void measure(const std::string& name, int count, int steps, const std::function<Stepper(Grains<2>&)>& with) {
  Grains<2> grains = box_of_discs(count, static_cast<int>(1.5 * std::sqrt(count)));
  const Stepper step = with(grains);
  const std::clock_t start = std::clock();
  for (int k = 0; k < steps; ++k) step(1e-3);
  const double ms = 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / steps;
  Grains<2> pile = six_discs();
  const Stepper once = with(pile);
  constexpr double h = 0.01;
  once(h);
  std::printf("%-34s %10.3f %12.2e %14.2e %18.2e\n", name.c_str(), ms, 1e3 * deepest(grains), grains.kinetic_energy(),
              std::abs(pile.v[5](1) / h + 0.0605946584846100378));
}

}  // namespace

int main(int argc, char** argv) {
  const int count = argc > 1 ? std::atoi(argv[1]) : 1000, steps = argc > 2 ? std::atoi(argv[2]) : 1000;
  if (count < 1 || steps < 1 || argc > 3) {
    std::fprintf(stderr, "usage: contact_peers [discs [steps]]\n");
    return 2;
  }
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  std::printf("%d discs settle in %d steps of 1 ms; a pile of six\n\n%-34s %10s %12s %14s %18s\n", count, steps, "",
              "ms a step", "overlap/mm", "energy left/J", "acceleration off");
  for (const auto& options :
       {GrainOptions{.tolerance = 1e-2, .sweeps = 30}, GrainOptions{.tolerance = 1e-4, .sweeps = 100},
        GrainOptions{.tolerance = 1e-6, .sweeps = 300}}) {
    char name[64];
    std::snprintf(name, sizeof name, "torsor, %.0e, at most %d sweeps", options.tolerance, options.sweeps);
    measure(name, count, steps, [&options](Grains<2>& grains) -> Stepper {
      const auto motion = std::make_shared<GrainMotion<2>>(grains, options);
      return [motion](double h) { (void)motion->step(h); };
    });
  }
#if defined(TORSOR_BOX2D)
  for (const int iterations : {8, 30, 100}) {
    measure("Box2D, " + std::to_string(iterations) + " iterations", count, steps,
            [iterations](Grains<2>& grains) -> Stepper {
              const auto peer = std::make_shared<Box2d>(grains, iterations);
              return [peer](double h) { (*peer)(h); };
            });
  }
#endif
#if defined(TORSOR_CHIPMUNK)
  for (const int iterations : {10, 30, 100}) {
    measure("Chipmunk, " + std::to_string(iterations) + " iterations", count, steps,
            [iterations](Grains<2>& grains) -> Stepper {
              const auto peer = std::make_shared<Chipmunk>(grains, iterations);
              return [peer](double h) { (*peer)(h); };
            });
  }
#endif
  return 0;
}
