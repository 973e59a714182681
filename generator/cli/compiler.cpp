// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/cli/compiler.hpp"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/base/printable.hpp"
#include "torsor/generator/base/process.hpp"

#ifndef TORSOR_EIGEN_DIR
#define TORSOR_EIGEN_DIR "/usr/include/eigen3"
#endif

namespace torsor {

std::string eigen_folder() { return TORSOR_EIGEN_DIR; }

std::string eigen_remedy(const std::string& output) {
  return output.find("Eigen/") == std::string::npos ? "" : "; what moves contacts needs Eigen 3 (Debian: libeigen3-dev)";
}

std::vector<std::string> separate_words(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

Compiler found_compiler(const std::string& variable, const std::vector<std::string>& candidates,
                        const std::string& language) {
  const char* const named = std::getenv(variable.c_str());
  const bool chosen = named != nullptr && *named != '\0';
  for (const std::string& candidate : chosen ? std::vector<std::string>{named} : candidates) {
    std::vector<std::string> words = separate_words(candidate);
    if (words.empty()) continue;
    std::vector<std::string> question = words;
    question.push_back("--version");
    try {
      const ProcessResult said = run_process(question);
      if (said.code == 0) return {std::move(words), said.output};
    } catch (const FileError&) {  // the next candidate
    }
  }
  const std::string kind = language.substr(0, language.starts_with("C++") ? 3 : 1);
  throw FileError(fmt::format("no {} compiler: {}; install one (Debian: g++), or set {} to one that knows {}", kind,
                              chosen ? fmt::format("{}, which is '{}', does not run", variable, named)
                                     : fmt::format("none of {} runs", fmt::join(candidates, ", ")),
                              variable, language));
}

std::string predefined_macros(const Compiler& compiler, const std::vector<std::string>& flags) {
  std::vector<std::string> command = compiler.words;
  command.insert(command.end(), flags.begin(), flags.end());
  command.insert(command.end(), {"-dM", "-E", "-x", "c", "-"});  // the standard input is empty
  ProcessResult said = run_process(command);
  if (said.code != 0) {
    throw FileError(fmt::format("the compiler '{}' does not say what it predefines: {}", fmt::join(compiler.words, " "),
                                compiler_errors(said.output)));
  }
  return std::move(said.output);
}

void tell_of_compiling(const std::string& what, const Compiler& compiler) {
  if (isatty(STDERR_FILENO) == 0) return;
  const std::string text = fmt::format("compiling {} by {} (kept for the next time)", what, fmt::join(compiler.words, " "));
  std::fprintf(stderr, "%s\n", printable(text).c_str());
}

std::string compiled_bytes(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  if (!file || bytes.empty()) {
    throw FileError(fmt::format("cannot read '{}', which was just written; is another program at work there?", path));
  }
  return bytes;
}

std::string compiler_errors(const std::string& output) {
  std::istringstream stream(output);
  std::string text;
  int lines = 0;
  for (std::string line; std::getline(stream, line) && lines < 5;) {
    if (line.find("error") == std::string::npos) continue;
    text += (text.empty() ? "" : "; ") + line;
    ++lines;
  }
  return text.empty() ? output.substr(0, 500) : text;
}

}  // namespace torsor
