// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/torsor.hpp"

// Scenes of examples, compiled into the tests without their main.
torsor::Scene loading_robot_scene();
torsor::Scene model_making_press_scene();
torsor::Scene model_making_press_reduced_scene();
torsor::Scene passenger_in_vehicle_scene();
torsor::Scene satellite_arms_scene();
torsor::Scene shaker_scene();
torsor::Scene shaker_damped_scene();
torsor::Scene shaker_free_support_scene();
torsor::Scene shaker_from_mass_scene();
torsor::Scene vibration_absorber_scene();
torsor::Scene winder_scene();
