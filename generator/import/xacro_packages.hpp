// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace torsor {

/// Finds folders of ROS packages for $(find package). Looked at in this order: the given folders, those of
/// ROS_PACKAGE_PATH, share/ in those of AMENT_PREFIX_PATH, the folders above the file and what lies beside them. A
/// folder is a package when its package.xml names it, or, without one, when it has the package's name.
class PackageFolders {
 public:
  /// `file` is the file that is read; `given` are folders of packages or that hold them, at any depth up to 4.
  PackageFolders(const std::string& file, const std::vector<std::string>& given);

  std::optional<std::string> find(const std::string& package);
  /// Where was looked, for messages.
  std::string described() const;

 private:
  std::vector<std::string> deep_;    ///< whatever is below them is looked at
  std::vector<std::string> beside_;  ///< they, and what lies in them
  std::map<std::string, std::optional<std::string>> found_;
};

}  // namespace torsor
