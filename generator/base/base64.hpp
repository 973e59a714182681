// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace torsor {

/// Bytes as letters, digits, + and /, four for three bytes, = at the end (RFC 4648).
std::string base64(std::string_view bytes);

}  // namespace torsor
