// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/mechanics/scene_content.hpp"

namespace torsor {

/// A start that cannot be one, of a mechanism that may stand elsewhere: open constraints, bodies within each other.
class StartError : public SceneError {
 public:
  using SceneError::SceneError;
};

/// How the author of a scene gives another start: "correct initial(...)", or of a robot's file, where no `initial` stands, by
/// the option of the commands.
inline std::string another_start(const SceneContent& scene) {
  return scene.origin.file.empty() ? "correct initial(...)" : "give another start by --initial";
}

}  // namespace torsor
