// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/printing/first_integrals.hpp"

#include <fmt/format.h>

#include "generator/dynamics/theorems/painleve.hpp"

namespace torsor::printing {

void write_first_integrals(const Equations& equations, const InlineLimits& limits, Page& page) {
  const PainleveReport report = painleve(equations);
  InlineView view(equations.program(), limits, positive_parameters(equations.scene().content()));
  page.section("Painleve's equation and first integrals");
  const bool multipliers = !equations.constraints().empty();
  page.formula(fmt::format("d(T2 - T0)/dt + dT/dt = sum_i Q_i q_i'{}, dT/dt at constant q and q'.",
                           multipliers ? " + sum_j lambda_j b_j" : ""),
               fmt::format("$\\frac{{\\mathrm{{d}}}}{{\\mathrm{{d}}t}}(T_2 - T_0) + \\frac{{\\partial T}}{{\\partial t}} = "
                           "\\sum_i Q_i \\dot{{q}}_i{}$.",
                           multipliers ? " + \\sum_j \\lambda_j b_j" : ""));
  const auto write = [&](const Written& left, const Value& value, const std::string& remark) {
    if (const std::optional<Sum> sum = view.sum(value)) {
      page.equation("", left, collected(*sum), remark);
    } else {
      page.equation("", left, named("..."), remark + ": too long to be written out; kernels compute it");
    }
  };
  if (!report.failing_conditions.empty()) {
    Written difference = named("T2");
    difference.push_back(named("T0")[0]);
    difference.back().coefficient = Number(-1);
    write(difference, report.t2_minus_t0, "in J");
    if (!report.explicit_rate.is_zero()) write(named("dT/dt"), report.explicit_rate, "partial derivative at constant q and q', in W");
    std::string reasons;
    for (const std::string& reason : report.failing_conditions) reasons += (reasons.empty() ? "" : "; ") + reason;
    page.note("T2 - T0 - U is not conserved: " + reasons + ".");
  }
  for (const FirstIntegral& integral : report.first_integrals) {
    write(named("constant"), integral.value, integral.documentation);
  }
  for (const MissingMomentum& missing : missing_momenta(equations, report)) {
    page.note(fmt::format("No momentum integral along {}: {}.", missing.coordinate, fmt::join(missing.reasons, ", ")));
  }
}

}  // namespace torsor::printing
