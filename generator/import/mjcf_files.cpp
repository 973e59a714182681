// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/import/mjcf_files.hpp"

#include <algorithm>
#include <filesystem>

#include <tinyxml2.h>

namespace torsor {
namespace {

class MjcfFiles {
 public:
  explicit MjcfFiles(const std::string& path) : folder_(std::filesystem::path(path).parent_path()) { read(path); }
  std::vector<std::string> found() const { return {read_.begin() + 1, read_.end()}; }

 private:
  void read(const std::string& path) {
    if (std::find(read_.begin(), read_.end(), path) != read_.end()) return;
    read_.push_back(path);
    tinyxml2::XMLDocument document;
    if (!path.ends_with(".xml") || document.LoadFile(path.c_str()) != tinyxml2::XML_SUCCESS) return;
    if (document.RootElement() != nullptr) look_at(*document.RootElement());
  }

  void look_at(const tinyxml2::XMLElement& element) {
    if (std::string(element.Name()) == "compiler") {
      for (const char* folder : {"meshdir", "texturedir", "assetdir"}) {
        if (const char* given = element.Attribute(folder)) folders_.emplace_back(given);
      }
    }
    if (const char* file = element.Attribute("file")) {
      std::error_code none;
      for (const std::string& below : folders_) {
        const auto path = (folder_ / below / file).lexically_normal();
        if (!std::filesystem::is_regular_file(path, none)) continue;
        read(path.string());
        break;
      }
    }
    for (const auto* child = element.FirstChildElement(); child != nullptr; child = child->NextSiblingElement()) {
      look_at(*child);
    }
  }

  std::filesystem::path folder_;  ///< of the first file: all names are relative to it
  std::vector<std::string> folders_{""};
  std::vector<std::string> read_;
};

}  // namespace

std::vector<std::string> mjcf_files(const std::string& path) { return MjcfFiles(path).found(); }

}  // namespace torsor
