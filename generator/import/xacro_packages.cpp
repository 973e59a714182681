// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/import/xacro_packages.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include <fmt/format.h>
#include <tinyxml2.h>

namespace torsor {
namespace {

namespace fs = std::filesystem;

constexpr int depth_of_packages = 4;

std::vector<std::string> paths_of_environment(const char* variable, const std::string& below) {
  std::vector<std::string> paths;
  const char* value = std::getenv(variable);
  const std::string all = value == nullptr ? "" : value;
  std::size_t begin = 0;
  while (begin < all.size()) {
    const std::size_t end = std::min(all.find(':', begin), all.size());
    if (end > begin) paths.push_back(all.substr(begin, end - begin) + below);
    begin = end + 1;
  }
  return paths;
}

/// The package that a folder is: by its package.xml, otherwise by its name.
std::string package_of(const fs::path& folder) {
  std::error_code none;
  const fs::path file = folder / "package.xml";
  tinyxml2::XMLDocument document;
  if (fs::is_regular_file(file, none) && document.LoadFile(file.c_str()) == tinyxml2::XML_SUCCESS) {
    const auto* root = document.RootElement();
    const auto* name = root == nullptr ? nullptr : root->FirstChildElement("name");
    const std::string text = name == nullptr || name->GetText() == nullptr ? "" : name->GetText();
    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    if (begin != std::string::npos) return text.substr(begin, text.find_last_not_of(" \t\r\n") + 1 - begin);
  }
  return folder.filename().string();
}

/// Folders inside, by name, so that every machine finds the same.
std::vector<fs::path> folders_in(const fs::path& folder) {
  std::vector<fs::path> all;
  std::error_code failure;
  for (auto each = fs::directory_iterator(folder, fs::directory_options::skip_permission_denied, failure);
       !failure && each != fs::directory_iterator(); each.increment(failure)) {
    std::error_code none;
    const std::string name = each->path().filename().string();
    if (each->is_directory(none) && !name.starts_with('.')) all.push_back(each->path());
  }
  std::sort(all.begin(), all.end());
  return all;
}

std::optional<std::string> find_below(const fs::path& folder, const std::string& package, int depth) {
  std::error_code none;
  if (!fs::is_directory(folder, none)) return std::nullopt;
  if (package_of(folder) == package) return folder.string();
  if (depth == 0) return std::nullopt;
  if (fs::is_directory(folder / package, none) && package_of(folder / package) == package) {
    return (folder / package).string();
  }
  for (const fs::path& inner : folders_in(folder)) {
    if (auto found = find_below(inner, package, depth - 1)) return found;
  }
  return std::nullopt;
}

}  // namespace

PackageFolders::PackageFolders(const std::string& file, const std::vector<std::string>& given) : deep_(given) {
  for (const auto& paths :
       {paths_of_environment("ROS_PACKAGE_PATH", ""), paths_of_environment("AMENT_PREFIX_PATH", "/share")}) {
    deep_.insert(deep_.end(), paths.begin(), paths.end());
  }
  for (std::string& path : deep_) {
    while (path.size() > 1 && path.back() == '/') path.pop_back();
  }
  std::error_code none;
  fs::path at = fs::absolute(file, none).lexically_normal().parent_path();
  for (int up = 0; up < depth_of_packages && at != at.root_path(); ++up, at = at.parent_path())
    beside_.push_back(at.string());
}

std::optional<std::string> PackageFolders::find(const std::string& package) {
  if (package.empty() || package.find('/') != std::string::npos) return std::nullopt;
  const auto known = found_.find(package);
  if (known != found_.end()) return known->second;
  std::optional<std::string> found;
  for (const std::string& folder : deep_) {
    if (!found) found = find_below(folder, package, depth_of_packages);
  }
  for (const std::string& folder : beside_) {
    if (!found && package_of(folder) == package) found = folder;
    if (!found) found = find_below(fs::path(folder) / package, package, 0);
  }
  found_[package] = found;
  return found;
}

std::string PackageFolders::described() const {
  std::string text;
  for (const std::string& folder : deep_) text += folder + ", ";
  return text + "the folders above the file";
}

}  // namespace torsor
