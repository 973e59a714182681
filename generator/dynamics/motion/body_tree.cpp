// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>

#include "torsor/generator/dynamics/motion/body_tree.hpp"
#include "torsor/generator/dynamics/motion/nominal_number.hpp"
#include "torsor/generator/geometry/exact_turn.hpp"

namespace torsor {
namespace {

/// A turn about axis 0, 1 or 2.
struct AxisTurn {
  int axis;
  Value sine, cosine;
};

/// R v.
Vector turn(Program& program, const AxisTurn& by, const Vector& v) {
  const int a = (by.axis + 1) % 3;
  const int b = (by.axis + 2) % 3;
  Vector turned = v;
  turned[a] = by.cosine * v[a];
  turned[a] -= by.sine * v[b];
  turned[b] = by.sine * v[a];
  turned[b] += by.cosine * v[b];
  return bound(program, turned);
}

AxisTurn turn_of(const Link& link, bool inverse) {
  return {*link.aligned, inverse ? -link.sine : link.sine, link.cosine};
}

/// R v for a rotation by the link's angle (its transpose for the inverse turn).
Vector turn(Program& program, const Link& link, const Vector& v, bool inverse) {
  if (link.turn == Turn::none) return v;
  if (link.turn == Turn::general) return bound(program, (inverse ? transpose(link.rotation) : link.rotation) * v);
  return turn(program, turn_of(link, inverse), v);
}

/// R J Rᵀ for a turn about axis z. With d = J_xx − J_yy, e = J_xy + J_yx and u = s d + c e:
/// J'_xx = J_xx − s u, J'_yy = J_yy + s u, J'_xy = c u − J_yx, J'_yx = c u − J_xy, and (J_xz, J_yz), (J_zx, J_zy) turn
/// as vectors. 16 operations for a symmetric array where two general products take 27.
///
/// Where e vanishes, J_xx cos² + J_yy sin² is written from the smaller of both moments, J_yy + d cos², the other as
/// J_yy + d sin²: a sum of positive terms, which loses nothing where the squares are near 1.
Matrix turn(Program& program, const SceneContent& scene, const AxisTurn& by, const Matrix& j) {
  const auto& [z, sine, cosine] = by;
  const int x = (z + 1) % 3;
  const int y = (z + 2) % 3;
  const Value difference = program.bind(j(x, x) - j(y, y));
  const Value sum = program.bind(j(x, y) + j(y, x));
  const Vector column = turn(program, by, {j(0, z), j(1, z), j(2, z)});
  const Vector row = turn(program, by, {j(z, 0), j(z, 1), j(z, 2)});
  Matrix turned;
  const std::optional<double> across = nominal_number(scene, j(x, x));
  const std::optional<double> along = nominal_number(scene, j(y, y));
  if (sum.is_zero() && across && along && *across != *along) {
    const bool first = std::abs(*across) > std::abs(*along);  // the larger moment
    const Value& least = first ? j(y, y) : j(x, x);
    const Value spread = first ? difference : program.bind(-difference);
    const Value by_sine = program.bind(sine * spread), by_cosine = program.bind(cosine * spread);
    turned(first ? x : y, first ? x : y) = program.bind(least + cosine * by_cosine);
    turned(first ? y : x, first ? y : x) = program.bind(least + sine * by_sine);
    const Value mixed = program.bind(sine * by_cosine);
    turned(x, y) = turned(y, x) = first ? mixed : -mixed;
    turned(x, y) -= j(y, x);
    turned(y, x) -= j(x, y);
  } else {
    Value u = sine * difference;
    u += cosine * sum;
    u = program.bind(u);
    const Value change = program.bind(sine * u);
    const Value mixed = cosine * u;
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

/// The turn of a link's axes by its angle, or back.
struct LinkTurn {
  const Link& link;
  bool inverse;
};

/// The same by the link's angle (the inverse turn: Rᵀ J R).
Matrix turn(Program& program, const SceneContent& scene, const LinkTurn& by, const Matrix& j) {
  const auto& [link, inverse] = by;
  if (link.turn == Turn::none) return j;
  if (link.turn == Turn::general) {
    const Matrix back = transpose(link.rotation);
    const Matrix half = bound(program, (inverse ? back : link.rotation) * j);
    return bound(program, half * (inverse ? link.rotation : back));
  }
  return turn(program, scene, turn_of(link, inverse), j);
}

/// The same for a constant rotation.
Matrix turn(Program& program, const SceneContent& scene, const Rotation& r, const Matrix& j) {
  if (const std::optional<int> z = axis_of_turn(r)) {
    const int x = (*z + 1) % 3, y = (*z + 2) % 3;
    return turn(program, scene, AxisTurn{*z, program.number(r(y, x)), program.number(r(x, x))}, j);
  }
  const Matrix constant = constant_matrix(program, r);
  return bound(program, constant * j * transpose(constant));
}

}  // namespace

Matrix BodyTree::to_parent(const Link& link, const Matrix& j) const {
  Matrix turned = turn(*program_, *scene_, {.link = link, .inverse = false}, j);
  const std::vector<Rotation>& factors = link.placement_factors;
  for (auto factor = factors.rbegin(); factor != factors.rend(); ++factor) {
    turned = turn(*program_, *scene_, *factor, turned);
  }
  if (!factors.empty() || link.placement_rotation.is_identity()) return turned;
  const Matrix placement = constant_matrix(*program_, link.placement_rotation);
  return bound(*program_, placement * turned * transpose(placement));
}

Matrix BodyTree::from_parent(const Link& link, const Matrix& j) const {
  Matrix turned = j;
  for (const Rotation& factor : link.placement_factors) turned = turn(*program_, *scene_, factor.transpose(), turned);
  if (link.placement_factors.empty() && !link.placement_rotation.is_identity()) {
    const Matrix placement = constant_matrix(*program_, link.placement_rotation);
    turned = bound(*program_, transpose(placement) * j * placement);
  }
  return turn(*program_, *scene_, {.link = link, .inverse = true}, turned);
}

Vector BodyTree::to_parent(const Link& link, const Vector& v) const {
  return from_joint(link, turn(*program_, link, v, false));
}

Vector BodyTree::from_joint(const Link& link, const Vector& v) const {
  if (link.placement_factors.size() < 2) return link.placement_rotation * v;
  return link.placement_factors.front() * bound(*program_, link.placement_factors.back() * v);
}

Vector BodyTree::to_joint(const Link& link, const Vector& v) const {
  if (link.placement_factors.size() < 2) return bound(*program_, link.placement_rotation.transpose() * v);
  const Vector half = bound(*program_, link.placement_factors.front().transpose() * v);
  return bound(*program_, link.placement_factors.back().transpose() * half);
}

Vector BodyTree::from_parent(const Link& link, const Vector& v) const {
  return turn(*program_, link, to_joint(link, v), true);
}

Vector BodyTree::axis_in_parent(const Link& link) const {
  // Axes of a quaternion's links turn with them; any other turn leaves its axis alone.
  const bool moves = link.turn == Turn::general && link.aligned;
  return moves ? to_parent(link, link.axis) : link.placement_rotation * link.axis;
}

Vector BodyTree::origin_in_parent(const Link& link) const {
  if (link.joint != JointKind::prismatic) return link.placement_origin;
  return link.placement_origin + link.displacement * axis_in_parent(link);
}

std::size_t BodyTree::turning_link(std::size_t link) const {
  while (link + 1 < links_.size() && links_[link + 1].in_group == links_[link].in_group + 1) ++link;
  return link;
}

std::vector<int> BodyTree::chain(int link) const {
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
std::vector<Link> BodyTree::runs(int link, int top) const {
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

Vector BodyTree::express(const Vector& v, int from, int to) const {
  const int top = common_ancestor(links_, from, to);
  Vector w = v;
  for (const Link& run : runs(from, top)) w = to_parent(run, w);
  const std::vector<Link> down = runs(to, top);
  for (auto run = down.rbegin(); run != down.rend(); ++run) w = from_parent(*run, w);
  return w;
}

Vector BodyTree::locate(const Vector& p, int from, int to) const {
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

Vector BodyTree::between(const GeometricPoint& a, const GeometricPoint& b, int axes) const {
  // Of the three nearest links of pairs two are the same, and the third is on the way between all.
  const int meeting = std::max({common_ancestor(links_, a.link, b.link), common_ancestor(links_, a.link, axes),
                                common_ancestor(links_, b.link, axes)});
  const int top = common_ancestor(links_, meeting, axes);
  const auto is_turned = [&](int k) { return k != top && links_[static_cast<std::size_t>(k)].joint != JointKind::prismatic; };
  const auto above = [&](int k) { return links_[static_cast<std::size_t>(k)].parent; };
  // Joints that turn in a row turn the places of all points once, with sums that those share.
  int from = meeting;
  while (is_turned(from) && is_turned(above(from))) from = above(from);
  Vector to_a = locate(a.place, a.link, from), to_b = locate(b.place, b.link, from);
  if (is_turned(from)) {
    const Link& first = links_[static_cast<std::size_t>(from)];
    to_a = to_parent(first, bound(*program_, to_a));
    to_b = to_parent(first, bound(*program_, to_b));
    from = first.parent;
  }
  return express(bound(*program_, to_b - to_a), from, axes);
}

Vector BodyTree::arm(const Link& link) const {
  const Vector origin = origin_in_parent(link);
  if (!length_unit_) return origin;
  const Value inverse = pow(length(), -1);
  return inverse * origin;
}

Vector BodyTree::upward_gravity() const {
  const Vector upward = -lower(*program_, scene_->gravity);
  if (!length_unit_) return upward;
  const Value inverse = pow(length(), -1);
  return inverse * upward;
}

Wrench BodyTree::applied(std::size_t k, const Wrench& wrench) const {
  const Link& link = links_[k];
  Wrench own = wrench;
  if (!link.scene_rotation.is_identity()) {
    own = {bound(*program_, link.scene_rotation * wrench.resultant), link.scene_rotation * wrench.moment};
  }
  if (!link.scene_origin.is_zero()) own.moment += cross(link.scene_origin, own.resultant);
  if (length_unit_) own.resultant = length() * own.resultant;
  return own;
}

}  // namespace torsor
