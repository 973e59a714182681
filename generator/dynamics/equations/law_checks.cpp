// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/equations/law_checks.hpp"

#include <algorithm>
#include <string>
#include <variant>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/dynamics/motion/model.hpp"
#include "torsor/generator/expression/expression_node.hpp"
#include "torsor/generator/expression/function.hpp"
#include "torsor/generator/program/derivative.hpp"
#include "torsor/generator/program/jumps.hpp"

namespace torsor {
namespace {

ModelOptions with_values(const SceneContent& content) {
  ModelOptions options;
  for (const ParameterContent& parameter : content.parameters) {
    if (parameter.value) options.valued.insert(parameter.symbol->name);
  }
  return options;
}

/// Whether a function may have a kink or a jump: a root has one where what it is taken of touches zero, atan2 a cut.
bool may_bend(Function function) {
  return traits_of(function).selects || function == Function::sqrt || function == Function::atan2;
}

bool may_bend(const Expression& formula) {
  using Node = Expression::Node;
  const auto& content = formula.node().content;
  if (const auto* sum = std::get_if<Node::Sum>(&content)) return may_bend(sum->left) || may_bend(sum->right);
  if (const auto* product = std::get_if<Node::Product>(&content)) return may_bend(product->left) || may_bend(product->right);
  if (const auto* power = std::get_if<Node::Power>(&content)) return may_bend(power->base);
  if (const auto* rate = std::get_if<Node::Rate>(&content)) return may_bend(rate->formula);
  const auto* call = std::get_if<Node::Apply>(&content);
  return call != nullptr && (may_bend(call->function) ||
                             std::any_of(call->arguments.begin(), call->arguments.end(),
                                         [](const Expression& argument) { return may_bend(argument); }));
}

/// Most scenes have no such law.
bool has_laws_that_may_bend(const SceneContent& scene) {
  return std::any_of(scene.coordinates.begin(), scene.coordinates.end(),
                     [](const CoordinateContent& c) { return c.law && may_bend(*c.law); }) ||
         std::any_of(scene.frames.begin(), scene.frames.end(),
                     [](const FrameContent& frame) { return may_bend(frame.displacement); });
}

class LawCheck {
 public:
  explicit LawCheck(const Scene& scene)
      : options_(with_values(scene.content())), program_(Model::resolver(scene, options_)), model_(scene, program_, options_),
        scene_(scene.content()) {}

  void run() {
    for (const FrameContent& frame : scene_.frames) {
      look(frame, scene_.time);
      if (!moves_mass(frame)) continue;  // no energy depends on where it is
      for (const SymbolPointer& q : coordinates_of(frame.displacement)) look(frame, q);
    }
  }

 private:
  /// Refuses a displacement whose value or slope jumps along the time or a coordinate.
  void look(const FrameContent& frame, const SymbolPointer& along) {
    // A full turn changes nothing: of an angle its sine and cosine are what must not jump.
    const bool turns = frame.joint == JointKind::revolute;
    const std::string jumping = what_jumps(frame.displacement, along, turns);
    if (jumping.empty()) return;
    const bool of_time = along == scene_.time;
    for (const CoordinateContent& c : scene_.coordinates) {
      if (!c.law || !follows(frame.displacement, c)) continue;
      const std::string of_law = what_jumps(*c.law, along, turns && frame.displacement.as_symbol() == c.q);
      if (of_law.empty()) continue;
      refuse(fmt::format("coordinate '{}' is driven by the law {}", c.q->name, c.law->to_string()), of_law,
             of_time ? "give a law whose rate is continuous, as a spline is, or leave it an unknown with the condition "
                       "holonomic(...) and start a motion anew there"
                     : without_kink);
    }
    refuse(fmt::format("the displacement of {} is {}", scene_.name_of(frame), frame.displacement.to_string()), jumping,
           of_time ? "give a law whose rate is continuous, as a spline is, or make it a coordinate with the condition "
                     "holonomic(...) and start a motion anew there"
                   : without_kink);
  }

