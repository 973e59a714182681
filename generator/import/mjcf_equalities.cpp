// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/import/mjcf_builder.hpp"

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
    for (std::optional<int> at = law.second; at && !circle;) {
      const auto next = followed_.find(static_cast<std::size_t>(*at));
      if (next == followed_.end()) break;
      at = model_.equalities[next->second].second;
      circle = at == law.first;
    }
    if (!circle) followed_[first] = e;
  }
}

std::string MjcfBuilder::frame_at(int body, const std::string& name, const ExactPlace& place) {
  const std::string& frame = frames_[static_cast<std::size_t>(body)];
  const bool at_origin = std::all_of(place.point.begin(), place.point.end(), [](const Number& x) { return x.is_zero(); });
  if (at_origin && place.turned.is_identity()) return frame;
  const std::string made = identifiers_.frames().take(name, "equality");
  scene_.weld(made, frame, {quantities(place.point, units::metre), place.turned});
  return made;
}

/// Where bodies stand as the file places them, joints at their references.
MjcfBuilder::ExactPlace MjcfBuilder::in_parent(int body, const ExactPlace& place) const {
  const MjcfBody& moved = model_.bodies[static_cast<std::size_t>(body)];
  std::array<Number, 4> quaternion;  // what was made exact has been told where the body was placed
  for (std::size_t k = 0; k < 4; ++k) quaternion[k] = from_double(moved.quaternion[k]);
  const Rotation turn = exact_rotation(quaternion, options_.angle_tolerance).rotation;
  ExactPlace result{{}, turn * place.turned};
  for (int row = 0; row < 3; ++row) {
    Number sum = from_double(moved.position[static_cast<std::size_t>(row)]);
    for (int k = 0; k < 3; ++k) sum += turn(row, k) * place.point[static_cast<std::size_t>(k)];
    result.point[static_cast<std::size_t>(row)] = sum;
  }
  return result;
}

/// The same place in the second body, through the body that carries both; nothing where one moves freely on the way.
std::optional<MjcfBuilder::ExactPlace> MjcfBuilder::in_second_body(const MjcfEquality& equality,
                                                                   const ExactPlace& in_first) const {
  const auto parent = [this](int body) { return model_.bodies[static_cast<std::size_t>(body)].parent; };
  const auto is_free = [this](int body) {
    return std::any_of(model_.joints.begin(), model_.joints.end(), [body](const MjcfJoint& joint) {
      return joint.body == body && joint.type == MjcfJointType::free;
    });
  };
  std::vector<int> down;  // from the second body to the ground
  for (int body = *equality.second; body > 0; body = parent(body)) down.push_back(body);
  ExactPlace place = in_first;
  int body = equality.first;
  for (; body > 0 && std::find(down.begin(), down.end(), body) == down.end(); body = parent(body)) {
    if (is_free(body)) return std::nullopt;
    place = in_parent(body, place);
  }
  down.erase(std::find(down.begin(), down.end(), body), down.end());
  for (std::size_t k = down.size(); k-- > 0;) {
    if (is_free(down[k])) return std::nullopt;
    const ExactPlace own = in_parent(down[k], {});
    const Rotation back = own.turned.transpose();
    std::array<Number, 3> point;
    for (int row = 0; row < 3; ++row) {
      for (std::size_t j = 0; j < 3; ++j) {
        point[static_cast<std::size_t>(row)] += back(row, static_cast<int>(j)) * (place.point[j] - own.point[j]);
      }
    }
    place = {point, back * place.turned};
  }
  return place;
}

