// SPDX-License-Identifier: GPL-3.0-or-later
// A scene's parameters, coordinates, initial state, and choices.
#include "python/scene/bindings.hpp"

namespace torsor::python {


void bind_quantities(SceneClass& scene) {
  scene.def_property_readonly("name", [](S s) { return s.scene.name(); });
  scene.def_property_readonly("title", [](S s) { return s.scene.content().title; });
  scene.def(
      "parameter",
      [](S s, Name name, Name unit, const std::optional<Expression>& value) {
        return value ? s.scene.parameter(name, unit, *value) : s.scene.parameter(name, unit);
      },
      "name"_a, "unit"_a, "value"_a = py::none(), comment_of("parameter"));
  scene.def("run_time_parameter", [](S s, Name name, Name unit, E value) { return s.scene.run_time_parameter(name, unit, value); },
            "name"_a, "unit"_a, "value"_a, comment_of("run_time_parameter"));
  scene.def("coordinate", [](S s, Name name, Name unit) { return s.scene.coordinate(name, unit); }, "name"_a, "unit"_a,
            comment_of("coordinate"));
  scene.def("released_coordinate", [](S s, Name name, Name unit) { return s.scene.released_coordinate(name, unit); }, "name"_a,
            "unit"_a, comment_of("released_coordinate"));
  scene.def("attitude", [](S s, Name name) { return s.given(s.scene.attitude(name), name); }, "name"_a, comment_of("attitude"));
  scene.def_property_readonly("time", [](S s) { return s.scene.time(); }, comment_of("time"));
  scene.def("drive", [](S s, E coordinate, E law) { s.scene.drive(coordinate, law); }, "coordinate"_a, "law"_a, comment_of("drive"));
  scene.def("initial", [](S s, E coordinate, E value, E rate) { s.scene.initial(coordinate, value, rate); }, "coordinate"_a,
            "value"_a, "rate"_a = 0, comment_of("initial"));
  scene.def(
      "initial",
      [](S s, const Attitude& attitude, const std::array<Expression, 4>& quaternion, const Triple& angular_velocity) {
        s.scene.initial(s.of(attitude), quaternion, angular_velocity);
      },
      "attitude"_a, "quaternion"_a, "angular_velocity"_a = Triple{});
  using Limit = const std::optional<ExactNumber>&;
  scene.def(
      "limits",
      [](S s, E coordinate, Limit lower, Limit upper, Limit velocity, Limit effort) {
        const auto number = [](Limit limit) { return limit ? std::optional(limit->value) : std::nullopt; };
        s.scene.limits(coordinate, {number(lower), number(upper), number(velocity), number(effort)});
      },
      "coordinate"_a, py::kw_only(), "lower"_a = py::none(), "upper"_a = py::none(), "velocity"_a = py::none(),
      "effort"_a = py::none(), comment_of("limits"));
  scene.def("independent", [](S s, const std::vector<Expression>& coordinates) { s.scene.independent(coordinates); },
            "coordinates"_a, comment_of("independent"));
  scene.def("keep_massless", [](S s) { s.scene.keep_massless(); }, comment_of("keep_massless"));
  scene.def(
      "show",
      [](S s, const FrameArgument& frame, const BoundForm& form, const Triple& origin, const Rotation& rotation,
         const std::optional<std::array<double, 3>>& colour) {
        Shown shown{s.of(frame), form.form, {origin, rotation}, {}};
        if (colour) shown.colour = Colour{(*colour)[0], (*colour)[1], (*colour)[2]};
        s.scene.show(shown);
      },
      "frame"_a, "form"_a, py::kw_only(), "origin"_a = Triple{}, py::arg_v("rotation", Rotation(), "Rotation()"), "colour"_a = py::none(),
      comment_of("show"));
}

}  // namespace torsor::python
