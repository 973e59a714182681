// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/mechanics/scene.hpp"

namespace torsor {

/// A chain of `joints` revolute joints, a quarter of a metre apart, that turn about x and y in turns; every link has a
/// full inertia tensor. The numbers are random, of six decimals, and the same on every machine.
Scene serial_chain(int joints);

}  // namespace torsor
