// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/forces/energy.hpp"

#include "torsor/generator/dynamics/motion/central_bodies.hpp"
#include "torsor/generator/program/derivative.hpp"
#include "torsor/generator/program/paired_cosines.hpp"

namespace torsor {

Value kinetic_energy(const Model& model) {
  const std::vector<Twist> all = twists(model);
  Value doubled;
  for (std::size_t k = 1; k < all.size(); ++k) {
    doubled += reciprocal_product(momentum(model.links()[k].mass, all[k]), all[k]);
  }
  return Number::rational(1, 2) * doubled;
}

Value kinetic_energy_about_centres(const Model& model) {
  Program& program = model.program();
  const std::vector<Twist> all = twists(model);
  Value doubled;
  for (const CentralBody& body : central_bodies(model)) {
    const Twist& twist = all[body.link];
    Vector velocity = twist.linear + cross(twist.angular, body.center);
    for (int i = 0; i < 3; ++i) velocity[i] = with_paired_cosines(program, velocity[i]);
    velocity = bound(program, velocity);
    doubled += body.mass * dot(velocity, velocity);
    doubled += dot(twist.angular, bound(program, body.inertia * twist.angular));
  }
  return Number::rational(1, 2) * doubled;
}

Value rotor_energy(const Model& model, std::size_t rotor) {
  const BodyContent& body = model.scene().rotors[rotor];
  const Link& link = model.links()[static_cast<std::size_t>(model.place(body.frame, body.name).link)];
  return Number::rational(1, 2) * link.mass.inertia(2, 2) * link.rate * link.rate;
}

Value gravity_force_function(const Model& model) {
  Program& program = model.program();
  const Vector g = lower(program, model.scene().gravity);
  Value sum;
  for (std::size_t k = 1; k < model.links().size(); ++k) {
    const MassProperties& body = model.links()[k].mass;
    const int link = static_cast<int>(k);
    const Vector origin = model.locate(Vector(), link, 0);
    const Vector moment = model.express(body.first_moment, link, 0);
    sum += body.mass * dot(g, origin);
    sum += dot(g, moment);
  }
  return sum;
}

Value kinetic_energy_from_positions(const Model& model) {
  Program& program = model.program();
  const Value one = program.number(Number(1));
  Derivation rate = time_derivation(program);
  const auto rates = [&rate](const Vector& v) { return Vector{rate(v[0]), rate(v[1]), rate(v[2])}; };
  Value doubled;
  for (std::size_t k = 1; k < model.links().size(); ++k) {
    const MassProperties& body = model.links()[k].mass;
    const int link = static_cast<int>(k);
    const Vector velocity = bound(program, rates(model.locate(Vector(), link, 0)));
    Vector axes[3];
    Vector omega;  // 2 Ω = Σ e_i ∧ ė_i
    for (int i = 0; i < 3; ++i) {
      Vector e;
      e[i] = one;
      axes[i] = bound(program, model.express(e, link, 0));
      omega += cross(axes[i], bound(program, rates(axes[i])));
    }
    omega = bound(program, Vector(Number::rational(1, 2) * omega[0], Number::rational(1, 2) * omega[1],
                                  Number::rational(1, 2) * omega[2]));
    Vector turn;  // Ω in the link's axes, where its inertia operator is constant
    for (int i = 0; i < 3; ++i) turn[i] = program.bind(dot(axes[i], omega));
    Vector moment;  // m OG in the ground's axes
    for (int i = 0; i < 3; ++i) moment += body.first_moment[i] * axes[i];
    doubled += body.mass * dot(velocity, velocity);
    doubled += Number(2) * dot(velocity, cross(omega, bound(program, moment)));
    doubled += dot(turn, bound(program, body.inertia * turn));
  }
  return Number::rational(1, 2) * doubled;
}

std::vector<Value> turning_terms(const Model& model, const std::vector<Value>& momenta) {
  std::vector<Value> terms(momenta.size());
  for (std::size_t i = 0; i + 2 < momenta.size(); ++i) {
    const std::optional<int> attitude = model.coordinates()[i].attitude;
    if (!attitude || (i > 0 && model.coordinates()[i - 1].attitude == attitude)) continue;
    const int first = static_cast<int>(i);
    const Vector omega{model.v(first), model.v(first + 1), model.v(first + 2)};
    const Vector bound_momenta = bound(model.program(), Vector{momenta[i], momenta[i + 1], momenta[i + 2]});
    const Vector term = cross(omega, bound_momenta);
    for (int k = 0; k < 3; ++k) terms[i + static_cast<std::size_t>(k)] = term[k];
  }
  return terms;
}

std::vector<Value> lagrange_operator(const Model& model, const Value& kinetic_energy) {
  std::vector<SymbolPointer> velocities;
  for (const CoordinateContent& c : model.coordinates()) velocities.push_back(c.v);
  if (kinetic_energy.is_zero()) return std::vector<Value>(velocities.size());
  const std::vector<Value> along_q = gradient_along(kinetic_energy, velocities);
  const std::vector<Value> momenta = gradient(kinetic_energy, velocities);
  Derivation rate = time_derivation(model.program());
  std::vector<Value> result;
  const std::vector<Value> turning = turning_terms(model, momenta);
  for (std::size_t i = 0; i < velocities.size(); ++i) result.push_back(rate(momenta[i]) - along_q[i] + turning[i]);
  return result;
}

}  // namespace torsor
