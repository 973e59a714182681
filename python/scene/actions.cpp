// SPDX-License-Identifier: GPL-3.0-or-later
// A scene's actions.
#include "python/scene/bindings.hpp"

namespace torsor::python {
namespace {

void bind_springs(SceneClass& scene) {
  scene.def("spring", [](S s, Name n, E elongation, E stiffness, E rest) { s.scene.spring(n, elongation, stiffness, rest); },
            "name"_a, "elongation"_a, "stiffness"_a, "rest"_a = 0, comment_of("spring"));
  scene.def("spring",
            [](S s, Name n, P a, P b, E stiffness, E rest) { s.scene.spring(n, {s.of(a), s.of(b), stiffness, rest}); }, "name"_a,
            py::kw_only(), "a"_a, "b"_a, "stiffness"_a, "rest"_a = 0, "Between two points: U = -k (|AB| - rest)^2/2.");
  scene.def("damper", [](S s, Name n, E elongation, E damping) { s.scene.damper(n, elongation, damping); }, "name"_a,
            "elongation"_a, "damping"_a, comment_of("damper"));
  scene.def("damper", [](S s, Name n, P a, P b, E damping) { s.scene.damper(n, s.of(a), s.of(b), damping); }, "name"_a, "a"_a,
            "b"_a, "damping"_a, "Between two points: tension c d|AB|/dt.");
  scene.def("motor", [](S s, Name n, E displacement) { return s.scene.motor(n, displacement); }, "name"_a, "displacement"_a,
            comment_of("motor"));
  scene.def("force_function", [](S s, Name n, E u) { s.scene.force_function(n, u); }, "name"_a, "u"_a, comment_of("force_function"));
  scene.def("generalised_force", [](S s, Name n, E along, E force) { s.scene.generalised_force(n, along, force); }, "name"_a,
            "displacement"_a, "force"_a, comment_of("generalised_force"));
  scene.def("gravitation", [](S s, Name n, P a, P b, E strength) { s.scene.gravitation(n, s.of(a), s.of(b), strength); }, "name"_a,
            "a"_a, "b"_a, "strength"_a, comment_of("gravitation"));
}

void bind_forces(SceneClass& scene) {
  scene.def("gravity", [](S s, T acceleration) { s.scene.gravity(acceleration); }, "acceleration"_a, comment_of("gravity"));
  scene.def(
      "force",
      [](S s, Name n, F body, P point, T components, F axes) { s.scene.force(n, {s.of(body), s.of(point), components, s.of(axes)}); },
      "name"_a, "body"_a, "point"_a, "components"_a, "axes"_a, comment_of("force"));
  scene.def("torque", [](S s, Name n, F body, T components, F axes) { s.scene.torque(n, s.of(body), components, s.of(axes)); },
            "name"_a, "body"_a, "components"_a, "axes"_a, comment_of("torque"));
  scene.def(
      "wrench",
      [](S s, Name n, F body, P point, T force, T moment, F axes) {
        s.scene.wrench(n, {s.of(body), s.of(point), force, moment, s.of(axes)});
      },
      "name"_a, "body"_a, "point"_a, "force"_a, "moment"_a, "axes"_a, comment_of("wrench"));
  scene.def("drag",
            [](S s, Name n, F body, P point, E c, F to) { s.scene.drag(n, {s.of(body), s.of(point), c, s.of(to)}); }, "name"_a,
            "body"_a, "point"_a, "coefficient"_a, "relative_to"_a = "ground", comment_of("drag"));
  scene.def("rotational_drag", [](S s, Name n, F body, E c, F to) { s.scene.rotational_drag(n, s.of(body), c, s.of(to)); },
            "name"_a, "body"_a, "coefficient"_a, "relative_to"_a = "ground", comment_of("rotational_drag"));
  scene.def(
      "force_between",
      [](S s, Name n, F a, F b, P point, T components, F axes) {
        s.scene.force_between(n, {s.of(a), s.of(b), s.of(point), components, s.of(axes)});
      },
      "name"_a, "a"_a, "b"_a, "point"_a, "components"_a, "axes"_a, comment_of("force_between"));
  scene.def("torque_between",
            [](S s, Name n, F a, F b, T components, F axes) { s.scene.torque_between(n, {s.of(a), s.of(b), components, s.of(axes)}); },
            "name"_a, "a"_a, "b"_a, "components"_a, "axes"_a, comment_of("torque_between"));
}

}  // namespace

void bind_actions(SceneClass& scene) {
  bind_springs(scene);
  bind_forces(scene);
}

}  // namespace torsor::python
