// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "torsor/generator/emission/mechanism_listing.hpp"

namespace torsor {

/// A text and its path below a folder.
struct SourceFile {
  std::string path, text;
};

/// The runtime's contact layer, the same for every mechanism: first the file that includes the others, `contact_layer.cpp`.
std::vector<SourceFile> contact_layer_sources();

/// Contacts that its matrices on the stack need room for, where it moves this scene alone: TORSOR_MOST_CONTACTS. Few
/// sizes, so that few layers are compiled.
std::size_t room_for_contacts(const Scene& scene);

/// Lines that make it a part of a file, unless TORSOR_CONTACT_LAYER_APART is defined: then it is linked.
std::string contact_layer_includes();

/// The kernels of a library, and last `run_time_sizes` where run-time parameters bear on sizes that cannot have any value.
MechanismListing lower_library(const Scene& scene, const std::vector<std::string>& kernels, const ModelOptions& options);

/// What a shared library of a mechanism with the interface of runtime/abi.h is compiled from, in C++20: `library.cpp`,
/// which comes first, the generated header, and headers of the runtime, all found from one folder.
std::vector<SourceFile> library_sources(const MechanismListing& mechanism);

}  // namespace torsor
