// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/dynamics/theorems/unknowns_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "generator/dynamics/theorems/joint_reactions.hpp"

namespace torsor {
namespace {

std::string listed(const std::vector<std::string>& names) {
  return names.empty() ? "none" : fmt::format("{} ({})", names.size(), fmt::join(names, ", "));
}

std::string counted(std::size_t n, const std::string& noun) {
  return fmt::format("{} {}{}", n, noun, n == 1 ? "" : "s");
}

}  // namespace

std::string unknowns_report(const Equations& equations) {
  const SceneContent& scene = equations.scene().content();
  std::vector<std::string> unknown, driven, released, constraints;
  for (const CoordinateContent& c : scene.coordinates) {
    (c.law ? driven : c.released ? released : unknown).push_back(c.q->name);
  }
  for (const ConstraintRow& row : equations.constraints()) {
    constraints.push_back(row.name + (row.holonomic ? "" : ", non-holonomic"));
  }
  const std::size_t n = unknown.size();
  const std::size_t m = constraints.size();
  std::string text = fmt::format("Unknowns and equations of {}\n", scene.name);
  text += fmt::format("  unknown coordinates: {}\n", listed(unknown));
  text += fmt::format("  driven by a law of time: {}\n", listed(driven));
  text += fmt::format("  released, held at zero: {}\n", listed(released));
  text += fmt::format("  constraints: {}\n", m == 0 ? "none" : fmt::format("{} ({})", m, fmt::join(constraints, "; ")));
  // Constraints that repeat others take no freedom away, and no motion tells what they transmit.
  const ConstraintRank& rank = equations.redundancy();
  const std::size_t repeating = rank.dropped.size(), counting = m - repeating;
  const std::size_t freedoms = n - counting;
  if (repeating > 0) {
    std::vector<std::string> names;
    for (const std::size_t j : rank.dropped) names.push_back(equations.constraints()[j].name);
    text += fmt::format("  of these, constraints that repeat others: {}\n", listed(names));
  }
  text += fmt::format("  degrees of freedom: {}\n", freedoms);

  const std::vector<Connection> joints = connections(equations);
  std::size_t components = 0;
  for (const Connection& joint : joints) {
    components += joint.components.size();
    std::vector<std::string> names;
    for (const ReactionComponent& component : joint.components) names.push_back(component.name);
    const std::string& from = equations.model().links()[static_cast<std::size_t>(joint.from)].name;
    text += fmt::format("  joint {} on {}: {}\n", joint.name, from,
                        names.empty() ? "nothing unknown" : fmt::format("{}", fmt::join(names, ", ")));
  }
  const std::size_t theorems = 6 * joints.size();
  text += "Newton-Euler\n";
  text += fmt::format("  {}: 6 for each of {} and {} of constraint\n", counted(theorems + counting, "equation"),
                      joints.size() == 1 ? "1 body" : fmt::format("{} bodies", joints.size()), counting);
  text += fmt::format("  {}: {} in joints, {}, {}\n", counted(components + m + n, "unknown"),
                      counted(components, "component"), counted(m, "multiplier"), counted(n, "acceleration"));
  if (components + n > theorems) {
    text += fmt::format("  {} more: joints tied by formulas of shared coordinates transmit power without loss\n",
                        counted(components + n - theorems, "equation"));
  }
  if (repeating > 0) {
    text += fmt::format("  {} indeterminate: constraints that repeat others share their forces in a way that no motion "
                        "tells\n",
                        counted(repeating, "unknown"));
  }
  text += "Lagrange\n";
  text += fmt::format("  {}: {} of motion and {} of constraint, for {} and {}\n", counted(n + counting, "equation"), n, counting,
                      counted(n, "acceleration"), counted(counting, "multiplier"));
  if (repeating > 0) {
    text += fmt::format("  {} of constraints that repeat others, taken as zero\n", counted(repeating, "multiplier"));
  }
  if (!released.empty()) {
    text += fmt::format("  {} more, of the released coordinates, for the reactions against them\n",
                        counted(released.size(), "equation"));
  }
  text += "The choice\n";
  if (m > 0) {
    text += fmt::format(
        "  with {} independent instead of {} coordinates there is no multiplier, and what the "
        "constraints transmit stays unknown\n",
        freedoms, n);
  }
  text +=
      "  each component in a joint comes from Newton-Euler for isolated bodies, or from one more released coordinate "
      "and its equation\n";
  return text;
}

}  // namespace torsor
