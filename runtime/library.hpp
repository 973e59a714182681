// SPDX-License-Identifier: MIT
#pragma once
#include <Eigen/Core>

namespace torsor::runtime::detail {

/// The library and its user hand matrices to each other that one allocates and the other frees, and Eigen does both by
/// the alignment that -mavx, -march=native and EIGEN_MAX_ALIGN_BYTES choose. The library defines this for its own
/// alignment only, so that a program that would corrupt its memory does not link. The remedy: build both with the same
/// flags, or the program with EIGEN_MAX_ALIGN_BYTES=16, or both with one value of it.
template <int bytes>
void library_is_built_with_eigen_aligned_to() noexcept;

// Up to 16 bytes malloc itself aligns, and Eigen leaves it to it.
inline constexpr int eigen_alignment = EIGEN_DEFAULT_ALIGN_BYTES <= 16 ? 16 : EIGEN_DEFAULT_ALIGN_BYTES;
[[gnu::used]] inline void (*const needed_library)() noexcept = &library_is_built_with_eigen_aligned_to<eigen_alignment>;

}  // namespace torsor::runtime::detail
