// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/kernels/kernel_kinematics.hpp"

#include <fmt/format.h>

#include "torsor/generator/dynamics/motion/ground_motion.hpp"
#include "torsor/generator/kernels/kernel_parts.hpp"

namespace torsor {
namespace {

/// Fills the structure `Kinematics` member by member.
class KinematicsBuilder {
 public:
  explicit KinematicsBuilder(const Equations& equations)
      : model_(equations.model()), program_(model_.program()), motion_(model_) {}

  void body(const BodyContent& body) {
    const FramePlace& at = model_.place(body.frame, "body '" + body.name + "'");
    const Vector center = bound(program_, at.origin + at.rotation * lower(program_, body.inertia.center));
    const Matrix& turn = motion_.rotation(at.link);
    const Vector arm = bound(program_, turn * center);
    add_vector(body.name + "_position", {"centre of mass of " + body.name, "m"},
               bound(program_, motion_.origin(at.link) + arm));
    add_rotation(body.name + "_rotation", "from the axes of " + body.name + " to the ground's",
                 bound(program_, turn * constant_matrix(program_, at.rotation)));
    add_vector(body.name + "_velocity", {"velocity of the centre of mass of " + body.name, "m/s"},
               motion_.velocity(at.link, center));
    add_vector(body.name + "_angular_velocity", {"angular velocity of " + body.name, "rad/s"},
               motion_.angular(at.link));
  }

  void point(const PointContent& point, int index) {
    const std::string user = name_of(point);
    const int link = model_.place(point.frame, user).link;
    const Vector place = bound(program_, model_.locate(PointHandle{index}, link, user));
    const Matrix& turn = motion_.rotation(link);
    const Vector arm = bound(program_, turn * place);
    const Vector carried = motion_.velocity(link, place);
    add_vector(point.name + "_position", {"position of " + point.name, "m"},
               bound(program_, motion_.origin(link) + arm));
    add_vector(point.name + "_velocity", {"velocity of the material point at " + point.name, "m/s"}, carried);
    const Vector moved = time_derivative(place);
    if (!moved.is_zero()) {
      const Vector there = bound(program_, turn * bound(program_, moved));
      add_vector(point.name + "_geometric_velocity",
                 {"velocity of the point " + point.name + " itself, which moves in its frame", "m/s"},
                 bound(program_, carried + there));
    }
    const auto n = static_cast<std::size_t>(model_.unknown_count());
    const std::string member = point.name + "_jacobian";
    result_.member(member, 3, n, "partial velocities of " + point.name);
    const std::vector<Vector> columns = motion_.partial_velocities(link, arm);
    for (int i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < n; ++j) result_.assign(member, 3 * j + static_cast<std::size_t>(i), columns[j][i]);
    }
  }

  Kernel take() {
    return result_.take(
        "Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;\n"
        "matrices column by column.");
  }

 private:
  void add_vector(const std::string& name, const Meaning& meaning, const Vector& v) {
    result_.member(name, 3, meaning);
    result_.vector(name, 0, v);
  }

  void add_rotation(const std::string& name, const std::string& text, const Matrix& m) {
    result_.member(name, 3, 3, text);
    result_.matrix(name, 0, m);
  }

  const Model& model_;
  Program& program_;
  GroundMotion motion_;
  StructureBuilder result_{"Kinematics", "Poses, twists and named points in ground axes."};
};

}  // namespace

Kernel make_kinematics(const Equations& equations) {
  KinematicsBuilder builder(equations);
  const SceneContent& scene = equations.model().scene();
  for (const BodyContent& body : scene.bodies) builder.body(body);
  for (std::size_t i = 0; i < scene.points.size(); ++i) builder.point(scene.points[i], static_cast<int>(i));
  return builder.take();
}

bool has_quaternions(const Model& model) {
  return model.positions().size() != static_cast<std::size_t>(model.unknown_count());
}

Kernel make_coordinate_rates(const Equations& equations) {
  const std::vector<SymbolPointer> positions = equations.model().positions();
  Kernel kernel;
  kernel.name = "coordinate_rates";
  kernel.documentation =
      "dq/dt from v: the velocity itself for a coordinate, 1/2 e (0, omega) for a unit quaternion e with the angular\n"
      "velocity omega in moving axes.";
  kernel.results = {{"", "rates", positions.size()}};
  for (std::size_t i = 0; i < positions.size(); ++i) {
    kernel.assignments.push_back({Target{"rates"}[i], rate_of(equations.program(), positions[i])});
  }
  return kernel;
}

}  // namespace torsor
