// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace torsor {

/// Whether a word is the name of a scene in C++: it ends in .cpp, .cc or .cxx.
bool names_scene_file(std::string_view word);

/// The path of the program of a scene in C++. CMake builds it with $CXX against the libraries of this torsor, or those that
/// $torsor_ROOT or $torsor_DIR name. It is kept in the cache (compile_cache.hpp) under a name that tells the path, the
/// compiler and its flags, and torsor; it is built again when the text, a file that it includes or torsor's library has
/// changed. Throws FileError where the file or a compiler is missing, and with what the compiler says where it fails.
std::string scene_file_program(const std::string& path);

/// What this program was built from, headers included, where it is one that the cache keeps.
std::vector<std::string> inputs_of_this_program();

}  // namespace torsor
