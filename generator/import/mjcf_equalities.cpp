// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "generator/base/error.hpp"
#include "generator/import/mjcf_builder.hpp"

namespace torsor {

/// A joint that an equality ties to another one needs no coordinate: the first equality of each joint, unless the other
/// one follows it in its turn.
void MjcfBuilder::choose_followers() {
  for (std::size_t e = 0; e < model_.equalities.size(); ++e) {
    const MjcfEquality& law = model_.equalities[e];
    if (law.type != MjcfEqualityType::joint) continue;
    const auto first = static_cast<std::size_t>(law.first);
    if (followed_.contains(first)) continue;
    bool circle = law.second == law.first;
    for (int at = law.second; at >= 0 && !circle;) {
      const auto next = followed_.find(static_cast<std::size_t>(at));
      if (next == followed_.end()) break;
      at = model_.equalities[next->second].second;
      circle = at == law.first;
    }
    if (!circle) followed_[first] = e;
  }
}

std::string MjcfBuilder::frame_at(int body, const std::string& name, const std::array<double, 3>& point,
                                  const Rotation& turned) {
  const std::string& frame = frames_[static_cast<std::size_t>(body)];
  if (point == std::array<double, 3>{} && turned.is_identity()) return frame;
  const std::string made = frame_names_.take(name, "equality");
  scene_.weld(made, frame, {lengths(point), turned});
  return made;
}

void MjcfBuilder::add_points_together(const MjcfEquality& equality, const std::string& name) {
  if (!moves(equality.first) && !moves(equality.second)) {
    notes_.push_back(fmt::format("equality constraint {} is between bodies that stand still", equality.name));
    return;
  }
  const bool weld = equality.type == MjcfEqualityType::weld;
  const Rotation turned = weld ? rotation(equality.quaternion, "equality " + equality.name) : Rotation();
  const std::string a = frame_at(equality.first, name + "_first", equality.first_point, turned);
  const std::string b = frame_at(equality.second, name + "_second", equality.second_point, {});
  scene_.loop_joint(name, {.type = weld ? JointType::weld : JointType::spherical, .a = a, .b = b});
}

void MjcfBuilder::add_equalities() {
  for (std::size_t e = 0; e < model_.equalities.size(); ++e) {
    const MjcfEquality& equality = model_.equalities[e];
    const auto first = static_cast<std::size_t>(equality.first);
    switch (equality.type) {
      case MjcfEqualityType::connect:
      case MjcfEqualityType::weld: {
        const std::string name = take(symbols_, equality.name, "equality", {"", "_x", "_y", "_z", "_rx", "_ry", "_rz"});
        add_points_together(equality, name);
        break;
      }
      case MjcfEqualityType::joint: {
        const auto law = followed_.find(first);
        if (law != followed_.end() && law->second == e) break;
        const std::string name = take(symbols_, equality.name, "equality");
        scene_.holonomic(name, position(first) - polynomial(equality, first));
        break;
      }
      case MjcfEqualityType::tendon: {
        const MjcfTendon& tendon = model_.tendons[first];
        const std::optional<Expression> length = tendon_length(tendon);
        std::optional<Expression> other;
        if (equality.second >= 0) other = tendon_length(model_.tendons[static_cast<std::size_t>(equality.second)]);
        if (!length || (equality.second >= 0 && !other)) {
          notes_.push_back(fmt::format("equality constraint {} does not act: its tendon is spatial", equality.name));
          break;
        }
        // L1 − L1° = Σ c_k (L2 − L2°)^k.
        const auto metres = [](double value) { return Expression::quantity(from_double(value), units::metre); };
        Expression f = *length - metres(tendon.length_at_reference + equality.polynomial[0]);
        if (other) {
          const Expression moved =
              *other - metres(model_.tendons[static_cast<std::size_t>(equality.second)].length_at_reference);
          Expression power = moved;
          Unit unit = units::metre;
          for (std::size_t k = 1; k < 5; ++k) {
            if (equality.polynomial[k] != 0) {
              f = f - Expression::quantity(from_double(equality.polynomial[k]), units::metre / unit) * power;
            }
            power = power * moved;
            unit = unit * units::metre;
          }
        }
        scene_.holonomic(take(symbols_, equality.name, "equality"), f);
        break;
      }
      case MjcfEqualityType::other:
        notes_.push_back(
            fmt::format("equality constraint {} does not act: it is none of connect, weld, joint, tendon "
                        "between bodies",
                        equality.name));
    }
  }
  for (const auto& equality : model_.equalities) {
    if (equality.type == MjcfEqualityType::other) continue;
    data_.push_back("equality constraints are ideal here: solref and solimp do not act");
    break;
  }
}

}  // namespace torsor
