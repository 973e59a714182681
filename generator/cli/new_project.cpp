// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/cli/new_project.hpp"

#include <filesystem>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/base/output_file.hpp"
#include "torsor/generator/emission/embedded_templates.hpp"
#include "torsor/generator/emission/text_template.hpp"
#include "torsor/generator/mechanics/identifier.hpp"

namespace torsor {

std::vector<std::string> write_new_project(const std::string& name) {
  require_identifier(name, "project");
  if (const char* reason = reserved_in_headers(name, true)) {
    throw SceneError(fmt::format("the name '{}' of a project {}: choose another", name, reason));
  }
  for (const char* target : {"all", "clean", "edit_cache", "help", "install", "package", "page", "test"}) {
    if (name != target) continue;
    throw SceneError(fmt::format("the name '{}' of a project is that of a target of every build: choose another", name));
  }
  if (std::filesystem::exists(name)) {
    throw FileError(fmt::format("'{}' exists already: give another name, or move it away", name));
  }
  std::error_code failed;
  std::filesystem::create_directory(name, failed);
  if (failed) throw FileError(fmt::format("cannot make the folder '{}': {}", name, failed.message()));
  std::vector<std::string> files;
  for (const char* file : {"scene.cpp", "main.cpp", "CMakeLists.txt", "README.md"}) {
    const std::string from = fmt::format("new/{}.in", file);
    files.push_back(fmt::format("{}/{}", name, file));
    write_file_if_changed(files.back(), fill_template(from, embedded_template(from), {{"name", name}}));
  }
  return files;
}

}  // namespace torsor
