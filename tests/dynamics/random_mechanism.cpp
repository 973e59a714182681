// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/dynamics/random_mechanism.hpp"

#include <string>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/dynamics/equations/equations.hpp"
#include "tests/dynamics/random_loops.hpp"
#include "tests/dynamics/random_source.hpp"

namespace torsor::testing_mechanisms {
namespace {

/// Builds one mechanism; draws numbers in a fixed order, one statement each.
class Builder : private RandomSource {
 public:
  Builder(unsigned seed, const RandomMechanismOptions& options)
      : RandomSource(seed), options_(options), scene_("random_mechanism") {}

  Scene build() {
    gravity_ = scene_.parameter("gravity", "m/s^2", fraction());
    const int bodies = 1 + below(options_.most_bodies);
    frames_.push_back(options_.conservative && options_.driven ? turntable() : scene_.ground());
    for (int k = 0; k < bodies; ++k) {
      if (options_.joints && k > 0 && one_in(2)) {
        add_body_on_any_joint(k);
      } else {
        add_body(k);
      }
    }
    if (options_.loops) add_loop();
    const Expression g = gravity_;
    if (!options_.weightless) scene_.gravity({0, options_.conservative && options_.driven ? 0 : g / 3, -g});
    if (options_.released) release();
    add_points();
    if (options_.chains) add_chain();
    if (options_.conservative) {
      if (options_.actions) add_conservative_actions();
      if (options_.constraints) add_constraints();
      return scene_;
    }
    if (options_.actions) add_actions();
    add_motors();
    if (options_.constraints) add_constraints();
    // Drawn last, so that a seed keeps what it had.
    if (options_.actions) add_formulas();
    if (options_.actions) add_mutual_actions();
    if (options_.actions && options_.constraints) add_friction();
    return scene_;
  }

 private:
  /// A joint's displacement: mostly a coordinate of its own, sometimes a formula of several, or of time.
  Expression displacement(int k, bool angle) {
    const std::string name = "q" + std::to_string(k);
    const Expression own = scene_.coordinate(name, angle ? "rad" : "m");
    auto& same = angle ? angles_ : lengths_;
    Expression result = own;
    const int kind = below(8);
    if (kind == 0 && !same.empty()) result = own - Expression(fraction()) * same.back();
    if (kind == 1) result = own + Expression::quantity(fraction(), angle ? Unit() : units::metre);
    if (kind == 2 && options_.driven && !options_.conservative) {
      const Expression phase = quantity("rad/s") * scene_.time();
      result = own + Expression::quantity(fraction(), angle ? Unit() : units::metre) * sin(phase);
    }
    if (kind == 3 && options_.driven && !options_.conservative && k > 0) {
      const Expression s = scene_.time() / Expression::quantity("1", "s");
      scene_.drive(own, Expression::quantity(fraction(), angle ? Unit() : units::metre) * (s + s * s / 3));
      return own;
    }
    same.push_back(own);
    unknowns_.push_back(own);
    return result;
  }

  void add_body(int k) {
    const std::string name = "body" + std::to_string(k);
    const FrameHandle parent = frames_[static_cast<std::size_t>(below(static_cast<int>(frames_.size())))];
    const bool angle = !one_in(3);
    const Expression s = displacement(k, angle);
    const Triple n = axis();
    const Placement place = placement();
    const FrameHandle frame =
        angle ? scene_.revolute(name, parent, n, s, place) : scene_.prismatic(name, parent, n, s, place);
    frames_.push_back(frame);
    attach(name, frame);
    if (one_in(4)) attach(name + "_flange", scene_.weld(name + "_flange", frame, placement()));
  }

