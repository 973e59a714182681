// SPDX-License-Identifier: MIT
#pragma once
#include <Eigen/Core>

namespace torsor::runtime::detail {

/// The library and its user hand matrices to each other that one allocates and the other frees, and objects with matrices
/// of fixed room within. Eigen does both by the alignments that -mavx, -march=native, EIGEN_MAX_ALIGN_BYTES and
/// EIGEN_DONT_ALIGN choose. The library defines this for its own alignments only, so that a program that would corrupt its
/// memory does not link. The remedy: build both with the same flags.
template <int bytes, int bytes_within>
void library_is_built_with_eigen_aligned_to() noexcept;

// Up to 16 bytes malloc itself aligns, and Eigen leaves it to it.
inline constexpr int eigen_alignment = EIGEN_DEFAULT_ALIGN_BYTES <= 16 ? 16 : EIGEN_DEFAULT_ALIGN_BYTES;
[[gnu::used]] inline void (*const needed_library)() noexcept = &library_is_built_with_eigen_aligned_to<eigen_alignment, EIGEN_MAX_STATIC_ALIGN_BYTES>;

}  // namespace torsor::runtime::detail
