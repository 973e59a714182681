// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "generator/dynamics/model.hpp"

namespace torsor {
namespace {

/// R v for a rotation by the link's angle (its transpose for the inverse turn).
Vector turn(Program& program, const Link& link, const Vector& v, bool inverse) {
  if (link.joint != JointKind::revolute) return v;
  if (link.aligned < 0) return bound(program, (inverse ? transpose(link.rotation) : link.rotation) * v);
  const int a = (link.aligned + 1) % 3;
  const int b = (link.aligned + 2) % 3;
  const Value sine = inverse ? -link.sine : link.sine;
  Vector turned = v;
  turned[a] = link.cosine * v[a];
  turned[a] -= sine * v[b];
  turned[b] = sine * v[a];
  turned[b] += link.cosine * v[b];
  return bound(program, turned);
}

}  // namespace

Vector Model::to_parent(const Link& link, const Vector& v) const {
  return link.placement_rotation * turn(*program_, link, v, false);
}

Vector Model::to_joint(const Link& link, const Vector& v) const {
  return bound(*program_, link.placement_rotation.transpose() * v);
}

Vector Model::from_parent(const Link& link, const Vector& v) const {
  return turn(*program_, link, to_joint(link, v), true);
}

Vector Model::axis_in_parent(const Link& link) const { return link.placement_rotation * link.axis; }

Vector Model::origin_in_parent(const Link& link) const {
  if (link.joint != JointKind::prismatic) return link.placement_origin;
  return link.placement_origin + link.displacement * axis_in_parent(link);
}

std::vector<int> Model::chain(int link) const {
  std::vector<int> path;
  for (int k = link; k > 0; k = links_[static_cast<std::size_t>(k)].parent) path.push_back(k);
  std::reverse(path.begin(), path.end());
  return path;
}

namespace {
/// The last link that both chains share; parents have smaller indices than children.
int common_ancestor(const std::vector<Link>& links, int a, int b) {
  while (a != b) {
    int& later = a > b ? a : b;
    later = links[static_cast<std::size_t>(later)].parent;
  }
  return a;
}
}  // namespace

Vector Model::express(const Vector& v, int from, int to) const {
  const int top = common_ancestor(links_, from, to);
  Vector w = v;
  for (int k = from; k != top; k = links_[static_cast<std::size_t>(k)].parent) {
    w = to_parent(links_[static_cast<std::size_t>(k)], w);
  }
  const std::vector<int> down = chain(to);
  for (const int k : down) {
    if (k > top) w = from_parent(links_[static_cast<std::size_t>(k)], w);
  }
  return w;
}

Vector Model::locate(const Vector& p, int from, int to) const {
  const int top = common_ancestor(links_, from, to);
  Vector w = p;
  for (int k = from; k != top;) {
    const Link& link = links_[static_cast<std::size_t>(k)];
    const Vector turned = to_parent(link, bound(*program_, w));
    w = bound(*program_, turned + origin_in_parent(link));
    k = link.parent;
  }
  for (const int k : chain(to)) {
    if (k <= top) continue;
    const Link& link = links_[static_cast<std::size_t>(k)];
    w = from_parent(link, bound(*program_, w - origin_in_parent(link)));
  }
  return w;
}

Vector Model::locate(const PointReference& reference, int link, const std::string& user) const {
  const PointContent& point = scene_->points[static_cast<std::size_t>(scene_->point_index(reference, user))];
  const FramePlace& at = place(point.frame, "point '" + point.name + "'");
  return locate(at.origin + at.rotation * lower(*program_, point.components), at.link, link);
}

Vector Model::express(const Triple& direction, const FrameReference& axes, int link, const std::string& user) const {
  const FramePlace& at = place(axes, user);
  return express(at.rotation * lower(*program_, direction), at.link, link);
}

}  // namespace torsor
