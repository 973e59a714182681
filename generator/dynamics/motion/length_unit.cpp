// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>

#include "torsor/generator/dynamics/motion/body_tree.hpp"

namespace torsor {
namespace {

/// The constant that stands most often, up to sign, among the components of the places of joints on moving links; of
/// equals the one met first.
std::optional<Number> most_frequent_length(const std::vector<Link>& links) {
  std::vector<std::pair<Number, int>> counts;
  for (std::size_t k = 1; k < links.size(); ++k) {
    if (links[k].parent == 0) continue;  // the ground does not turn: nothing is multiplied there
    for (int i = 0; i < 3; ++i) {
      const Value& component = links[k].placement_origin[i];
      if (component.is_zero() || !component.is_constant()) continue;
      const Number size = component.polynomial().constant().abs();
      const auto place = std::find_if(counts.begin(), counts.end(), [&](const auto& c) { return c.first == size; });
      if (place == counts.end()) {
        counts.emplace_back(size, 1);
      } else {
        ++place->second;
      }
    }
  }
  const auto best = std::max_element(counts.begin(), counts.end(),
                                     [](const auto& a, const auto& b) { return a.second < b.second; });
  if (best == counts.end()) return std::nullopt;
  return best->first;
}

}  // namespace

BodyTree in_length_unit(const BodyTree& tree) {
  BodyTree result = tree;
  std::vector<Link>& links = result.links_;
  const bool slides = std::any_of(links.begin() + 1, links.end(),
                                  [](const Link& link) { return link.joint == JointKind::prismatic; });
  if (!slides) result.length_unit_ = most_frequent_length(links);
  if (result.length_unit_ && *result.length_unit_ == Number(1)) result.length_unit_.reset();  // as it is
  if (!result.length_unit_) return result;
  Program& program = *result.program_;
  const Value unit = result.length();
  for (Link& link : links) {
    MassProperties& body = link.mass;
    const Value first = program.bind(body.mass * unit);
    body.mass = program.bind(first * unit);
    body.first_moment = bound(program, unit * body.first_moment);
  }
  return result;
}

Value BodyTree::length() const { return program_->number(*length_unit_, units::metre); }

std::string BodyTree::length_note(const char* relation) const {
  return length_unit_ ? fmt::format("{} {:.6g} m", relation, length_unit_->to_double()) : "";
}

}  // namespace torsor
