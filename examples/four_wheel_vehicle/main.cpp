// SPDX-License-Identifier: MIT
#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <iostream>
#include <numbers>
#include <string>

#include "generated/four_wheel_vehicle.hpp"
#include "generated/four_wheel_vehicle_all_wheels.hpp"
#include "torsor/runtime/integration/demonstration.hpp"
#include "torsor/runtime/integration/work_precision.hpp"
#include "torsor/runtime/mechanism.hpp"
#include "torsor/runtime/numerics/decompositions.hpp"

namespace {

using namespace torsor::runtime;
using Vehicle = four_wheel_vehicle::Mechanism<double>;
using AllWheels = four_wheel_vehicle_all_wheels::Mechanism<double>;

/// The eight conditions of no slip for one steering: their rank, and the motion they leave.
void add_steering(Table& table, const std::string& name, const std::array<double, 4>& degrees) {
  AllWheels::Parameters parameters{};
  for (int i = 0; i < 4; ++i) parameters[i] = degrees[static_cast<std::size_t>(i)] * std::numbers::pi / 180.0;
  AllWheels::Constraints conditions{};
  AllWheels::constraints(AllWheels::precompute(parameters), {}, conditions);
  // Column by column, those of the wheels' sliding last: none slides.
  const Eigen::Map<const Eigen::Matrix<double, 8, 7>> rows(conditions.jacobian.data());
  const SingularValues svd = singular_values(rows);
  const auto smallest = svd.values[6];
  std::string motion = "none";
  if (smallest < 1e-12) {
    const Eigen::VectorXd left = svd.right.col(6);  // x', y', psi', phi_i'
    motion = std::abs(left[2]) < 1e-12
                 ? "translation"
                 : "turns about (" + scientific(-left[1] / left[2]) + ", " + scientific(left[0] / left[2]) + ") m";
  }
  std::string angles;
  for (const double angle : degrees) angles += (angles.empty() ? "" : ", ") + std::to_string(std::lround(angle));
  table.add({name, angles, scientific(smallest, 1), smallest < 1e-12 ? "6" : "7", motion});
}

void show(const Reference<double>& reference) {
  const auto motion = equations_of_motion<Vehicle>();
  std::cout << "A vehicle rolls round a corner and slows down\n\n"
            << work_precision(motion, reference, Midpoint{.step = 1e-3}, RungeKutta4{.step = 1e-2},
                              DormandPrince54{.relative_tolerance = 1e-9, .absolute_tolerance = 1e-9},
                              DormandPrince54{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12});
  Table steering({"axes of the wheels", "alpha 1, 2, 3, 4 [deg]", "7th singular value", "rank", "motion"});
  add_steering(steering, "meet", {-45, -30, 0, 0});
  add_steering(steering, "parallel", {20, 20, 20, 20});
  add_steering(steering, "front pair parallel, turned", {-45, -45, 0, 0});
  add_steering(steering, "three of them meet", {-45, -31, 0, 0});
  std::cout << "\nWhich steering lets all four wheels roll\n\n" << steering;

  const auto state = Vehicle::initial_state();
  Vehicle::Kinematics at{};
  Vehicle::kinematics(motion.precomputed(), state, at);
  Table slip({"s from P1 along the generatrix [m]", "slip of wheel 1 [m/s]"});
  for (const double s : {-0.05, 0.0, 0.05}) {
    const auto& V = at.wheel_1_velocity;
    const auto& omega = at.wheel_1_angular_velocity;
    const double angle = state.q.psi - std::numbers::pi / 4.0;
    const double arm[] = {s * std::cos(angle), s * std::sin(angle), -0.3};
    const double x = V[0] + omega[1] * arm[2] - omega[2] * arm[1], y = V[1] + omega[2] * arm[0] - omega[0] * arm[2];
    slip.add({scientific(s), scientific(std::hypot(x, y))});
  }
  std::cout << "\nNo slip at P1, and yet beside it, the vehicle turning at 1 rad/s\n\n" << slip;
}

}  // namespace

int main(int argc, char** argv) {
  return demonstrate(argc, argv,
                     {.name = "four_wheel_vehicle", .about = "which steering lets four wheels roll without slipping"},
                     show);
}
