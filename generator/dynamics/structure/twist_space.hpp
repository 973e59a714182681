// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "torsor/generator/base/linear_algebra/real_rows.hpp"
#include "torsor/generator/base/natural_language.hpp"
#include "torsor/generator/geometry/real_vector.hpp"
#include "torsor/generator/mechanics/joint.hpp"

namespace torsor {

// Vector spaces of twists at one configuration: rows {Ω, V_O} of six numbers, lengths of the order of 1. Two joints in
// series allow the sum of their spaces, two in parallel the intersection; the ideal wrench of a joint is reciprocal to
// its space.

/// Ranks of twists are decided by elimination with this tolerance, relative to the largest entry.
Real twist_tolerance();
/// The same for a single entry of order 1.
bool is_small(const Real& entry);

/// Independent rows that span what the rows of both span.
RealRows span_of(const RealRows& a, const RealRows& b);
RealRows intersection_of(const RealRows& a, const RealRows& b);

/// Wrenches {R, M_O} of no power with any of the twists: R·V + M·Ω = 0. The same function leads back.
RealRows reciprocal_to(const RealRows& twists);

/// A space of twists as a joint of the table, where it is one.
struct TwistClass {
  int freedoms = 0;
  std::optional<JointType> type;        ///< none: no joint of the table allows this space
  std::optional<RealVector> direction;  ///< axis, or normal of the contact plane
  std::optional<RealVector> point;      ///< the centre, or the point of the axis nearest to the origin

  /// "prismatic along z", "spherical", "2 freedoms, no joint of the table"
  std::string text(const NaturalLanguage& say = {}) const;
};

/// Recognises the joint of the table that allows exactly these twists: from its translations, its directions of turning
/// and common points of axes; spaces of four and five freedoms by the reciprocal wrenches in the same way.
TwistClass recognise_twists(const RealRows& twists);

}  // namespace torsor
