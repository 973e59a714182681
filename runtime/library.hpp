// SPDX-License-Identifier: MIT
#pragma once
#include <Eigen/Core>

namespace torsor::runtime::detail {

/// The library and its user hand matrices to each other that one allocates and the other frees, and objects with matrices
/// of fixed room within. How Eigen allocates and aligns follows from -mavx, -march=native, EIGEN_MAX_ALIGN_BYTES,
/// EIGEN_DONT_ALIGN and, of g++, -fsanitize=address. The library defines this for its own way only, so that a program that
/// would corrupt its memory does not link. The remedy: build both with the same flags, or, where -fsanitize=address is all
/// that differs, the program with -DEIGEN_MALLOC_ALREADY_ALIGNED=1.
template <int bytes, int bytes_within>
void library_is_built_with_eigen_aligned_to() noexcept;

/// 0: Eigen leaves it to malloc.
inline constexpr int eigen_alignment =
    EIGEN_DEFAULT_ALIGN_BYTES == 0 || EIGEN_MALLOC_ALREADY_ALIGNED ? 0 : EIGEN_DEFAULT_ALIGN_BYTES;
[[gnu::used]] inline void (*const needed_library)() noexcept = &library_is_built_with_eigen_aligned_to<eigen_alignment, EIGEN_MAX_STATIC_ALIGN_BYTES>;

}  // namespace torsor::runtime::detail
