// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace torsor {

/// A fixed phrase and its French: whole sentences where that is possible, with a place {} for each name or number. The
/// places of both stand in the same order.
struct Translation {
  std::string_view english, french;
};

}  // namespace torsor
