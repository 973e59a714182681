// SPDX-License-Identifier: GPL-3.0-or-later
#include <fstream>
#include <iterator>

#include <fmt/format.h>

#include "generator/expression/error.hpp"
#include "generator/import/urdf.hpp"

namespace torsor {

ImportedRobot read_urdf(const std::string& path, const UrdfOptions& options) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw FileError(fmt::format("cannot read '{}': does the file exist?", path));
  const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  if (file.bad()) throw FileError(fmt::format("cannot read '{}': it is no regular file", path));
  return read_urdf_text(text, path, options);
}

}  // namespace torsor
