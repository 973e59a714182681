// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/dynamics/motion/model.hpp"

#include <optional>

#include "generator/dynamics/motion/nominal_number.hpp"

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
Value spread_along(const Model& model, const Matrix& inertia, int x, int y) {
  const Value product = inertia(x, y) + inertia(y, x);
  if (!product.is_zero()) return inertia(y, y);
  const std::optional<double> across = nominal_number(model.scene(), inertia(x, x));
  const std::optional<double> along = nominal_number(model.scene(), inertia(y, y));
  return across && along && *across < *along ? inertia(x, x) : inertia(y, y);
}

void regroup(const Model& model, std::vector<Link>& links, MassProperties Link::*properties) {
  Program& program = model.program();
  const bool whole_line = properties == &Link::off_axis && model.options().passes.off_axis;
  for (std::size_t k = links.size(); k-- > 1;) {
    Link& link = links[k];
    MassProperties& own = link.*properties;
    MassProperties& parent = links[static_cast<std::size_t>(link.parent)].*properties;
    MassProperties moved;
    if (link.turn == Turn::aligned) {
      // Mass spread on the axis z: m, h_z and an equal amount of J_xx and J_yy feel no turn about z.
      const int z = link.aligned;
      const int x = (z + 1) % 3;
      const int y = (z + 2) % 3;
      Value line = spread_along(model, own.inertia, x, y);
      if (whole_line && !is_symmetric_about(own.inertia, z)) {
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
      add_placed(program, parent, moved, link.placement_rotation, link.placement_origin);
    } else if (link.joint == JointKind::prismatic) {
      // The axes do not turn: what resists rotation alone may sit on either side.
      moved.inertia = own.inertia;
      own.inertia = Matrix();
      add_placed(program, parent, moved, link.placement_rotation, Vector());
    }
  }
}

}  // namespace

void regroup_inertia(const Model& model, std::vector<Link>& links) {
  regroup(model, links, &Link::effective);
  regroup(model, links, &Link::off_axis);
}

}  // namespace torsor
