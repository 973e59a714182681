// SPDX-License-Identifier: GPL-3.0-or-later
// Rotations and bodies.
#include "python/scene/bindings.hpp"

namespace torsor::python {
namespace {

void bind_rotations(py::module_& module) {
  py::class_<Rotation>(module, "Rotation", "A constant rotation with exact entries: v_outer = R v_inner.")
      .def(py::init<>())
      .def_static(
          "about", [](int axis, int twelfths_of_pi) { return Rotation::about(axis, twelfths_of_pi); }, "axis"_a.noconvert(),
          "twelfths_of_pi"_a.noconvert(), "About axis 0, 1 or 2 (x, y, z) by so many times 15 degrees.")
      .def_static(
          "matrix",
          [](const std::array<std::array<ExactNumber, 3>, 3>& rows) {
            std::array<Number, 9> entries;
            for (std::size_t i = 0; i < 9; ++i) entries[i] = rows[i / 3][i % 3].value;
            return Rotation::matrix(entries);
          },
          "rows"_a, "By its rows; refused unless it is exactly a rotation.")
      .def("transpose", &Rotation::transpose)
      .def("__mul__", [](const Rotation& a, const Rotation& b) { return a * b; }, py::is_operator());
  py::class_<AngleSequence>(module, "AngleSequence", "Axes of three plane rotations, each about an axis that the one before has turned.")
      .def(py::init([](const std::array<int, 3>& axes) { return AngleSequence{axes}; }), "axes"_a.noconvert())
      .def_readonly("axes", &AngleSequence::axes);
  module.attr("euler") = AngleSequence::euler;
  module.attr("cardan") = AngleSequence::cardan;
  py::class_<PlaneRotations>(module, "PlaneRotations", "A turn about a point by three plane rotations.")
      .def(py::init([](const AngleSequence& sequence, const Triple& angles) { return PlaneRotations{sequence, angles}; }),
           "sequence"_a, "angles"_a);
  py::enum_<Moments>(module, "Moments", "Whether the moments of inertia of a body must be such as matter can have.")
      .value("of_matter", Moments::of_matter)
      .value("as_given", Moments::as_given);
}

/// 0, 1 or 2, or a unit vector along an axis of the frame, as joints take it.
int axis_number(const py::object& axis) {
  if (PyIndex_Check(axis.ptr()) != 0) return axis.cast<int>();
  if (py::isinstance<py::sequence>(axis) && py::len(axis) == 3) {
    const py::sequence parts(axis);
    for (int i = 0; i < 3; ++i) {
      const auto is = [&](int k, int value) { return py::object(parts[static_cast<std::size_t>((i + k) % 3)]).equal(py::int_(value)); };
      if (is(0, 1) && is(1, 0) && is(2, 0)) return i;
    }
  }
  throw py::value_error("the axis is " + py::repr(axis).cast<std::string>() + " and must be axis.x, axis.y or axis.z (or 0, 1, 2)");
}

/// The same body for Python, whose axis may be a vector.
auto about_axis(Inertia (*make)(E, E, int)) {
  return [make](E mass, E a, const py::object& axis) { return make(mass, a, axis_number(axis)); };
}
auto about_axis(Inertia (*make)(E, E, E, int)) {
  return [make](E mass, E a, E b, const py::object& axis) { return make(mass, a, b, axis_number(axis)); };
}

}  // namespace

void bind_inertia(py::module_& module) {
  bind_rotations(module);
  py::class_<Inertia> inertia(module, "Inertia",
                              "Mass [kg], centre of mass [m] and inertia operator about it [kg m^2] in a frame's axes; products "
                              "of inertia carry their minus sign: xy is that of -x y.");
  const auto shape = [&inertia](const char* name, auto make, auto... arguments) {
    inertia.def_static(name, make, arguments..., comment_of(name));
  };
  inertia.def_static("point", [](E mass) { return Inertia::point(mass); }, "mass"_a, "A point mass at the origin of the frame.");
  shape(
      "general", [](E mass, E xx, E yy, E zz, E xy, E xz, E yz) { return Inertia::general({mass, xx, yy, zz, xy, xz, yz}); },
      "mass"_a, "xx"_a = 0, "yy"_a = 0, "zz"_a = 0, "xy"_a = 0, "xz"_a = 0, "yz"_a = 0);
  shape("rod", about_axis(&Inertia::rod), "mass"_a, "length"_a, "axis"_a);
  shape("disk", about_axis(&Inertia::disk), "mass"_a, "radius"_a, "axis"_a);
  shape("ring", about_axis(&Inertia::ring), "mass"_a, "radius"_a, "axis"_a);
  shape("cylinder", about_axis(&Inertia::cylinder), "mass"_a, "radius"_a, "height"_a, "axis"_a);
  shape(
      "hollow_cylinder",
      [](E mass, E outer, E inner, E height, const py::object& axis) {
        return Inertia::hollow_cylinder({mass, outer, inner, height, axis_number(axis)});
      },
      "mass"_a, "outer_radius"_a, "inner_radius"_a, "height"_a, "axis"_a);
  shape("cylindrical_shell", about_axis(&Inertia::cylindrical_shell), "mass"_a, "radius"_a, "height"_a, "axis"_a);
  shape("cone", about_axis(&Inertia::cone), "mass"_a, "base_radius"_a, "height"_a, "axis"_a);
  shape("conical_shell", about_axis(&Inertia::conical_shell), "mass"_a, "base_radius"_a, "height"_a, "axis"_a);
  shape("solid_sphere", &Inertia::solid_sphere, "mass"_a, "radius"_a);
  shape("hollow_sphere", &Inertia::hollow_sphere, "mass"_a, "radius"_a);
  shape("box", &Inertia::box, "mass"_a, "a"_a, "b"_a, "c"_a);
  shape("plate", &Inertia::plate, "mass"_a, "a"_a, "b"_a);
  shape("half_disk", about_axis(&Inertia::half_disk), "mass"_a, "radius"_a, "axis"_a);
  shape("quarter_disk", about_axis(&Inertia::quarter_disk), "mass"_a, "radius"_a, "axis"_a);
  shape("triangle", &Inertia::triangle, "mass"_a, "a"_a, "b"_a, "c"_a);
  inertia.def("at", &Inertia::at, "center"_a, comment_of("at"));
  inertia.def("rotated", py::overload_cast<const Rotation&>(&Inertia::rotated, py::const_), "rotation"_a, comment_of("rotated"));
  inertia.def("rotated", py::overload_cast<const Triple&, E>(&Inertia::rotated, py::const_), "axis"_a, "angle"_a);
}

}  // namespace torsor::python
