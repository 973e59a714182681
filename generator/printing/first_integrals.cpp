// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/printing/first_integrals.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "torsor/generator/dynamics/forces/energy.hpp"
#include "torsor/generator/dynamics/theorems/painleve.hpp"
#include "torsor/generator/printing/limit_met.hpp"
#include "torsor/generator/program/written_unit.hpp"

namespace torsor::printing {
namespace {

/// What an integral is, with its unit as a person writes it.
std::string meaning(const FirstIntegral& integral, const NaturalLanguage& say) {
  return say("{}, in {}", integral.meaning, integral.unit);
}

}  // namespace

void write_first_integrals(const Equations& equations, const InlineLimits& limits, Page& page) {
  const PainleveReport report = painleve(equations, page.say);
  InlineView view(equations.program(), limits, positive_parameters(equations.scene().content()));
  const NaturalLanguage& say = page.say;
  page.section(say("Painleve's equation and first integrals"));
  const bool multipliers = !equations.constraints().empty();
  page.formula(say("d(T2 - T0)/dt + dT/dt = sum_i Q_i q_i'{}, dT/dt at constant q and q'.",
                           multipliers ? " + sum_j lambda_j b_j" : ""),
               fmt::format("$\\frac{{\\mathrm{{d}}}}{{\\mathrm{{d}}t}}(T_2 - T_0) + \\frac{{\\partial T}}{{\\partial t}} = "
                           "\\sum_i Q_i \\dot{{q}}_i{}$.",
                           multipliers ? " + \\sum_j \\lambda_j b_j" : ""));
  const auto write = [&](const Spelling& left, const Value& value, const std::string& remark) {
    if (const std::optional<Sum> sum = view.sum(value)) {
      page.stated(left, collected(*sum), remark);
    } else {
      page.note(say("{}: {}, too long to be written out ({}); kernels compute it.", left.plain, remark,
                    limit_met(view, value, say)));
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
    page.note(say("T2 - T0 - U is not conserved: {}.", reasons));
  }
  for (const FirstIntegral& integral : report.first_integrals) {
    write({say("constant"), say("\\text{constant}")}, integral.value, meaning(integral, say));
  }
  for (const MissingMomentum& missing : missing_momenta(equations, report, say)) {
    page.note(say("No momentum integral along {}: {}.", missing.coordinate, fmt::join(missing.reasons, ", ")));
  }
}

}  // namespace torsor::printing
