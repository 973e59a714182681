// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace torsor {

/// The text of a file, of a pipe (also one with a name, such as /dev/stdin or what <(command) of a shell makes), or of a
/// device. A pipe that no program has opened is given up after five seconds, one that a program has opened after a minute
/// of silence. Throws FileError with reason and remedy for what cannot be read, a folder, a byte 0 (no text has it) and more
/// than 256 MiB.
std::string text_of_file(const std::string& path);

}  // namespace torsor
