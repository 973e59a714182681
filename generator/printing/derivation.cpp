// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/printing/derivation.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "torsor/generator/base/as_index.hpp"
#include "torsor/generator/dynamics/forces/energy.hpp"
#include "torsor/generator/dynamics/forces/selected_actions.hpp"
#include "torsor/generator/dynamics/motion/frame_motion.hpp"
#include "torsor/generator/dynamics/theorems/joint_reactions.hpp"
#include "torsor/generator/dynamics/theorems/newton_euler.hpp"
#include "torsor/generator/mechanics/uncounted_contacts.hpp"
#include "torsor/generator/printing/limit_met.hpp"
#include "torsor/generator/printing/notation.hpp"

namespace torsor::printing {
namespace {

constexpr std::size_t most_bodies = 8;   ///< that a person follows one by one
constexpr std::size_t most_actions = 20;
constexpr std::size_t most_axes = 6;     ///< frames that are tried for the shortest components

ModelOptions symbolic() {
  ModelOptions options;
  options.symbolic_parameters = true;
  return as_given(std::move(options));
}

/// Adds a point at the centre of mass of each body, with a name that is still free.
std::vector<PointHandle> add_centres(Scene& scene) {
  std::vector<PointHandle> centres;
  const std::vector<BodyContent> bodies = scene.content().bodies;  // a copy: the scene grows
  for (const BodyContent& body : bodies) {
    std::string name = "G_" + body.name;
    while (scene.content().names.count(name) > 0) name += "_";
    centres.push_back(scene.point(name, body.frame, body.inertia.center));
  }
  return centres;
}

/// How components of a vector are called: R_arm[1], and R[1] where the name is no identifier, for it is data.
std::string entry_of(const std::string& letter, const std::string& name) {
  return named_object(name).latex.starts_with("\\text") ? letter : letter + "_" + name;
}

/// The coordinate and its rate, or twice the angular velocity of an attitude.
std::pair<Spelling, Spelling> spelled(const CoordinateContent& c) {
  const auto both = [](const std::string& name) { return Spelling{name, latex_name(name)}; };
  if (c.attitude) return {both(c.v->name), both(c.v->name)};
  return {both(c.q->name), both(c.q->name + "'")};
}

}  // namespace

Derivation::Derivation(const Scene& scene, const InlineLimits& limits, Page& page)
    : scene_(scene),
      centres_(add_centres(scene_)),
      equations_(scene_, symbolic()),
      view_(equations_.program(), limits, scene_.content()),
      page_(page) {}

bool Derivation::too_many(std::size_t count, std::size_t most, const std::string& what) {
  if (count <= most) return false;
  page_.note(page_.say("Not written one by one: there are {} {}, and a page is for {} at most.", count, what, most));
  return true;
}

std::size_t Derivation::length(const Vector& vector) {
  std::size_t sum = 0;
  for (int i = 0; i < 3; ++i) {
    if (vector[i].is_zero()) continue;
    const std::optional<Sum> written = view_.sum(vector[i]);
    if (!written) return std::numeric_limits<std::size_t>::max() / 4;
    sum += text(collected(*written)).size();
  }
  return sum;
}

void Derivation::choose_axes(BodyAtCentre& body, const FrameReference& frame) {
  const SceneContent& content = scene_.content();
  const Twist at_origin = relative_twist(equations_.model(), body.link, 0);
  std::size_t best = std::numeric_limits<std::size_t>::max(), tried = 0;
  // From the body to the ground; among equals the nearest to the body.
  for (int k = content.frame_index(frame, "body '" + body.name + "'");; ++tried) {
    const FrameContent& here = content.frames[as_index(k)];
    const bool ground = !here.parent;
    if (ground || tried < most_axes) {
      const ScrewQuery query{body.query.point, FrameHandle{k}, "ground"};
      const Twist twist = as_asked(equations_.model(), at_origin, body.link, query);
      const std::size_t size = length(twist.angular) + length(twist.linear);
      if (size < best) {
        best = size;
        body.query = query;
        body.axes = here.name;
      }
    }
    if (ground) return;
    k = content.frame_index(*here.parent, "frame '" + here.name + "'");
  }
}

void Derivation::vector(const Spelling& name, const std::string& entry, const Vector& vector) {
  std::vector<std::vector<Written>> rows;
  for (int i = 0; i < 3; ++i) {
    const std::optional<Sum> sum = vector[i].is_zero() ? Sum() : view_.sum(vector[i]);
    if (!sum) {
      page_.note(page_.say("{} is too long to be written out: {}.", name.plain, limit_met(view_, vector[i], page_.say)));
      return;
    }
    rows.push_back({collected(*sum)});
  }
  page_.matrix(name, entry, rows);
}

void Derivation::formula(const Spelling& left, const Value& value, const std::string& remark) {
  const std::optional<Sum> sum = value.is_zero() ? Sum() : view_.sum(value);
  if (sum) {
    page_.stated(left, collected(*sum), remark);
  } else {
    page_.note(page_.say("{} is too long to be written out: {}.", left.plain, limit_met(view_, value, page_.say)));
  }
}

void Derivation::screws() {
  page_.step(page_.say("Twist and momentum screw of each body at its centre of mass"));
  const std::vector<BodyContent>& bodies = scene_.content().bodies;
  if (too_many(bodies.size(), most_bodies, page_.say("bodies"))) return;
  page_.formula(page_.say("{Omega; V(G)} and {m V(G); sigma_G}, sigma_G = J_G Omega."),
                page_.say("$\\left\\{\\vec{\\Omega}\\,;\\ \\vec{V}(G)\\right\\}$ and $\\left\\{m \\vec{V}(G)\\,;\\ "
                          "\\vec{\\sigma}_G\\right\\}$, $\\vec{\\sigma}_G = J_G\\,\\vec{\\Omega}$."));
  const Model& model = equations_.model();
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const std::string& name = bodies[k].name;
    BodyAtCentre body{name, model.place(bodies[k].frame, "body '" + name + "'").link, {centres_[k], "ground", "ground"}, {}};
    choose_axes(body, bodies[k].frame);
    page_.note(page_.say("{}, along the axes of {}:", name, body.axes));
    const Twist twist = as_asked(model, relative_twist(model, body.link, 0), body.link, body.query);
    const MomentumScrew momentum = momentum_screw(model, {name}, body.query);
    const std::string who = named_object(name).latex;
    vector({fmt::format("Omega({})", name), fmt::format("\\vec{{\\Omega}}({})", who)}, entry_of("Omega", name), twist.angular);
    vector({page_.say("V(G of {})", name), fmt::format("\\vec{{V}}(G_{{{}}})", who)}, entry_of("V", name), twist.linear);
    vector({fmt::format("sigma_G({})", name), fmt::format("\\vec{{\\sigma}}_G({})", who)}, entry_of("sigma", name), momentum.moment);
  }
}

