// SPDX-License-Identifier: GPL-3.0-or-later
// Simbody: contacts by Hunt and Crossley's law, and friction that grows with the slip up to a transition velocity.
#include <Simbody.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "benchmarks/contact_peers/closed_forms.hpp"
#include "benchmarks/contact_peers/peers.hpp"

namespace torsor::contact_peers {
namespace {

using namespace SimTK;

Outcome roll(double stiffness, double transition, double accuracy) {
  MultibodySystem system;
  SimbodyMatterSubsystem matter(system);
  GeneralForceSubsystem forces(system);
  const Force::UniformGravity gravity(forces, matter, Vec3(0, 0, -billiard::g));
  GeneralContactSubsystem contacts(system);
  const ContactSetIndex set = contacts.createContactSet();
  const Body::Rigid body(
      MassProperties(billiard::mass, Vec3(0), billiard::mass * UnitInertia::sphere(billiard::radius)));
  MobilizedBody::Free ball(matter.Ground(), Transform(), body, Transform());
  contacts.addBody(set, ball, ContactGeometry::Sphere(billiard::radius), Transform());
  contacts.addBody(set, matter.updGround(), ContactGeometry::HalfSpace(), Transform(Rotation(Pi / 2, YAxis), Vec3(0)));
  HuntCrossleyForce law(forces, contacts, set);
  for (int surface = 0; surface < 2; ++surface) {
    law.setBodyParameters(ContactSurfaceIndex(surface), stiffness, 1, billiard::friction, billiard::friction, 0);
  }
  law.setTransitionVelocity(transition);
  system.realizeTopology();
  State state = system.getDefaultState();
  ball.setQToFitTranslation(state, Vec3(0, 0, billiard::radius));
  ball.setUToFitLinearVelocity(state, Vec3(billiard::speed, 0, 0));
  RungeKuttaMersonIntegrator integrator(system);
  integrator.setAccuracy(accuracy);
  TimeStepper stepper(system, integrator);
  stepper.initialize(state);
  const Stopwatch watch;
  stepper.stepTo(billiard::end);
  const double seconds = watch.seconds();
  return {seconds, std::abs(ball.getBodyOriginLocation(integrator.getState())[0] - billiard::place())};
}

}  // namespace

std::vector<Way> simbody_billiard() {
  struct Setting {
    double stiffness, transition, accuracy;
  };
  std::vector<Way> ways;
  for (const Setting& each : {Setting{1e6, 1e-2, 1e-3}, Setting{1e8, 1e-3, 1e-4}, Setting{1e8, 1e-4, 1e-6}}) {
    char name[96];
    std::snprintf(name, sizeof name, "stiffness %.0e, transition %.0e m/s, accuracy %.0e", each.stiffness,
                  each.transition, each.accuracy);
    ways.push_back({"Simbody", name, [each] { return roll(each.stiffness, each.transition, each.accuracy); }});
  }
  return ways;
}

}  // namespace torsor::contact_peers
