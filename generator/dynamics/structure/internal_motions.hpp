// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "torsor/generator/dynamics/structure/mobility.hpp"

namespace torsor {

/// The columns of an array that are not marked, and how many those are.
RealRows without_columns(const RealRows& matrix, const std::vector<bool>& marked);
std::size_t inner_count(const std::vector<bool>& marked);

/// Fills `internal` and `internal_freedoms`: first the motions that one body can do alone while all others rest, then
/// those of several together.
void describe_internal_motions(Mobility& mobility, const std::vector<TwistEdge>& edges, const NaturalLanguage& say);

/// Fills `indeterminate` and `redundant`. Each wrench that can run around the loops without any load (a combination of
/// the closure equations that is zero) makes the reactions it is felt in indeterminate: those equations can be dropped
/// one at a time without lowering the rank.
void describe_indeterminate(Mobility& mobility, const std::vector<TwistEdge>& edges, const JointSpace& space,
                            const NaturalLanguage& say);

}  // namespace torsor
