// SPDX-License-Identifier: GPL-3.0-or-later
// The module _torsor_scene: scenes in Python. The package torsor has it as torsor.scene.
#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/cli/command_line.hpp"
#include "python/scene/bindings.hpp"

namespace torsor::python {

std::vector<Constraint> BoundScene::given(const std::vector<ConstraintHandle>& handles, const std::string& name) const {
  std::vector<Constraint> constraints;
  for (const ConstraintHandle handle : handles) constraints.push_back(given(handle, name));
  return constraints;
}

SphericalMotion BoundScene::of(const Turn& argument) const {
  if (argument.rotations) return *argument.rotations;
  return of(*argument.attitude);
}

void BoundScene::require_own(const Owner& other, const std::string& name) const {
  if (!other || other == owner) return;
  throw SceneError(fmt::format("'{}' belongs to another scene than '{}': take what this scene gave out", name, scene.name()));
}

namespace {

template <class Handle>
void bind_handle(py::module_& module, const char* name, const char* text) {
  py::class_<Owned<Handle>>(module, name, text)
      .def_readonly("name", &Owned<Handle>::name)
      .def("__repr__", [name](const Owned<Handle>& self) { return fmt::format("<{} {}>", name, self.name); });
}

void bind_handles(py::module_& module) {
  bind_handle<FrameHandle>(module, "Frame", "A frame of a scene.");
  bind_handle<PointHandle>(module, "Point", "A point of a scene.");
  bind_handle<ConstraintHandle>(module, "Constraint", "A constraint of a scene.");
  bind_handle<AttitudeHandle>(module, "Attitude", "An orientation of a scene, by a unit quaternion.");
}

void bind_errors(py::module_& module) {
  const auto base = py::register_exception<Error>(module, "Error", PyExc_ValueError);
  py::register_exception<SceneError>(module, "SceneError", base);
  py::register_exception<UnitError>(module, "UnitError", base);
  py::register_exception<UsageError>(module, "UsageError", base);
  py::register_exception<FileError>(module, "FileError", base);
}

void bind_commands(SceneClass& scene) {
  scene.def(
      "_run",
      [](const BoundScene& self, const std::vector<std::string>& words, const std::vector<std::string>& read) {
        CommandOutcome outcome = run_command(words, self.scene, read);
        return std::make_tuple(std::move(outcome.text), outcome.passed, std::move(outcome.notes));
      },
      "words"_a, "read"_a);
}

}  // namespace
}  // namespace torsor::python

PYBIND11_MODULE(_torsor_scene, module) {
  using namespace torsor::python;
  module.doc() = "Mechanisms described in Python: what generator/mechanics/scene.hpp offers in C++.";
  module.attr("__version__") = TORSOR_VERSION;
  bind_errors(module);
  bind_formulas(module);
  bind_handles(module);
  bind_inertia(module);
  bind_shapes(module);
  SceneClass scene(module, "Scene", "A mechanism as its author describes it.");
  scene.def(py::init<const std::string&, const std::string&>(), "name"_a, "title"_a = "");
  bind_quantities(scene);
  bind_joints(scene);
  bind_points(scene);
  bind_actions(scene);
  bind_contacts(scene);
  bind_constraints(scene);
  bind_commands(scene);
}
