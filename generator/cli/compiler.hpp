// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace torsor {

/// A compiler as words of a command, and what it says of itself.
struct Compiler {
  std::vector<std::string> words;
  std::string version;
};

/// That of the environment's variable, or the first of the candidates that runs. Throws FileError where none does; the
/// language, "C++20", is for the message.
Compiler found_compiler(const std::string& variable, const std::vector<std::string>& candidates,
                        const std::string& language);

/// Of what a compiler said, the first lines that name an error.
std::string compiler_errors(const std::string& output);

/// Where what moves contacts finds Eigen.
std::string eigen_folder();

/// What a person is told where a compiler does not find it; else nothing.
std::string eigen_remedy(const std::string& output);

/// What it predefines with these flags, one "#define NAME VALUE" a line. Throws FileError where it does not run.
std::string predefined_macros(const Compiler& compiler, const std::vector<std::string>& flags);

/// Says on the standard error what is compiled, where a person looks at it and would else wait in silence.
void tell_of_compiling(const std::string& what, const Compiler& compiler);

/// The bytes of what it made. Throws FileError where they cannot be read.
std::string compiled_bytes(const std::string& path);

std::vector<std::string> separate_words(const std::string& text);

}  // namespace torsor
