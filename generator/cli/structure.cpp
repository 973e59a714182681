// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <optional>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "torsor/generator/base/did_you_mean.hpp"
#include "torsor/generator/base/error.hpp"
#include "torsor/generator/cli/command_texts.hpp"
#include "torsor/generator/dynamics/equations/constraint_rank.hpp"
#include "torsor/generator/dynamics/structure/mobility.hpp"
#include "torsor/generator/dynamics/structure/reduced_graph.hpp"
#include "torsor/generator/graphs/graph_printer.hpp"

namespace torsor {
namespace {

/// The rank of the constraints at the closed state near the start; none where there is no such state.
std::optional<std::size_t> rank_of_closed(const Scene& scene) {
  if (scene.content().constraints.empty()) return std::nullopt;
  try {
    const ConstraintRank rank = constraint_rank(scene);
    return rank.closed ? std::optional(rank.rank_at_start) : std::nullopt;
  } catch (const Error&) {
    return std::nullopt;  // constraints that contradict each other
  }
}

using Json = nlohmann::ordered_json;

std::string type_text(const GraphJoint& joint, const NaturalLanguage& say = {}) {
  return joint.type ? name_of(*joint.type, say) : say("no joint of the table");
}

std::string joined(const std::vector<std::string>& names) { return fmt::format("{}", fmt::join(names, ", ")); }

/// A line below a heading.
std::string line(const std::string& sentence) { return "  " + sentence + "\n"; }

std::string count_text(const MobilityCount& count, const NaturalLanguage& say) {
  return line(say("bodies {}, joints {}: independent loops mu = {}", count.bodies, count.joints, count.loops)) +
         line(say("freedoms of the joints n_p = {}, closure equations 6 mu = {} of rank r = {}", count.parameters,
                  count.equations, count.rank)) +
         line(say("mobility m = n_p - r = {}: {} useful, {} internal", count.mobility, count.useful, count.internal)) +
         line(say("degree of redundancy h = 6 mu - r = {}", count.redundancy));
}

Json count_json(const MobilityCount& count) {
  return {{"bodies", count.bodies},         {"joints", count.joints},       {"loops", count.loops},
          {"parameters", count.parameters}, {"equations", count.equations}, {"rank", count.rank},
          {"mobility", count.mobility},     {"useful", count.useful},       {"internal", count.internal},
          {"redundancy", count.redundancy}};
}

std::string freedoms_text(const SceneFreedoms& scene, const NaturalLanguage& say) {
  return say("{} freedom{}: {} useful, {} internal", scene.freedoms(), scene.freedoms() == 1 ? "" : "s", scene.useful(),
             scene.internal);
}

/// Constraints that are no joints tie what the graph counts as free.
std::string beside_joints(const SceneFreedoms& scene, const NaturalLanguage& say) {
  const std::size_t count = scene.no_joints.size();
  if (count == 0) return "";
  const std::string names = joined(scene.no_joints), freedoms = freedoms_text(scene, say);
  return line(
      count == 1
          ? say("that is the joints alone: {} constraint is no joint beside them ({}), with which the scene has {}", count, names,
                freedoms)
          : say("that is the joints alone: {} constraints are no joints beside them ({}), with which the scene has {}", count,
                names, freedoms));
}

/// Joints of the tree whose displacements share a coordinate, as a mimic's do with its leader's: the graph counts a freedom
/// for each of them.
std::vector<std::string> joints_that_share_coordinates(const SceneContent& scene) {
  std::map<const Symbol*, std::set<std::size_t>> users;  // looked up only
  for (std::size_t j = 0; j < scene.joints.size(); ++j) {
    if (!scene.joints[j].of_tree) continue;
    const auto [first, last] = *scene.joints[j].of_tree;
    for (int f = first; f <= last; ++f) {
      const FrameContent& frame = scene.frames[static_cast<std::size_t>(f)];
      if (frame.joint != JointKind::revolute && frame.joint != JointKind::prismatic) continue;
      for (const SymbolPointer& symbol : frame.displacement.symbols()) {
        if (symbol->kind == SymbolKind::coordinate) users[symbol.get()].insert(j);
      }
    }
  }
  std::set<std::size_t> sharing;
  for (const auto& [symbol, joints] : users) {
    if (joints.size() > 1) sharing.insert(joints.begin(), joints.end());
  }
  std::vector<std::string> names;
  for (const std::size_t j : sharing) names.push_back(scene.joints[j].name);
  return names;
}

std::string shared_coordinates(const Scene& scene, const SceneFreedoms& own, const NaturalLanguage& say) {
  const std::vector<std::string> names = joints_that_share_coordinates(scene.content());
  if (names.empty()) return "";
  return line(say("that is the joints alone: formulas of coordinates tie {}, and the scene has {}", joined(names),
                  freedoms_text(own, say)));
}

std::string scene_text(const SceneFreedoms& own, const NaturalLanguage& say) {
  return "\n" +
         say("The scene as it is written: {} unknown coordinate{}, {} driven, {} constraint{} of rank {} at the "
             "initial configuration: {}",
             own.coordinates, own.coordinates == 1 ? "" : "s", own.driven, own.constraints, own.constraints == 1 ? "" : "s",
             own.rank, freedoms_text(own, say)) +
         "\n";
}

}  // namespace

std::string structure_text(const Scene& scene, const std::vector<std::string>& inputs_outputs, const NaturalLanguage& say) {
  const Mobility mobility = analyse_mobility(scene, {.inputs_outputs = inputs_outputs, .language = say});
  const StructureGraph& graph = mobility.graph;
  std::string text = scene.content().title.empty() ? scene.name() + "\n"
                                                   : fmt::format("{}: {}\n", scene.name(), scene.content().title);
  text += "\n" + say("Joints (* with the outside)") + "\n";
  for (std::size_t j = 0; j < graph.joints.size(); ++j) {
    const GraphJoint& joint = graph.joints[j];
    const auto& names = (mobility.singular ? mobility.generic_edges : mobility.given_edges)[j].motion.names;
    text += fmt::format("  {}{:<15} {} - {}: {}, {}{}{}\n", mobility.outside[j] ? "*" : " ", joint.name,
                        graph.bodies[static_cast<std::size_t>(joint.a)].name,
                        graph.bodies[static_cast<std::size_t>(joint.b)].name, type_text(joint, say),
                        say("{} freedom{}", joint.freedoms, joint.freedoms == 1 ? "" : "s"),
                        names.empty() ? "" : " (" + joined(names) + ")", joint.closes_loop ? say(", closes a loop") : "");
  }
  const SceneFreedoms own = scene_freedoms(scene, inputs_outputs, rank_of_closed(scene));
  text += "\n" + say("Structure graph") + "\n" + count_text(mobility.singular ? mobility.generic : mobility.given, say) +
          beside_joints(own, say) + shared_coordinates(scene, own, say);
  if (mobility.moved_to_close)
    text += line(say("(the initial values do not close the loops exactly: taken from the nearest ones that do)"));
  if (mobility.singular) {
    text += line(say("warning: the initial configuration is singular: r = {}, m = {}, h = {} there", mobility.given.rank,
                     mobility.given.mobility, mobility.given.redundancy));
  }
  if (mobility.immobile) {
    text += line(say(
        "warning: no other configuration was found near the initial one: its freedoms may be infinitesimal only"));
  }
  for (const InternalMotion& motion : mobility.internal) {
    text += line(say("internal: {} {}{}", joined(motion.bodies), motion.text,
                     motion.freedoms == 1 ? "" : say(" ({} freedoms)", motion.freedoms)));
  }
  if (!mobility.internal_freedoms.empty()) {
    text += line(say("freedoms in internal motions: {}", joined(mobility.internal_freedoms)));
  }
  if (!mobility.loops.empty()) {
    text += "\n" + say("Closures (P(b/a): components along a into components along b)") + "\n";
  }
  for (std::size_t l = 0; l < mobility.loops.size(); ++l) {
    std::vector<std::string> names;
    for (const auto& [joint, sense] : mobility.loops[l].joints)
      names.push_back(graph.joints[static_cast<std::size_t>(joint)].name);
    text += line(say("loop {} ({})", l + 1, joined(names)));
    text += fmt::format("    {}\n    {}\n    {}\n", orientation_closure(graph, mobility.loops[l]), position_closure(graph, mobility.loops[l]),
                        twist_closure(graph, mobility.loops[l]));
  }
  if (!mobility.redundant.empty()) {
    text += line(say("redundant, each on its own: {}", joined(mobility.redundant)));
    text += "\n" + say("Reactions that equilibrium does not determine (components along the joint's axes)") + "\n";
    for (const IndeterminateReaction& reaction : mobility.indeterminate) {
      text += fmt::format("  {:<15} {}\n", reaction.joint, joined(reaction.components));
    }
  } else if (!mobility.loops.empty()) {
    text += "\n" + say("Equilibrium determines all reactions of the joints") + "\n";
  }
  const ReducedGraph reduced = reduced_graph(mobility, say);
  if (!reduced.steps.empty()) {
    text += "\n" + say("Reduced graph") + "\n";
    for (const ReductionStep& step : reduced.steps) {
      text += fmt::format("  {}{}{}\n", step.text,
                          step.redundant > 0 ? say("; redundant equations: {} fewer", step.redundant) : "",
                          step.internal > 0 ? say("; internal freedoms: {} fewer", step.internal) : "");
    }
    text += count_text(reduced.count, say);
    for (const EquivalentJoint& joint : reduced.joints) {
      text +=
          fmt::format("  {:<16} {} - {}: {}\n", joint.edge.name, reduced.bodies[static_cast<std::size_t>(joint.edge.a)],
                      reduced.bodies[static_cast<std::size_t>(joint.edge.b)], joint.allows.text(say));
    }
    if (reduced.special) text += line(say("(at a generic configuration: the initial one is special)"));
  }
  return text + scene_text(own, say);
}

std::string structure_json(const Scene& scene, const std::vector<std::string>& inputs_outputs) {
  const Mobility mobility = analyse_mobility(scene, {inputs_outputs});
  const StructureGraph& graph = mobility.graph;
  const auto body = [&graph](int i) { return graph.bodies[static_cast<std::size_t>(i)].name; };
  Json json{{"name", scene.name()}, {"bodies", Json::array()}, {"joints", Json::array()}, {"links", Json::array()}};
  for (const GraphBody& each : graph.bodies) json["bodies"].push_back({{"name", each.name}, {"parts", each.parts}});
  for (std::size_t j = 0; j < graph.joints.size(); ++j) {
    const GraphJoint& joint = graph.joints[j];
    json["joints"].push_back({{"name", joint.name},
                              {"type", type_text(joint)},
                              {"freedoms", joint.freedoms},
                              {"between", {body(joint.a), body(joint.b)}},
                              {"closes_loop", joint.closes_loop},
                              {"outside", static_cast<bool>(mobility.outside[j])}});
  }
  for (const AnalysisLink& link : analysis_links(scene, graph)) {
    Json bodies = Json::array();
    for (const int i : link.bodies) bodies.push_back(body(i));
    json["links"].push_back({{"name", link.name},
                             {"kind", link.kind == AnalysisLink::Kind::action ? "action" : "constraint"},
                             {"what", link.what},
                             {"between", bodies}});
  }
  const SceneFreedoms own = scene_freedoms(scene, inputs_outputs, rank_of_closed(scene));
  json["scene"] = {{"coordinates", own.coordinates}, {"driven", own.driven},    {"constraints", own.constraints},
                   {"no_joints", own.no_joints},     {"rank", own.rank},        {"freedoms", own.freedoms()},
                   {"useful", own.useful()},         {"internal", own.internal}};
  json["scene"]["tied_joints"] = joints_that_share_coordinates(scene.content());
  json["given"] = count_json(mobility.given);
  json["generic"] = count_json(mobility.generic);
  json["singular"] = mobility.singular;
  json["immobile"] = mobility.immobile;
  json["internal"] = Json::array();
  for (const InternalMotion& motion : mobility.internal) {
    json["internal"].push_back({{"bodies", motion.bodies}, {"freedoms", motion.freedoms}, {"motion", motion.text}});
  }
  json["internal_freedoms"] = mobility.internal_freedoms;
  json["redundant_equations"] = mobility.redundant;
  json["indeterminate_reactions"] = Json::object();
  for (const IndeterminateReaction& reaction : mobility.indeterminate) {
    json["indeterminate_reactions"][reaction.joint] = reaction.components;
  }
  const ReducedGraph reduced = reduced_graph(mobility);
  Json joints = Json::array();
  for (const EquivalentJoint& joint : reduced.joints) {
    joints.push_back(
        {{"name", joint.edge.name},
         {"type", joint.allows.type ? std::string(to_string(*joint.allows.type)) : "no joint of the table"},
         {"freedoms", joint.allows.freedoms},
         {"between",
          {reduced.bodies[static_cast<std::size_t>(joint.edge.a)],
           reduced.bodies[static_cast<std::size_t>(joint.edge.b)]}}});
  }
  json["reduced"] = {{"bodies", reduced.bodies}, {"joints", joints}, {"count", count_json(reduced.count)}};
  return json.dump(2) + "\n";
}

std::string graph_text(const Scene& scene, const GraphRequest& request, const NaturalLanguage& say) {
  const auto& [kind, format, inputs_outputs] = request;
  if (format != "dot" && format != "svg") {
    throw UsageError(fmt::format("unknown format '{}' of a graph: use dot (Graphviz draws it) or svg", format));
  }
  GraphDrawing drawing;
  if (kind == "structure") {
    drawing = draw_structure(scene, structure_graph(scene), say);
  } else if (kind == "analysis") {
    const StructureGraph graph = structure_graph(scene);
    drawing = draw_analysis(scene, graph, analysis_links(scene, graph, say), say);
  } else if (kind == "reduced") {
    drawing = draw_reduced(scene, reduced_graph(analyse_mobility(scene, {inputs_outputs})), say);
  } else {
    throw UsageError(fmt::format("unknown graph '{}': {}use structure, analysis or reduced", kind,
                                 did_you_mean(kind, {"structure", "analysis", "reduced"})));
  }
  return format == "dot" ? graph_dot(drawing) : graph_svg(drawing);
}

}  // namespace torsor
