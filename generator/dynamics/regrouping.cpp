// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/dynamics/model.hpp"

namespace torsor {

void regroup_inertia(const Model& model, std::vector<Link>& links) {
  Program& program = model.program();
  for (std::size_t k = links.size(); k-- > 1;) {
    Link& link = links[k];
    MassProperties& own = link.effective;
    MassProperties moved;
    if (link.turn == Turn::aligned) {
      // Mass spread on the axis z: m, h_z and an equal amount of J_xx and J_yy feel no turn about z.
      const int z = link.aligned;
      const int x = (z + 1) % 3;
      const int y = (z + 2) % 3;
      moved.mass = own.mass;
      moved.first_moment[z] = own.first_moment[z];
      moved.inertia(x, x) = own.inertia(y, y);
      moved.inertia(y, y) = own.inertia(y, y);
      own.mass = Value();
      own.first_moment[z] = Value();
      own.inertia(x, x) = program.bind(own.inertia(x, x) - own.inertia(y, y));
      own.inertia(y, y) = Value();
      add_placed(program, links[static_cast<std::size_t>(link.parent)].effective, moved, link.placement_rotation,
                 link.placement_origin);
    } else if (link.joint == JointKind::prismatic) {
      // The axes do not turn: what resists rotation alone may sit on either side.
      moved.inertia = own.inertia;
      own.inertia = Matrix();
      add_placed(program, links[static_cast<std::size_t>(link.parent)].effective, moved, link.placement_rotation,
                 Vector());
    }
  }
}

}  // namespace torsor
