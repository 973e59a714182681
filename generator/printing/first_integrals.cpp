// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/printing/first_integrals.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "torsor/generator/dynamics/forces/energy.hpp"
#include "torsor/generator/dynamics/theorems/fixed_axis_momenta.hpp"
#include "torsor/generator/dynamics/theorems/painleve.hpp"
#include "torsor/generator/printing/limit_met.hpp"
#include "torsor/generator/printing/notation.hpp"
#include "torsor/generator/program/written_unit.hpp"

namespace torsor::printing {
namespace {

/// What an integral is, with its unit as a person writes it.
Remark meaning(const FirstIntegral& integral, const Equations& equations, const NaturalLanguage& say) {
  std::string formula;
  if (integral.name == "energy") formula = "$T - U$";
  if (integral.name == "painleve") formula = "$T_2 - T_0 - U$";
  for (const CoordinateContent& c : equations.model().coordinates()) {
    if (c.attitude || integral.meaning != say("dT/d{}' of the cyclic coordinate '{}'", c.q->name, c.q->name)) continue;
    formula = say("$\\frac{{\\partial T}}{{\\partial {}}}$ of the cyclic coordinate ${}$", latex_name(c.v->name), latex_name(c.q->name));
  }
  const std::string plain = say("{}, in {}", integral.meaning, integral.unit);
  if (formula.empty()) return plain;
  return {plain, say("{}, in {}", formula, integral.unit == "J" ? "J" : fmt::format("${}$", latex_unit(integral.value.unit())))};
}

bool is_energy(const FirstIntegral& integral) { return integral.name == "energy" || integral.name == "painleve"; }

}  // namespace

void write_first_integrals(const Equations& equations, const InlineLimits& limits, Page& page,
                           const std::vector<Stretch>& stretches) {
  const PainleveReport report = painleve(equations, page.say);
  InlineView view(equations.program(), limits, equations.scene().content());
  const NaturalLanguage& say = page.say;
  page.section(say("Painleve's equation and first integrals"));
  const Spelling constant{say("constant"), say("\\text{constant}")};
  const bool multipliers = !equations.constraints().empty();
  page.formula(say("d(T2 - T0)/dt + dT/dt = sum_i Q_i q_i'{}, dT/dt at constant q and q'.",
                           multipliers ? " + sum_j lambda_j b_j" : ""),
               fmt::format("$\\frac{{\\mathrm{{d}}}}{{\\mathrm{{d}}t}}(T_2 - T_0) + \\frac{{\\partial T}}{{\\partial t}} = "
                           "\\sum_i Q_i \\dot{{q}}_i{}$.",
                           multipliers ? " + \\sum_j \\lambda_j b_j" : ""));
  const auto write = [&](const Spelling& left, const Value& value, const Remark& remark, const std::vector<KeptPiece>& pieces = {}) {
    if (const std::optional<Sum> sum = view.sum(value)) {
      page.stated(left, collected_around(*sum, pieces, view), remark);
    } else {
      const std::string limit = limit_met(view, value, say);
      page.formula(say("{}: {}, too long to be written out ({}); kernels compute it.", left.plain, remark.plain, limit),
                   say("{}: {}, too long to be written out ({}); kernels compute it.", say("constant"),
                       remark.latex.empty() ? latex_escaped(remark.plain) : remark.latex, latex_escaped(limit)));
    }
  };
  if (!report.failing_conditions.empty()) {
    if (report.t2_minus_t0.polynomial() == kinetic_energy(equations.model()).polynomial()) {
      page.stated({"T2 - T0", "T_2 - T_0"}, named("T"), say("nothing is driven"));
    } else {
      write({"T2 - T0", "T_2 - T_0"}, report.t2_minus_t0, say("in J"));
    }
    if (!report.explicit_rate.is_zero()) {
      write({"dT/dt", "\\frac{\\partial T}{\\partial t}"}, report.explicit_rate,
            say("partial derivative at constant q and q', in W"));
    }
    std::string reasons;
    for (const std::string& reason : report.failing_conditions) reasons += (reasons.empty() ? "" : "; ") + reason;
    page.formula(say("T2 - T0 - U is not conserved: {}.", reasons),
                 say("$T_2 - T_0 - U$ is not conserved: {}.", latex_escaped(reasons)));
  }
  for (const FirstIntegral& integral : report.first_integrals) {
    const Remark remark = meaning(integral, equations, say);
    if (is_energy(integral)) {
      write(constant, integral.value, remark, energy_pieces(stretches, -1));
    } else if (const std::optional<Sum> momentum = view.sum(integral.value)) {
      page.stated(constant, collected_entry(*momentum), remark);
    } else {
      write(constant, integral.value, remark);  // says why not
    }
  }
  for (const MissingMomentum& missing : missing_momenta(equations, report, say)) {
    const std::string reasons = fmt::format("{}", fmt::join(missing.reasons, ", "));
    page.formula(say("No momentum integral along {}: {}.", missing.coordinate, reasons),
                 say("No momentum integral along {}: {}.", fmt::format("${}$", latex_name(missing.coordinate)), latex_escaped(reasons)));
  }
  for (const FixedAxisMomentum& turn : fixed_axis_momenta(equations, say)) {
    const std::string axis =
        !turn.about_base    ? say("axis {} of '{}' through the origin of '{}'", turn.axis, turn.base, turn.frame)
        : turn.zero.empty() ? say("axis {} of '{}'", turn.axis, turn.base)
                            : say("an axis along {} of '{}' through where {} and {} are zero", turn.axis, turn.base, turn.zero[0],
                                  turn.zero[1]);
    const std::optional<Sum> momentum = turn.reasons.empty() ? view.sum(turn.momentum) : std::nullopt;
    if (momentum) {
      page.stated(constant, collected_entry(*momentum), say("momentum about {}, in N m s", axis));
    } else if (turn.reasons.empty()) {
      const std::string limit = limit_met(view, turn.momentum, say);
      page.formula(say("The momentum about {} is constant, and too long to be written out ({}).", axis, limit),
                   say("The momentum about {} is constant, and too long to be written out ({}).", latex_escaped(axis),
                       latex_escaped(limit)));
    } else {
      const std::string reasons = fmt::format("{}", fmt::join(turn.reasons, ", "));
      page.formula(say("No momentum integral about {}: {}.", axis, reasons),
                   say("No momentum integral about {}: {}.", latex_escaped(axis), latex_escaped(reasons)));
    }
  }
}

}  // namespace torsor::printing
