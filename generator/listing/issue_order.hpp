// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "torsor/generator/listing/earliest_start.hpp"
#include "torsor/generator/program/program.hpp"

namespace torsor {

/// The definitions of a function that are left after its sines and cosines, in the order in which it computes them:
/// list scheduling (Gibbons & Muchnick 1986) for a processor that looks some way ahead. What the results wait for
/// longest goes first, unless more values are live than registers hold: then what frees most. `definitions` are in the
/// program's order, and stay so without the pass `scheduling`. Same definitions, same bits.
std::vector<ValueNumber> issue_order(const Program& program, const EarliestStarts& starts,
                              const std::vector<ValueNumber>& definitions);

}  // namespace torsor
