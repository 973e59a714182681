// SPDX-License-Identifier: GPL-3.0-or-later
// MuJoCo: contacts are springs, regularised, whose stiffness the settings choose.
#include <mujoco/mujoco.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "benchmarks/contact_peers/closed_forms.hpp"
#include "benchmarks/contact_peers/peers.hpp"

namespace torsor::contact_peers {
namespace {

/// `option` and `geom` are attributes of these elements.
struct Settings {
  std::string name, option, geom;
  double step;
};

const std::vector<Settings>& settings() {
  static const std::vector<Settings> all{
      {"as it comes: pyramids, h = 2 ms", "", "", 2e-3},
      {"elliptic cones, h = 2 ms", "cone='elliptic'", "", 2e-3},
      {"elliptic cones, stiff, h = 1 ms", "cone='elliptic' timestep='1e-3'",
       "solref='0.002 1' solimp='0.99 0.999 0.0001'", 1e-3},
      {"elliptic cones, stiffer, RK4, h = 0.1 ms",
       "cone='elliptic' timestep='1e-4' impratio='100' tolerance='1e-12' iterations='1000' integrator='RK4'",
       "solref='0.0002 1' solimp='0.999 0.9999 0.00001'", 1e-4}};
  return all;
}

using Model = std::unique_ptr<mjModel, decltype(&mj_deleteModel)>;
using Data = std::unique_ptr<mjData, decltype(&mj_deleteData)>;

Model load(const std::string& text) {
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), "model.xml", static_cast<int>(text.size()));
  std::memcpy(files->filedata[0], text.data(), text.size());
  std::array<char, 1000> error{};
  Model model(mj_loadXML("model.xml", files.get(), error.data(), static_cast<int>(error.size())), mj_deleteModel);
  mj_deleteVFS(files.get());
  if (!model) std::fprintf(stderr, "contact_peers: %s\n", error.data());
  return model;
}

/// A world of weight 9.81 over the plane z = 0; `body` has its defaults.
std::string world(const Settings& with, const std::string& joint, const std::string& geom, const std::string& body) {
  return "<mujoco><compiler angle='radian'/><option gravity='0 0 -9.81' " + with.option +
         "/><default><geom condim='3' " + geom + " " + with.geom + "/><joint " + joint +
         "/></default><worldbody><geom type='plane' size='0 0 1'/>" + body + "</worldbody></mujoco>";
}

std::string leg(double front, double side) {
  std::array<char, 1500> text{};
  std::snprintf(
      text.data(), text.size(),
      "<body pos='%g %g 0'><joint axis='1 0 0'/><inertial pos='0 %g 0' mass='0.5' diaginertia='0.0006 0.0004 0.0006'/>"
      "<body pos='0 %g 0'><joint axis='0 1 0' springref='0.7'/><inertial pos='0 0 -0.09' mass='0.8' "
      "diaginertia='0.0028 0.0028 "
      "0.0004'/><body pos='0 0 -0.2'><joint axis='0 1 0' springref='-1.4'/><inertial pos='0 0 -0.1' mass='0.2' "
      "diaginertia='0.0007 0.0007 0.00003'/><body pos='0 0 -0.2'><inertial pos='0 0 0' mass='0.06' "
      "diaginertia='0.0000096 0.0000096 "
      "0.0000096'/><geom type='sphere' size='0.02'/></body></body></body></body>",
      0.2 * front, 0.05 * side, 0.04 * side, 0.08 * side);
  return text.data();
}

Outcome land(const Settings& with, const Path& truth) {
  std::string body = "<body pos='0 0 0.45'><freejoint/><inertial pos='0 0 0' mass='6' diaginertia='0.025 0.085 0.1'/>";
  for (const double front : {1.0, -1.0}) {
    for (const double side : {1.0, -1.0}) body += leg(front, side);
  }
  // The damping of the motors and that of the joints.
  const Model model = load(world(with, "damping='2.05' stiffness='60'", "friction='0.6 0 0'", body + "</body>"));
  if (!model) return {0, INFINITY};
  const Data data(mj_makeData(model.get()), mj_deleteData);
  for (int j = 0; j < 12; ++j) data->qpos[7 + j] = std::array{0.0, 0.7, -1.4}[static_cast<std::size_t>(j % 3)];
  data->qvel[0] = 0.5;
  Path path;
  const Stopwatch watch;
  for (int k = 0; k < 100; ++k) {
    for (long j = std::lround(0.1 / with.step); j > 0; --j) mj_step(model.get(), data.get());
    path.push_back({data->qpos[0], data->qpos[1], data->qpos[2]});
  }
  return {watch.seconds(), distance(path, truth)};
}

Outcome roll(const Settings& with) {
  std::array<char, 500> ball{};
  std::snprintf(ball.data(), ball.size(),
                "<body pos='0 0 %.9g'><freejoint/><geom type='sphere' size='%.9g' mass='%g'/></body>", billiard::radius,
                billiard::radius, billiard::mass);
  const Model model = load(world(with, "", "friction='0.2 0 0'", ball.data()));
  if (!model) return {0, INFINITY};
  const Data data(mj_makeData(model.get()), mj_deleteData);
  data->qvel[0] = billiard::speed;
  const Stopwatch watch;
  for (long j = std::lround(billiard::end / with.step); j > 0; --j) mj_step(model.get(), data.get());
  return {watch.seconds(), std::abs(data->qpos[0] - billiard::place())};
}

}  // namespace

std::vector<Way> mujoco_quadruped(const Path& truth) {
  std::vector<Way> ways;
  for (const Settings& each : settings())
    ways.push_back({"MuJoCo", each.name, [&each, truth] { return land(each, truth); }});
  return ways;
}

std::vector<Way> mujoco_billiard() {
  std::vector<Way> ways;
  for (const Settings& each : settings()) ways.push_back({"MuJoCo", each.name, [&each] { return roll(each); }});
  return ways;
}

}  // namespace torsor::contact_peers
