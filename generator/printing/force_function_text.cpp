// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/printing/force_function_text.hpp"

#include <fmt/format.h>

#include "torsor/generator/dynamics/equations/validation.hpp"
#include "torsor/generator/dynamics/theorems/force_function.hpp"
#include "torsor/generator/mechanics/uncounted_contacts.hpp"
#include "torsor/generator/printing/inline_view.hpp"
#include "torsor/generator/printing/limit_met.hpp"
#include "torsor/generator/printing/notation.hpp"

namespace torsor {
namespace {

std::string listed(const std::vector<std::string>& names, const std::string& otherwise) {
  return names.empty() ? otherwise : fmt::format("{}", fmt::join(names, ", "));
}

std::string written(printing::InlineView& view, const Value& value) {
  if (value.is_zero()) return "0";
  const std::optional<printing::Sum> sum = view.sum(value);
  return sum ? printing::text(printing::collected(*sum)) : "... (too long to be written out: " + printing::limit_met(view, value, NaturalLanguage::named("en")) +
               "; the kernels bias and energy compute it)";
}

}  // namespace

std::string force_function_text(const Scene& scene, const ActionSelection& selection) {
  validate(scene);
  ModelOptions options;
  options.symbolic_parameters = true;
  const Equations equations(scene, options);
  const ForceFunctionReport report = classify_force_function(equations, selection);
  printing::InlineView view(equations.program(), {}, printing::positive_parameters(scene.content()));
  std::string text = fmt::format("{}: {}, {}\n", scene.name(), listed(selection.actions, "all actions"),
                                 selection.bodies.empty() ? "wherever they act" : "on " + listed(selection.bodies, ""));
  for (const std::string& sentence : uncounted_contacts(scene.content())) text += fmt::format("  {}\n", sentence);
  for (std::size_t i = 0; i < report.forces.size(); ++i) {
    text += fmt::format("  Q_{} = {}\n", equations.model().coordinates()[i].q->name, written(view, report.forces[i]));
  }
  text += fmt::format("  power = {}\n", written(view, report.power));
  text += fmt::format("  {}\n", to_string(report.kind));
  for (const std::string& reason : report.reasons) text += fmt::format("    {}\n", reason);
  if (report.force_function) text += fmt::format("  U = {}\n", written(view, *report.force_function));
  if (!report.remark.empty()) text += fmt::format("    {}\n", report.remark);
  return text;
}

}  // namespace torsor
