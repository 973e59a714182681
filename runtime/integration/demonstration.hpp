// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <exception>
#include <filesystem>
#include <functional>
#include <iostream>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "torsor/runtime/records/file.hpp"
#include "torsor/runtime/records/reference.hpp"

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

/// Where a demonstration leaves its plots and their data: in a folder that was asked for, or nowhere.
class PlotFolder {
 public:
  PlotFolder() = default;
  explicit PlotFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// False: no plot is wanted, and none is to be written.
  explicit operator bool() const { return !folder_.empty(); }
  /// A file in the folder, which is made when it is not there.
  std::filesystem::path file(const std::string& name) const {
    std::filesystem::create_directories(folder_);
    return folder_ / name;
  }

 private:
  std::filesystem::path folder_;
};

/// What a program says of itself.
struct Demonstration {
  std::string name;        ///< its own, and that of its reference file
  std::string_view about;  ///< one line for --help
};

namespace detail {

inline int demonstrate(std::span<char* const> arguments, const Demonstration& program, bool has_plots,
                       const std::function<void(const Reference<double>&, const PlotFolder&)>& show) {
  const std::string& name = program.name;
  std::filesystem::path path;
  PlotFolder plots;
  const std::string usage = "usage: " + name + " [--reference FILE]" + (has_plots ? " [--plots FOLDER]" : "") + " [--help]";
  for (std::size_t i = 1; i < arguments.size(); ++i) {
    const std::string_view argument = arguments[i];
    const bool last = i + 1 == arguments.size();
    if (argument == "--help" || argument == "-h") {
      std::cout << name << ": " << program.about << '\n'
                << usage << "\n  --reference FILE  the reference to compare with, generated/" << name
                << ".reference.csv if not given\n";
      if (has_plots) std::cout << "  --plots FOLDER    writes plots and their data there; none if not given\n";
      return 0;
    }
    if (has_plots && argument == "--plots" && !last && *arguments[i + 1] != '\0') {
      plots = PlotFolder(arguments[++i]);
      continue;
    }
    if (argument != "--reference" || last) {
      std::cerr << name << ": cannot understand '" << argument << "'; " << usage << '\n';
      return 2;
    }
    path = arguments[++i];
  }
  try {
    if (path.empty()) path = find_reference(arguments[0], name);
    show(read_reference<double>(path), plots);
    return 0;
  } catch (const std::exception& error) {
    std::cerr << name << ": " << error.what() << '\n';
    return 3;
  }
}

}  // namespace detail

/// The main of a program that shows a generated mechanism at work: reads the command line `[--reference FILE]`, then
/// calls `show(reference)`. Answers --help. It writes nothing but what it prints. Returns the exit code: 0, 2 for bad
/// usage, 3 when a file or a plot cannot be read or made, with one line on stderr.
inline int demonstrate(int argc, char** argv, const Demonstration& program,
                       const std::function<void(const Reference<double>&)>& show) {
  return detail::demonstrate({argv, static_cast<std::size_t>(argc)}, program, false,
                             [&show](const Reference<double>& reference, const PlotFolder&) { show(reference); });
}

/// The same of a program that has plots too: `--plots FOLDER` asks for them, and `show(reference, plots)` writes them
/// only where it was given.
inline int demonstrate_with_plots(int argc, char** argv, const Demonstration& program,
                                  const std::function<void(const Reference<double>&, const PlotFolder&)>& show) {
  return detail::demonstrate({argv, static_cast<std::size_t>(argc)}, program, true, show);
}

}  // namespace torsor::runtime
