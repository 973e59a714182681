// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "torsor/generator/listing/computation.hpp"
#include "torsor/generator/listing/listing.hpp"
#include "torsor/generator/listing/schedule.hpp"
#include "torsor/generator/program/program.hpp"

namespace torsor {

/// What stands ready for a function: its arguments, and those members of Precomputed that it has in its schedule. Null:
/// none.
struct Surroundings {
  const Layout* layout = nullptr;
  const Schedule* schedule = nullptr;
  std::string function{};  ///< its name, for messages
};

/// The function as it is computed. Sines and cosines come first, with what their angles need: those of all angles that
/// need no sine or cosine in one group, then those of angles that need these. What follows stands in the order of
/// issue_order.hpp. Results that are equal up to sign are computed once.
/// Throws Error naming a symbol that is not in the layout.
Listing lower(Program& program, const Block& block, const Computation& computation, const Surroundings& around);

/// What the function has computed once: its outputs are the members of Precomputed that it reads, in its own order. The
/// outputs' meanings are those of the members.
Listing lower_precompute(Program& program, const Schedule& schedule, const Layout& layout);

/// Name of a member of Precomputed among those of the function.
std::string precomputed_name(const Program& program, const Schedule& schedule, std::size_t member);
std::size_t precomputed_count(const Schedule& schedule);

}  // namespace torsor
