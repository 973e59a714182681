// SPDX-License-Identifier: MIT
#pragma once
#include <Eigen/Core>

#include "torsor/runtime/library.hpp"

namespace torsor::runtime {

/// e^A by scaling and squaring with the Padé approximant of degree 13 (Higham, The scaling and squaring method for the
/// matrix exponential revisited, SIAM J. Matrix Anal. Appl. 26 (2005), algorithm 2.3). Its error is some ‖A‖ roundings
/// of ‖e^A‖. Throws std::invalid_argument for a matrix that is not square or not finite.
[[nodiscard]] Eigen::MatrixXd matrix_exponential(const Eigen::MatrixXd& matrix);

}  // namespace torsor::runtime
