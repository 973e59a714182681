// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <functional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "generator/cli/command_texts.hpp"
#include "generator/emission/kernel.hpp"
#include "generator/mechanics/freedom_positions.hpp"

namespace torsor {
namespace {

using Json = nlohmann::ordered_json;

const char* role(const CoordinateContent& c) { return c.attitude ? "quasi-velocity" : c.law ? "driven" : c.released ? "released" : "unknown"; }

Json content_json(const Scene& scene) {
  const SceneContent& content = scene.content();
  Json json{{"name", content.name}, {"title", content.title}};
  const auto list = [&json](const char* key) -> Json& { return json[key] = Json::array(); };
  Json& parameters = list("parameters");
  for (const ParameterContent& p : content.parameters) {
    parameters.push_back({{"name", p.symbol->name},
                          {"unit", p.symbol->unit.to_string()},
                          {"value", p.value ? Json(p.value->to_string()) : Json()},
                          {"run_time", p.run_time}});
  }
  Json& coordinates = list("coordinates");
  for (const CoordinateContent& c : content.coordinates) {
    if (c.attitude) {
      for (const SymbolPointer& e : positions_with(content, c)) {
        coordinates.push_back({{"name", e->name}, {"unit", e->unit.to_string()}, {"role", "quaternion"}});
      }
    }
    Json coordinate{{"name", c.q->name}, {"unit", c.q->unit.to_string()}, {"role", role(c)}};
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
  Json& frames = list("frames");
  for (const FrameContent& f : content.frames) frames.push_back(f.name);
  Json& bodies = list("bodies");
  for (const BodyContent& b : content.bodies) bodies.push_back(b.name);
  Json& points = list("points");
  for (const PointContent& p : content.points) points.push_back(p.name);
  Json& actions = list("actions");
  for (const ActionContent& a : content.actions) actions.push_back(name_of(a));
  for (const ContactFriction& f : content.frictions) actions.push_back(f.name);
  Json& constraints = list("constraints");
  for (const ConstraintContent& c : content.constraints) {
    constraints.push_back({{"name", c.name}, {"multiplier", c.multiplier->name}});
  }
  const Equations equations(scene);
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

std::string line(const std::string& title, const Json& items, const std::function<std::string(const Json&)>& text) {
  std::string joined;
  for (const Json& item : items) joined += (joined.empty() ? "" : ", ") + text(item);
  return joined.empty() ? "" : fmt::format("{:<14}{}\n", title, joined);
}

}  // namespace

std::string list_json(const Scene& scene) { return content_json(scene).dump(2) + "\n"; }

std::string list_text(const Scene& scene) {
  const Json json = content_json(scene);
  const auto plain = [](const Json& item) { return item.get<std::string>(); };
  const auto text = [](const Json& value) { return value.get<std::string>(); };
  std::string out = scene.content().title.empty() ? scene.name() + "\n"
                                                  : fmt::format("{}: {}\n", scene.name(), scene.content().title);
  out += line("parameters", json["parameters"], [&](const Json& p) {
    const std::string value = p["value"].is_null() ? "given at run time" : text(p["value"]);
    return fmt::format("{} = {} [{}]{}", text(p["name"]), value, text(p["unit"]),
                       p["run_time"].get<bool>() && !p["value"].is_null() ? " (run time)" : "");
  });
  out += line("coordinates", json["coordinates"], [&](const Json& c) {
    return fmt::format("{} [{}]{}", text(c["name"]), text(c["unit"]),
                       c["role"] == "unknown" ? "" : " (" + text(c["role"]) + ")");
  });
  for (const char* key : {"frames", "bodies", "points", "actions"}) out += line(key, json[key], plain);
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
