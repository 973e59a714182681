// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/kernels/kernel_frames.hpp"

#include <fmt/format.h>

#include "torsor/generator/dynamics/motion/ground_drift.hpp"
#include "torsor/generator/kernels/kernel_parts.hpp"
#include "torsor/generator/program/derivative.hpp"

namespace torsor {
namespace {

/// A point of the scene on its link.
struct OperationalFrame {
  std::string name;
  int link = 0;
  Matrix rotation;  ///< of its frame to the ground's axes
  Vector place;     ///< from the link's origin, in the link's axes
  Vector arm;       ///< the same in the ground's
};

std::vector<OperationalFrame> operational_frames(const Model& model, const GroundMotion& motion) {
  Program& program = model.program();
  std::vector<OperationalFrame> all;
  for (std::size_t k = 0; k < model.scene().points.size(); ++k) {
    const PointContent& point = model.scene().points[k];
    const std::string user = name_of(point);
    const FramePlace& at = model.place(point.frame, user);
    const Matrix& turn = motion.rotation(at.link);
    const Vector place = bound(program, model.locate(PointHandle{static_cast<int>(k)}, at.link, user));
    all.push_back({point.name, at.link, bound(program, turn * constant_matrix(program, at.rotation)), place,
                   bound(program, turn * place)});
  }
  return all;
}

/// dV/dt of the velocity V of whatever is at the point: the acceleration of the link there, and Ω ∧ d(place)/dt because at
/// the next instant another of its points is there.
Vector drift_of_velocity(Program& program, const GroundMotion& motion, const GroundDrift& drift, const OperationalFrame& frame) {
  const Vector shift = bound(program, motion.rotation(frame.link) * bound(program, time_derivative(frame.place)));
  return bound(program, drift.linear(frame.link, frame.arm) + cross(motion.angular(frame.link), shift));
}

/// Six rows, linear before angular, for each unknown.
ValueMatrix jacobian(const GroundMotion& motion, const OperationalFrame& frame, std::size_t n) {
  const std::vector<Vector> linear = motion.partial_velocities(frame.link, frame.arm);
  const std::vector<Vector> angular = motion.partial_angular_velocities(frame.link);
  ValueMatrix rows(6, std::vector<Value>(n));
  for (int i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      rows[static_cast<std::size_t>(i)][j] = linear[j][i];
      rows[static_cast<std::size_t>(i) + 3][j] = angular[j][i];
    }
  }
  return rows;
}

}  // namespace

Kernel make_frames(const Equations& equations) {
  const Model& model = equations.model();
  const GroundMotion motion(model);
  const GroundDrift drift(model, motion);
  const std::size_t n = unknowns(equations);
  Structure structure{"Frames", "Points with the axes of their frames, in ground axes; of six numbers the first three are\n"
                                "linear, the others angular.", {}};
  Kernel kernel;
  kernel.documentation =
      "Pose, twist, Jacobian J and drift of every named point with the axes of its frame, in ground axes:\n"
      "(V, Omega) = J v + what laws of time drive, (dV/dt, dOmega/dt) = J a + drift.";
  const auto six = [&](const std::string& member, const std::string& text, const Vector& linear, const Vector& angular) {
    structure.members.push_back(vector_member(member, 6, text));
    for (int i = 0; i < 3; ++i) {
      const auto row = static_cast<std::size_t>(i);
      kernel.assignments.push_back({{"result", member, row}, linear[i]});
      kernel.assignments.push_back({{"result", member, row + 3}, angular[i]});
    }
  };
  for (const OperationalFrame& frame : operational_frames(model, motion)) {
    const Vector position = bound(model.program(), motion.origin(frame.link) + frame.arm);
    structure.members.push_back(vector_member(frame.name + "_position", 3, {"position of " + frame.name, "m"}));
    structure.members.push_back(
        matrix_member(frame.name + "_rotation", 3, 3, "from the axes of its frame to the ground's, column by column"));
    for (int j = 0; j < 3; ++j) {
      kernel.assignments.push_back({{"result", frame.name + "_position", static_cast<std::size_t>(j)}, position[j]});
      for (int i = 0; i < 3; ++i) {
        kernel.assignments.push_back(
            {{"result", frame.name + "_rotation", static_cast<std::size_t>(3 * j + i)}, frame.rotation(i, j)});
      }
    }
    six(frame.name + "_twist", "velocity of the material point there [m/s], angular velocity [rad/s]",
        motion.velocity(frame.link, frame.place), motion.angular(frame.link));
    six(frame.name + "_drift", "the same of accelerations while v does not change, dJ/dt v [m/s^2], [rad/s^2]",
        drift_of_velocity(model.program(), motion, drift, frame), drift.angular(frame.link));
    structure.members.push_back(matrix_member(frame.name + "_jacobian", 6, n, "J of the twist, column by column"));
    const ValueMatrix rows = jacobian(motion, frame, n);
    for (std::size_t j = 0; j < n; ++j) {
      for (std::size_t i = 0; i < 6; ++i) {
        kernel.assignments.push_back({{"result", frame.name + "_jacobian", 6 * j + i}, rows[i][j]});
      }
    }
  }
  kernel.structures = {structure};
  kernel.results = {{"Frames", "result"}};
  return kernel;
}

Kernel make_operational_inertia(const Equations& equations) {
  const Model& model = equations.model();
  const GroundMotion motion(model);
  const std::size_t n = unknowns(equations);
  const std::vector<Value> at_rest(equations.constraints().size());
  Kernel kernel;
  kernel.documentation =
      "J M^-1 J' of every named point: the change of its twist (V, Omega) for an impulse (force, moment) there, in ground\n"
      "axes. Its inverse is the operational-space inertia, where J has rank six. Returns singular when a pivot is not\n"
      "positive relative to its diagonal entry.";
  Structure structure{"OperationalInertia", "Inverse operational-space inertia; linear before angular, in ground axes.", {}};
  for (const OperationalFrame& frame : operational_frames(model, motion)) {
    const std::string member = frame.name + "_inverse_inertia";
    structure.members.push_back(
        matrix_member(member, 6, 6, "at " + frame.name + ", symmetric [1/kg], [1/(kg m)], [1/(kg m^2)]"));
    const ValueMatrix rows = jacobian(motion, frame, n);
    for (std::size_t s = 0; s < 6; ++s) {
      const ForwardSolution answer = equations.solve(rows[s], at_rest);
      if (kernel.pivots.empty()) kernel.pivots = answer.pivots;
      for (std::size_t r = s; r < 6; ++r) {
        Value sum;
        for (std::size_t j = 0; j < n; ++j) sum += rows[r][j] * answer.accelerations[j];
        sum = model.program().bind(sum);
        kernel.assignments.push_back({{"result", member, 6 * s + r}, sum});
        if (r != s) kernel.assignments.push_back({{"result", member, 6 * r + s}, sum});
      }
    }
  }
  kernel.structures = {structure};
  kernel.results = {{"OperationalInertia", "result"}};
  return kernel;
}

std::string no_points(const Equations& equations) {
  return equations.model().scene().points.empty() ? "the scene has no named point (point, or --points)" : "";
}

std::string no_operational_inertia(const Equations& equations) {
  if (!equations.scene().content().frictions.empty()) {
    return "friction in proportion to a reaction: what an impulse changes is then not symmetric";
  }
  return no_points(equations);
}

}  // namespace torsor
