// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "torsor/generator/emission/fmi_unit.hpp"
#include "torsor/generator/emission/library_sources.hpp"

namespace torsor {

/// The C99 text of the unit, which binaries/ is compiled from: first the file that includes the others.
std::vector<SourceFile> fmi_sources(const FmiUnit& unit);

/// The C++20 text that moves a unit with contacts, which is compiled beside that: first the file that knows the mechanism,
/// second the contact layer, then what they include. Eigen 3 is not among it.
std::vector<SourceFile> fmi_contact_sources(const FmiUnit& unit);

/// How to compile them: sources/buildDescription.xml of FMI 3.0.
std::string fmi_build_description(const FmiUnit& unit);

/// documentation/licenses/: first license.txt, where the standard has an importer begin.
std::vector<SourceFile> fmi_licence_files(const FmiUnit& unit);

}  // namespace torsor
