// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <functional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/cli/command_texts.hpp"
#include "torsor/generator/emission/description.hpp"
#include "torsor/generator/emission/header.hpp"
#include "torsor/generator/kernels/kernel.hpp"
#include "torsor/generator/mechanics/freedom_positions.hpp"
#include "torsor/generator/mechanics/parameter_value.hpp"
#include "torsor/generator/mechanics/uncounted_contacts.hpp"
#include "torsor/generator/printing/notation.hpp"
#include "torsor/generator/program/written_unit.hpp"

namespace torsor {
namespace {

using Json = nlohmann::ordered_json;

const char* role(const CoordinateContent& c) { return c.attitude ? "quasi-velocity" : c.law ? "driven" : c.released ? "released" : "unknown"; }

/// A number as it starts; null where a parameter has no value.
Json start_of(const SceneContent& content, const SymbolPointer& symbol) {
  try {
    return initial_value(content, symbol).to_double();
  } catch (const SceneError&) {
    return {};
  }
}

/// The state in which the scene starts, in the order of generated texts.
Json initial_state_json(const Model& model) {
  const SceneContent& content = model.scene();
  Json state{{"time", 0.0}, {"q", Json::array()}, {"v", Json::array()}};
  for (const SymbolPointer& q : model.positions()) state["q"].push_back(start_of(content, q));
  for (int i = 0; i < model.unknown_count(); ++i) {
    state["v"].push_back(start_of(content, model.coordinates()[static_cast<std::size_t>(i)].v));
  }
  return state;
}

/// Adds to the kernels that are derived what they read and write, and to the whole the fingerprint of the header with
/// them. A scene for which nothing can be generated is listed all the same, with the reason.
void add_kernel_shapes(Json& json, const Scene& scene, const std::vector<std::string>& names) {
  try {
    const MechanismListing mechanism = lower_mechanism(scene, names);
    for (const Json& shape : kernels_json(mechanism)) {
      for (Json& kernel : json["kernels"]) {
        if (kernel["name"] != shape["name"]) continue;
        for (const auto& [key, value] : shape.items()) kernel[key] = value;
      }
    }
    json["fingerprint"] = fmt::format("{:016x}", header_fingerprint(mechanism));
  } catch (const Error& error) {
    json["fingerprint"] = nullptr;
    json["why_no_header"] = error.what();
  }
}

Json content_json(const Scene& scene, const Equations& equations) {
  const SceneContent& content = scene.content();
  Json json{{"name", content.name}, {"title", content.title}};
  const auto list = [&json](const char* key) -> Json& { return json[key] = Json::array(); };
  Json& parameters = list("parameters");
  for (const ParameterContent& p : content.parameters) {
    parameters.push_back({{"name", p.symbol->name},
                          {"unit", written_unit(*p.symbol)},
                          {"value", p.value ? Json(p.value->to_string()) : Json()},
                          {"run_time", p.run_time}});
  }
  Json& coordinates = list("coordinates");
  for (const CoordinateContent& c : content.coordinates) {
    if (c.attitude) {
      for (const SymbolPointer& e : positions_with(content, c)) {
        coordinates.push_back({{"name", e->name}, {"unit", written_unit(*e)}, {"role", "quaternion"}});
      }
    }
    Json coordinate{{"name", c.q->name}, {"unit", written_unit(*symbols_of(c).front())}, {"role", role(c)}};
    if (c.limits) {
      const auto limit = [&](const char* name, const std::optional<Number>& value) {
        if (value) coordinate["limits"][name] = value->to_double();
      };
      limit("lower", c.limits->lower);
      limit("upper", c.limits->upper);
      limit("velocity", c.limits->velocity);
      limit("effort", c.limits->effort);
    }
    coordinates.push_back(std::move(coordinate));
  }
  const Model& model = equations.model();
  std::vector<SymbolPointer> velocities;
  for (int i = 0; i < model.unknown_count(); ++i) {
    velocities.push_back(model.coordinates()[static_cast<std::size_t>(i)].v);
  }
  json["velocities"] = quantities_json(velocities);
  json["inputs"] = quantities_json(model.inputs());
  json["initial_state"] = initial_state_json(model);
  Json& frames = list("frames");
  for (const FrameContent& f : content.frames) frames.push_back(f.name);
  Json& bodies = list("bodies");
  for (const BodyContent& b : content.bodies) bodies.push_back(b.name);
  Json& rotors = list("reflected_inertias");
  for (const BodyContent& r : content.rotors) rotors.push_back(r.name);
  Json& points = list("points");
  for (const PointContent& p : content.points) points.push_back(p.name);
  Json& actions = list("actions");
  for (const ActionContent& a : content.actions) actions.push_back(name_of(a));
  for (const ContactFriction& f : content.frictions) actions.push_back(f.name);
  Json& contacts = list("contacts");
  for (const ContactContent& c : content.contacts) contacts.push_back({{"name", c.name}, {"kind", kind_of(c)}});
  Json& constraints = list("constraints");
  for (const ConstraintContent& c : content.constraints) {
    constraints.push_back(
        {{"name", c.name}, {"multiplier", c.multiplier->name}, {"unit", written_unit(*c.multiplier)}});
  }
  Json& kernels = list("kernels");
  for (const std::string& name : kernel_names()) {
    const std::string skipped = why_absent(name, equations);
    Json kernel{{"name", name}, {"available", skipped.empty()}};
    const auto& usual = usual_kernel_names();
    kernel["when_named"] = std::find(usual.begin(), usual.end(), name) == usual.end();
    if (!skipped.empty()) kernel["why_not"] = skipped;
    kernels.push_back(std::move(kernel));
  }
  return json;
}

/// As a person writes it, and as equations are printed.
std::string readable(const Equations& equations, const Expression& formula) {
  const Value value = equations.program().lower(formula);
  if (!formula.symbols().empty() || !value.is_constant()) return formula.to_string();
  return printing::decimal_text(value.polynomial().constant());
}

std::string line(const std::string& title, const Json& items, const std::function<std::string(const Json&)>& text) {
  std::string joined;
  for (const Json& item : items) joined += (joined.empty() ? "" : ", ") + text(item);
  return joined.empty() ? "" : fmt::format("{:<14}{}\n", title, joined);
}

}  // namespace

std::string list_json(const Scene& scene, const std::vector<std::string>& kernels) {
  Json json = content_json(scene, Equations(scene));
  add_kernel_shapes(json, scene, kernels);
  return json.dump(2) + "\n";
}

std::string list_text(const Scene& scene) {
  const Equations equations(scene);
  const Json json = content_json(scene, equations);
  const auto plain = [](const Json& item) { return item.get<std::string>(); };
  const auto text = [](const Json& value) { return value.get<std::string>(); };
  std::string out = scene.content().title.empty() ? scene.name() + "\n"
                                                  : fmt::format("{}: {}\n", scene.name(), scene.content().title);
  std::vector<std::string> parameters;
  for (const ParameterContent& p : scene.content().parameters) {
    const std::string value = p.value ? readable(equations, *p.value) : "given at run time";
    parameters.push_back(fmt::format("{} = {} [{}]{}", p.symbol->name, value, written_unit(*p.symbol),
                                     p.run_time && p.value ? " (run time)" : ""));
  }
  out += line("parameters", Json(parameters), plain);
  out += line("coordinates", json["coordinates"], [&](const Json& c) {
    return fmt::format("{} [{}]{}", text(c["name"]), text(c["unit"]),
                       c["role"] == "unknown" ? "" : " (" + text(c["role"]) + ")");
  });
  for (const char* key : {"frames", "bodies", "points", "actions"}) out += line(key, json[key], plain);
  out += line("rotors", json["reflected_inertias"], plain);
  out += line("contacts", json["contacts"],
              [&](const Json& c) { return fmt::format("{} ({})", text(c["name"]), text(c["kind"])); });
  out += line("constraints", json["constraints"],
              [&](const Json& c) { return fmt::format("{} ({})", text(c["name"]), text(c["multiplier"])); });
  for (const Json& kernel : json["kernels"]) {
    std::string remark = kernel["available"].get<bool>() ? "" : " (absent: " + text(kernel["why_not"]) + ")";
    if (remark.empty() && kernel["when_named"].get<bool>()) remark = " (when named)";
    out += fmt::format("{:<14}{}{}\n", &kernel == &json["kernels"][0] ? "kernels" : "", text(kernel["name"]), remark);
  }
  return out;
}

}  // namespace torsor
