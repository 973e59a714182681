// SPDX-License-Identifier: GPL-3.0-or-later
// A scene's parameters, coordinates, initial state, and choices.
#include "torsor/generator/base/decimal.hpp"
#include "python/scene/bindings.hpp"

namespace torsor::python {

/// A start is data, which a search may have found: its floats are taken with all their digits.
struct StartValue { Expression formula; };

}  // namespace torsor::python

namespace pybind11::detail {

template <>
class type_caster<torsor::python::StartValue> {
 public:
  PYBIND11_TYPE_CASTER(torsor::python::StartValue, make_caster<torsor::Expression>::name);
  bool load(handle source, bool convert) {
    if (PyFloat_Check(source.ptr()) != 0) {
      value.formula = torsor::Expression(torsor::from_double(PyFloat_AsDouble(source.ptr())));
      return true;
    }
    make_caster<torsor::Expression> formula;
    if (!formula.load(source, convert)) return false;
    value.formula = cast_op<torsor::Expression&>(formula);
    return true;
  }
};

/// Text is no sequence of numbers here either.
template <std::size_t n>
class type_caster<std::array<torsor::python::StartValue, n>>
    : public array_caster<std::array<torsor::python::StartValue, n>, torsor::python::StartValue, false, n> {
 public:
  bool load(handle source, bool convert) {
    if (PyUnicode_Check(source.ptr()) != 0 || PyBytes_Check(source.ptr()) != 0 || PyByteArray_Check(source.ptr()) != 0) return false;
    return array_caster<std::array<torsor::python::StartValue, n>, torsor::python::StartValue, false, n>::load(source, convert);
  }
};

}  // namespace pybind11::detail

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
  scene.def("set_parameter", [](S s, E parameter, E value) { s.scene.set_parameter(parameter, value); }, "parameter"_a, "value"_a,
            comment_of("set_parameter"));
  scene.def("coordinate", [](S s, Name name, Name unit) { return s.scene.coordinate(name, unit); }, "name"_a, "unit"_a,
            comment_of("coordinate"));
  scene.def("released_coordinate", [](S s, Name name, Name unit) { return s.scene.released_coordinate(name, unit); }, "name"_a,
            "unit"_a, comment_of("released_coordinate"));
  scene.def("attitude", [](S s, Name name) { return s.given(s.scene.attitude(name), name); }, "name"_a, comment_of("attitude"));
  scene.def_property_readonly("time", [](S s) { return s.scene.time(); }, comment_of("time"));
  scene.def("drive", [](S s, E coordinate, E law) { s.scene.drive(coordinate, law); }, "coordinate"_a, "law"_a, comment_of("drive"));
  using Start = const StartValue&;
  scene.def("initial", [](S s, E coordinate, Start value, Start rate) { s.scene.initial(coordinate, value.formula, rate.formula); },
            "coordinate"_a, "value"_a, "rate"_a = 0, comment_of("initial"));
  scene.def(
      "initial",
      [](S s, const Attitude& attitude, const std::array<StartValue, 4>& e, const std::array<StartValue, 3>& omega) {
        s.scene.initial(s.of(attitude), {e[0].formula, e[1].formula, e[2].formula, e[3].formula},
                        {omega[0].formula, omega[1].formula, omega[2].formula});
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
