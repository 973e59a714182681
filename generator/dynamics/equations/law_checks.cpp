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

bool selects(const Expression& formula) {
  using Node = Expression::Node;
  const auto& content = formula.node().content;
  if (const auto* sum = std::get_if<Node::Sum>(&content)) return selects(sum->left) || selects(sum->right);
  if (const auto* product = std::get_if<Node::Product>(&content)) return selects(product->left) || selects(product->right);
  if (const auto* power = std::get_if<Node::Power>(&content)) return selects(power->base);
  if (const auto* rate = std::get_if<Node::Rate>(&content)) return selects(rate->formula);
  const auto* call = std::get_if<Node::Apply>(&content);
  return call != nullptr && (traits_of(call->function).selects ||
                             std::any_of(call->arguments.begin(), call->arguments.end(), selects));
}

/// Most scenes have no such law.
bool has_laws_that_select(const SceneContent& scene) {
  return std::any_of(scene.coordinates.begin(), scene.coordinates.end(),
                     [](const CoordinateContent& c) { return c.law && selects(*c.law); }) ||
         std::any_of(scene.frames.begin(), scene.frames.end(),
                     [](const FrameContent& frame) { return selects(frame.displacement); });
}

class LawCheck {
 public:
  explicit LawCheck(const Scene& scene)
      : options_(with_values(scene.content())), program_(Model::resolver(scene, options_)), model_(scene, program_, options_),
        scene_(scene.content()) {}

  void run() {
    for (const FrameContent& frame : scene_.frames) {
      const std::string jumping = what_jumps(frame.displacement);
      if (jumping.empty()) continue;
      for (const CoordinateContent& c : scene_.coordinates) {
        if (!c.law || !follows(frame.displacement, c)) continue;
        if (const std::string of_law = what_jumps(*c.law); !of_law.empty()) {
          refuse(fmt::format("coordinate '{}' is driven by the law {}", c.q->name, c.law->to_string()), of_law,
                 "or leave it an unknown with the condition holonomic(...) and start a motion anew there");
        }
      }
      refuse(fmt::format("the displacement of {} is {}", scene_.name_of(frame), frame.displacement.to_string()), jumping,
             "or make it a coordinate with the condition holonomic(...) and start a motion anew there");
    }
  }

 private:
  /// Through laws of other coordinates too.
  bool follows(const Expression& formula, const CoordinateContent& driven) const {
    if (formula.depends_on(driven.q)) return true;
    return std::any_of(scene_.coordinates.begin(), scene_.coordinates.end(), [&](const CoordinateContent& c) {
      return c.law && formula.depends_on(c.q) && follows(*c.law, driven);
    });
  }

  bool selects_by_time(const Value& value) const {
    if (value.program() == nullptr || value.is_zero()) return false;
    bool selects = false, of_time = false;
    for (const ValueNumber number : program_.live({value})) {
      const Definition& definition = program_[number];
      of_time = of_time || definition.symbol == scene_.time;
      selects = selects || definition.function == Function::select || definition.function == Function::sign ||
                definition.function == Function::abs || definition.function == Function::maximum;
    }
    return selects && of_time;
  }

  /// A form that coordinates take part in choosing bends along these too, and is none of time.
  bool is_chosen_by_time(const Value& value) {
    for (const ValueNumber number : program_.live({value})) {
      const Definition definition = program_[number];
      if (definition.function != Function::select && definition.function != Function::sign) continue;
      for (const ValueNumber of : program_.live({program_.argument(definition, 0)})) {
        const SymbolPointer& symbol = program_[of].symbol;
        if (!symbol || symbol == scene_.time || symbol->kind == SymbolKind::parameter || symbol->kind == SymbolKind::pi) continue;
        return false;
      }
    }
    return true;
  }

  /// Empty where neither the formula nor its rate does.
  std::string what_jumps(const Expression& formula) {
    const Value value = program_.lower(formula);
    if (!selects_by_time(value)) return "";
    if (jumps_along(value, scene_.time)) return "that";
    const Value rate = partial_derivation(program_, scene_.time)(value);
    return !rate.is_zero() && is_chosen_by_time(rate) && jumps_along(rate, scene_.time) ? "its rate" : "";
  }

  [[noreturn]] static void refuse(const std::string& what, const std::string& jumping, const char* or_else) {
    throw SceneError(fmt::format("{}: {} jumps, and the motion has no impulse for it; give a law whose rate is continuous, as a "
                                 "spline is, {}",
                                 what, jumping, or_else));
  }

  ModelOptions options_;
  Program program_;
  const Model model_;  // knows what formulas measure
  const SceneContent& scene_;
};

}  // namespace

void check_laws_of_time(const Scene& scene) {
  if (has_laws_that_select(scene.content())) LawCheck(scene).run();
}

}  // namespace torsor
