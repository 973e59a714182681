// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>

#include "generator/dynamics/motion/model.hpp"
#include "generator/dynamics/motion/nominal_number.hpp"

namespace torsor {
namespace {

/// R v for a rotation by the link's angle (its transpose for the inverse turn).
Vector turn(Program& program, const Link& link, const Vector& v, bool inverse) {
  if (link.turn == Turn::none) return v;
  if (link.turn == Turn::general) return bound(program, (inverse ? transpose(link.rotation) : link.rotation) * v);
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

/// R J Rᵀ (the inverse turn: Rᵀ J R) for a turn about an aligned axis z. With d = J_xx − J_yy, e = J_xy + J_yx and u = s d + c e:
/// J'_xx = J_xx − s u, J'_yy = J_yy + s u, J'_xy = c u − J_yx, J'_yx = c u − J_xy, and (J_xz, J_yz), (J_zx, J_zy) turn as
/// vectors. 16 operations for a symmetric array where two general products take 27.
///
/// Where e vanishes, J_xx cos² + J_yy sin² is written from the smaller of both moments, J_yy + d cos², the other as
/// J_yy + d sin²: a sum of positive terms, which loses nothing where the squares are near 1.
Matrix turn(Program& program, const SceneContent& scene, const Link& link, const Matrix& j, bool inverse) {
  if (link.turn == Turn::none) return j;
  if (link.turn == Turn::general) {
    const Matrix back = transpose(link.rotation);
    const Matrix half = bound(program, (inverse ? back : link.rotation) * j);
    return bound(program, half * (inverse ? link.rotation : back));
  }
  const Value sine = inverse ? -link.sine : link.sine;
  const int z = link.aligned;
  const int x = (z + 1) % 3;
  const int y = (z + 2) % 3;
  const Value difference = program.bind(j(x, x) - j(y, y));
  const Value sum = program.bind(j(x, y) + j(y, x));
  const Vector column = turn(program, link, {j(0, z), j(1, z), j(2, z)}, inverse);
  const Vector row = turn(program, link, {j(z, 0), j(z, 1), j(z, 2)}, inverse);
  Matrix turned;
  const std::optional<double> across = nominal_number(scene, j(x, x));
  const std::optional<double> along = nominal_number(scene, j(y, y));
  if (sum.is_zero() && across && along && *across != *along) {
    const bool first = std::abs(*across) > std::abs(*along);  // the larger moment
    const Value& least = first ? j(y, y) : j(x, x);
    const Value spread = first ? difference : program.bind(-difference);
    const Value by_sine = program.bind(sine * spread), by_cosine = program.bind(link.cosine * spread);
    turned(first ? x : y, first ? x : y) = program.bind(least + link.cosine * by_cosine);
    turned(first ? y : x, first ? y : x) = program.bind(least + sine * by_sine);
    const Value mixed = program.bind(sine * by_cosine);
    turned(x, y) = turned(y, x) = first ? mixed : -mixed;
    turned(x, y) -= j(y, x);
    turned(y, x) -= j(x, y);
  } else {
    Value u = sine * difference;
    u += link.cosine * sum;
    u = program.bind(u);
    const Value change = program.bind(sine * u);
    const Value mixed = link.cosine * u;
    turned(x, x) = program.bind(j(x, x) - change);
    turned(y, y) = program.bind(j(y, y) + change);
    turned(x, y) = program.bind(mixed - j(y, x));
    turned(y, x) = program.bind(mixed - j(x, y));
  }
  for (const int i : {x, y}) {
    turned(i, z) = column[i];
    turned(z, i) = row[i];
  }
  turned(z, z) = j(z, z);
  return turned;
}

}  // namespace

Matrix Model::to_parent(const Link& link, const Matrix& j) const {
  const Matrix turned = turn(*program_, *scene_, link, j, false);
  if (link.placement_rotation.is_identity()) return turned;
  const Matrix placement = constant_matrix(*program_, link.placement_rotation);
  return bound(*program_, placement * turned * transpose(placement));
}

Matrix Model::from_parent(const Link& link, const Matrix& j) const {
  if (link.placement_rotation.is_identity()) return turn(*program_, *scene_, link, j, true);
  const Matrix placement = constant_matrix(*program_, link.placement_rotation);
  return turn(*program_, *scene_, link, bound(*program_, transpose(placement) * j * placement), true);
}

Vector Model::to_parent(const Link& link, const Vector& v) const {
  return link.placement_rotation * turn(*program_, link, v, false);
}

Vector Model::to_joint(const Link& link, const Vector& v) const {
  return bound(*program_, link.placement_rotation.transpose() * v);
}

Vector Model::from_parent(const Link& link, const Vector& v) const {
  return turn(*program_, link, to_joint(link, v), true);
}

Vector Model::axis_in_parent(const Link& link) const {
  // Axes of a quaternion's links turn with them; any other turn leaves its axis alone.
  const bool moves = link.turn == Turn::general && link.aligned >= 0;
  return moves ? to_parent(link, link.axis) : link.placement_rotation * link.axis;
}

Vector Model::origin_in_parent(const Link& link) const {
  if (link.joint != JointKind::prismatic) return link.placement_origin;
  return link.placement_origin + link.displacement * axis_in_parent(link);
}

std::size_t Model::turning_link(std::size_t link) const {
  while (link + 1 < links_.size() && links_[link + 1].in_group == links_[link].in_group + 1) ++link;
  return link;
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

/// The joints from a link up to just below `top`; neighbours that turn about one axis become a single joint by the sum
/// of their angles, so that absolute angles come out as they are and relative ones are turned by once.
std::vector<Link> Model::runs(int link, int top) const {
  std::vector<Link> all;
  for (int k = link; k != top;) {
    Link run = links_[static_cast<std::size_t>(k)];
    bool merged = false;
    for (k = run.parent; k != top; k = run.parent) {
      Link outer = links_[static_cast<std::size_t>(k)];
      const bool parallel = run.turn == Turn::aligned && outer.turn == Turn::aligned && run.aligned == outer.aligned &&
                            run.placement_rotation.is_identity();
      if (!parallel) break;
      outer.angle += run.angle;
      run = outer;
      merged = true;
    }
    if (merged) {
      run.sine = program_->sin(run.angle);
      run.cosine = program_->cos(run.angle);
    }
    all.push_back(std::move(run));
  }
  return all;
}

Vector Model::express(const Vector& v, int from, int to) const {
  const int top = common_ancestor(links_, from, to);
  Vector w = v;
  for (const Link& run : runs(from, top)) w = to_parent(run, w);
  const std::vector<Link> down = runs(to, top);
  for (auto run = down.rbegin(); run != down.rend(); ++run) w = from_parent(*run, w);
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
  if (point.lowest) return lowest(point, link, user);
  const FramePlace& at = place(point.frame, "point '" + point.name + "'");
  return locate(at.origin + at.rotation * lower(*program_, point.components), at.link, link);
}

Vector Model::down_in(const PointContent& point, const FramePlace& at, const std::string& user) const {
  const Vector normal = bound(*program_, express(axis::z, point.lowest->plane, at.link, user));
  return bound(*program_, -(at.rotation.transpose() * normal));
}

std::pair<Value, Vector> Model::supported(const PointContent& point, const Vector& down) const {
  const SupportFunction& support = *point.lowest->support;
  Substitution in_direction(*program_, [&](const SymbolPointer& symbol) -> std::optional<Value> {
    for (int i = 0; i < 3; ++i) {
      if (support.direction[static_cast<std::size_t>(i)] == symbol) return down[i];
    }
    return std::nullopt;
  });
  const Value h = program_->bind(program_->lower(support.h));
  Vector place;
  for (int i = 0; i < 3; ++i) {
    const SymbolPointer& u = support.direction[static_cast<std::size_t>(i)];
    place[i] = program_->bind(in_direction(partial_derivation(*program_, u)(h)));
  }
  return {program_->bind(in_direction(h)), place};
}

Vector Model::lowest(const PointContent& point, int link, const std::string& user) const {
  Program& program = *program_;
  const FramePlace& at = place(point.frame, "point '" + point.name + "'");
  if (point.lowest->support) {
    const Vector place = supported(point, down_in(point, at, user)).second;
    return locate(at.origin + at.rotation * place, at.link, link);
  }
  const Vector center = locate(at.origin, at.link, link);
  Vector down = bound(program, -express(axis::z, point.lowest->plane, link, user));
  const Value radius = program.lower(point.lowest->radius);
  if (point.lowest->axis) {
    const Vector k = bound(program, express(*point.lowest->axis, point.frame, link, user));
    const Value along = program.bind(dot(down, k));
    down = bound(program, down - along * k);
    const Value square = dot(down, down);
    const Value scale = program.bind(radius / program.sqrt(square));
    if (point.lowest->tube.is_zero()) return center + scale * down;
    const Value tube = program.lower(point.lowest->tube);
    const Vector normal = bound(program, express(axis::z, point.lowest->plane, link, user));
    return center + scale * down - tube * normal;
  }
  return center + radius * down;
}

Value Model::lowest_height(const PointContent& point, int link, const std::string& user) const {
  Program& program = *program_;
  const FramePlace& at = place(point.frame, "point '" + point.name + "'");
  const FramePlace& plane = place(point.lowest->plane, user);
  const Vector normal = bound(program, express(axis::z, point.lowest->plane, link, user));
  const Vector center = locate(at.origin, at.link, link);
  const Vector origin = locate(plane.origin, plane.link, link);
  const Value height = program.bind(dot(bound(program, center - origin), normal));
  if (point.lowest->support) return height - supported(point, down_in(point, at, user)).first;
  const Value radius = program.lower(point.lowest->radius);
  if (!point.lowest->axis) return height - radius;
  const Vector k = bound(program, express(*point.lowest->axis, point.frame, link, user));
  const Value along = program.bind(dot(normal, k));
  const Vector rest = bound(program, normal - along * k);
  const Value over_rim = height - radius * program.sqrt(dot(rest, rest));
  return point.lowest->tube.is_zero() ? over_rim : over_rim - program.lower(point.lowest->tube);
}

Vector Model::express(const Triple& direction, const FrameReference& axes, int link, const std::string& user) const {
  const FramePlace& at = place(axes, user);
  return express(at.rotation * lower(*program_, direction), at.link, link);
}

}  // namespace torsor
