// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/verification/check.hpp"

namespace torsor {

/// Every kernel of the scene evaluated in double and in CLN at the same double inputs: for each group of outputs of one
/// unit, ‖double − CLN‖ / ‖CLN‖. Kernels that solve are bounded by 1e-14 times the condition number of M, the others
/// by 1e-13.
std::vector<CheckResult> check_kernels(const Scene& scene, const CheckOptions& options);

}  // namespace torsor
