// SPDX-License-Identifier: GPL-3.0-or-later
// hostile_headers FOLDER BATCH [ROLE...] < NAMES: every name in every role of a scene, or in those, so many in one. Writes
// headers and, for each of them, a source that instantiates it, the same in C, and a module of JavaScript; prints these
// files and the names that were refused, with their role.
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/emission/c_header.hpp"
#include "torsor/generator/emission/header.hpp"
#include "torsor/generator/emission/javascript_module.hpp"
#include "torsor/generator/mechanics/scene.hpp"

namespace {

using namespace torsor;
using Names = std::vector<std::string>;

const Names all_roles{"coordinate", "parameter", "input", "multiplier", "point", "attitude", "body", "scene"};
const Names kernels{"kinematics",  "mass_matrix", "bias",            "inverse_dynamics", "forward_dynamics",
                    "energy",      "constraints", "first_integrals", "residual",         "jets"};

/// A mechanism in all languages.
struct Texts {
  std::string cpp, c, javascript;
};

Texts texts_of(const Scene& scene, const Names& asked) {
  const MechanismListing mechanism = lower_mechanism(scene, asked);
  return {emit_header(mechanism), emit_c(mechanism).header, emit_javascript(mechanism)};
}

/// A coordinate, at first an angle and then a length in turn, with a body of that mass and a spring.
class Builder {
 public:
  Builder() : scene_("hostile", "Names of all kinds") {}

  void add(const std::string& role, const std::string& name) {
    const std::string number = std::to_string(count_++);
    if (role == "coordinate") {
      moving(name, "own_frame" + number, "own_body" + number, Expression::quantity("2", "kg"));
    } else if (role == "parameter") {
      moving("own_x" + number, "own_frame" + number, "own_body" + number, scene_.run_time_parameter(name, "kg", 2));
    } else if (role == "input") {
      scene_.motor(name, moving("own_x" + number, "own_frame" + number, "own_body" + number, Expression::quantity("2", "kg")));
    } else if (role == "multiplier") {
      angle_ = false;
      const Expression a = moving("own_x" + number, "own_frame" + number, "own_body" + number, Expression::quantity("2", "kg"));
      angle_ = false;
      const Expression b = moving("own_y" + number, "own_other" + number, "own_second" + number, Expression::quantity("1", "kg"));
      scene_.holonomic(name, a - b);
    } else if (role == "point") {
      moving("own_x" + number, name, "own_body" + number, Expression::quantity("2", "kg"));
      scene_.point(name, name, {Expression::quantity("1", "m"), 0, 0});
    } else if (role == "attitude") {
      const AttitudeHandle e = scene_.attitude(name);
      const Expression moment = Expression::quantity("2", "kg m^2");
      scene_.body(
          "own_body" + number, scene_.spherical("own_frame" + number, scene_.ground(), e),
          Inertia::general({.mass = Expression::quantity("1", "kg"), .xx = moment, .yy = moment, .zz = moment}));
    } else {
      const Expression q = moving("own_x" + number, name, name, Expression::quantity("2", "kg"));
      scene_.damper(name, q, scene_.parameter("own_d" + number, is_angle_ ? "N m s" : "N s/m", 1));
    }
  }

  Texts texts(const Names& asked) const { return texts_of(scene_, asked); }

 private:
  Expression moving(const std::string& name, const std::string& frame, const std::string& body, const Expression& mass) {
    is_angle_ = angle_;
    angle_ = !angle_;
    const Expression metre = Expression::quantity("1", "m");
    const Expression q = scene_.coordinate(name, is_angle_ ? "rad" : "m");
    const FrameHandle handle = is_angle_ ? scene_.revolute(frame, scene_.ground(), axis::z, q)
                                         : scene_.prismatic(frame, scene_.ground(), axis::x, q);
    scene_.body(body, handle, Inertia::point(mass).at({metre, 0, 0}));
    scene_.generalised_force(
        "e_" + name, q, is_angle_ ? Expression::quantity("1", "N m") * sin(q) : Expression::quantity("1", "N/m") * q);
    return q;
  }

