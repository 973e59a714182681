// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/listing/computation.hpp"

#include "torsor/generator/listing/shared_products.hpp"
#include "torsor/generator/program/identically_zero.hpp"
#include "torsor/generator/program/limits_at_roots.hpp"

namespace torsor {
namespace {

/// Other values in the order of Computation::values, of a function without a series.
void put(std::vector<Value> values, Computation& computation) {
  auto value = values.begin();
  for (Assignment& assignment : computation.assignments) assignment.value = std::move(*value++);
  for (PivotTest& test : computation.pivots) {
    test.pivot = std::move(*value++);
    test.measure = std::move(*value++);
  }
}

}  // namespace

std::vector<Value> Computation::values() const {
  std::vector<Value> all;
  for (const Assignment& assignment : assignments) all.push_back(assignment.value);
  for (const PivotTest& test : pivots) {
    all.push_back(test.pivot);
    all.push_back(test.measure);
  }
  if (series) {
    const SeriesProgram& program = series->program;
    for (const Polynomial& root : series->solve ? series->solve->coefficients(program) : program.roots()) {
      all.push_back(program.value(root));
    }
    if (series->solve) {
      for (const Value& value : series->solve->at_start(program)) all.push_back(value);
    }
  }
  return all;
}

void clear_identically_zero(Program&, Computation& computation) {
  std::vector<Value> values;
  for (const Assignment& assignment : computation.assignments) values.push_back(assignment.value);
  clear_identically_zero(values);
  for (std::size_t i = 0; i < values.size(); ++i) computation.assignments[i].value = std::move(values[i]);
}

void share_products(Program& program, Computation& computation) {
  if (!computation.series) put(with_shared_products(program, computation.values()), computation);
}

void take_limits_at_roots(Program& program, Computation& computation) {
  if (!computation.series) put(with_limits_at_roots(program, computation.values()), computation);
}

}  // namespace torsor
