// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/generation/serial_chain.hpp"

#include <cstdint>
#include <string>

#include <fmt/format.h>

namespace torsor {
namespace {

/// Decimal numbers from the minimal standard generator (Park and Miller 1988), which no library changes.
class Decimals {
 public:
  /// Between the two, in millionths.
  Expression between(int low, int high, const Unit& unit) {
    state_ = state_ * 48271 % 2147483647;
    const auto span = static_cast<std::uint64_t>(high - low);
    const int millionths = low + static_cast<int>(state_ % span);
    return Expression::quantity(Number(millionths) / Number(1000000), unit);
  }

 private:
  std::uint64_t state_ = 1;
};

}  // namespace

Scene serial_chain(int joints) {
  Scene scene(fmt::format("chain{}", joints));
  scene.gravity({0, 0, Expression::quantity(Number(-981) / Number(100), units::metre_per_second_squared)});
  Decimals random;
  FrameHandle parent = scene.ground();
  for (int k = 1; k <= joints; ++k) {
    const std::string index = std::to_string(k);
    Placement placement;
    if (k > 1) placement.origin = {0, 0, Expression::quantity(Number(1) / Number(4), units::metre)};
    const Expression q = scene.coordinate("q" + index, "rad");
    parent = scene.revolute("link" + index, parent, k % 2 == 1 ? axis::x : axis::y, q, placement);
    const auto moment = [&](int low, int high) { return random.between(low, high, units::kilogram_metre_squared); };
    const Expression mass = random.between(1000000, 1500000, units::kilogram);
    const Expression xx = moment(6000, 8000), yy = moment(6000, 8000), zz = moment(2000, 2700);
    const Expression xy = moment(-200, 200), xz = moment(-200, 200), yz = moment(-200, 200);
    const Expression x = random.between(-20000, 20000, units::metre), y = random.between(-20000, 20000, units::metre);
    const Expression z = random.between(110000, 140000, units::metre);
    scene.body(
        "link" + index, parent,
        Inertia::general({.mass = mass, .xx = xx, .yy = yy, .zz = zz, .xy = xy, .xz = xz, .yz = yz}).at({x, y, z}));
  }
  return scene;
}

}  // namespace torsor
