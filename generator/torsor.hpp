// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// All that the author of a scene needs: describe the mechanism in a function, give it a main with TORSOR_SCENE.

#include "torsor/generator/cli/scene_program.hpp"
#include "torsor/generator/expression/piecewise.hpp"
#include "torsor/generator/mechanics/scene.hpp"
