// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/base/error.hpp"

namespace torsor {

/// A start that cannot be one, of a mechanism that may stand elsewhere: open constraints, bodies within each other.
class StartError : public SceneError {
 public:
  using SceneError::SceneError;
};

}  // namespace torsor