  /// A body on a joint of several freedoms, each a coordinate of its own.
  void add_body_on_any_joint(int k) {
    const std::string name = "body" + std::to_string(k);
    const FrameHandle parent = frames_[static_cast<std::size_t>(below(static_cast<int>(frames_.size())))];
    const Placement place = placement();
    int count = 0;
    const auto fresh = [&](const char* unit) {
      const Expression q = scene_.coordinate("q" + std::to_string(k) + "_" + std::to_string(count++), unit);
      unknowns_.push_back(q);
      return q;
    };
    const auto attitude = [&] { return scene_.attitude("turn" + std::to_string(k)); };
    FrameHandle frame;
    switch (below(8)) {
      case 0: {
        const Expression angle = fresh("rad");
        const Expression pitch = quantity("m");
        frame = scene_.helical(name, parent, {.axis = axis(), .angle = angle, .pitch = pitch}, place);
        break;
      }
      case 1: {
        const Expression x = fresh("m");
        const Expression angle = fresh("rad");
        frame = scene_.cylindrical(name, parent, {.axis = axis(), .displacement = x, .angle = angle}, place);
        break;
      }
      case 2: {
        const Expression first = fresh("rad");
        const Expression second = fresh("rad");
        frame = scene_.universal(
            name, parent, {.first = axis::z, .first_angle = first, .second = axis::x, .second_angle = second}, place);
        break;
      }
      case 3: frame = scene_.spherical(name, parent, attitude(), place); break;
      case 4: {
        const Expression x = fresh("m");
        const Expression y = fresh("m");
        const Expression angle = fresh("rad");
        frame = scene_.planar(name, parent, {.x = x, .y = y, .angle = angle}, place);
        break;
      }
      case 5: {
        const Expression x = fresh("m");
        const Expression y = fresh("m");
        const Expression yaw = fresh("rad");
        const Expression roll = fresh("rad");
        frame = scene_.line_contact(name, parent, {.x = x, .y = y, .yaw = yaw, .roll = roll}, place);
        break;
      }
      case 6: {
        const Expression x = fresh("m");
        const AttitudeHandle turn = attitude();
        frame = scene_.sphere_in_cylinder(name, parent, {.axis = axis(), .displacement = x, .turn = turn}, place);
        break;
      }
      default: {
        const Expression x = fresh("m");
        const Expression y = fresh("m");
        frame = scene_.point_contact(name, parent, {.x = x, .y = y, .turn = attitude()}, place);
        break;
      }
    }
    frames_.push_back(frame);
    attach(name, frame);
  }

  /// Constraints of one joint on the six freedoms of a free body are independent whatever it is tied to.
  void add_loop() {
    if (!one_in(2)) return;
    const Expression x = scene_.coordinate("loop_x", "m");
    const Expression y = scene_.coordinate("loop_y", "m");
    const Expression z = scene_.coordinate("loop_z", "m");
    const FrameHandle frame = scene_.free("looped", scene_.ground(), {x, y, z}, scene_.attitude("loop_turn"));
    attach("looped", frame);
    const FrameHandle near = scene_.weld("near", frame, placement());
    const FrameHandle far = scene_.weld("far", frames_.back(), placement());
    const JointType type = static_cast<JointType>(1 + below(10));  // revolute to point contact
    const Expression pitch = type == JointType::helical ? quantity("m") : Expression(0);
    scene_.loop_joint("loop_joint", {.type = type, .a = far, .b = near, .pitch = pitch});
  }

  /// A vertical axis that turns uniformly: it imposes a motion but leaves T2 − T0 − U of what stands on it constant.
  FrameHandle turntable() {
    const Expression turn = scene_.coordinate("turn", "rad");
    scene_.drive(turn, quantity("rad/s") * scene_.time());
    return scene_.revolute("turntable", scene_.ground(), axis::z, turn);
  }

  /// A closed chain on any body of the tree, with actions of its own.
  void add_chain() {
    const FrameHandle base = frames_[static_cast<std::size_t>(below(static_cast<int>(frames_.size())))];
    const ClosedChain chain = add_closed_chain(scene_, *this, base);
    const PointHandle a = scene_.point("A", chain.frames.front(), vector("m"));
    const PointHandle b = scene_.point("B", chain.frames.back(), vector("m"));
    if (options_.actions) {
      if (one_in(2)) {
        const Expression rest = quantity("m");
        scene_.spring("chain_tie", {.a = a, .b = scene_.point("P1"), .stiffness = quantity("N/m"), .rest = rest});
      }
      const Expression last = chain.coordinates.empty() ? unknowns_[0] : chain.coordinates.back();
      if (one_in(2)) scene_.spring("chain_spring", last, quantity(last.unit().is_dimensionless() ? "N m" : "N/m"));
      if (options_.conservative) return;
      if (one_in(2))
        scene_.force("chain_push", {.body = chain.frames.back(), .point = b, .components = vector("N"), .axes = base});
      if (one_in(2)) scene_.damper("chain_brake", b, scene_.point("Q0"), quantity("N s/m"));
    }
    if (options_.motors && !options_.conservative && !chain.coordinates.empty()) {
      scene_.motor("chain_motor", chain.coordinates.front());
    }
  }