void Derivation::kinetic_energies() {
  page_.step(page_.say("Kinetic energy, body by body"));
  const std::vector<BodyContent>& bodies = scene_.content().bodies;
  if (too_many(bodies.size(), most_bodies, page_.say("bodies"))) return;
  page_.formula(page_.say("T = 1/2 (m V(G)^2 + sigma_G . Omega), in J."),
                page_.say("$T = \\frac{1}{2}\\left(m \\vec{V}(G)^2 + \\vec{\\sigma}_G \\cdot \\vec{\\Omega}\\right)$, in J."));
  for (const BodyContent& body : bodies) {
    formula({fmt::format("T({})", body.name), fmt::format("T({})", named_object(body.name).latex)},
            kinetic_energy(equations_.model(), {body.name}));
  }
  const std::vector<BodyContent>& rotors = scene_.content().rotors;
  for (std::size_t k = 0; k < rotors.size(); ++k) {
    formula({fmt::format("T({})", rotors[k].name), fmt::format("T({})", named_object(rotors[k].name).latex)},
            rotor_energy(equations_.model(), k));
  }
}

void Derivation::partial_derivatives(const std::vector<LagrangeEquation>& equations) {
  page_.step(page_.say("Partial derivatives of the kinetic energy"));
  bool left_out = false;
  const auto write = [&](const Spelling& left, const std::optional<Sum>& sum, const Layout& layout) {
    if (sum) page_.stated(left, collected(*sum, layout), "");
    left_out = left_out || !sum;
  };
  for (const LagrangeEquation& equation : equations) {
    const auto [q, rate] = spelled(equation.coordinate);
    const LagrangeSteps& steps = equation.steps;
    const Spelling momentum{fmt::format("dT/d({})", rate.plain), fmt::format("\\frac{{\\partial T}}{{\\partial {}}}", rate.latex)};
    write(momentum, steps.momentum, {});
    write({fmt::format("d/dt {}", momentum.plain), fmt::format("\\frac{{\\mathrm{{d}}}}{{\\mathrm{{d}}t}} {}", momentum.latex)},
          steps.rate, {equation.coordinate.a});
    if (equation.coordinate.attitude) continue;
    write({fmt::format("dT/d({})", q.plain), fmt::format("\\frac{{\\partial T}}{{\\partial {}}}", q.latex)}, steps.along, {});
  }
  if (left_out) page_.note(page_.say("Those that are missing are too long to be written out: more than {} terms.", view_.limits().terms));
}

