// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace torsor {

/// Gives a file exactly these bytes; returns whether it had to be written.
///
/// A regular file appears whole or not at all: the bytes go to a temporary file beside it, which then takes its name (a
/// symbolic link stays a link). A file that has these bytes already is not touched. What exists and is no regular file
/// (/dev/stdout, a pipe) is written through.
/// Throws FileError naming file, reason and remedy when the folder is missing, the file cannot be written or the disk
/// is full; nothing half-written is left behind.
bool write_file_if_changed(const std::string& path, std::string_view bytes);

struct OutputFile {
  std::string path, text;
};

/// Several at once: when one of them cannot be written, those before it are as they were. All bytes are on the disk before
/// the first name appears; what remains to go wrong is a rename.
void write_files_if_changed(const std::vector<OutputFile>& files);

/// Whether two names stand for one regular file, be it there already or not.
bool same_file(const std::string& a, const std::string& b);

}  // namespace torsor
