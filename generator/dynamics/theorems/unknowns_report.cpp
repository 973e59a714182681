// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/theorems/unknowns_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "torsor/generator/dynamics/theorems/joint_reactions.hpp"
#include "torsor/generator/mechanics/uncounted_contacts.hpp"

namespace torsor {
namespace {

std::string listed(const std::vector<std::string>& names, const NaturalLanguage& say) {
  return names.empty() ? say("none") : fmt::format("{} ({})", names.size(), fmt::join(names, ", "));
}

const char* plural(std::size_t n) { return n == 1 ? "" : "s"; }

}  // namespace

std::string unknowns_report(const Equations& equations, const NaturalLanguage& say) {
  const SceneContent& scene = equations.scene().content();
  std::vector<std::string> unknown, driven, released, constraints;
  for (const CoordinateContent& c : scene.coordinates) {
    (c.law ? driven : c.released ? released : unknown).push_back(c.q->name);
  }
  for (const ConstraintRow& row : equations.constraints()) {
    constraints.push_back(row.holonomic ? row.name : say("{}, non-holonomic", row.name));
  }
  const std::size_t n = unknown.size();
  const std::size_t m = constraints.size();
  std::string text = say("Unknowns and equations of {}", scene.name) + "\n";
  text += "  " + say("unknown coordinates: {}", listed(unknown, say)) + "\n";
  text += "  " + say("driven by a law of time: {}", listed(driven, say)) + "\n";
  text += "  " + say("released, held at zero: {}", listed(released, say)) + "\n";
  text += "  " + say("constraints: {}", m == 0 ? say("none") : fmt::format("{} ({})", m, fmt::join(constraints, "; "))) + "\n";
  // Constraints that repeat others take no freedom away, and no motion tells what they transmit.
  const ConstraintRank& rank = equations.redundancy();
  const std::size_t repeating = rank.dropped.size(), counting = m - repeating;
  const std::size_t freedoms = n - counting;
  if (repeating > 0) {
    std::vector<std::string> names;
    for (const std::size_t j : rank.dropped) names.push_back(equations.constraints()[j].name);
    text += "  " + say("of these, constraints that repeat others: {}", listed(names, say)) + "\n";
  }
  text += "  " + say("degrees of freedom: {}", freedoms) + "\n";

  const std::vector<Connection> joints = connections(equations);
  std::size_t components = 0;
  for (const Connection& joint : joints) {
    components += joint.components.size();
    std::vector<std::string> names;
    for (const ReactionComponent& component : joint.components) names.push_back(component.name);
    const std::string& from = equations.model().links()[static_cast<std::size_t>(joint.from)].name;
    text += "  " + say("joint {} on {}: {}", joint.name, from,
                        names.empty() ? say("nothing unknown") : fmt::format("{}", fmt::join(names, ", "))) + "\n";
  }
  for (const std::string& sentence : uncounted_contacts(scene, say)) text += "  " + sentence + "\n";
  const std::size_t theorems = 6 * joints.size();
  text += say("Newton-Euler") + "\n";
  const std::size_t all = theorems + counting, sought = components + m + n;
  text += "  " + say("{}: 6 for each of {} and {} of constraint", say("{} equation{}", all, plural(all)),
                     joints.size() == 1 ? say("1 body") : say("{} bodies", joints.size()), counting) + "\n";
  text += "  " + say("{}: {} in joints, {}, {}", say("{} unknown{}", sought, plural(sought)),
                     say("{} component{}", components, plural(components)), say("{} multiplier{}", m, plural(m)),
                     say("{} acceleration{}", n, plural(n))) + "\n";
  if (components + n > theorems) {
    text += "  " + say("{} more: joints tied by formulas of shared coordinates transmit power without loss",
                        say("{} equation{}", components + n - theorems, plural(components + n - theorems))) + "\n";
  }
  if (repeating > 0) {
    text += "  " + say("{} indeterminate: constraints that repeat others share their forces in a way that no motion tells",
                        say("{} unknown{}", repeating, plural(repeating))) + "\n";
  }
  text += say("Lagrange") + "\n";
  text += "  " + say("{}: {} of motion and {} of constraint, for {} and {}", say("{} equation{}", n + counting, plural(n + counting)), n,
                     counting, say("{} acceleration{}", n, plural(n)),
                     say("{} multiplier{}", counting, plural(counting))) + "\n";
  if (repeating > 0) {
    text += "  " + say("{} of constraints that repeat others, taken as zero", say("{} multiplier{}", repeating, plural(repeating))) + "\n";
  }
  if (!released.empty()) {
    text += "  " + say("{} more, of the released coordinates, for the reactions against them",
                        say("{} equation{}", released.size(), plural(released.size()))) + "\n";
  }
  text += say("The choice") + "\n";
  if (m > 0) {
    text += "  " + say("with {} independent instead of {} coordinates there is no multiplier, and what the constraints transmit "
                       "stays unknown",
                       freedoms, n) + "\n";
  }
  text += "  " + say("each component in a joint comes from Newton-Euler for isolated bodies, or from one more released "
                     "coordinate and its equation") + "\n";
  return text;
}

}  // namespace torsor