  /// Only what has a force function that does not depend on time.
  void add_conservative_actions() {
    const Expression first = unknowns_[0];
    const bool angle = first.unit().is_dimensionless();
    if (one_in(2)) scene_.spring("spring", first, quantity(angle ? "N m" : "N/m"));
    const std::string tip = std::to_string(frames_.size() - 1);
    if (one_in(2)) {
      const Expression rest = quantity("m");
      scene_.spring(
          "tie", {.a = scene_.point("P0"), .b = scene_.point("P" + tip), .stiffness = quantity("N/m"), .rest = rest});
    }
    if (one_in(2)) scene_.gravitation("attraction", scene_.point("Q0"), scene_.point("P" + tip), quantity("N m^2"));
    const Expression last = unknowns_.back();
    const Expression scale = last.unit().is_dimensionless() ? Expression(1) : Expression::quantity("1", "m");
    if (one_in(2)) scene_.force_function("field", quantity("J") * sin(2 * last / scale));
  }

  void attach(const std::string& name, const FrameHandle& frame) {
    const Expression mass = scene_.parameter("m_" + name, "kg", fraction());
    scene_.body(name, frame, inertia(mass));
  }

  void release() {
    if (!one_in(2)) return;
    const FrameHandle parent = frames_.back();
    const bool angle = one_in(2);
    const char* unit = angle ? "rad" : "m";
    const Expression held = options_.held ? scene_.coordinate("held", unit) : scene_.released_coordinate("held", unit);
    if (options_.held) scene_.holonomic("hold", held);
    const FrameHandle frame = angle ? scene_.revolute("released", parent, axis(), held, placement())
                                    : scene_.prismatic("released", parent, axis(), held, placement());
    attach("released", frame);
    frames_.push_back(frame);
  }

  void add_points() {
    for (std::size_t k = 0; k < frames_.size(); ++k) {
      scene_.point("P" + std::to_string(k), frames_[k], vector("m"));
      scene_.point("Q" + std::to_string(k), frames_[k], vector("m"));
    }
  }

  std::string random_point(char family) { return family + std::to_string(below(static_cast<int>(frames_.size()))); }

  void add_actions() {
    const Expression first = unknowns_[0];
    const bool angle = first.unit().is_dimensionless();
    if (one_in(2)) scene_.spring("spring", first, quantity(angle ? "N m" : "N/m"));
    if (one_in(2))
      scene_.damper("damper", unknowns_.back(),
                    quantity(unknowns_.back().unit().is_dimensionless() ? "N m s" : "N s/m"));
    const std::string tip = std::to_string(frames_.size() - 1);
    if (one_in(2)) {
      const Expression rest = quantity("m");
      scene_.spring(
          "tie", {.a = scene_.point("P0"), .b = scene_.point("P" + tip), .stiffness = quantity("N/m"), .rest = rest});
    }
    if (one_in(3))
      scene_.spring("zero_tie", {.a = scene_.point("Q0"), .b = scene_.point("Q" + tip), .stiffness = quantity("N/m")});
    if (one_in(3)) scene_.damper("brake", scene_.point("Q0"), scene_.point("P" + tip), quantity("N s/m"));
    if (one_in(2))
      scene_.force(
          "push",
          {.body = frames_.back(), .point = PointReference("P" + tip), .components = vector("N"), .axes = frames_[0]});
    if (one_in(3)) scene_.torque("twist", frames_[1], vector("N m"), frames_.back());
  }

  void add_motors() {
    for (std::size_t k = 0; k < unknowns_.size(); ++k) {
      const bool wanted = options_.motors || one_in(3);
      if (wanted) scene_.motor("u" + std::to_string(k), unknowns_[k]);
    }
  }

