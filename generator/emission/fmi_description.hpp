// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "torsor/generator/emission/mechanism_listing.hpp"

namespace torsor {

enum class FmiVersion { two, three };

/// What tells the unit from others: guid of FMI 2.0, instantiation token of 3.0. It changes with the equations and with the
/// interface.
std::string fmi_token(const MechanismListing& mechanism, FmiVersion version);

/// modelDescription.xml, with the variables of fmi_variables(); in FMI 3.0 time is the last. Throws SceneError where the
/// mechanism has no forward dynamics, or a parameter no value.
std::string fmi_description(const MechanismListing& mechanism, FmiVersion version);

}  // namespace torsor
