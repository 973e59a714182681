// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/theorems/newton_euler.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/dynamics/forces/constraint_wrench.hpp"
#include "torsor/generator/dynamics/motion/inertia_wrench.hpp"
#include "torsor/generator/dynamics/theorems/joint_reactions.hpp"

namespace torsor {
namespace {

template <class Kind>
Screw<Kind> bound_screw(Program& program, const Screw<Kind>& screw) {
  const Vector resultant = bound(program, screw.resultant);
  return {resultant, bound(program, screw.moment)};
}

Wrench weight_at_origin(const Model& model, int link, const MassProperties& mass) {
  const Vector g = model.express(lower(model.program(), model.scene().gravity), 0, link);
  const Vector force = mass.mass * g;
  return {force, cross(mass.first_moment, bound(model.program(), g))};
}

/// Σ λ_j × unit wrench on each link.
WrenchOnLinks constraint_wrenches(const Equations& equations) {
  Program& program = equations.program();
  WrenchOnLinks sum;
  for (std::size_t j = 0; j < equations.constraints().size(); ++j) {
    const auto unit = constraint_wrench(equations.model(), static_cast<int>(j));
    if (!unit) continue;
    const Value lambda = program.symbol(equations.constraints()[j].multiplier);
    for (const auto& [link, wrench] : *unit) sum[link] = sum[link] + lambda * wrench;
  }
  return sum;
}

Wrench sum_as_asked(const Model& model, const WrenchOnLinks& wrenches, const std::vector<bool>& inside,
                    const ScrewQuery& query) {
  Wrench sum;
  for (const auto& [link, wrench] : wrenches) {
    if (inside[static_cast<std::size_t>(link)]) sum = sum + as_asked(model, wrench, link, query);
  }
  return bound_screw(model.program(), sum);
}

/// A link that is not settled is isolated where all that it carries is. True of those that carry something.
std::vector<bool> go_with_what_they_carry(const Model& model, const std::vector<bool>& massive, const std::vector<bool>& settled,
                                          std::vector<bool>& inside) {
  const std::size_t count = inside.size();
  std::vector<bool> carries(count, false), carries_outside(count, false);
  for (std::size_t k = count; k-- > 1;) {
    if (!settled[k]) inside[k] = carries[k] && !carries_outside[k];
    const auto parent = static_cast<std::size_t>(model.links()[k].parent);
    const bool counts = massive[k] || carries[k];
    carries[parent] = carries[parent] || counts;
    carries_outside[parent] = carries_outside[parent] || (counts && !inside[k]);
  }
  return carries;
}

}  // namespace

std::vector<bool> isolated_links(const Equations& equations, const BodyNames& names, const std::string& user) {
  const Model& model = equations.model();
  const auto& bodies = model.scene().bodies;
  const std::vector<int> asked = body_indices(model, names, user);
  const std::size_t count = model.links().size();
  std::vector<bool> inside(count, false), massive(count, false);
  const auto link_of = [&](const BodyContent& body) {
    return static_cast<std::size_t>(model.place(body.frame, "body '" + body.name + "'").link);
  };
  for (const int index : asked) inside[link_of(bodies[static_cast<std::size_t>(index)])] = true;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const std::size_t link = link_of(bodies[b]);
    massive[link] = true;
    if (!inside[link] || std::binary_search(asked.begin(), asked.end(), static_cast<int>(b))) continue;
    throw SceneError(
        fmt::format("{} isolates part of a rigid body: '{}' is fixed to what is asked for; name it too, or "
                    "put a joint with a released coordinate between them",
                    user, bodies[b].name));
  }
  if (inside[0]) {
    BodyNames fixed;
    for (const int index : asked) {
      const BodyContent& body = bodies[static_cast<std::size_t>(index)];
      if (link_of(body) == 0) fixed.push_back(body.name);
    }
    throw SceneError(fmt::format(
        "{} isolates {}, part of the ground, which nothing moves: leave that out, or release a coordinate", user,
        fmt::join(fixed, ", ")));
  }
  const std::vector<bool> carries = go_with_what_they_carry(model, massive, massive, inside);
  // A link without mass that stands for itself is a body of mass 0: it is in between where what carries it is isolated.
  const std::vector<bool> stands = standing_links(equations);
  std::vector<bool> settled = massive;
  for (std::size_t k = 1; k < count; ++k) {
    if (massive[k] || !stands[k] || !carries[k]) continue;
    settled[k] = true;
    auto below = static_cast<std::size_t>(model.links()[k].parent);
    while (!stands[below]) below = static_cast<std::size_t>(model.links()[below].parent);
    inside[k] = inside[k] && inside[below];
  }
  go_with_what_they_carry(model, massive, settled, inside);
  for (std::size_t k = 1; k < count; ++k) {  // one that carries nothing goes with what carries it
    if (!massive[k] && !carries[k]) inside[k] = inside[static_cast<std::size_t>(model.links()[k].parent)];
  }
  return inside;
}

