// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "torsor/generator/dynamics/forces/constraint_wrench.hpp"
#include "torsor/generator/dynamics/theorems/joint_reactions.hpp"
#include "torsor/generator/dynamics/theorems/unknowns_report.hpp"

namespace torsor {
namespace {

/// Six values as one vector each, to evaluate one after the other.
std::array<Real, 6> evaluated(Evaluator<Real>& evaluate, const Wrench& wrench) {
  std::array<Real, 6> numbers;
  for (std::size_t i = 0; i < 3; ++i) {
    numbers[i] = evaluate(wrench.resultant[static_cast<int>(i)]);
    numbers[i + 3] = evaluate(wrench.moment[static_cast<int>(i)]);
  }
  return numbers;
}

IsolationUnknown named(std::string name, const std::array<Real, 6>& wrench) {
  IsolationUnknown unknown{std::move(name), {}};
  for (std::size_t i = 0; i < 6; ++i) unknown.enters[i] = !is_negligible(wrench[i]);
  return unknown;
}

/// The six theorems' rows of one component of a connection: each of the six unit wrenches at the bottom's origin along
/// the top's axes is reduced as asked, and the component combines them.
class ComponentRows {
 public:
  ComponentRows(const Model& model, Evaluator<Real>& evaluate, const Connection& connection, const ScrewQuery& query) {
    Program& program = model.program();
    const Vector at = bound(program, model.locate(Vector(), connection.bottom, connection.top));
    for (int i = 0; i < 6; ++i) {
      Wrench unit;
      (i < 3 ? unit.resultant : unit.moment)[i % 3] =
          program.number(Number(1), i < 3 ? units::newton : units::newton_metre);
      const Wrench at_top = reduced_at(unit, -at);  // as_asked starts from the origin of the link
      const Wrench asked = as_asked(model, at_top, connection.top, query);
      rows_[static_cast<std::size_t>(i)] = evaluated(evaluate, asked);
    }
  }
  std::array<Real, 6> of(const ReactionComponent& component) const {
    std::array<Real, 6> sum{Real(0), Real(0), Real(0), Real(0), Real(0), Real(0)};
    for (std::size_t i = 0; i < 6; ++i) {
      for (std::size_t j = 0; j < 6; ++j) sum[j] += component.direction[i] * rows_[i][j];
    }
    return sum;
  }

 private:
  std::array<std::array<Real, 6>, 6> rows_;
};

std::string name_of(const FrameReference& frame, const Model& model) {
  return model.scene().frames[static_cast<std::size_t>(model.scene().frame_index(frame, "a report"))].name;
}

}  // namespace

IsolationReport isolation_report(const Equations& equations, const BodyNames& bodies, const ScrewQuery& query,
                                 const NaturalLanguage& say) {
  const WorkingDigits precision(50);
  const Model& model = equations.model();
  const std::vector<bool> inside = isolated_links(equations, bodies, "a report on isolated bodies");
  const auto is_inside = [&](int link) { return inside[static_cast<std::size_t>(link)]; };
  Evaluator<Real> evaluate = at_generic_state(equations);
  IsolationReport report;
  const PointContent& point =
      model.scene().points[static_cast<std::size_t>(model.scene().point_index(query.point, "a report"))];
  report.text = say("Newton-Euler for {} at {} along the axes of {}", fmt::join(bodies, ", "), point.name,
                    name_of(query.axes, model)) + "\n";
  for (const Connection& connection : connections(equations)) {
    if (is_inside(connection.bottom) == is_inside(connection.from)) continue;
    const ComponentRows rows(model, evaluate, connection, query);
    std::vector<std::string> names;
    for (const ReactionComponent& component : connection.components) {
      names.push_back(component.name);
      const bool sum = component.name.find(' ') != std::string::npos;
      const std::string name = sum ? "(" + component.name + ")" : component.name;
      report.unknowns.push_back(named(connection.name + " " + name, rows.of(component)));
    }
    report.text += "  " + say("joint {}: {}", connection.name,
                              names.empty() ? say("transmits nothing unknown") : fmt::format("{}", fmt::join(names, ", "))) + "\n";
  }
  for (std::size_t j = 0; j < equations.constraints().size(); ++j) {
    const ConstraintRow& row = equations.constraints()[j];
    const auto unit = constraint_wrench(model, static_cast<int>(j));
    if (!unit) {
      report.text += "  " + say("constraint {}: a formula; its force is counted with the joints", row.name) + "\n";
      continue;
    }
    const auto crosses = [&](const auto& entry) { return is_inside(entry.first); };
    const auto count = std::count_if(unit->begin(), unit->end(), crosses);
    if (count == 0 || count == static_cast<std::ptrdiff_t>(unit->size())) continue;
    Wrench sum;
    for (const auto& [link, wrench] : *unit) {
      if (is_inside(link)) sum = sum + as_asked(model, wrench, link, query);
    }
    report.unknowns.push_back(named(row.multiplier->name, evaluated(evaluate, sum)));
    report.text += "  " + say("constraint {}: {}", row.name, row.multiplier->name) + "\n";
  }
  const std::array<std::string, 6> equations_names{say("resultant, x"), say("resultant, y"), say("resultant, z"),
                                                   say("moment, x"),    say("moment, y"),    say("moment, z")};
  for (std::size_t i = 0; i < 6; ++i) {
    std::vector<std::string> names;
    for (const IsolationUnknown& unknown : report.unknowns) {
      if (unknown.enters[i]) names.push_back(unknown.name);
    }
    report.text += fmt::format(
        "  {}: {}\n", equations_names[i],
        names.empty() ? say("no unknown component, an equation of motion") : fmt::format("{}", fmt::join(names, ", ")));
  }
  return report;
}

}  // namespace torsor
