// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/mechanics/scene_content.hpp"

#include <fmt/format.h>

#include "generator/expression/error.hpp"

namespace torsor {
namespace {

template <class Content>
int find_index(const std::vector<Content>& all, const std::variant<int, std::string>& target, const std::string& kind,
               const std::string& user) {
  if (const int* index = std::get_if<int>(&target)) {
    if (*index >= 0 && *index < static_cast<int>(all.size())) return *index;
    throw SceneError(fmt::format("{} uses {} number {}, which belongs to another scene", user, kind, *index));
  }
  const std::string& name = std::get<std::string>(target);
  std::string known;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].name == name) return static_cast<int>(i);
    known += (known.empty() ? "" : ", ") + all[i].name;
  }
  throw SceneError(fmt::format("unknown {} '{}' in {}: the scene has {}", kind, name, user,
                               known.empty() ? "none" : known));
}

}  // namespace

int SceneContent::frame_index(const FrameReference& reference, const std::string& user) const {
  return find_index(frames, reference.target, "frame", user);
}
int SceneContent::point_index(const PointReference& reference, const std::string& user) const {
  return find_index(points, reference.target, "point", user);
}

}  // namespace torsor
