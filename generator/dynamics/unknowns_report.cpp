// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/dynamics/unknowns_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "generator/dynamics/joint_reactions.hpp"

namespace torsor {
namespace {

std::string listed(const std::vector<std::string>& names) {
  return names.empty() ? "none" : fmt::format("{} ({})", names.size(), fmt::join(names, ", "));
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
  text += fmt::format("  degrees of freedom, the constraints being independent: {}\n",
                      static_cast<long>(n) - static_cast<long>(m));

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
  text += fmt::format("  {} equations: 6 for each of {} bodies and {} of constraint\n", theorems + m, joints.size(), m);
  text += fmt::format("  {} unknowns: {} components in joints, {} multipliers, {} accelerations\n", components + m + n,
                      components, m, n);
  if (components + n > theorems) {
    text +=
        fmt::format("  {} more say that joints tied by formulas of shared coordinates transmit power without loss\n",
                    components + n - theorems);
  }
  text += "Lagrange\n";
  text += fmt::format("  {} equations: {} of motion and {} of constraint, for {} accelerations and {} multipliers\n",
                      n + m, n, m, n, m);
  if (!released.empty()) {
    text += fmt::format("  {} more, one for each released coordinate, give the reaction against it\n", released.size());
  }
  text += "The choice\n";
  if (m > 0) {
    text += fmt::format(
        "  with {} independent coordinates instead of {} there are no multipliers, and the reactions of "
        "the {} constraints stay unknown\n",
        static_cast<long>(n) - static_cast<long>(m), n, m);
  }
  text += fmt::format(
      "  each of the {} components in joints comes from Newton-Euler for isolated bodies, or from one more "
      "released coordinate and its equation\n",
      components);
  return text;
}

}  // namespace torsor
