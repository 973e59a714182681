// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "torsor/generator/dynamics/motion/model.hpp"

namespace torsor::printing {

/// A value that a page may name where it stands under a root: k of √(1 − k²).
struct NamedProduct {
  SymbolPointer symbol;  ///< "n.k_P"
  Value value;
  std::string point;  ///< of the disc that touches the plane
};

/// n·k of every point where a disc touches a plane, n the normal of the plane and k the axis of the disc: the height of
/// its centre over the plane is r √(1 − (n·k)²), from which multiplied out nobody reads that the yaw does not enter.
std::vector<NamedProduct> disc_products(const Model& model);

}  // namespace torsor::printing
