// SPDX-License-Identifier: GPL-3.0-or-later
// Laws of friction in an assumed regime, and contacts that open and close.
#include "python/scene/bindings.hpp"

namespace torsor::python {
namespace {

using N = const Constraint&;
using Maybe = const std::optional<Expression>&;

void bind_assumed(SceneClass& scene) {
  scene.def(
      "sliding_friction",
      [](S s, Name n, N normal, E coefficient, F body, P point, T direction, F axes, F other) {
        s.scene.sliding_friction(n, s.of(normal), {coefficient, s.of(body), s.of(point), direction, s.of(axes), s.of(other)});
      },
      "name"_a, "normal"_a, py::kw_only(), "coefficient"_a, "body"_a, "point"_a, "direction"_a, "axes"_a, "other"_a = "ground",
      comment_of("sliding_friction"));
  scene.def(
      "friction_law",
      [](S s, Name n, N normal, const std::function<Expression(const Expression&)>& law, F body, P point, F plane, F other, E smoothing) {
        s.scene.friction_law(n, s.of(normal), {law, s.of(body), s.of(point), s.of(plane), s.of(other), smoothing});
      },
      "name"_a, "normal"_a, py::kw_only(), "law"_a, "body"_a, "point"_a, "plane"_a, "other"_a = "ground",
      "smoothing"_a = Expression::quantity("0.000001", "m/s"), comment_of("friction_law"));
  scene.def(
      "rolling_resistance",
      [](S s, Name n, N normal, E length, F body, T direction, F axes, F other) {
        s.scene.rolling_resistance(n, s.of(normal), {length, s.of(body), direction, s.of(axes), s.of(other)});
      },
      "name"_a, "normal"_a, py::kw_only(), "length"_a, "body"_a, "direction"_a, "axes"_a, "other"_a = "ground",
      comment_of("rolling_resistance"));
  scene.def(
      "spinning_resistance",
      [](S s, Name n, N normal, E length, F body, T direction, F axes, F other) {
        s.scene.spinning_resistance(n, s.of(normal), {length, s.of(body), direction, s.of(axes), s.of(other)});
      },
      "name"_a, "normal"_a, py::kw_only(), "length"_a, "body"_a, "direction"_a, "axes"_a, "other"_a = "ground",
      comment_of("spinning_resistance"));
}

}  // namespace

void bind_contacts(SceneClass& scene) {
  bind_assumed(scene);
  scene.def(
      "contact",
      [](S s, Name n, const Shape& shape, const Shape& other, E friction, Maybe static_friction, E restitution, E rolling, E spinning) {
        s.scene.contact(n, s.of(shape), s.of(other), {friction, static_friction, restitution, rolling, spinning});
      },
      "name"_a, "shape"_a, "other"_a, py::kw_only(), "friction"_a = 0, "static_friction"_a = py::none(), "restitution"_a = 0,
      "rolling"_a = 0, "spinning"_a = 0, comment_of("contact"));
  scene.def(
      "stop",
      [](S s, E coordinate, Maybe lower, Maybe upper, E restitution) { s.scene.stop(coordinate, lower, upper, {restitution}); },
      "coordinate"_a, "lower"_a = py::none(), "upper"_a = py::none(), py::kw_only(), "restitution"_a = 0, comment_of("stop"));
  scene.def(
      "dry_friction",
      [](S s, Name n, E displacement, E bound, Maybe static_bound) { s.scene.dry_friction(n, displacement, {bound, static_bound}); },
      "name"_a, "displacement"_a, py::kw_only(), "bound"_a, "static_bound"_a = py::none(), comment_of("dry_friction"));
  scene.def(
      "joint_friction",
      [](S s, Name n, F frame, E friction, Maybe static_friction, E radius) {
        s.scene.joint_friction(n, s.of(frame), {friction, static_friction, radius});
      },
      "name"_a, "frame"_a, py::kw_only(), "friction"_a, "static_friction"_a = py::none(), "radius"_a = 0,
      comment_of("joint_friction"));
}

}  // namespace torsor::python
