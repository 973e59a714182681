// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/dynamics/random_loops.hpp"

#include <array>
#include <string>

namespace torsor::testing_mechanisms {
namespace {

using Numbers = std::array<Number, 3>;

/// Where a frame is in the base, exactly.
struct Pose {
  Numbers origin;
  Rotation rotation;

  Pose moved(const Numbers& by, const Rotation& turn) const {
    Pose result = *this;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        result.origin[static_cast<std::size_t>(i)] += rotation(i, j) * by[static_cast<std::size_t>(j)];
      }
    }
    result.rotation = rotation * turn;
    return result;
  }
  Placement placement() const {
    Placement place;
    for (std::size_t i = 0; i < 3; ++i) place.origin[i] = Expression::quantity(origin[i], units::metre);
    place.rotation = rotation;
    return place;
  }
};

class ChainBuilder {
 public:
  ChainBuilder(Scene& scene, RandomSource& random, const FrameHandle& base)
      : scene_(scene), random_(random), base_(base), last_(base) {}

  ClosedChain build() {
    switch (random_.below(3)) {
      case 0:
        spatial();
        break;
      case 1:
        planar();
        break;
      default:
        hinged();
        break;
    }
    return chain_;
  }

 private:
  /// Quarters, so that exact sums along the chain stay short.
  Number quarter() { return Number::rational(1 + random_.below(6), 4); }
  Number signed_quarter() {
    const Number size = quarter();
    return random_.one_in(2) ? size : -size;
  }
  Numbers offset(bool in_plane) {
    Numbers place;
    place[0] = signed_quarter();
    place[1] = signed_quarter();
    if (!in_plane) place[2] = signed_quarter();
    return place;
  }
  /// Twice a turn by no right angle: aligned axes would make starts singular where a mechanism is locked.
  Rotation turn() {
    const int about = random_.below(3);
    const Rotation first = Rotation::about(about, oblique());
    const int then = (about + 1 + random_.below(2)) % 3;
    return first * Rotation::about(then, oblique());
  }
  int oblique() {
    const int third = 3 * random_.below(8);
    return third + 1 + random_.below(2);
  }

  /// The constant placement of the next joint.
  Placement place(const Numbers& origin, const Rotation& rotation) {
    end_ = end_.moved(origin, rotation);
    return Pose{origin, rotation}.placement();
  }
  Placement anywhere() {
    const Numbers origin = offset(false);
    return place(origin, turn());
  }

  Expression angle(int about, int least = -11, int most = 11) {
    const int twelfths = least + random_.below(most - least + 1);
    const Expression q = coordinate("rad");
    scene_.initial(q, Expression(twelfths) * pi() / Expression(12));
    end_ = end_.moved({}, Rotation::about(about, twelfths));
    return q;
  }
  Expression length(int along) {
    const Number start = signed_quarter();
    const Expression q = coordinate("m");
    scene_.initial(q, Expression::quantity(start, units::metre));
    Numbers by;
    by[static_cast<std::size_t>(along)] = start;
    end_ = end_.moved(by, Rotation());
    return q;
  }
  Expression coordinate(const char* unit) {
    const Expression q = scene_.coordinate(kind_ + "_q" + std::to_string(chain_.coordinates.size()), unit);
    chain_.coordinates.push_back(q);
    return q;
  }
  /// Starts at rest, at a quarter turn, or with its axes exchanged in a ring.
  AttitudeHandle attitude() {
    const AttitudeHandle e = scene_.attitude(kind_ + "_turn" + std::to_string(chain_.frames.size()));
    switch (random_.below(3)) {
      case 0:
        scene_.initial(e, {1, 1, 0, 0});
        end_ = end_.moved({}, Rotation::about(0, 6));
        break;
      case 1:
        scene_.initial(e, {1, 1, 1, 1});
        end_ = end_.moved({}, Rotation::about(0, 6) * Rotation::about(1, 6));  // x to y to z to x
        break;
      default:
        break;
    }
    return e;
  }
  static const Triple& along(int i) { return i == 0 ? axis::x : i == 1 ? axis::y : axis::z; }

  std::string next_name() const { return kind_ + std::to_string(chain_.frames.size()); }

  void add(const std::string& name, const FrameHandle& frame) {
    const Expression mass = scene_.parameter("m_" + name, "kg", random_.fraction());
    scene_.body(name, frame, random_.inertia(mass));
    chain_.frames.push_back(frame);
    last_ = frame;
  }

