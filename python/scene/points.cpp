// SPDX-License-Identifier: GPL-3.0-or-later
// A scene's points and bodies, and what formulas may ask of the motion.
#include "python/scene/bindings.hpp"

namespace torsor::python {
namespace {

void bind_contact_points(SceneClass& scene) {
  scene.def(
      "disc_contact",
      [](S s, Name n, F frame, T axis, E radius, F plane) {
        return s.given(s.scene.disc_contact(n, {s.of(frame), axis, radius, s.of(plane)}), n);
      },
      "name"_a, "frame"_a, "axis"_a, "radius"_a, "plane"_a, comment_of("disc_contact"));
  scene.def(
      "sphere_contact",
      [](S s, Name n, F frame, E radius, F plane) { return s.given(s.scene.sphere_contact(n, s.of(frame), radius, s.of(plane)), n); },
      "name"_a, "frame"_a, "radius"_a, "plane"_a, comment_of("sphere_contact"));
  scene.def(
      "torus_contact",
      [](S s, Name n, F frame, T axis, E circle_radius, E tube_radius, F plane) {
        return s.given(s.scene.torus_contact(n, {s.of(frame), axis, circle_radius, tube_radius, s.of(plane)}), n);
      },
      "name"_a, "frame"_a, "axis"_a, "circle_radius"_a, "tube_radius"_a, "plane"_a, comment_of("torus_contact"));
  scene.def(
      "ellipsoid_contact",
      [](S s, Name n, F frame, T axes, F plane) { return s.given(s.scene.ellipsoid_contact(n, s.of(frame), axes, s.of(plane)), n); },
      "name"_a, "frame"_a, "semi_axes"_a, "plane"_a, comment_of("ellipsoid_contact"));
  scene.def(
      "support_contact",
      [](S s, Name n, F frame, const std::function<Expression(const Triple&)>& h, F plane) {
        return s.given(s.scene.support_contact(n, s.of(frame), h, s.of(plane)), n);
      },
      "name"_a, "frame"_a, "h"_a, "plane"_a, comment_of("support_contact"));
}

void bind_measures(SceneClass& scene) {
  scene.def("attitude_components", [](S s, const Attitude& attitude) { return s.scene.attitude_components(s.of(attitude)); },
            "attitude"_a, comment_of("attitude_components"));
  scene.def("direction", [](S s, F frame, T along, F axes) { return s.scene.direction(s.of(frame), along, s.of(axes)); },
            "frame"_a, "along"_a, "axes"_a, comment_of("direction"));
  scene.def("position", [](S s, P point, F frame) { return s.scene.position(s.of(point), s.of(frame)); }, "point"_a, "frame"_a,
            comment_of("position"));
  scene.def("angular_velocity",
            [](S s, F frame, F axes, F to) { return s.scene.angular_velocity(s.of(frame), s.of(axes), s.of(to)); }, "frame"_a,
            "axes"_a, "relative_to"_a = "ground", comment_of("angular_velocity"));
  scene.def("velocity",
            [](S s, P point, F body, F axes, F to) { return s.scene.velocity(s.of(point), s.of(body), s.of(axes), s.of(to)); },
            "point"_a, "body"_a, "axes"_a, "relative_to"_a = "ground", comment_of("velocity"));
}

}  // namespace

void bind_points(SceneClass& scene) {
  scene.def("point", [](S s, Name n, F frame, T components) { return s.given(s.scene.point(n, s.of(frame), components), n); },
            "name"_a, "frame"_a, "components"_a = Triple{}, comment_of("point"));
  bind_contact_points(scene);
  scene.def("body", [](S s, Name n, F frame, const Inertia& inertia, Moments moments) { s.scene.body(n, s.of(frame), inertia, moments); },
            "name"_a, "frame"_a, "inertia"_a, py::arg_v("moments", Moments::of_matter, "Moments.of_matter"), comment_of("body"));
  scene.def("reflected_inertia", [](S s, Name n, E of, E inertia) { s.scene.reflected_inertia(n, of, inertia); },
            "name"_a, "displacement"_a, "inertia"_a, comment_of("reflected_inertia"));
  bind_measures(scene);
}

}  // namespace torsor::python
