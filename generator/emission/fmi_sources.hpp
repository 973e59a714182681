// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "torsor/generator/emission/fmi_description.hpp"
#include "torsor/generator/emission/library_sources.hpp"

namespace torsor {

/// The kernels that a functional mock-up unit of the scene is made of.
std::vector<std::string> fmi_kernels(const Scene& scene);

/// The C99 text of the unit, which binaries/ is compiled from: first the file that includes the others.
std::vector<SourceFile> fmi_sources(const MechanismListing& mechanism, FmiVersion version);

/// The C++ text that moves a unit with contacts, which is compiled beside that and linked with the contact layer: first the
/// file that includes the others.
std::vector<SourceFile> fmi_contact_sources(const MechanismListing& mechanism);

/// How to compile them: sources/buildDescription.xml of FMI 3.0.
std::string fmi_build_description(const MechanismListing& mechanism);

}  // namespace torsor