  /// A link on a joint of that type; its freedoms.
  int link(JointType type, const Placement& at) {
    const std::string name = next_name();
    const int i = random_.below(3);
    switch (type) {
      case JointType::prismatic:
        add(name, scene_.prismatic(name, last_, along(i), length(i), at));
        break;
      case JointType::helical: {
        const Expression pitch = random_.quantity("m");
        add(name, scene_.helical(name, last_, {.axis = along(i), .angle = angle(i, 0, 0), .pitch = pitch},
                                 at));  // π m are no exact start
        break;
      }
      case JointType::cylindrical: {
        const Expression x = length(i);
        add(name, scene_.cylindrical(name, last_, {.axis = along(i), .displacement = x, .angle = angle(i)}, at));
        break;
      }
      case JointType::universal: {
        const Expression first = angle(2);
        add(name, scene_.universal(
                      name, last_,
                      {.first = axis::z, .first_angle = first, .second = axis::x, .second_angle = angle(0)}, at));
        break;
      }
      case JointType::spherical:
        if (random_.one_in(3)) {
          const Expression first = angle(0);
          const Expression second = angle(1, -4, 4);  // away from the singular orientation of Cardan's angles
          const Expression third = angle(2);
          add(name,
              scene_.spherical(name, last_, {.sequence = AngleSequence::cardan, .angles = {first, second, third}}, at));
        } else {
          add(name, scene_.spherical(name, last_, attitude(), at));
        }
        break;
      case JointType::planar: {
        const Expression x = length(0);
        const Expression y = length(1);
        add(name, scene_.planar(name, last_, {.x = x, .y = y, .angle = angle(2)}, at));
        break;
      }
      default:
        add(name, scene_.revolute(name, last_, along(i), angle(i), at));
        return 1;
    }
    return freedom_count(type);
  }

  /// Joins the end of the chain, moved by a constant placement, to the base.
  void close(const std::string& suffix, JointType type, const Numbers& by, const Rotation& rotation) {
    const FrameHandle near = scene_.weld(kind_ + "_near" + suffix, last_, Pose{by, rotation}.placement());
    const FrameHandle far = scene_.weld(kind_ + "_far" + suffix, base_, end_.moved(by, rotation).placement());
    const Expression pitch = type == JointType::helical ? random_.quantity("m") : Expression(0);
    scene_.loop_joint(kind_ + "_close" + suffix, {.type = type, .a = far, .b = near, .pitch = pitch});
  }

  void spatial() {
    kind_ = "spatial";
    const auto closing = static_cast<JointType>(random_.below(11));  // weld to point contact
    static constexpr std::array<JointType, 8> types{JointType::revolute,  JointType::cylindrical, JointType::universal,
                                                    JointType::spherical, JointType::helical,     JointType::planar,
                                                    JointType::prismatic, JointType::spherical};
    int freedoms = freedom_count(closing);
    for (std::size_t k = 0; freedoms < 7 || k < 2; ++k) {
      const JointType type = types[static_cast<std::size_t>(random_.below(8))];
      const Placement at = anywhere();
      freedoms += link(type, at);
    }
    const Numbers by = offset(false);
    close("", closing, by, turn());
  }

  void planar() {
    kind_ = "planar";
    base_ = last_ = scene_.weld("planar_base", base_, random_.placement());
    static constexpr std::array<JointType, 4> types{JointType::revolute, JointType::cylindrical, JointType::spherical,
                                                    JointType::weld};
    const JointType closing = types[static_cast<std::size_t>(random_.below(4))];
    const int links = closing == JointType::weld ? 4 : 3;
    const int slider = random_.below(2 * links);  // or none
    for (int k = 0; k < links; ++k) {
      const Placement at = place(offset(true), Rotation());
      const std::string name = next_name();
      if (k == slider)
        add(name, scene_.prismatic(name, last_, axis::x, length(0), at));
      else
        add(name, scene_.revolute(name, last_, axis::z, angle(2), at));
    }
    close("", closing, offset(true), Rotation::about(1, -6));  // x along the axes of the others
  }

  void hinged() {
    kind_ = "hinged";
    base_ = scene_.weld("hinged_base", base_, random_.placement());
    const Expression x = length(0);
    const Expression y = length(1);
    const Expression z = length(2);
    const std::string name = next_name();
    add(name, scene_.free(name, base_, {x, y, z}, attitude()));
    static constexpr std::array<JointType, 3> types{JointType::revolute, JointType::prismatic, JointType::cylindrical};
    const JointType type = types[static_cast<std::size_t>(random_.below(3))];
    const Numbers first = offset(false);
    const Rotation direction = turn();
    close("_1", type, first, direction);
    Numbers further;
    if (type == JointType::prismatic) further = offset(false);
    further[0] = quarter();
    Numbers second = first;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        second[static_cast<std::size_t>(i)] += direction(i, j) * further[static_cast<std::size_t>(j)];
      }
    }
    close("_2", type, second, direction);
  }

  Scene& scene_;
  RandomSource& random_;
  FrameHandle base_, last_;
  Pose end_;  ///< of the last frame, at the start
  std::string kind_;
  ClosedChain chain_;
};

}  // namespace

ClosedChain add_closed_chain(Scene& scene, RandomSource& random, const FrameHandle& base) {
  return ChainBuilder(scene, random, base).build();
}

}  // namespace torsor::testing_mechanisms
