// SPDX-License-Identifier: MIT
#pragma once
#include <Eigen/Core>

#include "torsor/runtime/small_motions/linear_system.hpp"

namespace torsor::runtime {

/// F(t) = constant + cosine cos(ω t) + sine sin(ω t), each vector along the coordinates; an empty one is zero. A
/// constant alone is a step at t = 0.
struct HarmonicForce {
  Eigen::VectorXd constant{}, cosine{}, sine{};
  double angular_frequency = 0.0;  ///< ω [rad/s]
};

/// The motion M x'' + C x' + K x = F(t) from x(0), x'(0) in closed form, for any damping, with free motions (singular
/// K) and at resonance alike: (x, x', 1, cos, sin) is the exponential of one constant matrix times its start. The
/// system's own F counts with the force. Throws std::invalid_argument where shapes do not fit.
///   const LinearResponse response(system, x0, v0, {.constant = gust});
///   const auto [x, v] = response.at(2.0);
class LinearResponse {
 public:
  struct Motion {
    Eigen::VectorXd x, v;
  };

  LinearResponse(const LinearSystem& system, const Eigen::VectorXd& x0, const Eigen::VectorXd& v0,
                 const HarmonicForce& force = {});

  /// Position and velocity at a time counted from the start.
  [[nodiscard]] Motion at(double t) const;

 private:
  NormalisedSystem normal_;
  Eigen::MatrixXd generator_;
  Eigen::VectorXd start_;
};

}  // namespace torsor::runtime
