// SPDX-License-Identifier: MIT
#include "torsor/runtime/library.hpp"

namespace torsor::runtime::detail {

template <int bytes, int bytes_within>
void library_is_built_with_eigen_aligned_to() noexcept {}

template void library_is_built_with_eigen_aligned_to<eigen_alignment, EIGEN_MAX_STATIC_ALIGN_BYTES>() noexcept;

}  // namespace torsor::runtime::detail
