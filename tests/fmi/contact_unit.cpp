// SPDX-License-Identifier: GPL-3.0-or-later
// contact_unit VERSION FOLDER: the sources of a unit of FMI whose body touches a table and stops, and its token on stdout.
#include <cstdio>
#include <filesystem>
#include <string>

#include "torsor/generator/base/output_file.hpp"
#include "torsor/generator/emission/fmi_description.hpp"
#include "torsor/generator/emission/fmi_sources.hpp"
#include "torsor/generator/torsor.hpp"

namespace {

using namespace torsor;
using namespace torsor::literals;

Scene ball_between_stops() {
  Scene scene("ball_between_stops", "Ball on a table between two stops, pushed along it");
  const Expression m = scene.parameter("m", "kg", 1), r = scene.parameter("r", "m", 0.1_r);
  const Expression f = scene.run_time_parameter("f", "1", 0.2_r), e = scene.run_time_parameter("e", "1", 0.5_r);
  const Expression x = scene.coordinate("x", "m"), z = scene.coordinate("z", "m"), turn = scene.coordinate("turn", "rad");
  scene.initial(x, 0, Expression::quantity("1", "m/s"));
  scene.initial(z, r);
  const FrameHandle slide = scene.prismatic("slide", scene.ground(), axis::x, x);
  const FrameHandle lift = scene.prismatic("lift", slide, axis::z, z);
  const FrameHandle ball = scene.revolute("ball", lift, axis::y, turn);
  scene.body("ball", ball, Inertia::solid_sphere(m, r));
  scene.gravity({0, 0, Expression::quantity("-9.81", "m/s^2")});
  scene.point("B", ball, {r, 0, 0});
  scene.motor("push", x);
  scene.contact("table", shape::Sphere{.frame = ball, .radius = r}, shape::Plane{.frame = scene.ground()},
                {.friction = f, .restitution = e});
  scene.stop(x, Expression::quantity("-1", "m"), Expression::quantity("1", "m"), {.restitution = e});
  return scene;
}

}  // namespace

int main(int count, char** words) {
  if (count != 3) return std::fprintf(stderr, "usage: contact_unit VERSION FOLDER\n"), 2;
  const FmiVersion version = std::string(words[1]) == "2" ? FmiVersion::two : FmiVersion::three;
  const Scene scene = ball_between_stops();
  const FmiUnit unit = lower_unit(scene, version, {{"B"}, {"ball"}, {}});
  for (const auto& sources : {fmi_sources(unit), fmi_contact_sources(unit)}) {
    for (const SourceFile& source : sources) {
      const std::filesystem::path path = std::filesystem::path(words[2]) / source.path;
      std::filesystem::create_directories(path.parent_path());
      write_file_if_changed(path.string(), source.text);
    }
    std::printf("%s\n", sources.front().path.c_str());
  }
  std::printf("%s\n", fmi_token(unit).c_str());
}
