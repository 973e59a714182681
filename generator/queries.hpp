// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The theorems of mechanics and statics as questions to a scene, for programs of one's own: make `Equations` of the
// scene (with ModelOptions::symbolic_parameters for formulas), ask, and read the values with
// `readable(multiplied_out(value))` or an `Evaluator`. Scene programs have the same as commands: theorem, statics,
// unknowns, structure.

#include "torsor/generator/dynamics/derivatives/linearisation.hpp"           // linearisation: M, C, K about a state
#include "torsor/generator/dynamics/motion/body_screws.hpp"                  // momentum_screw, dynamic_screw, kinetic_energy of bodies
#include "torsor/generator/dynamics/motion/contact_motion.hpp"               // contact_motion: sliding, rolling, spinning
#include "torsor/generator/dynamics/motion/frame_motion.hpp"                 // relative_twist, derivative_in, body_motion, recognise_motion
#include "torsor/generator/dynamics/motion/inertia_wrench.hpp"               // transport and Coriolis inertia wrenches
#include "torsor/generator/dynamics/structure/mobility.hpp"                  // analyse_mobility, scene_freedoms
#include "torsor/generator/dynamics/theorems/energy_theorem.hpp"             // energy_theorem, action_power
#include "torsor/generator/dynamics/theorems/equilibrium_equations.hpp"      // equilibrium_equations, AtState
#include "torsor/generator/dynamics/theorems/flat_polynomials.hpp"           // multiplied_out, readable
#include "torsor/generator/dynamics/theorems/joint_actions.hpp"              // joint_actions: what joints transmit, by name
#include "torsor/generator/dynamics/theorems/newton_euler.hpp"               // newton_euler, transmitted_wrench
#include "torsor/generator/dynamics/theorems/painleve.hpp"                   // painleve, missing_momenta
#include "torsor/generator/dynamics/theorems/routh.hpp"                      // characteristic_polynomial, routh_table, hurwitz_conditions
#include "torsor/generator/dynamics/theorems/stability.hpp"                  // lejeune_dirichlet, sylvester_conditions
#include "torsor/generator/dynamics/theorems/theorem_equations.hpp"          // theorem_equation, energy_equation
#include "torsor/generator/dynamics/theorems/unknowns_report.hpp"            // unknowns_report, isolation_report
#include "torsor/generator/geometry/orientation.hpp"                         // rotation_matrix, angular_velocity; euler, cardan
#include "torsor/generator/geometry/positions.hpp"                           // cartesian, cylindrical and spherical coordinates
#include "torsor/generator/geometry/quaternion.hpp"                          // unit quaternions: products, rates
#include "torsor/generator/geometry/vector_division.hpp"                     // the x with a ∧ x = b
#include "torsor/generator/mechanics/central_axis.hpp"                       // central_axis of a screw
#include "torsor/generator/mechanics/inertia_operations.hpp"                 // operator_about, assembly, bodies cut out of others
#include "torsor/generator/mechanics/inertia_symmetry.hpp"                   // with_symmetry, is_spherical, is_of_revolution, is_principal
#include "torsor/generator/mechanics/joint_screws.hpp"                       // allowed_twists and ideal_wrenches of joints
#include "torsor/generator/mechanics/rigid_motion.hpp"                       // twist_of_velocities, recognise
#include "torsor/generator/mechanics/sliding_vector.hpp"                     // screws of sets of sliding vectors and of densities
