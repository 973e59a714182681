// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace torsor {

/// Numbers of bodies, joints and frames are ints, some of them −1 for none; arrays count by std::size_t.
constexpr std::size_t as_index(int number) { return static_cast<std::size_t>(number); }

}  // namespace torsor
