// SPDX-License-Identifier: GPL-3.0-or-later
// A scene's constraints.
#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "python/scene/bindings.hpp"

namespace torsor::python {
namespace {

JointType joint_type(Name name) {
  std::string known;
  for (int i = 0; i <= static_cast<int>(JointType::free); ++i) {
    const std::string_view text = to_string(static_cast<JointType>(i));
    std::string word(text);
    for (char& character : word) {
      if (character == ' ' || character == '-') character = '_';
    }
    if (name == word) return static_cast<JointType>(i);
    known += (known.empty() ? "" : ", ") + word;
  }
  throw SceneError(fmt::format("'{}' is no type of joint; use one of {}", name, known));
}

}  // namespace

void bind_constraints(SceneClass& scene) {
  scene.def("holonomic", [](S s, Name n, E f) { return s.given(s.scene.holonomic(n, f), n); }, "name"_a, "f"_a, comment_of("holonomic"));
  scene.def("nonholonomic", [](S s, Name n, E left) { return s.given(s.scene.nonholonomic(n, left), n); }, "name"_a, "left_side"_a,
            comment_of("nonholonomic"));
  scene.def(
      "no_slip",
      [](S s, Name n, F body, P contact, T direction, F axes, F on) {
        return s.given(s.scene.no_slip(n, {s.of(body), s.of(contact), direction, s.of(axes), s.of(on)}), n);
      },
      "name"_a, py::kw_only(), "body"_a, "contact"_a, "direction"_a, "axes"_a, "on"_a = "ground", comment_of("no_slip"));
  scene.def(
      "rolling",
      [](S s, Name n, F body, F on, P contact, F tangents) {
        return s.given(s.scene.rolling(n, {s.of(body), s.of(on), s.of(contact), s.of(tangents)}), n);
      },
      "name"_a, py::kw_only(), "body"_a, "on"_a, "contact"_a, "tangents"_a, comment_of("rolling"));
  scene.def("point_in_plane", [](S s, Name n, P point, F plane) { return s.given(s.scene.point_in_plane(n, s.of(point), s.of(plane)), n); },
            "name"_a, "point"_a, "plane"_a, comment_of("point_in_plane"));
  scene.def("closure", [](S s, Name n, P a, P b, T direction) { return s.given(s.scene.closure(n, s.of(a), s.of(b), direction), n); },
            "name"_a, "a"_a, "b"_a, "direction"_a, comment_of("closure"));
  scene.def(
      "loop_joint",
      [](S s, Name n, Name type, F a, F b, E pitch) {
        return s.given(s.scene.loop_joint(n, {joint_type(type), s.of(a), s.of(b), pitch}), n);
      },
      "name"_a, py::kw_only(), "type"_a, "a"_a, "b"_a, "pitch"_a = 0, comment_of("loop_joint"));
  scene.def(
      "reaction",
      [](S s, const Constraint& constraint, Name n, F body, P contact, T direction, F axes, F other) {
        s.scene.reaction(s.of(constraint), n, {s.of(body), s.of(contact), direction, s.of(axes), s.of(other)});
      },
      "constraint"_a, "name"_a, py::kw_only(), "body"_a, "contact"_a, "direction"_a, "axes"_a, "other"_a = "ground",
      comment_of("reaction"));
}

}  // namespace torsor::python
