// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "torsor/generator/base/comment_text.hpp"
#include "torsor/generator/expression/symbol.hpp"
#include "torsor/generator/listing/local_names.hpp"

namespace torsor {

/// Where a kernel finds a symbol: "state.q.theta", "inputs.torque"; parameters under the given prefix.
std::string symbol_access(const Symbol& symbol, const std::string& parameters);

/// Throws SceneError when a name cannot stand in a generated header as `what` ("parameter", "scene"): C++ keywords,
/// macros of <cmath>, names of the header's own types, and for scenes the functions of the C library.
void require_cpp_name(const std::string& name, const std::string& what);

}  // namespace torsor