  void add_constraints() {
    if (unknowns_.size() < (options_.joints ? 2U : 3U)) return;
    // Dimensionless combinations of the unknowns, independent of one another.
    const auto scaled = [&](std::size_t k) {
      const Expression q = unknowns_[k];
      return q.unit().is_dimensionless() ? q : q / Expression::quantity("1", "m");
    };
    if (one_in(2)) {
      const Expression tied = sin(scaled(0)) + Expression(fraction()) * scaled(1);
      scene_.holonomic("tied", options_.conservative ? tied : tied - quantity("rad/s") * scene_.time());
    }
    if (unknowns_.size() < 3) return;
    if (one_in(3)) {
      const Expression rolling = rate(scaled(2)) - cos(scaled(0)) * rate(scaled(1)) / 3;
      scene_.nonholonomic("rolling", options_.conservative ? rolling : rolling - quantity("rad/s"));
      return;
    }
    const std::string tip = std::to_string(frames_.size() - 1);
    const bool loop = one_in(2);
    Scene constrained = scene_;
    if (loop) {
      constrained.closure("loop", constrained.point("P0"), constrained.point("P" + tip), {1, 0, 2});
    } else {
      constrained.no_slip(
          "rolling",
          {.body = frames_.back(), .contact = constrained.point("P" + tip), .direction = axis::x, .axes = frames_[0]});
    }
    // The direction may be one in which the tip never moves, or cannot move for a loop: then there is nothing to
    // constrain.
    try {
      const Equations equations(constrained);
      equations.constraints();
      if (options_.chains) equations.redundancy();
      scene_ = constrained;
    } catch (const SceneError&) {
    }
  }

  void add_formulas() {
    const Expression last = unknowns_.back();
    const bool angle = last.unit().is_dimensionless();
    const Expression scale = angle ? Expression(1) : Expression::quantity("1", "m");
    if (one_in(4)) scene_.force_function("field", quantity("J") * sin(2 * last / scale));
    if (one_in(4)) {
      const Expression speed = rate(last) / scale;
      scene_.generalised_force("cubic_damper", last, -quantity("J s^3") * speed * speed * speed / scale);
    }
  }

  void add_mutual_actions() {
    const FrameHandle body = frames_.back();
    const std::string tip = std::to_string(frames_.size() - 1);
    const FrameHandle other = frames_[static_cast<std::size_t>(below(static_cast<int>(frames_.size()) - 1))];
    if (one_in(4)) scene_.gravitation("attraction", scene_.point("P0"), scene_.point("Q" + tip), quantity("N m^2"));
    if (one_in(4))
      scene_.wrench("wrench", {.body = body,
                               .point = PointReference("Q" + tip),
                               .force = vector("N"),
                               .moment = vector("N m"),
                               .axes = frames_[1]});
    if (one_in(4))
      scene_.drag(
          "drag",
          {.body = body, .point = PointReference("P" + tip), .coefficient = quantity("N s/m"), .relative_to = other});
    if (one_in(4)) scene_.rotational_drag("turning_drag", body, quantity("N m s"), other);
    if (one_in(4))
      scene_.force_between(
          "mutual_force",
          {.a = body, .b = other, .point = PointReference("P" + tip), .components = vector("N"), .axes = other});
    if (one_in(4))
      scene_.torque_between("mutual_torque", {.a = body, .b = other, .components = vector("N m"), .axes = frames_[0]});
  }

  void add_friction() {
    const auto& constraints = scene_.content().constraints;
    const bool wanted = one_in(2);
    for (std::size_t j = 0; wanted && j < constraints.size(); ++j) {
      if (!(constraints[j].multiplier->unit == units::newton) || constraints[j].name == "hold") continue;
      // The normal force of a joint that repeats another is indeterminate.
      if (constraints[j].name.starts_with("planar") || constraints[j].name.starts_with("hinged")) continue;
      const std::string tip = std::to_string(frames_.size() - 1);
      const ConstraintHandle normal{static_cast<int>(j)};
      scene_.sliding_friction("friction", normal,
                              {.coefficient = Expression(fraction()) / 10,
                               .body = frames_.back(),
                               .point = PointReference("Q" + tip),
                               .direction = axis(),
                               .axes = frames_[0]});
      scene_.rolling_resistance(
          "resistance", normal,
          {.length = quantity("m") / 10, .body = frames_.back(), .direction = axis(), .axes = frames_.back()});
      return;
    }
  }

  RandomMechanismOptions options_;
  Scene scene_;
  Expression gravity_;
  std::vector<FrameHandle> frames_;
  std::vector<Expression> angles_, lengths_, unknowns_;
};

}  // namespace

std::string call_of(unsigned seed, const RandomMechanismOptions& options) {
  std::string text = "random_mechanism(" + std::to_string(seed) + ", {";
  for (const auto& [name, value] : random_mechanism_switches) {
    text += std::string(".") + name + (options.*value ? " = true, " : " = false, ");
  }
  return text + ".most_bodies = " + std::to_string(options.most_bodies) + "})";
}

Scene random_mechanism(unsigned seed, const RandomMechanismOptions& options) { return Builder(seed, options).build(); }

}  // namespace torsor::testing_mechanisms
