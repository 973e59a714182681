// SPDX-License-Identifier: GPL-3.0-or-later
// A program for a mechanism with all selections, which no example has.
#include "torsor/generator/torsor.hpp"
#include "tests/emission/selections_scene.hpp"

TORSOR_SCENE(torsor::testing_scenes::golden_selections)
