// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "torsor/generator/emission/fmi_unit.hpp"

namespace torsor {

/// Where in a unit a binary belongs: the folder below binaries/, and how its name ends.
struct FmiPlatform {
  std::string folder, suffix;
};

/// The platform that a compiler builds for, by what it predefines (`cc -dM -E`). FMI 2.0 names five; others have the name of
/// FMI 3.0, processor-system. Throws FileError for those without a name.
FmiPlatform fmi_platform(const std::string& macros, FmiVersion version);

}  // namespace torsor