  /// Whether a body hangs on a frame.
  bool moves_mass(const FrameContent& frame) const {
    const auto at = [&](const FrameReference& reference) {
      return &scene_.frames[static_cast<std::size_t>(scene_.frame_index(reference, frame.name))];
    };
    return std::any_of(scene_.bodies.begin(), scene_.bodies.end(), [&](const BodyContent& body) {
      const FrameContent* of_body = at(body.frame);
      while (of_body != &frame && of_body->parent) of_body = at(*of_body->parent);
      return of_body == &frame;
    });
  }

  /// Coordinates that a formula depends on, through laws too.
  std::vector<SymbolPointer> coordinates_of(const Expression& formula) {
    std::vector<SymbolPointer> coordinates;
    const Value value = program_.lower(formula);
    if (value.program() == nullptr || value.is_zero()) return coordinates;
    for (const ValueNumber number : program_.live({value})) {
      const SymbolPointer& symbol = program_[number].symbol;
      if (symbol && symbol->kind == SymbolKind::coordinate) coordinates.push_back(symbol);
    }
    return coordinates;
  }

  /// Through laws of other coordinates too.
  bool follows(const Expression& formula, const CoordinateContent& driven) const {
    if (formula.depends_on(driven.q)) return true;
    return std::any_of(scene_.coordinates.begin(), scene_.coordinates.end(), [&](const CoordinateContent& c) {
      return c.law && formula.depends_on(c.q) && follows(*c.law, driven);
    });
  }

  bool may_bend_along(const Value& value, const SymbolPointer& along) const {
    if (value.program() == nullptr || value.is_zero()) return false;
    bool bends = false, depends = false;
    for (const ValueNumber number : program_.live({value})) {
      const Definition& definition = program_[number];
      depends = depends || definition.symbol == along;
      bends = bends || (definition.function && may_bend(*definition.function));
    }
    return bends && depends;
  }

  /// Empty where neither the formula nor its slope does.
  std::string what_jumps(const Expression& formula, const SymbolPointer& along, bool turns) {
    const Value value = program_.lower(formula);
    if (!may_bend_along(value, along)) return "";
    const bool of_time = along == scene_.time;
    std::vector<Value> what{value};
    if (turns) what = {program_.sin(value), program_.cos(value)};
    if (const auto place = place_of_jump(what, along, Deciding::any)) {
      return of_time ? "that jumps" + at_time(what, *place) : fmt::format("that jumps along '{}'", along->name);
    }
    // A form that coordinates take part in choosing bends along these too, and is none of time.
    const Value slope = partial_derivation(program_, along)(value);
    const auto place = place_of_jump({slope}, along, of_time ? Deciding::alone : Deciding::any);
    if (!place) return "";
    return of_time ? "its rate jumps" + at_time({slope}, *place) : fmt::format("its slope along '{}' jumps", along->name);
  }

  /// Where it is the same in every motion.
  std::string at_time(const std::vector<Value>& what, double place) const {
    for (const ValueNumber number : program_.live(what)) {
      const SymbolPointer& symbol = program_[number].symbol;
      if (symbol && symbol->kind == SymbolKind::coordinate) return "";
    }
    return fmt::format(" at t = {:.6g} s", place);
  }

  [[noreturn]] static void refuse(const std::string& what, const std::string& jumping, const char* remedy) {
    throw SceneError(fmt::format("{}: {}, and the motion has no impulse for it; {}", what, jumping, remedy));
  }

  static constexpr const char* without_kink =
      "give a formula whose slope is continuous, as a spline is, or round the corner off, as sqrt(a^2 + b^2) does abs(a)";
  ModelOptions options_;
  Program program_;
  const Model model_;  // knows what formulas measure
  const SceneContent& scene_;
};

}  // namespace

void check_laws(const Scene& scene) {
  if (has_laws_that_may_bend(scene.content())) LawCheck(scene).run();
}

}  // namespace torsor
