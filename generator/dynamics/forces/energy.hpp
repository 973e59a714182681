// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/dynamics/forces/actions.hpp"

namespace torsor {

/// T = ½ Σ_S (momentum screw of S · twist of S) [J], twists by composition along the chains.
Value kinetic_energy(const Model& model);

/// The same as sums of squares, T = ½ Σ_S (m V_G² + Ω · J_G Ω): nothing is subtracted. A heavy body that nearly stands
/// still on a light link that turns fast keeps its digits, which m V_O² + 2 m V_O · (Ω ∧ OG) + Ω · J_O Ω loses to those
/// of the origin O.
Value kinetic_energy_about_centres(const Model& model);

/// ½ a ė² of a reflected inertia, by its place among the rotors of the scene.
Value rotor_energy(const Model& model, std::size_t rotor);

/// U of gravity: Σ m g · OG [J].
Value gravity_force_function(const Model& model);

/// T by another derivation: positions of all centres of mass and axes in the ground frame, differentiated with respect to
/// time, 2 Ω = Σ e_i ∧ ė_i. Nothing in common with the recursion of twists.
Value kinetic_energy_from_positions(const Model& model);

/// What the quasi-velocities ω of quaternions add to Lagrange's operator, ω ∧ ∂T/∂ω; zero for any other coordinate
/// (Boltzmann-Hamel equations; Lurie, Analytical Mechanics, 2002, §7.9). `momenta` are ∂T/∂v_i.
std::vector<Value> turning_terms(const Model& model, const std::vector<Value>& momenta);

/// Lagrange's operator P_i = d/dt ∂T/∂q̇_i − ∂T/∂q_i (+ turning terms) on any T, for every coordinate of the model.
std::vector<Value> lagrange_operator(const Model& model, const Value& kinetic_energy);

}  // namespace torsor
