// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes of contacts and forms of pictures.
#include "python/scene/bindings.hpp"

namespace torsor::python {
namespace {

/// A shape whose frame or point is an argument.
template <class Given, class Reference, class... Further>
Shape shape_of(const Argument<Reference>& at, Further&&... further) {
  return {Given{*at.reference, std::forward<Further>(further)...}, at.owner};
}

void bind_contact_shapes(py::module_& parent) {
  py::class_<Shape>(parent, "Shape", "What a body touches others with.");
  py::module_ module = parent.def_submodule("shape", "What a body touches others with: torsor::shape of C++.");
  module.def("Point", [](const PointArgument& point) { return shape_of<shape::Point>(point); }, "point"_a,
             "A point of a body, or a point of contact that was declared for the same plane.");
  module.def("Sphere", [](F frame, E radius) { return shape_of<shape::Sphere>(frame, radius); }, "frame"_a, "radius"_a,
             "Centred at the origin of the frame.");
  module.def("HollowSphere", [](F frame, E radius) { return shape_of<shape::HollowSphere>(frame, radius); }, "frame"_a,
             "radius"_a, "The inside of a hollow sphere around the frame's origin; in the plane a drum.");
  module.def("Disc", [](F frame, T axis, E radius) { return shape_of<shape::Disc>(frame, axis, radius); }, "frame"_a,
             "axis"_a, "radius"_a, "The rim of a thin disc centred at the origin of the frame.");
  module.def("Torus", [](F frame, T axis, E circle, E tube) { return shape_of<shape::Torus>(frame, axis, circle, tube); },
             "frame"_a, "axis"_a, "circle_radius"_a, "tube_radius"_a);
  module.def("Ellipsoid", [](F frame, T axes) { return shape_of<shape::Ellipsoid>(frame, axes); }, "frame"_a,
             "semi_axes"_a, "Semi-axes [m] along those of the frame, centred at its origin.");
  module.def(
      "Convex",
      [](F frame, const std::function<Expression(const Triple&)>& support) { return shape_of<shape::Convex>(frame, support); },
      "frame"_a, "support"_a, "A smooth convex body by its support function h(u) = max u . CP [m].");
  module.def("Box", [](F frame, T half) { return shape_of<shape::Box>(frame, half); }, "frame"_a, "half_edges"_a,
             "The corners at +- half_edges [m], each a contact; a half edge 0 leaves its axis out.");
  module.def("Plane", [](F frame, const std::array<Expression, 2>& belt) { return shape_of<shape::Plane>(frame, belt); },
             "frame"_a, "belt"_a = std::array<Expression, 2>{},
             "The plane x, y of the frame, of a body below it; belt: the velocity [m/s] of its surface.");
}

void bind_forms(py::module_& parent) {
  py::class_<BoundForm>(parent, "Form", "What a picture shows.");
  py::module_ module = parent.def_submodule("form", "What a picture shows, in m along the axes of a frame.");
  module.def("Box", [](T edges) { return BoundForm{form::Box{edges}}; }, "edges"_a, "Centred.");
  module.def("Cylinder", [](E radius, E length) { return BoundForm{form::Cylinder{radius, length}}; }, "radius"_a, "length"_a,
             "Centred, about z.");
  module.def("Cone", [](E radius, E length) { return BoundForm{form::Cone{radius, length}}; }, "radius"_a, "length"_a,
             "About z, the centre of its base at the origin, its tip at z = length.");
  module.def("Sphere", [](E radius) { return BoundForm{form::Sphere{radius}}; }, "radius"_a, "Centred.");
  module.def("Segment", [](T from, T to, E radius) { return BoundForm{form::Segment{from, to, radius}}; }, "start"_a, "end"_a,
             "radius"_a, "A round bar between two points.");
  module.def("Torus", [](E radius, E tube) { return BoundForm{form::Torus{radius, tube}}; }, "radius"_a, "tube"_a,
             "A ring about z, centred, whose tube has this radius.");
  module.def("Mesh", [](const std::string& file, const std::array<double, 3>& scale) { return BoundForm{form::Mesh{file, scale}}; },
             "file"_a, "scale"_a = std::array<double, 3>{1, 1, 1}, "The triangles of a file, times the scale.");
}

}  // namespace

void bind_shapes(py::module_& module) {
  bind_contact_shapes(module);
  bind_forms(module);
}

}  // namespace torsor::python
