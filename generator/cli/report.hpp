// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "torsor/generator/base/natural_language.hpp"
#include "torsor/generator/dynamics/motion/model.hpp"
#include "torsor/generator/mechanics/scene.hpp"
#include "torsor/generator/verification/evaluated_motion.hpp"

namespace torsor {

struct ReportOptions {
  ModelOptions model;                                      ///< how the kernels of the motion are derived
  std::vector<std::pair<std::string, std::string>> about;  ///< state of the linearisation
  double duration = 10.0;                                  ///< of the motion [s]
  bool meshes = false;                                     ///< put the triangles of meshes into the page
  NamedNumbers initial, inputs;                            ///< of the motion, in place of the scene's and of 0
  std::string reference;                                   ///< file of a reference trajectory; empty: none
  NaturalLanguage language{};                              ///< of every fixed phrase
};

/// A scene as one HTML file that needs no other: what the mechanism is, its graphs, equations and theorems, and its motion,
/// which the JavaScript kernels in it integrate; a motion with contacts is recorded and played back. The same bytes for the same scene. Names, units and titles are data: no
/// text of a scene becomes HTML, JavaScript, LaTeX or SVG.
///
/// All parameters become run-time parameters, which the reader can change, unless the options name some, there are more
/// than 40, or the scene's constraints repeat each other only at the values that it states.
std::string report_html(const Scene& scene, const ReportOptions& options);

/// An ES module as an expression: an object with everything that it exports.
std::string module_as_object(const std::string& module);
/// JavaScript, or JSON, inside a <script> element: no text in it ends the element or begins a comment of HTML.
std::string inside_script(const std::string& text);
std::string inside_json(const std::string& text);
/// What a viewer needs to know of the scene beside its kernels.
std::string report_data(const Scene& scene, double duration);
/// Surfaces of the scene's convex bodies and tori that touch a plane, at the values of its parameters.
nlohmann::ordered_json report_surfaces(const SceneContent& scene);
/// The motion of a scene with contacts from event to event, for a page that plays it back: samples, regimes and events.
/// Throws as `simulate`, and Error where the motion cannot start.
std::string report_recording(const Scene& scene, const ReportOptions& given);
/// A reference trajectory (the command `reference`) for dots beside the motion. Throws FileError, also for one of another scene, and
/// UsageError for a scene with contacts.
std::string report_reference(const SceneContent& scene, const std::string& path);
/// The meshes that the scene shows, made small enough for a page, and which of its forms has which. Throws FileError.
std::string report_meshes(const SceneContent& scene);

}  // namespace torsor
