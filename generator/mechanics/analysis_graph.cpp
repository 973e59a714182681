// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/mechanics/analysis_graph.hpp"

#include <algorithm>
#include <optional>
#include <set>

#include "torsor/generator/base/as_index.hpp"
#include "torsor/generator/program/program.hpp"

namespace torsor {
namespace {

class Linker {
 public:
  Linker(const Scene& scene, const StructureGraph& graph, const NaturalLanguage& language)
      : say(language), scene_(scene.content()), graph_(graph) {}

  std::vector<AnalysisLink> all() {
    for (const ConstraintContent& constraint : scene_.constraints) {
      name_ = constraint.name;
      std::visit([this](const auto& law) { tie(law); }, constraint.law);
    }
    if (std::any_of(scene_.gravity.begin(), scene_.gravity.end(), [](const Expression& g) { return !g.is_zero(); })) {
      std::set<int> heavy;
      for (const BodyContent& body : scene_.bodies) heavy.insert(body_of(body.frame));
      heavy.erase(0);
      for (const int body : heavy) add(AnalysisLink::Kind::action, say("gravity"), say("gravity"), {0, body});
    }
    for (const ActionContent& action : scene_.actions)
      std::visit([this](const auto& content) { tie(content); }, action);
    for (const ContactFriction& friction : scene_.frictions) {
      add(AnalysisLink::Kind::action, friction.name, friction.point ? say("friction") : say("resistance to turning"),
          {body_of(friction.body), body_of(friction.other)});
    }
    for (const ContactContent& contact : scene_.contacts) {
      name_ = contact.name;
      std::visit([this](const auto& geometry) { touch(geometry); }, contact.geometry);
    }
    drives();
    return std::move(links_);
  }

 private:
  void add(AnalysisLink::Kind kind, const std::string& name, const std::string& what, std::vector<int> bodies) {
    std::sort(bodies.begin(), bodies.end());
    bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
    // The two directions of one contact are one link.
    const auto twin = std::find_if(links_.begin(), links_.end(), [&](const AnalysisLink& link) {
      return kind == AnalysisLink::Kind::constraint && link.kind == kind && link.what == what && link.bodies == bodies;
    });
    if (twin != links_.end()) {
      twin->name += ", " + name;
      return;
    }
    links_.push_back({kind, name, what, std::move(bodies)});
  }
  void constraint(const std::string& what, std::vector<int> bodies) {
    add(AnalysisLink::Kind::constraint, name_, what, std::move(bodies));
  }
  void action(const std::string& name, const std::string& what, std::vector<int> bodies) {
    add(AnalysisLink::Kind::action, name, what, std::move(bodies));
  }

  void impose(const std::string& name, std::vector<int> bodies) {
    const std::string what = say("imposes {}(t)", name);
    if (!bodies.empty()) action(what, what, std::move(bodies));
  }

  /// What imposes a motion is an unknown action between the two bodies that it moves.
  void drives() {
    for (const CoordinateContent& c : scene_.coordinates) {
      if (c.law) impose(c.q->name, displaced_by(Expression(c.q)));
    }
    for (const GraphJoint& joint : graph_.joints) {
      const auto follows_time = [this](int f) {
        const Expression& displacement = scene_.frames[as_index(f)].displacement;
        return displacement.depends_on(scene_.time) && !depends_on_a_coordinate(displacement);
      };
      if (std::any_of(joint.frames.begin(), joint.frames.end(), follows_time)) impose(joint.name, {joint.a, joint.b});
    }
  }

  bool depends_on_a_coordinate(const Expression& formula) const {
    return std::any_of(scene_.coordinates.begin(), scene_.coordinates.end(),
                       [&](const CoordinateContent& c) { return formula.depends_on(c.q); });
  }

  int body_of(const FrameReference& frame) const {
    return graph_.body_of_frame[as_index(scene_.frame_index(frame, "the analysis graph"))];
  }
  int body_of(const PointReference& point) const {
    return body_of(scene_.points[as_index(scene_.point_index(point, "the analysis graph"))].frame);
  }

  void tie(const HolonomicFormula& law) { constraint(say("holonomic relation"), moved_by(law.f)); }
  void tie(const NonholonomicFormula& law) { constraint(say("non-holonomic relation"), moved_by(law.left_side)); }
  void tie(const NoSlip& law) { constraint(say("no slip"), {body_of(law.body), body_of(law.on)}); }
  void tie(const Closure& law) { constraint(say("closure of points"), {body_of(law.a), body_of(law.b)}); }
  void tie(const PointInPlane& law) { constraint(say("point in plane"), {body_of(law.point), body_of(law.plane)}); }
  void tie(const JointClosure&) {}

