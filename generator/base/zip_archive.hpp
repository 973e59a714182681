// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace torsor {

/// A file in an archive.
struct ArchivedFile {
  std::string path, bytes;
};

/// A zip archive of these files, in this order, not compressed and without times: the same files give the same bytes.
/// Throws FileError where they are larger than the format without extensions holds (4 GiB).
std::string zip_archive(const std::vector<ArchivedFile>& files);

}  // namespace torsor
