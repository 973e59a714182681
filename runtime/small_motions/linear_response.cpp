// SPDX-License-Identifier: MIT
#include "torsor/runtime/small_motions/linear_response.hpp"

#include <stdexcept>
#include <string>

#include "torsor/runtime/numerics/matrix_exponential.hpp"

namespace torsor::runtime {

LinearResponse::LinearResponse(const LinearSystem& system, const Eigen::VectorXd& x0, const Eigen::VectorXd& v0,
                               const HarmonicForce& force)
    : normal_(normalised(system)), generator_(2 * system.size() + 3, 2 * system.size() + 3) {
  const Eigen::Index n = system.size();
  const Eigen::VectorXd nothing = Eigen::VectorXd::Zero(n);
  const auto shaped = [n, &nothing](const Eigen::VectorXd& vector, const char* what) -> const Eigen::VectorXd& {
    if (vector.size() == 0) return nothing;
    if (vector.size() != n) {
      throw std::invalid_argument(std::string(what) + " has " + std::to_string(vector.size()) + " entries for " +
                                  std::to_string(n) + " coordinates");
    }
    return vector;
  };
  Eigen::VectorXd constant = shaped(force.constant, "the constant force");
  if (system.F.size() > 0) constant += shaped(system.F, "the force of the system");
  Eigen::MatrixXd forces(n, 3);
  forces.col(0) = normal_.force(constant);
  forces.col(1) = normal_.force(shaped(force.cosine, "the force along the cosine"));
  forces.col(2) = normal_.force(shaped(force.sine, "the force along the sine"));
  // The last three unknowns carry the size of the force, so that all entries of the matrix are of the size of 1.
  double size = forces.cwiseAbs().maxCoeff();
  if (size == 0.0) size = 1.0;
  generator_.setZero();
  generator_.block(0, n, n, n).setIdentity();
  generator_.block(n, 0, n, n) = -normal_.S;
  generator_.block(n, n, n, n) = -normal_.D;
  generator_.block(n, 2 * n, n, 3) = forces / size;
  generator_(2 * n + 1, 2 * n + 2) = -force.angular_frequency / normal_.sigma;
  generator_(2 * n + 2, 2 * n + 1) = force.angular_frequency / normal_.sigma;
  start_ = Eigen::VectorXd::Zero(2 * n + 3);
  start_.head(n) = normal_.L.transpose() * shaped(x0, "the initial position");
  start_.segment(n, n) = normal_.L.transpose() * shaped(v0, "the initial velocity") / normal_.sigma;
  start_(2 * n) = size;
  start_(2 * n + 1) = size;
}

LinearResponse::Motion LinearResponse::at(double t) const {
  const Eigen::Index n = normal_.L.rows();
  const Eigen::VectorXd z = matrix_exponential(generator_ * (normal_.sigma * t)) * start_;
  const Eigen::MatrixXd x = normal_.coordinates(Eigen::MatrixXd(z.head(n)));
  const Eigen::MatrixXd v = normal_.coordinates(Eigen::MatrixXd(z.segment(n, n)));
  return {x, v * normal_.sigma};
}

}  // namespace torsor::runtime