NewtonEuler newton_euler(const Equations& equations, const BodyNames& bodies, const ScrewQuery& query) {
  const std::string user = "Newton-Euler's theorem";
  const Model& model = equations.model();
  Program& program = equations.program();
  const std::vector<bool> inside = isolated_links(equations, bodies, user);
  NewtonEuler theorem;
  theorem.dynamic = dynamic_screw(model, bodies, query);
  WrenchOnLinks weights;
  for (const auto& [link, mass] : mass_by_link(model, bodies, user))
    weights[link] = weight_at_origin(model, link, mass);
  theorem.weight = sum_as_asked(model, weights, inside, query);
  theorem.applied = sum_as_asked(model, equations.actions().wrenches, inside, query);
  if (model.place(query.observer, user).link != 0) {
    const Wrench transport = transport_inertia_wrench(model, bodies, query);
    theorem.inertia = bound_screw(program, transport + coriolis_inertia_wrench(model, bodies, query));
  }
  theorem.constraints = sum_as_asked(model, constraint_wrenches(equations), inside, query);
  const Wrench known = theorem.weight + theorem.applied + theorem.inertia + theorem.constraints;
  theorem.transmitted =
      bound_screw(program, Wrench{theorem.dynamic.resultant - known.resultant, theorem.dynamic.moment - known.moment});
  return theorem;
}

NewtonEulerEquation newton_euler_along(const Equations& equations, const BodyNames& bodies, const TheoremQuery& query) {
  const NewtonEuler all = newton_euler(equations, bodies, query.screw);
  const Vector u = lower(equations.program(), query.direction);
  const auto along = [&](const auto& screw) {
    return equations.program().bind(dot(query.theorem == Theorem::resultant ? screw.resultant : screw.moment, u));
  };
  NewtonEulerEquation equation;
  equation.dynamic = along(all.dynamic);
  equation.known = along(all.weight + all.applied + all.inertia);
  equation.constraints = along(all.constraints);
  equation.transmitted = along(all.transmitted);
  return equation;
}

std::vector<Wrench> transmitted_wrenches(const Equations& equations) {
  const Model& model = equations.model();
  Program& program = equations.program();
  const auto& links = model.links();
  const WrenchOnLinks of_constraints = constraint_wrenches(equations);
  std::vector<Wrench> all(links.size());
  for (std::size_t k = links.size(); k-- > 1;) {
    const int link = static_cast<int>(k);
    const DynamicScrew dynamic = dynamic_screw_at_origin(program, links[k].mass, body_motion(model, link, 0));
    Wrench load = all[k] + Wrench{dynamic.resultant, dynamic.moment};  // all[k] holds the children's
    load = load - weight_at_origin(model, link, links[k].mass);
    for (const WrenchOnLinks* given : {&equations.actions().wrenches, &of_constraints}) {
      if (const auto place = given->find(link); place != given->end()) load = load - place->second;
    }
    all[k] = bound_screw(program, load);
    if (links[k].parent == 0) continue;
    const Vector force = bound(program, model.to_parent(links[k], all[k].resultant));
    const Vector moment = model.to_parent(links[k], all[k].moment);
    const Vector origin = bound(program, model.origin_in_parent(links[k]));
    Wrench& parent = all[static_cast<std::size_t>(links[k].parent)];
    parent = parent + Wrench{force, moment + cross(origin, force)};
  }
  return all;
}

namespace {

int joint_of(const Model& model, const FrameReference& frame) {
  const std::string user = "a transmitted wrench";
  const int link = model.place(frame, user).link;
  if (link != 0) return link;
  throw SceneError("no joint carries the ground: ask for the wrench transmitted to a frame that moves");
}

}  // namespace

Wrench transmitted_wrench(const Equations& equations, const FrameReference& frame) {
  return transmitted_wrenches(equations)[static_cast<std::size_t>(joint_of(equations.model(), frame))];
}

Wrench transmitted_wrench(const Equations& equations, const FrameReference& frame, const ScrewQuery& query) {
  const Wrench own = transmitted_wrench(equations, frame);
  return bound_screw(equations.program(), as_asked(equations.model(), own, joint_of(equations.model(), frame), query));
}

}  // namespace torsor
