// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "torsor/generator/base/high_precision.hpp"
#include "torsor/generator/base/linear_algebra/tolerances.hpp"
#include "torsor/generator/base/natural_language.hpp"
#include "torsor/generator/dynamics/equations/row_choice.hpp"
#include "torsor/generator/dynamics/motion/model.hpp"

namespace torsor {

/// Which constraints of a scene repeat others, and what follows for their multipliers.
///
/// Rows of A are compared in 50 digits at a configuration that satisfies the holonomic constraints near the initial one
/// (a pseudo-random displacement along the freedoms they leave, then Newton's method back onto f = 0): each row with
/// the independent ones before it, holonomic ones first and in order of declaration, in the metric of the diagonal of
/// M. It depends on them when less than `tolerance` of it stands out.
///
/// Where a closed loop makes rows repeat each other, which rows they are combined of can change along the motion, and rows that
/// count near the start lose rank elsewhere. Then the configurations that follow both ways, up to a turn, are looked at, and rows
/// that keep their rank there are kept (RowChoice).
///
/// A multiplier is determinate when its row is no combination of the other rows: then the equations of motion fix it.
/// Those of dropped rows are taken as zero; they and the ones they are combined of are indeterminate, their joint
/// effect on the motion is not.
struct ConstraintRank {
  static constexpr double tolerance = zero_tests::constraint_part;

  std::vector<std::size_t> kept;           ///< a maximal independent set, by index of constraint
  std::vector<std::size_t> dropped;        ///< the others
  std::vector<bool> determinate;           ///< by constraint
  std::vector<bool> determinate_released;  ///< by released coordinate: its reaction
  std::size_t rank_at_start = 0;           ///< at the initial configuration: fewer than `kept` where it is singular
  bool closed = true;  ///< false when no configuration that satisfies f = 0 was found near the initial one: then the
                       ///< rows are those of any configuration
  double least_share = 1.0;  ///< of the rows kept at the worst configuration that was looked at along the motion (RowChoice)
  /// Rows of A at the configuration where pivots are chosen (the initial one unless it is singular), each column i over
  /// √M_ii and each row then of length 1.
  std::vector<std::vector<Real>> scaled_rows;

  bool redundant() const { return !dropped.empty(); }
  /// Whether rows kept lose rank at places where all rows together do not.
  bool loses_rank() const { return redundant() && least_share < share_that_is_lost; }
  bool singular_start() const { return closed && rank_at_start < kept.size(); }
};

/// The dependence must not be an accident of the values that run-time parameters have in the scene: with those varied a
/// little and the kept holonomic rows satisfied anew, no dropped row may count or be violated.
/// Throws SceneError naming a constraint that contradicts those it depends on, or one that run-time parameters could
/// make independent, with these.
ConstraintRank constraint_rank(const Scene& scene, const ModelOptions& options = {});

/// What a reader of the equations must know about it, a sentence each; none where all is regular and determinate.
std::vector<std::string> notes(const ConstraintRank& rank, const Scene& scene, const NaturalLanguage& say = {});

}  // namespace torsor
