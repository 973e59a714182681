// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace torsor {

/// Gives a file exactly these bytes; returns whether it had to be written.
///
/// A regular file appears whole or not at all: the bytes go to a temporary file beside it, which then takes its name (a
/// symbolic link stays a link). A file that has these bytes already is not touched. What exists and is no regular file
/// (/dev/stdout, a pipe) is written through.
/// Throws FileError naming file, reason and remedy when the folder is missing, the file cannot be written or the disk
/// is full; nothing half-written is left behind.
bool write_file_if_changed(const std::string& path, std::string_view bytes);

}  // namespace torsor
