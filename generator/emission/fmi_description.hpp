// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/emission/library_sources.hpp"
#include "generator/emission/mechanism_listing.hpp"

namespace torsor {

/// The kernels that a functional mock-up unit of the scene is made of.
std::vector<std::string> fmi_kernels(const Scene& scene);

/// What tells the unit from others: guid of FMI 2.0. It changes with the equations and with the interface.
std::string fmi_token(const MechanismListing& mechanism);

/// modelDescription.xml of FMI 2.0. Variables are, in the order of their value references: states (q, then v), their
/// derivatives, inputs, tunable parameters, multipliers, energies. Throws SceneError where the mechanism has no forward
/// dynamics, or a parameter no value.
std::string fmi_description(const MechanismListing& mechanism);

/// The C99 text of the unit, SCENE_fmi2.c first: what sources/ holds and binaries/ is compiled from.
std::vector<SourceFile> fmi_sources(const MechanismListing& mechanism);

}  // namespace torsor
