// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "torsor/generator/cli/compiler.hpp"
#include "torsor/generator/emission/mechanism_listing.hpp"

namespace torsor {

struct LibraryOptions {
  std::string flags = "-O3 -march=native";  ///< of the compiler, separated by spaces
  bool fused = false;                       ///< products may be fused with sums: faster, other last digits
};

/// What the compiler is told besides: flags, fusing, and room for the scene's contacts. The same for units of FMI, which then
/// share the contact layer with libraries.
std::vector<std::string> compiler_flags(const LibraryOptions& options, const Scene& scene);

/// The path of a shared library of the mechanism (runtime/abi.h). It lies in a cache, under a name that tells sources,
/// compiler, flags and processor: what is there is not compiled again. The cache is $TORSOR_CACHE, or torsor in
/// $XDG_CACHE_HOME, or ~/.cache/torsor. The compiler is $CXX, or the first of c++, g++ and clang++ on the PATH.
/// Throws FileError where there is no compiler, or where it fails, with what it said.
std::string compiled_library(const MechanismListing& mechanism, const LibraryOptions& options);

/// The path of the runtime's contact layer as an object for position-independent code, compiled with these further
/// options. It lies in the same cache: only the first mechanism with contacts waits for it. Throws as compiled_library.
std::string compiled_contact_layer(const Compiler& compiler, const std::vector<std::string>& options);

}  // namespace torsor
