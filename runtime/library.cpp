// SPDX-License-Identifier: MIT
#include "runtime/library.hpp"

namespace torsor::runtime::detail {

template <int bytes>
void library_is_built_with_eigen_aligned_to() noexcept {}

template void library_is_built_with_eigen_aligned_to<eigen_alignment>() noexcept;

}  // namespace torsor::runtime::detail
