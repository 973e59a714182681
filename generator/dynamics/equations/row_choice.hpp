// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace torsor {

/// Rows of A at one configuration: by constraint, by freedom.
using RowsHere = std::vector<std::vector<double>>;

/// Which rows to keep of those that repeat each other, where how they do changes along the motion.
///
/// Where the rows left out are D = C K of the rows kept, those keep a share 1/√(1 + ‖C‖²) of the rank, each row being measured by
/// its largest length among the configurations: near 1 where what is left out is small beside what is kept, 0 where the rows kept
/// lose rank and all rows together do not. Rows that no C ties are chosen apart from each other.
struct RowChoice {
  std::vector<std::size_t> kept;  ///< in order
  double least_share = 1.0;       ///< at the worst configuration
};

/// A share below this is near a place where the rows kept lose rank, as near as configurations a twentieth of a radian apart
/// tell.
inline constexpr double share_that_is_lost = 0.05;

/// The rows given are changed for others only where their least share is below 0.1 and others do better. Towards a change point,
/// where all rows together lose rank, C has a limit, and the share is as good as beside it.
RowChoice choose_rows(std::vector<RowsHere> configurations, const std::vector<std::size_t>& kept);

/// Whether the rows left out are the same combination of those kept at both configurations, each row then of length 1.
bool repeat_alike(const RowsHere& one, const RowsHere& other, const std::vector<std::size_t>& kept);

}  // namespace torsor
