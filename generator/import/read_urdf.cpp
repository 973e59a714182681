// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/import/text_of_file.hpp"
#include "torsor/generator/import/urdf.hpp"

namespace torsor {

ImportedRobot read_urdf(const std::string& path, const UrdfOptions& options) {
  return read_urdf_text(text_of_file(path), path, options);
}

}  // namespace torsor
