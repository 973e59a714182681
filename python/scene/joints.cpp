// SPDX-License-Identifier: GPL-3.0-or-later
// A scene's tree of joints. Each is placed in its parent by `origin` and `rotation`.
#include "python/scene/bindings.hpp"

namespace torsor::python {
namespace {

py::arg_v origin_keyword() { return "origin"_a = Triple{}; }
py::arg_v rotation_keyword() { return py::arg_v("rotation", Rotation(), "Rotation()"); }

/// A joint with its placement: `make(scene, name, parent, placement, arguments...)`.
template <class... Arguments, class Make, class... Keywords>
void joint(SceneClass& scene, const char* name, Make make, const Keywords&... keywords) {
  scene.def(
      name,
      [make](S s, Name frame, F parent, Arguments... arguments, T origin, R rotation) {
        return s.given(make(s, frame, s.of(parent), Placement{origin, rotation}, arguments...), frame);
      },
      py::arg("name"), py::arg("parent"), keywords..., py::kw_only(), origin_keyword(), rotation_keyword(), comment_of(name));
}

using Parent = const FrameReference&;
using At = const Placement&;

void bind_of_one_freedom(SceneClass& scene) {
  joint<>(scene, "weld", [](S s, Name n, Parent f, At p) { return s.scene.weld(n, f, p); });
  joint<T, E>(scene, "revolute", [](S s, Name n, Parent f, At p, T axis, E q) { return s.scene.revolute(n, f, axis, q, p); },
              "axis"_a, "angle"_a);
  joint<T, E>(scene, "prismatic", [](S s, Name n, Parent f, At p, T axis, E q) { return s.scene.prismatic(n, f, axis, q, p); },
              "axis"_a, "displacement"_a);
  joint<T, E, E>(
      scene, "helical",
      [](S s, Name n, Parent f, At p, T axis, E angle, E pitch) { return s.scene.helical(n, f, {axis, angle, pitch}, p); },
      "axis"_a, "angle"_a, "pitch"_a);
}

void bind_of_more_freedoms(SceneClass& scene) {
  joint<T, E, E>(
      scene, "cylindrical",
      [](S s, Name n, Parent f, At p, T axis, E x, E angle) { return s.scene.cylindrical(n, f, {axis, x, angle}, p); },
      "axis"_a, "displacement"_a, "angle"_a);
  joint<T, E, T, E>(
      scene, "universal",
      [](S s, Name n, Parent f, At p, T a, E alpha, T b, E beta) { return s.scene.universal(n, f, {a, alpha, b, beta}, p); },
      "first"_a, "first_angle"_a, "second"_a, "second_angle"_a);
  joint<const AngleSequence&, T>(
      scene, "spherical",
      [](S s, Name n, Parent f, At p, const AngleSequence& by, T angles) {
        return s.scene.spherical(n, f, {.sequence = by, .angles = angles}, p);
      },
      "sequence"_a, "angles"_a);
  joint<const Attitude&>(
      scene, "spherical", [](S s, Name n, Parent f, At p, const Attitude& a) { return s.scene.spherical(n, f, s.of(a), p); },
      "attitude"_a);
  joint<E, E, E>(
      scene, "planar", [](S s, Name n, Parent f, At p, E x, E y, E angle) { return s.scene.planar(n, f, {x, y, angle}, p); },
      "x"_a, "y"_a, "angle"_a);
  joint<E, E, E, E>(
      scene, "line_contact",
      [](S s, Name n, Parent f, At p, E x, E y, E yaw, E roll) { return s.scene.line_contact(n, f, {x, y, yaw, roll}, p); },
      "x"_a, "y"_a, "yaw"_a, "roll"_a);
  joint<T, E, const Turn&>(
      scene, "sphere_in_cylinder",
      [](S s, Name n, Parent f, At p, T axis, E x, const Turn& turn) {
        return s.scene.sphere_in_cylinder(n, f, {axis, x, s.of(turn)}, p);
      },
      "axis"_a, "displacement"_a, "turn"_a);
  joint<E, E, const Turn&>(
      scene, "point_contact",
      [](S s, Name n, Parent f, At p, E x, E y, const Turn& turn) { return s.scene.point_contact(n, f, {x, y, s.of(turn)}, p); },
      "x"_a, "y"_a, "turn"_a);
}

}  // namespace

void bind_joints(SceneClass& scene) {
  scene.def_property_readonly("ground", [](S s) { return s.given(s.scene.ground(), "ground"); }, comment_of("ground"));
  bind_of_one_freedom(scene);
  bind_of_more_freedoms(scene);
  scene.def(
      "free",
      [](S s, Name n, F parent, const AngleSequence& by, T position, T angles) {
        return s.given(s.scene.free(n, s.of(parent), position, {.sequence = by, .angles = angles}), n);
      },
      "name"_a, "parent"_a, "sequence"_a, "position"_a, "angles"_a, comment_of("free"));
  scene.def(
      "free",
      [](S s, Name n, F parent, T position, const Attitude& attitude) {
        return s.given(s.scene.free(n, s.of(parent), position, s.of(attitude)), n);
      },
      "name"_a, "parent"_a, "position"_a, "attitude"_a);
  scene.def("name_joint", [](S s, const Frame& frame, Name name) { s.scene.name_joint(s.of(frame), name); }, "frame"_a, "name"_a,
            comment_of("name_joint"));
}

}  // namespace torsor::python