  void tie(const ElongationSpring& a) { action(a.name, say("spring"), displaced_by(a.elongation)); }
  void tie(const ElongationDamper& a) { action(a.name, say("damper"), displaced_by(a.elongation)); }
  void tie(const PointSpring& a) { action(a.name, say("spring"), {body_of(a.a), body_of(a.b)}); }
  void tie(const PointDamper& a) { action(a.name, say("damper"), {body_of(a.a), body_of(a.b)}); }
  void tie(const Motor& a) { action(a.name, say("motor"), displaced_by(a.displacement)); }
  void tie(const GivenForce& a) { action(a.name, say("force"), {0, body_of(a.body)}); }
  void tie(const GivenTorque& a) { action(a.name, say("torque"), {0, body_of(a.body)}); }
  void tie(const GivenForceFunction& a) { action(a.name, say("force function"), moved_by(a.force_function)); }
  void tie(const GeneralisedForce& a) { action(a.name, say("generalised force"), displaced_by(a.displacement)); }
  void tie(const Gravitation& a) { action(a.name, say("gravitation"), {body_of(a.a), body_of(a.b)}); }
  void tie(const GivenWrench& a) { action(a.name, say("wrench"), {0, body_of(a.body)}); }
  void tie(const Drag& a) { action(a.name, say("drag"), {body_of(a.body), body_of(a.relative_to)}); }
  void tie(const RotationalDrag& a) { action(a.name, say("rotational drag"), {body_of(a.body), body_of(a.relative_to)}); }
  void tie(const MutualAction& a) {
    action(a.name, a.point ? say("mutual force") : say("mutual torque"), {body_of(a.a), body_of(a.b)});
  }

  void touch(const PointOnPlane& c) { action(name_, say("contact"), {body_of(c.point), body_of(c.plane)}); }
  void touch(const SphereOnSphere& c) { action(name_, say("contact"), {body_of(c.a), body_of(c.b)}); }
  void touch(const Stop& c) { action(name_, say("stop"), displaced_by(c.displacement)); }
  void touch(const FrictionAlong& c) { action(name_, say("dry friction"), displaced_by(c.displacement)); }
  void touch(const FrictionInJoint& c) {
    const FrameContent& frame = scene_.frames[as_index(scene_.frame_index(c.frame, "the analysis graph"))];
    action(name_, say("dry friction"), {body_of(c.frame), body_of(*frame.parent)});
  }
  void touch(const TurnOnContact&) {}  // of a contact that stands there

  /// The frame that moves with a body, and those it hangs on.
  std::vector<int> moving_chain(int frame) const {
    std::vector<int> chain;
    for (; frame > 0; frame = scene_.frame_index(*scene_.frames[as_index(frame)].parent, "the analysis graph")) {
      if (scene_.frames[as_index(frame)].joint != JointKind::weld) chain.push_back(frame);
    }
    return chain;
  }

  /// Bodies of the joints that the coordinates of a formula move.
  std::vector<int> moved_by(const Expression& formula) const {
    std::vector<int> bodies;
    for (const GraphJoint& joint : graph_.joints) {
      for (const int f : joint.frames) {
        if (shares_a_coordinate(formula, scene_.frames[as_index(f)])) bodies.insert(bodies.end(), {joint.a, joint.b});
      }
    }
    return bodies;
  }

  bool shares_a_coordinate(const Expression& formula, const FrameContent& frame) const {
    for (const CoordinateContent& c : scene_.coordinates) {
      const bool here =
          frame.joint == JointKind::attitude ? c.attitude == frame.attitude : frame.displacement.depends_on(c.q);
      if (here && (formula.depends_on(c.q) || formula.depends_on(c.v))) return true;
    }
    if (frame.joint != JointKind::attitude) return false;
    for (const SymbolPointer& e : scene_.attitudes[as_index(*frame.attitude)].symbols->e) {
      if (formula.depends_on(e)) return true;
    }
    return false;
  }

  /// The ends of a stretch of one chain of frames whose displacements, all turns or all slides, add up to ± the
  /// formula, constants aside; the shortest that begins nearest to the ground.
  std::vector<int> displaced_by(const Expression& formula) const {
    Program program;
    const Value wanted = program.lower(formula);
    std::optional<std::pair<int, int>> best;
    std::size_t best_length = 0;
    for (std::size_t f = 0; f < scene_.frames.size(); ++f) {
      if (scene_.frames[f].joint != JointKind::revolute && scene_.frames[f].joint != JointKind::prismatic) continue;
      if (scene_.is_rotor(scene_.frames[f])) continue;
      const std::vector<int> chain = moving_chain(static_cast<int>(f));
      Value sum;
      for (std::size_t k = 0; k < chain.size() && scene_.frames[as_index(chain[k])].joint == scene_.frames[f].joint; ++k) {
        const FrameContent& frame = scene_.frames[as_index(chain[k])];
        const Value part = program.lower(frame.displacement);
        const bool fits = part.is_zero() || part.unit() == wanted.unit();
        if (!fits) break;
        sum += part;
        const Value difference = sum - wanted, total = sum + wanted;
        if (!difference.is_constant() && !total.is_constant() && !difference.is_zero() && !total.is_zero()) continue;
        if (best && best_length <= k + 1) continue;
        best = {graph_.body_of_frame[f], body_of(*frame.parent)};
        best_length = k + 1;
      }
    }
    if (best && best->first != best->second) return {best->first, best->second};
    return moved_by(formula);
  }

  const NaturalLanguage& say;
  const SceneContent& scene_;
  const StructureGraph& graph_;
  std::string name_;
  std::vector<AnalysisLink> links_;
};

}  // namespace

std::vector<AnalysisLink> analysis_links(const Scene& scene, const StructureGraph& graph, const NaturalLanguage& say) {
  return Linker(scene, graph, say).all();
}

}  // namespace torsor
