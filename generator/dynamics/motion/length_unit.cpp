// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>

#include "generator/dynamics/motion/model.hpp"

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

void Model::choose_length_unit() {
  const bool slides = std::any_of(links_.begin() + 1, links_.end(),
                                  [](const Link& link) { return link.joint == JointKind::prismatic; });
  if (!slides) length_unit_ = most_frequent_length(links_);
  if (length_unit_ && *length_unit_ == Number(1)) length_unit_.reset();  // as it is
  if (!length_unit_) return;
  const Value unit = length();
  for (Link& link : links_) {
    for (MassProperties* body : {&link.effective, &link.off_axis}) {
      const Value first = program_->bind(body->mass * unit);
      body->mass = program_->bind(first * unit);
      body->first_moment = bound(*program_, unit * body->first_moment);
    }
  }
}

Value Model::length() const { return program_->number(*length_unit_, units::metre); }

Vector Model::arm(const Link& link) const {
  const Vector origin = origin_in_parent(link);
  if (!length_unit_) return origin;
  const Value inverse = pow(length(), -1);
  return inverse * origin;
}

Vector Model::upward_gravity() const {
  const Vector upward = -lower(*program_, scene_->gravity);
  if (!length_unit_) return upward;
  const Value inverse = pow(length(), -1);
  return inverse * upward;
}

Wrench Model::over_length(const Wrench& wrench) const {
  if (!length_unit_) return wrench;
  return {length() * wrench.resultant, wrench.moment};
}

std::string Model::length_note(const char* relation) const {
  return length_unit_ ? fmt::format("{} {:.6g} m", relation, length_unit_->to_double()) : "";
}

}  // namespace torsor
