// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace torsor {

/// Refuses a name that generated code could not carry: letters, digits and single underscores inside, a letter first, no
/// C++ keyword. `what` says what is named ("parameter"). Throws SceneError with the name and the remedy.
void require_identifier(const std::string& name, const std::string& what);

/// Why a well-formed name cannot stand in generated C++ ("is a C++ keyword", a macro of the library, a type of the
/// header; of a scene also a function of the C library), or null when it can.
const char* reserved_in_headers(const std::string& name, bool names_scene);

}  // namespace torsor
