// SPDX-License-Identifier: MIT
#pragma once
#include <exception>
#include <filesystem>
#include <functional>
#include <iostream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

#include "runtime/records/file.hpp"
#include "runtime/records/reference.hpp"

namespace torsor::runtime {

namespace detail {

/// The file in this folder or in the nearest one above it; empty when there is none.
inline std::filesystem::path find_upwards(std::filesystem::path folder, const std::filesystem::path& file) {
  std::error_code error;
  folder = std::filesystem::weakly_canonical(folder, error);
  for (; !error && !folder.empty(); folder = folder.parent_path()) {
    if (std::filesystem::is_regular_file(folder / file, error)) return folder / file;
    if (folder == folder.parent_path()) break;
    error.clear();
  }
  return {};
}

}  // namespace detail

/// `generated/<name>.reference.csv`, in the nearest folder upwards of the current one or of the program's own.
/// Throws FileError when there is none.
[[nodiscard]] inline std::filesystem::path find_reference(const std::filesystem::path& program,
                                                          const std::string& name) {
  const std::filesystem::path file = std::filesystem::path("generated") / (name + ".reference.csv");
  for (const auto& start : {std::filesystem::path("."), program.parent_path()}) {
    const std::filesystem::path found = detail::find_upwards(start.empty() ? "." : start, file);
    if (!found.empty()) return found;
  }
  throw FileError("cannot find '" + file.string() +
                  "' in the current folder, the program's, or one above; run in the "
                  "source tree or name the file by --reference");
}

/// The main of a program that shows a generated mechanism at work: reads the command line `[--reference FILE]`, then
/// calls `show(reference)`. Answers --help. Returns the exit code: 0, 2 for bad usage, 3 when a file or a plot cannot
/// be read or made, with one line on stderr.
inline int demonstrate(int argc, char** argv, const std::string& name, std::string_view about,
                       const std::function<void(const Reference<double>&)>& show) {
  std::filesystem::path path;
  const std::string usage = "usage: " + name + " [--reference FILE] [--help]";
  for (int i = 1; i < argc; ++i) {
    const std::string_view argument = argv[i];
    if (argument == "--help" || argument == "-h") {
      std::cout << name << ": " << about << '\n'
                << usage << "\n  --reference FILE  the reference to compare with, generated/" << name
                << ".reference.csv if not given\n";
      return 0;
    }
    if (argument != "--reference" || i + 1 == argc) {
      std::cerr << name << ": cannot understand '" << argument << "'; " << usage << '\n';
      return 2;
    }
    path = argv[++i];
  }
  try {
    if (path.empty()) path = find_reference(argv[0], name);
    show(read_reference<double>(path));
    return 0;
  } catch (const std::exception& error) {
    std::cerr << name << ": " << error.what() << '\n';
    return 3;
  }
}

}  // namespace torsor::runtime
