// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>

#include "tests/scenes/bodies.hpp"
#include "tests/scenes/loops.hpp"

namespace torsor::testing_mechanisms {

/// Six links in a ring, by turns twisted by a right angle one way and the other.
struct SixLinks {
  std::array<const char*, 6> lengths;  ///< [m]
  std::array<const char*, 6> angles;   ///< at the start [rad]
  Triple gravity{0, 0, quantity("-9.81", "m/s^2")};
};

/// Six hinges whose ring is closed by a weld: six conditions for six angles, one of which repeats the others in a linkage of
/// Bricard, nowhere the same way.
inline Scene ring_of_six(const SixLinks& links) {
  Scene scene("ring");
  FrameHandle frame = scene.ground();
  const auto name = [](const char* what, std::size_t i) { return what + std::to_string(i); };
  const auto place = [&links](std::size_t i) {
    return Placement{{metres(links.lengths[i]), 0, 0}, Rotation::about(0, i % 2 == 0 ? 6 : -6)};
  };
  for (std::size_t i = 0; i < 6; ++i) {
    const Expression q = scene.coordinate(name("t", i), "rad");
    scene.initial(q, quantity(links.angles[i], "rad"));
    frame = scene.revolute(name("link", i), frame, axis::z, q, i == 0 ? Placement{} : place(i - 1));
    const Expression across = quantity("0.1", "kg m^2");
    scene.body(name("link", i), frame,
               Inertia::general({.mass = quantity("1", "kg"), .xx = quantity("0.02", "kg m^2"), .yy = across, .zz = across})
                   .at({metres("0.5"), 0, 0}));
  }
  const FrameHandle end = scene.weld("end", frame, place(5));
  scene.loop_joint("close", {.type = JointType::weld, .a = end, .b = scene.weld("base", scene.ground(), {})});
  scene.gravity(links.gravity);
  return scene;
}

/// Bricard's threefold symmetric linkage: cos θ + cos φ + cos θ cos φ = 0 for angles θ and φ by turns.
inline SixLinks threefold_links() {
  constexpr const char *theta = "1.3962634015954636", *phi = "1.7192974351777786";
  return {.lengths = {"1", "1", "1", "1", "1", "1"}, .angles = {theta, phi, theta, phi, theta, phi}};
}
inline Scene threefold_linkage() { return ring_of_six(threefold_links()); }

/// A trihedral linkage of Bricard: 0.4² + 0.8² + 0.9² = 0.5² + 0.6² + 1².
inline Scene trihedral_linkage() {
  return ring_of_six({.lengths = {"0.4", "0.5", "0.8", "0.6", "0.9", "1"},
                      .angles = {"0.32795938476797837", "-1.941731634792904", "0.30302282899096566", "-2.088723529591824",
                                 "0.35279347693517676", "-2.2060753162642204"}});
}

}  // namespace torsor::testing_mechanisms