  Scene scene_;
  int count_ = 0;
  bool angle_ = true, is_angle_ = true;
};

Texts texts_of(const std::string& role, const Names& names, const Names& asked) {
  Builder builder;
  for (const std::string& name : names) builder.add(role, name);
  return builder.texts(asked);
}

/// Those of the names that a scene takes in the role, all in one: halves of what it refuses are tried again.
Names accepted(const std::string& role, const Names& names) {
  if (names.empty()) return names;
  try {
    static_cast<void>(texts_of(role, names, {"mass_matrix", "kinematics"}));
    return names;
  } catch (const Error& refusal) {
    if (names.size() == 1) {
      std::printf("refused %s %s: %s\n", role.c_str(), names[0].c_str(), refusal.what());
      return {};
    }
    const auto half = names.begin() + static_cast<std::ptrdiff_t>(names.size() / 2);
    Names all = accepted(role, {names.begin(), half});
    for (const std::string& name : accepted(role, {half, names.end()})) all.push_back(name);
    return all;
  }
}

void write(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  if (!file.flush()) throw std::runtime_error("cannot write " + path);
}

class Writer {
 public:
  explicit Writer(std::string folder) : folder_(std::move(folder)) {}

  void write_all(const std::string& role, const Names& names) {
    Names all = accepted(role, names);
    // Two that are good alone may meet in one structure.
    while (!all.empty()) {
      try {
        put(role, texts_of(role, all, kernels), "hostile");
        return;
      } catch (const Error& refusal) {
        std::printf("refused %s %s: %s\n", role.c_str(), all.back().c_str(), refusal.what());
        all.pop_back();
      }
    }
  }

  /// The names of scenes: namespaces in one file, below one support; in C prefixes of one file each, included together.
  void write_scenes(const Names& names) {
    Texts all;
    std::string instances;
    for (const std::string& name : names) {
      try {
        Scene scene(name);
        const Expression x = scene.coordinate("x", "m");
        scene.body("block", scene.prismatic("slide", scene.ground(), axis::x, x), Inertia::point(Expression::quantity("1", "kg")));
        const Texts texts = texts_of(scene, {"mass_matrix"});
        all.cpp += all.cpp.empty() ? texts.cpp : texts.cpp.substr(texts.cpp.find("\nnamespace " + name + " {"));
        const std::string file = "scene_of_" + std::to_string(scenes_++) + ".h";
        write(folder_ + "/" + file, texts.c);
        all.c += "#include \"" + file + "\"\n";
        all.javascript = texts.javascript;  // modules stand alone: the last one is checked
        instances += "template struct " + name + "::Mechanism<double>;\n";
      } catch (const Error&) {
        std::printf("refused scene %s\n", name.c_str());
      }
    }
    if (!all.cpp.empty()) put("scene", all, "", instances);
  }

 private:
  void put(const std::string& role, const Texts& texts, const std::string& scene, std::string instances = {}) {
    const std::string name = role + std::to_string(number_++);
    if (instances.empty()) instances = "template struct " + scene + "::Mechanism<double>;\ntemplate struct " + scene + "::Mechanism<float>;\n";
    write(folder_ + "/" + name + ".hpp", texts.cpp);
    write(folder_ + "/" + name + ".cpp", "#include \"" + name + ".hpp\"\n" + instances);
    write(folder_ + "/" + name + ".h", texts.c);
    write(folder_ + "/" + name + ".c", "#include \"" + name + ".h\"\n");
    write(folder_ + "/" + name + ".mjs", texts.javascript);
    for (const char* extension : {"cpp", "c", "mjs"}) std::printf("source %s.%s\n", name.c_str(), extension);
  }

  std::string folder_;
  int number_ = 0, scenes_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) return 2;
  const std::size_t batch = std::stoul(argv[2]);
  Names wanted(argv + 3, argv + argc), names;
  if (wanted.empty()) wanted = all_roles;
  for (std::string name; std::getline(std::cin, name);) names.push_back(name);
  Writer writer(argv[1]);
  for (std::size_t begin = 0; begin < names.size(); begin += batch) {
    const std::size_t end = std::min(begin + batch, names.size());
    const Names some(names.begin() + static_cast<std::ptrdiff_t>(begin), names.begin() + static_cast<std::ptrdiff_t>(end));
    for (const std::string& role : wanted) {
      if (role != "scene") writer.write_all(role, some);
    }
  }
  if (std::find(wanted.begin(), wanted.end(), "scene") != wanted.end()) writer.write_scenes(names);
  return 0;
}
