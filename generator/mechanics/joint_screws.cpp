// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/mechanics/joint_screws.hpp"

#include <fmt/format.h>

namespace torsor {
namespace {

using Free = std::vector<JointFreedom>;
using Held = std::vector<JointTransmission>;

constexpr JointFreedom turn_x{JointFreedom::Kind::turn, 0}, turn_y{JointFreedom::Kind::turn, 1},
    turn_z{JointFreedom::Kind::turn, 2}, turn_x_of_b{JointFreedom::Kind::turn, 0, true},
    turn_y_of_b{JointFreedom::Kind::turn, 1, true}, slide_x{JointFreedom::Kind::slide, 0},
    slide_y{JointFreedom::Kind::slide, 1}, slide_z{JointFreedom::Kind::slide, 2}, screw_x{JointFreedom::Kind::screw, 0};
constexpr JointTransmission force_x{JointTransmission::Kind::force, 0}, force_y{JointTransmission::Kind::force, 1},
    force_z{JointTransmission::Kind::force, 2}, couple_x{JointTransmission::Kind::couple, 0},
    couple_y{JointTransmission::Kind::couple, 1}, couple_z{JointTransmission::Kind::couple, 2},
    thrust_x{JointTransmission::Kind::screw, 0}, couple_x_y{JointTransmission::Kind::couple, 0, 1},
    couple_z_x{JointTransmission::Kind::couple, 2, 0};

/// The axis about which b is turned where the basis depends on that angle.
std::optional<int> turned_axis(JointType type) {
  if (type == JointType::universal) return 0;
  if (type == JointType::line_contact) return 2;
  return std::nullopt;
}

PlacedJoint<Vector, Value> placed(Program& program, const SymbolicJoint& symbolic) {
  PlacedJoint<Vector, Value> joint;
  for (int i = 0; i < 3; ++i) joint.a[static_cast<std::size_t>(i)][i] = program.number(Number(1));
  joint.b = joint.a;
  const std::optional<int> about = turned_axis(symbolic.type);
  if (about) {
    const Value sine = program.sin(symbolic.angle);
    const Value cosine = program.cos(symbolic.angle);
    const int i = (*about + 1) % 3, j = (*about + 2) % 3;
    auto& b_i = joint.b[static_cast<std::size_t>(i)];
    auto& b_j = joint.b[static_cast<std::size_t>(j)];
    b_i[i] = cosine;
    b_i[j] = sine;
    b_j[i] = -sine;
    b_j[j] = cosine;
  }
  joint.point = symbolic.point;
  joint.pitch = symbolic.pitch;
  return joint;
}

}  // namespace

const std::vector<JointFreedom>& freedoms(JointType type) {
  static const std::array<Free, 12> table{{{},
                                           {turn_x},
                                           {slide_x},
                                           {screw_x},
                                           {turn_x, slide_x},
                                           {turn_x, turn_y_of_b},
                                           {turn_x, turn_y, turn_z},
                                           {slide_x, slide_y, turn_z},
                                           {slide_x, slide_y, turn_z, turn_x_of_b},
                                           {slide_x, turn_x, turn_y, turn_z},
                                           {slide_x, slide_y, turn_x, turn_y, turn_z},
                                           {slide_x, slide_y, slide_z, turn_x, turn_y, turn_z}}};
  return table.at(static_cast<std::size_t>(type));
}

const std::vector<JointTransmission>& transmissions(JointType type) {
  static const std::array<Held, 12> table{{{force_x, force_y, force_z, couple_x, couple_y, couple_z},
                                           {force_x, force_y, force_z, couple_y, couple_z},
                                           {force_y, force_z, couple_x, couple_y, couple_z},
                                           {thrust_x, force_y, force_z, couple_y, couple_z},
                                           {force_y, force_z, couple_y, couple_z},
                                           {force_x, force_y, force_z, couple_x_y},
                                           {force_x, force_y, force_z},
                                           {force_z, couple_x, couple_y},
                                           {force_z, couple_z_x},
                                           {force_y, force_z},
                                           {force_z},
                                           {}}};
  return table.at(static_cast<std::size_t>(type));
}

std::string describe(const JointFreedom& freedom) {
  const char* motion = freedom.kind == JointFreedom::Kind::turn    ? "turn about"
                       : freedom.kind == JointFreedom::Kind::slide ? "slide along"
                                                                   : "screw along";
  return fmt::format("{} {}{}", motion, "xyz"[freedom.axis], freedom.of_b ? " of b" : "");
}

std::vector<Twist> allowed_twists(Program& program, const SymbolicJoint& symbolic) {
  const PlacedJoint<Vector, Value> joint = placed(program, symbolic);
  std::vector<Twist> twists;
  for (const JointFreedom& freedom : freedoms(symbolic.type)) {
    const auto [angular, linear] = twist_of(freedom, joint);
    twists.push_back({angular, linear});
  }
  return twists;
}

std::vector<Wrench> ideal_wrenches(Program& program, const SymbolicJoint& symbolic) {
  const PlacedJoint<Vector, Value> joint = placed(program, symbolic);
  std::vector<Wrench> wrenches;
  for (const JointTransmission& part : transmissions(symbolic.type)) {
    const auto [resultant, moment] = wrench_of(part, joint);
    wrenches.push_back({resultant, moment});
  }
  return wrenches;
}

}  // namespace torsor