/// Where the second body closes the loop. MuJoCo finds that place in doubles, from bodies that stand as the file places
/// them. A direction in which a plane mechanism cannot move would then be missed by some 1e-17 m, and no motion could
/// mend that: the place is found once more, exactly, unless the file gives another one.
MjcfBuilder::ExactPlace MjcfBuilder::closing_place(const MjcfEquality& equality, const ExactPlace& in_first) const {
  ExactPlace given;
  for (std::size_t k = 0; k < 3; ++k) given.point[k] = from_double(equality.second_point[k]);
  const std::optional<ExactPlace> exact = in_second_body(equality, in_first);
  if (!exact) return given;
  // Angles of some ten bodies may have been made exact; lengths are of one size with those of the bodies on the way.
  Number lengths(0);
  for (const MjcfBody& body : model_.bodies) {
    for (const double x : body.position) lengths += from_double(x).abs();
  }
  for (std::size_t k = 0; k < 3; ++k) lengths += given.point[k].abs() + in_first.point[k].abs();
  const Number apart = Number(10) * options_.angle_tolerance + Number::rational(1, 1000000000);
  for (std::size_t k = 0; k < 3; ++k) {
    if ((exact->point[k] - given.point[k]).abs() > apart * lengths) return given;
  }
  for (int i = 0; i < 9 && equality.type == MjcfEqualityType::weld; ++i) {
    const Number off = exact->turned(i / 3, i % 3) - given.turned(i / 3, i % 3);
    if (off.abs() > apart) return given;
  }
  return {exact->point, equality.type == MjcfEqualityType::weld ? exact->turned : Rotation()};
}

void MjcfBuilder::add_points_together(const MjcfEquality& equality, const std::string& name) {
  if (!moves(equality.first) && !moves(*equality.second)) {
    note("equality constraints between bodies that stand still do not act", equality.name);
    return;
  }
  const bool weld = equality.type == MjcfEqualityType::weld;
  ExactPlace first;
  for (std::size_t k = 0; k < 3; ++k) first.point[k] = from_double(equality.first_point[k]);
  if (weld) first.turned = rotation(equality.quaternion, "equality " + equality.name);
  const std::string a = frame_at(equality.first, name + "_first", first);
  const std::string b = frame_at(*equality.second, name + "_second", closing_place(equality, first));
  scene_.loop_joint(name, {.type = weld ? JointType::weld : JointType::spherical, .a = a, .b = b});
}

/// What it ties may all be held: then no motion can satisfy or violate it.
void MjcfBuilder::constrain(const MjcfEquality& equality, const Expression& f) {
  if (varies(f)) {
    scene_.holonomic(identifiers_.symbol(equality.name, "equality"), f);
  } else {
    note("equality constraints of what is held already do not act", equality.name);
  }
}

void MjcfBuilder::add_equalities() {
  for (std::size_t e = 0; e < model_.equalities.size(); ++e) {
    const MjcfEquality& equality = model_.equalities[e];
    const auto first = static_cast<std::size_t>(equality.first);
    switch (equality.type) {
      case MjcfEqualityType::connect:
      case MjcfEqualityType::weld: {
        const std::string name =
            identifiers_.symbol(equality.name, "equality", {"", "_x", "_y", "_z", "_rx", "_ry", "_rz"});
        add_points_together(equality, name);
        break;
      }
      case MjcfEqualityType::joint: {
        const auto law = followed_.find(first);
        if (law != followed_.end() && law->second == e) break;
        constrain(equality, position(first) - polynomial(equality, first));
        break;
      }
      case MjcfEqualityType::tendon: {
        const MjcfTendon& tendon = model_.tendons[first];
        const std::optional<Expression> length = tendon_length(tendon);
        std::optional<Expression> other;
        if (equality.second) other = tendon_length(model_.tendons[static_cast<std::size_t>(*equality.second)]);
        if (!length || (equality.second && !other)) {
          note("equality constraints of tendons around geoms do not act", equality.name);
          break;
        }
        // L1 − L1° = Σ c_k (L2 − L2°)^k.
        const auto metres = [](double value) { return Expression::quantity(from_double(value), units::metre); };
        Expression f = *length - metres(tendon.length_at_reference + equality.polynomial[0]);
        if (other) {
          const Expression moved =
              *other - metres(model_.tendons[static_cast<std::size_t>(*equality.second)].length_at_reference);
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
        constrain(equality, f);
        break;
      }
      case MjcfEqualityType::other:
        note("equality constraints that are none of connect, weld, joint, tendon between bodies do not act",
             equality.name);
    }
  }
  for (const auto& equality : model_.equalities) {
    if (equality.type == MjcfEqualityType::other) continue;
    data_.push_back("equality constraints are ideal here: solref and solimp do not act");
    break;
  }
}

}  // namespace torsor
