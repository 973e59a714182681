// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace torsor {

/// A word of a command line such that a shell (POSIX.1-2024, bash, zsh, ksh) reads back the same bytes and runs nothing:
/// as it is where it holds letters, digits and -_./=,+@% only; in single quotes, those inside as '\''; in $'...' with
/// escapes where it holds control characters, bytes that are no UTF-8, or characters that a reader does not see or that
/// turn the direction of text. No trigraph of C stands in it.
std::string shell_word(std::string_view word);

}  // namespace torsor
