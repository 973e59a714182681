// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "torsor/generator/geometry/triple.hpp"

namespace torsor {

/// What a scene asks of the motion of its frames, so that formulas may use it; frames and points by their indices.
struct MeasuredVector {
  enum class Kind {
    direction,         ///< `along`, given in `frame`
    position,          ///< OP, O the origin of `axes`, P the point
    angular_velocity,  ///< Ω(frame/relative_to)
    velocity,          ///< V(P ∈ frame/relative_to)
  };
  Kind kind = Kind::direction;
  int index = 0;  ///< of the scene's measured vectors
  int frame = 0, point = 0, relative_to = 0;
  int axes = 0;   ///< whose axes the components are along
  Triple along{};
  std::shared_ptr<const Symbol> time{};  ///< of the scene that was asked, and of no other
};

/// One component of it: what a symbol that is no variable stands for (Symbol::measure).
struct Measure {
  std::shared_ptr<const MeasuredVector> vector;
  int component = 0;
};

}  // namespace torsor
