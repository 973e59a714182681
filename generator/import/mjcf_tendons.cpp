// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "torsor/generator/import/mjcf_builder.hpp"

namespace torsor {

/// A frame of that name with the axes of a site.
void MjcfBuilder::weld_at(const MjcfSite& site, const std::string& name) {
  scene_.weld(name, frames_[static_cast<std::size_t>(site.body)],
              {lengths(site.position), rotation(site.quaternion, "site " + site.name)});
}

/// The same, made once.
const std::string& MjcfBuilder::frame_of_site(int site) {
  const auto found = site_frames_.find(site);
  if (found != site_frames_.end()) return found->second;
  const MjcfSite& there = model_.sites[static_cast<std::size_t>(site)];
  const std::string name = identifiers_.frame(there.name, "site", {"", "_at"});
  weld_at(there, name);
  return site_frames_.emplace(site, name).first->second;
}

/// A point at a site, made once.
PointHandle MjcfBuilder::point_of_site(int site) {
  const auto found = site_points_.find(site);
  if (found != site_points_.end()) return found->second;
  const MjcfSite& there = model_.sites[static_cast<std::size_t>(site)];
  const std::string name = identifiers_.frame(there.name, "site", {"_at"}) + "_at";
  const PointHandle point = scene_.point(name, frames_[static_cast<std::size_t>(there.body)], lengths(there.position));
  site_points_.emplace(site, point);
  return point;
}

// A parent comes before its children, so that the larger index is the one to leave.
int MjcfBuilder::common_carrier(int body, int other) const {
  while (body != other) {
    int& leaves = body > other ? body : other;
    leaves = model_.bodies[static_cast<std::size_t>(leaves)].parent;
  }
  return body;
}

/// Whether a joint that may move stands between them.
bool MjcfBuilder::move_apart(int body, int other) const {
  const int carrier = common_carrier(body, other);
  for (int at : {body, other}) {
    for (; at != carrier; at = model_.bodies[static_cast<std::size_t>(at)].parent) {
      for (std::size_t k = 0; k < model_.joints.size(); ++k) {
        if (model_.joints[k].body == at && !is_held(k)) return true;
      }
    }
  }
  return false;
}

/// In metres; nothing where the tendon runs around geoms. A coefficient is in m for a hinge and a number for a slide.
std::optional<Expression> MjcfBuilder::tendon_length(const MjcfTendon& tendon) {
  if (tendon.wraps) return std::nullopt;
  Expression length = 0;
  for (const auto& [joint, coefficient] : tendon.terms) {
    if (coefficient == 0) continue;
    const auto i = static_cast<std::size_t>(joint);
    const Unit unit = model_.joints[i].type == MjcfJointType::hinge ? units::metre : Unit();
    length = length + Expression::quantity(from_double(coefficient), unit) * position(i);
  }
  for (const MjcfTendonSpan& span : tendon.spans) {
    const MjcfSite& a = model_.sites[static_cast<std::size_t>(span.from)];
    const MjcfSite& b = model_.sites[static_cast<std::size_t>(span.to)];
    const Expression divisor = Expression(from_double(span.divisor));
    if (!move_apart(a.body, b.body)) {
      length = length + Expression::quantity(from_double(span.length_at_reference), units::metre) / divisor;
      continue;
    }
    const Triple end = scene_.position(point_of_site(span.to), frames_[static_cast<std::size_t>(a.body)]);
    const Triple begin = lengths(a.position);
    Expression square = 0;
    for (std::size_t k = 0; k < 3; ++k) square = square + (end[k] - begin[k]) * (end[k] - begin[k]);
    length = length + sqrt(square) / divisor;
  }
  return length;
}

bool MjcfBuilder::varies(const Expression& f) {
  const auto is_coordinate = [](const SymbolPointer& symbol) {
    return symbol->kind == SymbolKind::coordinate && !symbol->measure;
  };
  const std::vector<SymbolPointer> symbols = f.symbols();
  return std::any_of(symbols.begin(), symbols.end(), [&](const SymbolPointer& symbol) {
    return is_coordinate(symbol) || std::any_of(symbol->made_of.begin(), symbol->made_of.end(), is_coordinate);
  });
}

}  // namespace torsor
