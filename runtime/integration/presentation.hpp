// SPDX-License-Identifier: MIT
#pragma once
#include <exception>
#include <functional>
#include <iostream>
#include <string>
#include <string_view>

#include "torsor/runtime/integration/demonstration.hpp"

namespace torsor::runtime {

/// The main of a program that shows something for which there is no reference file: reads the command line
/// `[--plots FOLDER]`, then calls `show(plots)`. Answers --help. Returns the exit code: 0, 2 for bad usage, 3 when a
/// file or a plot cannot be made, with one line on stderr.
inline int present(int argc, char** argv, const Demonstration& program,
                   const std::function<void(const PlotFolder&)>& show) {
  const std::string& name = program.name;
  PlotFolder plots;
  const std::string usage = "usage: " + name + " [--plots FOLDER] [--help]";
  for (int i = 1; i < argc; ++i) {
    const std::string_view argument = argv[i];
    if (argument == "--help" || argument == "-h") {
      std::cout << name << ": " << program.about << '\n'
                << usage << "\n  --plots FOLDER    writes plots and their data there; none if not given\n";
      return 0;
    }
    if (argument != "--plots" || i + 1 == argc || *argv[i + 1] == '\0') {
      std::cerr << name << ": cannot understand '" << argument << "'; " << usage << '\n';
      return 2;
    }
    plots = PlotFolder(argv[++i]);
  }
  try {
    show(plots);
    return 0;
  } catch (const std::exception& error) {
    std::cerr << name << ": " << error.what() << '\n';
    return 3;
  }
}

}  // namespace torsor::runtime