void Derivation::forces() {
  page_.step(page_.say("Generalised forces, action by action"));
  const Model& model = equations_.model();
  const SceneContent& content = scene_.content();
  std::vector<std::string> names;
  const bool weighs = !gravity_force_function(model).is_zero();
  if (weighs) names.emplace_back("gravity");
  for (const ActionContent& action : content.actions) names.push_back(name_of(action));
  if (names.empty()) page_.note(page_.say("No action works."));
  if (too_many(names.size(), most_actions, page_.say("actions"))) return;
  for (const std::string& name : names) {
    const SelectedActions selected = selected_actions(model, {{name}, {}});
    const bool none = std::all_of(selected.forces.begin(), selected.forces.end(), [](const Value& q) { return q.is_zero(); });
    const std::string who = name == "gravity" && weighs ? page_.say("gravity") : name;
    page_.note(none ? page_.say("{}: no coordinate that is free makes it work.", who) : page_.say("{}:", who));
    if (!selected.force_function.is_zero()) formula({"U", "U"}, selected.force_function);
    for (std::size_t i = 0; i < selected.forces.size(); ++i) {
      if (selected.forces[i].is_zero()) continue;
      const Spelling q = spelled(model.coordinates()[i]).first;
      formula({"Q_" + q.plain, fmt::format("Q_{{{}}}", q.latex)}, selected.forces[i]);
    }
  }
  for (const ContactFriction& friction : content.frictions) {
    page_.note(page_.say("{}: friction, in proportion to the multiplier of its contact.", friction.name));
  }
}

void Derivation::reactions() {
  page_.step(page_.say("What joints transmit"));
  const std::vector<Connection> joints = connections(equations_);
  if (too_many(joints.size(), most_bodies, page_.say("joints"))) return;
  page_.note(
      page_.say("By Newton-Euler for what hangs on the joint: force R [N] and moment M [N m] on the body, at the origin of its "
                "frame, along its axes. Motors and springs in the joint are part of them."));
  for (const std::string& sentence : uncounted_contacts(scene_.content(), page_.say)) page_.note(sentence);
  const std::vector<Wrench> transmitted = transmitted_wrenches(equations_);
  for (const Connection& joint : joints) {
    const std::string& body = equations_.model().links()[as_index(joint.bottom)].name;
    page_.note(page_.say("{}, on {}:", joint.name, body));
    const std::string who = named_object(joint.name).latex;
    const Wrench& wrench = transmitted[as_index(joint.bottom)];
    vector({fmt::format("R({})", joint.name), fmt::format("\\vec{{R}}({})", who)}, entry_of("R", joint.name), wrench.resultant);
    vector({fmt::format("M({})", joint.name), fmt::format("\\vec{{M}}({})", who)}, entry_of("M", joint.name), wrench.moment);
  }
}

}  // namespace torsor::printing
