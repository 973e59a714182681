// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/kernels/kernel_percussions.hpp"

#include "torsor/generator/dynamics/forces/contacts.hpp"
#include "torsor/generator/kernels/kernel_parts.hpp"

namespace torsor {
namespace {

std::vector<ContactRow> rows_of_contacts(const Equations& equations) {
  std::vector<ContactRow> rows;
  for (const ContactRows& contact : contact_rows(equations.model())) {
    rows.insert(rows.end(), contact.rows.begin(), contact.rows.end());
  }
  return rows;
}

/// What a unit impulse along a row changes: velocities as accelerations, impulses of constraints as multipliers. They
/// hold velocities, so that their γ is zero.
ForwardSolution answer_to(const Equations& equations, const ContactRow& row) {
  return equations.solve(row.jacobian, std::vector<Value>(equations.constraints().size()));
}

Value along(const Equations& equations, const ContactRow& row, const std::vector<Value>& v, const Value& rest = {}) {
  Value sum = rest;
  for (std::size_t j = 0; j < unknowns(equations); ++j) sum += row.jacobian[j] * v[j];
  return equations.program().bind(sum);
}

}  // namespace

Kernel make_delassus(const Equations& equations) {
  const std::vector<ContactRow> rows = rows_of_contacts(equations);
  const ForwardSolution& free = equations.forward_by_factorisation();
  StructureBuilder builder("Delassus", "The problem of one instant, dw/dt = W r + q, of all rows of contacts.");
  builder.member("matrix", rows.size(), rows.size(), "W, symmetric");
  builder.member("free", rows.size(), "q, dw/dt without reactions of contacts");
  for (std::size_t s = 0; s < rows.size(); ++s) {
    builder.assign("free", s, along(equations, rows[s], free.accelerations, rows[s].drift));
    const ForwardSolution answer = answer_to(equations, rows[s]);
    for (std::size_t r = s; r < rows.size(); ++r) {
      const Value entry = along(equations, rows[r], answer.accelerations);
      builder.assign("matrix", rows.size() * s + r, entry);
      if (r != s) builder.assign("matrix", rows.size() * r + s, entry);
    }
  }
  Kernel kernel = builder.take(
      "Delassus' matrix W and the accelerations q without reactions of contacts, of the rows that `contacts` has:\n"
      "dw/dt = W r + q. Loops are closed by the same solve. Of contacts that take part these are their rows and columns.\n"
      "Returns singular when a pivot is not positive relative to its diagonal entry.");
  kernel.arguments = {Argument::inputs};
  kernel.pivots = free.pivots;
  return kernel;
}

Kernel make_impact(const Equations& equations) {
  const std::vector<ContactRow> rows = rows_of_contacts(equations);
  const std::size_t n = unknowns(equations), m = equations.constraints().size();
  StructureBuilder builder("Impact", "What unit impulses along the rows of contacts change.");
  builder.member("velocities", n, rows.size(), "of velocities: v+ = v- + velocities P, column by column");
  builder.member("multipliers", m, rows.size(), "impulses of constraints: multipliers P, column by column");
  std::vector<PivotTest> pivots;
  for (std::size_t s = 0; s < rows.size(); ++s) {
    const ForwardSolution answer = answer_to(equations, rows[s]);
    if (pivots.empty()) pivots = answer.pivots;
    for (std::size_t i = 0; i < n; ++i) builder.assign("velocities", n * s + i, answer.accelerations[i]);
    for (std::size_t j = 0; j < m; ++j) builder.assign("multipliers", m * s + j, answer.multipliers[j]);
  }
  Kernel kernel = builder.take(
      "Jump equations of percussions: M (v+ - v-) = J' P + A' L, A v+ = A v-, P the impulses along the rows of `contacts`\n"
      "and L those of constraints, for unit impulses. Returns singular when a pivot is not positive relative to its\n"
      "diagonal entry.");
  kernel.pivots = std::move(pivots);
  return kernel;
}

}  // namespace torsor
