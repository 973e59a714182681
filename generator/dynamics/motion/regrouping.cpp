// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/motion/body_tree.hpp"

#include <algorithm>
#include <optional>

#include "torsor/generator/dynamics/motion/nominal_number.hpp"

namespace torsor {
namespace {

bool is_symmetric_about(const Matrix& inertia, int z) {
  const int x = (z + 1) % 3, y = (z + 2) % 3;
  for (int i = 0; i < 3; ++i) {
    if (!inertia(i, (i + 1) % 3).is_zero()) return false;
  }
  return (inertia(x, x) - inertia(y, y)).is_zero();
}

/// What is spread along z: J_yy, or J_xx where that is the smaller of two principal moments. What stays is positive then,
/// and turns into sums of positive terms: (J_yy − J_xx) cos², not J_yy − (J_yy − J_xx) sin².
Value spread_along(const BodyTree& tree, const Matrix& inertia, int x, int y) {
  const Value product = inertia(x, y) + inertia(y, x);
  if (!product.is_zero()) return inertia(y, y);
  const std::optional<double> across = nominal_number(tree.scene(), inertia(x, x));
  const std::optional<double> along = nominal_number(tree.scene(), inertia(y, y));
  return across && along && *across < *along ? inertia(x, x) : inertia(y, y);
}

/// A link that carries nothing, whose matter leans along one axis across the joint and has no moment of inertia about that
/// axis once `line` is moved: its angular acceleration about the axis is not asked for. All of a line would leave a moment.
bool hides_an_acceleration(const std::vector<Link>& links, std::size_t k, const Value& line) {
  const Link& link = links[k];
  const bool carries = std::any_of(links.begin() + 1, links.end(),
                                   [k](const Link& other) { return other.parent == static_cast<int>(k); });
  const MassProperties& own = link.mass;
  for (const int step : {1, 2}) {
    const int x = (*link.aligned + step) % 3, y = (*link.aligned + 3 - step) % 3;
    const bool apart = own.inertia(x, y).is_zero() && own.inertia(x, *link.aligned).is_zero();
    if (!carries && apart && own.first_moment[y].is_zero() && (own.inertia(x, x) - line).is_zero()) return true;
  }
  return false;
}

/// How much of a line of mass on the axis goes to the parent.
enum class Line { to_a_moment_of_zero, whole };

void regroup(const BodyTree& tree, std::vector<Link>& links, Line wanted) {
  Program& program = tree.program();
  for (std::size_t k = links.size(); k-- > 1;) {
    Link& link = links[k];
    MassProperties& own = link.mass;
    MassProperties& parent = links[static_cast<std::size_t>(link.parent)].mass;
    MassProperties moved;
    if (link.turn == Turn::aligned) {
      // Mass spread on the axis z: m, h_z and an equal amount of J_xx and J_yy feel no turn about z.
      const int z = *link.aligned;
      const int x = (z + 1) % 3;
      const int y = (z + 2) % 3;
      Value line = spread_along(tree, own.inertia, x, y);
      if (wanted == Line::whole && !is_symmetric_about(own.inertia, z) && !hides_an_acceleration(links, k, line)) {
        line = own.inertia(x, x) + own.inertia(y, y);
        line = program.bind(Number::rational(1, 2) * program.bind(line - own.inertia(z, z)));
        link.without_line = z;
      }
      moved.mass = own.mass;
      moved.first_moment[z] = own.first_moment[z];
      moved.inertia(x, x) = line;
      moved.inertia(y, y) = line;
      own.mass = Value();
      own.first_moment[z] = Value();
      own.inertia(x, x) = program.bind(own.inertia(x, x) - line);
      own.inertia(y, y) = program.bind(own.inertia(y, y) - line);
      add_placed(program, parent, moved, {.rotation = link.placement_rotation, .origin = link.placement_origin});
    } else if (link.joint == JointKind::prismatic) {
      // The axes do not turn: what resists rotation alone may sit on either side.
      moved.inertia = own.inertia;
      own.inertia = Matrix();
      add_placed(program, parent, moved, {.rotation = link.placement_rotation, .origin = {}});
    }
  }
}

}  // namespace

BodyTree regrouped(const BodyTree& tree) {
  BodyTree result = tree;
  regroup(tree, result.links_, Line::to_a_moment_of_zero);
  return result;
}

BodyTree without_lines(const BodyTree& tree) {
  BodyTree result = tree;
  regroup(tree, result.links_, Line::whole);
  return result;
}

}  // namespace torsor
