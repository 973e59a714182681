// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "torsor/generator/import/mjcf_model.hpp"

namespace torsor {

/// Has MuJoCo read and compile an MJCF file; what it takes of meshes, defaults and attachments is MuJoCo's. In the
/// library torsor_mjcf, which alone needs MuJoCo. Throws FileError "file:line: MuJoCo: what it says".
MjcfModel read_with_mujoco(const std::string& path);

}  // namespace torsor
