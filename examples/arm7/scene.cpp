// SPDX-License-Identifier: MIT
#include <array>
#include <string>

#include "torsor/generator/torsor.hpp"

namespace {

/// One link with the joint that carries it: the joint's axis is its own z.
struct Segment {
  int turn;                            ///< of the joint about the parent's x, in units of 15 degrees
  std::array<const char*, 3> origin;   ///< of the joint in the parent [m]
  const char* mass;                    ///< [kg]
  std::array<const char*, 3> center;   ///< centre of mass [m]
  std::array<const char*, 6> inertia;  ///< about it: xx, xy, xz, yy, yz, zz [kg m^2]
};

constexpr std::array<Segment, 7> segments{{
    {0,
     {"0", "0", "0.333"},
     "4.970684",
     {"0.003875", "0.002081", "-0.175"},
     {"0.70337", "-0.000139", "0.006772", "0.70661", "0.019169", "0.009117"}},
    {-6,
     {"0", "0", "0"},
     "0.646926",
     {"-0.003141", "-0.02872", "0.003495"},
     {"0.007962", "-0.003925", "0.010254", "0.02811", "0.000704", "0.025995"}},
    {6,
     {"0", "-0.316", "0"},
     "3.228604",
     {"0.027518", "0.039252", "-0.066502"},
     {"0.037242", "-0.004761", "-0.011396", "0.036155", "-0.012805", "0.01083"}},
    {6,
     {"0.0825", "0", "0"},
     "3.587895",
     {"-0.05317", "0.104419", "0.027454"},
     {"0.025853", "0.007796", "-0.001332", "0.019552", "0.008641", "0.028323"}},
    {-6,
     {"-0.0825", "0.384", "0"},
     "1.225946",
     {"-0.011953", "0.041065", "-0.038437"},
     {"0.035549", "-0.002117", "-0.004037", "0.029474", "0.000229", "0.008627"}},
    {6,
     {"0", "0", "0"},
     "1.666555",
     {"0.060149", "-0.014117", "-0.010517"},
     {"0.001964", "0.000109", "-0.001158", "0.004354", "0.000341", "0.005433"}},
    {6,
     {"0.088", "0", "0"},
     "0.735522",
     {"0.010517", "-0.004252", "0.061597"},
     {"0.012516", "-0.000428", "-0.001196", "0.010027", "-0.000741", "0.004815"}},
}};

}  // namespace

/// Arm with seven revolute joints: geometry and inertia of Franka Emika's Panda, a motor on each joint, z up.
torsor::Scene arm7_scene() {
  using namespace torsor;
  Scene scene("arm7", "Arm with seven revolute joints");
  const auto triple = [](const std::array<const char*, 3>& text) -> Triple {
    return {Expression::quantity(text[0], "m"), Expression::quantity(text[1], "m"), Expression::quantity(text[2], "m")};
  };

  constexpr std::array<const char*, 7> start{"0.3", "-0.7", "0.4", "-1.9", "0.2", "1.6", "-0.5"};
  FrameHandle parent = scene.ground();
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Segment& segment = segments[i];
    const std::string number = std::to_string(i + 1);
    const Expression q = scene.coordinate("q" + number, "rad");
    scene.initial(q, Expression::quantity(start[i]));
    parent = scene.revolute("link" + number, parent, axis::z, q,
                            {.origin = triple(segment.origin), .rotation = Rotation::about(0, segment.turn)});
    const auto moment = [&segment](std::size_t k) { return Expression::quantity(segment.inertia[k], "kg m^2"); };
    scene.body("link" + number, parent,
               Inertia::general({.mass = Expression::quantity(segment.mass, "kg"), .xx = moment(0), .yy = moment(3),
                                 .zz = moment(5), .xy = moment(1), .xz = moment(2), .yz = moment(4)})
                   .at(triple(segment.center)));
    scene.motor("tau" + number, q);
  }
  scene.point("tip", parent, {0, 0, Expression::quantity("0.107", "m")});
  scene.gravity({0, 0, Expression::quantity("-9.81", "m/s^2")});
  return scene;
}

TORSOR_SCENE(arm7_scene)
