// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "torsor/generator/emission/mechanism_listing.hpp"

namespace torsor {

struct COptions {
  std::string support{};          ///< the file that the header includes, of shared_c_support(); empty for none
  std::string source{};           ///< of functions and tables, as the command line calls it; empty for a header alone
  std::string included_header{};  ///< how that file includes the header; not empty where there is a source
};

struct CText {
  std::string header;
  std::string source;  ///< empty for a header alone
};

/// A mechanism in C99: the kernels of `emit_header` as functions `<scene>_<kernel>`, in double, or in float where
/// TORSOR_SINGLE is defined; inline in a header, or with a source file. Without fused operations, results have the bits of
/// the C++ header. Throws SceneError for a name that cannot stand in a header.
CText emit_c(const MechanismListing& mechanism, const COptions& options = {});

/// What all headers in C have in common, as one file.
std::string shared_c_support();

}  // namespace torsor
