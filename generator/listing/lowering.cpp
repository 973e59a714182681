// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/listing/lowering.hpp"

#include <fmt/format.h>

#include "torsor/generator/listing/listing_builder.hpp"
#include "torsor/generator/listing/local_names.hpp"
#include "torsor/generator/listing/recurrence_lowering.hpp"

namespace torsor {

Listing lower(Program& program, const Block& block, const Computation& computation, const Surroundings& around) {
  ListingBuilder builder(program, around);
  builder.compute(block);
  if (computation.series) RecurrenceLowering(builder, program, *computation.series, block).run();
  for (const Assignment& assignment : computation.assignments) builder.write(assignment);
  for (const auto& pivot : computation.pivots) builder.measure(pivot);
  return builder.take(computation.has_status());
}

Listing lower_precompute(Program& program, const Schedule& schedule, const Layout& layout) {
  ListingBuilder builder(program, {&layout, nullptr, "precompute"});
  builder.compute(schedule.precompute);
  for (std::size_t k = 0; k < precomputed_count(schedule); ++k) {
    const Target target{"precomputed", precomputed_name(program, schedule, k)};
    if (k < schedule.members.size()) {
      builder.write_member(target, schedule.members[k], program[schedule.members[k]].name);
    } else {
      builder.write({target, Value(program, schedule.results.sums()[k - schedule.members.size()], Unit())});
    }
  }
  return builder.take(false);
}

std::string precomputed_name(const Program& program, const Schedule& schedule, std::size_t member) {
  const std::size_t definitions = schedule.members.size();
  if (member >= definitions) return fmt::format("y{}", member - definitions);
  const std::string meaningful = local_name(program, schedule.members[member]);
  return meaningful.empty() ? fmt::format("m{}", member) : meaningful;
}

std::size_t precomputed_count(const Schedule& schedule) {
  return schedule.members.size() + schedule.results.sums().size();
}

}  // namespace torsor
