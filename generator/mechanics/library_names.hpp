// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace torsor {

/// Whether a name is a macro of the C library: of any standard header that generated headers or runtime/ include, or
/// that those include, with glibc. No member of a structure can have it.
bool is_library_macro(const std::string& name);

/// Whether one of those headers declares the name in the global namespace, a function, a type or a variable, or g++ knows
/// it as a function without any header. No namespace can have it.
bool is_global_library_name(const std::string& name);

}  // namespace torsor
