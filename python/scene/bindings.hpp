// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/functional.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "torsor/generator/torsor.hpp"

namespace torsor::python {

namespace py = pybind11;
using namespace pybind11::literals;

/// The comment of an operation in the header that declares it, for help(); made by comments.cmake.
const char* comment_of(const char* operation);

/// Tells scenes apart: a handle of one means nothing in another.
using Owner = std::shared_ptr<const int>;

/// What a scene gave out, with the scene that it belongs to.
template <class Handle>
struct Owned {
  Handle handle;
  Owner owner;
  std::string name;
};
using Frame = Owned<FrameHandle>;
using Point = Owned<PointHandle>;
using Constraint = Owned<ConstraintHandle>;
using Attitude = Owned<AttitudeHandle>;

/// A frame or a point as a caller gives it: what a scene gave out, or a name.
template <class Reference>
struct Argument {
  std::string name;
  std::optional<Reference> reference;
  Owner owner;
};
using FrameArgument = Argument<FrameReference>;
using PointArgument = Argument<PointReference>;

/// An exact number: int, Fraction, Decimal, text, or a float that is the decimal somebody wrote.
struct ExactNumber { Number value; };

/// How a joint turns about a point.
struct Turn { std::optional<PlaneRotations> rotations; std::optional<Attitude> attitude; };

/// A shape of a contact, and the scene whose handle it names.
struct Shape { ContactShape shape; Owner owner; };

/// What a picture shows: a class, not a variant.
struct BoundForm { Form form; };

/// A scene under construction. Copies would make two of what handles point to.
class BoundScene {
 public:
  BoundScene(const std::string& name, const std::string& title) : scene(name, title) {}
  BoundScene(const BoundScene&) = delete;
  BoundScene& operator=(const BoundScene&) = delete;

  Scene scene;
  const Owner owner = std::make_shared<const int>(0);

  template <class Handle>
  Owned<Handle> given(Handle handle, const std::string& name) const { return {handle, owner, name}; }
  std::vector<Constraint> given(const std::vector<ConstraintHandle>& handles, const std::string& name) const;

  /// Throw SceneError for what another scene gave out.
  template <class Handle>
  Handle of(const Owned<Handle>& argument) const {
    require_own(argument.owner, argument.name);
    return argument.handle;
  }
  template <class Reference>
  Reference of(const Argument<Reference>& argument) const {
    require_own(argument.owner, argument.name);
    return *argument.reference;
  }
  ContactShape of(const Shape& argument) const {
    require_own(argument.owner, "the shape's frame");
    return argument.shape;
  }
  SphericalMotion of(const Turn& argument) const;

 private:
  void require_own(const Owner& other, const std::string& name) const;
};

using SceneClass = py::class_<BoundScene>;

// What an operation of a scene is bound with, each on a line of its own: the scene, a name, and its arguments.
using S = BoundScene&;
using Name = const std::string&;
using E = const Expression&;
using T = const Triple&;
using R = const Rotation&;
using F = const FrameArgument&;
using P = const PointArgument&;

/// The exact value of a number of Python, nothing for any other object. Throws Error for text that is no number, and for
/// a float that nobody wrote as a decimal.
std::optional<Number> exact_number(py::handle object);

// Each adds what its file binds.
void bind_formulas(py::module_& module);
void bind_inertia(py::module_& module);
void bind_shapes(py::module_& module);
void bind_quantities(SceneClass& scene);
void bind_joints(SceneClass& scene);
void bind_points(SceneClass& scene);
void bind_actions(SceneClass& scene);
void bind_contacts(SceneClass& scene);
void bind_constraints(SceneClass& scene);

}  // namespace torsor::python

namespace pybind11::detail {

/// Numbers are formulas, as in C++.
template <>
class type_caster<torsor::Expression> : public type_caster_base<torsor::Expression> {
 public:
  bool load(handle source, bool convert) {
    if (type_caster_base<torsor::Expression>::load(source, convert)) return true;
    const std::optional<torsor::Number> number = torsor::python::exact_number(source);
    if (!number) return false;
    number_ = torsor::Expression(*number);
    value = &number_;
    return true;
  }

 private:
  torsor::Expression number_;
};

/// Text is no sequence of numbers: "123" is not the vector (1, 2, 3).
template <std::size_t n>
class type_caster<std::array<torsor::Expression, n>>
    : public array_caster<std::array<torsor::Expression, n>, torsor::Expression, false, n> {
 public:
  bool load(handle source, bool convert) {
    if (PyUnicode_Check(source.ptr()) != 0 || PyBytes_Check(source.ptr()) != 0 || PyByteArray_Check(source.ptr()) != 0) return false;
    return array_caster<std::array<torsor::Expression, n>, torsor::Expression, false, n>::load(source, convert);
  }
};

template <>
class type_caster<torsor::python::ExactNumber> {
 public:
  PYBIND11_TYPE_CASTER(torsor::python::ExactNumber, const_name("int | str | Fraction | float"));
  bool load(handle source, bool) {
    const std::optional<torsor::Number> number = torsor::python::exact_number(source);
    if (number) value.value = *number;
    return number.has_value();
  }
};

/// A handle, or a name.
template <class Reference, class Handle>
bool load_argument(torsor::python::Argument<Reference>& value, handle source) {
  if (isinstance<str>(source)) {
    value.name = source.cast<std::string>();
    value.reference = Reference(value.name);
    return true;
  }
  if (!isinstance<torsor::python::Owned<Handle>>(source)) return false;
  const auto& given = source.cast<const torsor::python::Owned<Handle>&>();
  value.name = given.name;
  value.reference = Reference(given.handle);
  value.owner = given.owner;
  return true;
}

template <>
class type_caster<torsor::python::FrameArgument> {
 public:
  PYBIND11_TYPE_CASTER(torsor::python::FrameArgument, const_name("Frame | str"));
  bool load(handle source, bool) { return load_argument<torsor::FrameReference, torsor::FrameHandle>(value, source); }
};

template <>
class type_caster<torsor::python::PointArgument> {
 public:
  PYBIND11_TYPE_CASTER(torsor::python::PointArgument, const_name("Point | str"));
  bool load(handle source, bool) { return load_argument<torsor::PointReference, torsor::PointHandle>(value, source); }
};

template <>
class type_caster<torsor::python::Turn> {
 public:
  PYBIND11_TYPE_CASTER(torsor::python::Turn, const_name("Attitude | PlaneRotations"));
  bool load(handle source, bool) {
    if (isinstance<torsor::PlaneRotations>(source)) {
      value.rotations = source.cast<torsor::PlaneRotations>();
      return true;
    }
    if (!isinstance<torsor::python::Attitude>(source)) return false;
    value.attitude = source.cast<torsor::python::Attitude>();
    return true;
  }
};

}  // namespace pybind11::detail
