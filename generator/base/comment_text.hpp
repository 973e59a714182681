// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace torsor {

/// Text that is safe behind `//`: one line that shows what it holds (see printable), without trigraphs, and no backslash at
/// its end.
std::string comment_text(const std::string& text);

}  // namespace torsor
