// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <memory>
#include <stdexcept>

#include <mujoco/mujoco.h>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "benchmarks/kernels/peers.hpp"

namespace kernels {
namespace {

class Mujoco {
 public:
  Mujoco(const std::string& path, const Chain& chain, const Batch& batch) : batch_(batch), numbers_(batch.freedoms) {
    std::array<char, 1000> error{};
    model_.reset(mj_loadXML(path.c_str(), nullptr, error.data(), static_cast<int>(error.size())));
    if (!model_) throw std::runtime_error("MuJoCo cannot read '" + path + "': " + error.data());
    if (static_cast<std::size_t>(model_->nv) != batch.freedoms) {
      throw std::runtime_error("'" + path + "' has another number of joints than the chain");
    }
    for (std::size_t i = 0; i < chain.joints.size(); ++i) take_principal_axes(chain.joints[i], static_cast<int>(i) + 1);
    data_.reset(mj_makeData(model_.get()));
  }

  void inverse_dynamics(std::size_t k) {
    copy(batch_.q, k, data_->qpos);
    copy(batch_.v, k, data_->qvel);
    copy(batch_.a, k, data_->qacc);
    mj_kinematics(model_.get(), data_.get());
    mj_comPos(model_.get(), data_.get());
    mj_comVel(model_.get(), data_.get());
    mj_rne(model_.get(), data_.get(), 1, numbers_.data());
  }

  /// To the sparse form in which MuJoCo itself uses it.
  void mass_matrix(std::size_t k) {
    copy(batch_.q, k, data_->qpos);
    mj_kinematics(model_.get(), data_.get());
    mj_comPos(model_.get(), data_.get());
    mj_crb(model_.get(), data_.get());
  }

  void forward_dynamics(std::size_t k) {
    copy(batch_.v, k, data_->qvel);
    mass_matrix(k);
    mj_factorM(model_.get(), data_.get());
    mj_comVel(model_.get(), data_.get());
    mj_rne(model_.get(), data_.get(), 0, numbers_.data());
    const double* tau = batch_.of(batch_.tau, k);
    for (std::size_t i = 0; i < batch_.freedoms; ++i) numbers_[i] = tau[i] - numbers_[i];
    mj_solveM(model_.get(), data_.get(), data_->qacc, numbers_.data(), 1);
  }

  /// What its users call: both also do what other models need.
  void whole_inverse(std::size_t k) {
    copy(batch_.q, k, data_->qpos);
    copy(batch_.v, k, data_->qvel);
    copy(batch_.a, k, data_->qacc);
    mj_inverse(model_.get(), data_.get());
    std::copy_n(data_->qfrc_inverse, batch_.freedoms, numbers_.data());
  }
  void whole_forward(std::size_t k) {
    copy(batch_.q, k, data_->qpos);
    copy(batch_.v, k, data_->qvel);
    copy(batch_.tau, k, data_->qfrc_applied);
    mj_forward(model_.get(), data_.get());
  }

  std::vector<double> result(Quantity quantity) const {
    if (quantity == Quantity::inverse_dynamics) return numbers_;
    if (quantity == Quantity::forward_dynamics) return {data_->qacc, data_->qacc + batch_.freedoms};
    std::vector<double> dense(batch_.freedoms * batch_.freedoms);
    mj_fullM(model_.get(), dense.data(), data_->qM);
    return dense;
  }

 private:
  struct Delete {
    void operator()(mjModel* model) const { mj_deleteModel(model); }
    void operator()(mjData* data) const { mj_deleteData(data); }
  };
  /// MuJoCo's reader finds principal axes within some 1e-9 only: it gets those of the same tensor to all digits.
  void take_principal_axes(const Joint& joint, int body) {
    if (model_->body_sameframe[body]) return;  // it takes the body's axes for them
    const auto& i = joint.inertia;
    Eigen::Matrix3d tensor;
    tensor << i[0], i[1], i[2], i[1], i[3], i[4], i[2], i[4], i[5];
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(tensor);
    Eigen::Matrix3d axes = principal.eigenvectors();
    if (axes.determinant() < 0) axes.col(0) = -axes.col(0);
    const Eigen::Quaterniond turn(axes);
    const std::array<double, 4> quaternion = {turn.w(), turn.x(), turn.y(), turn.z()};
    std::copy_n(quaternion.data(), 4, model_->body_iquat + 4 * body);
    std::copy_n(principal.eigenvalues().data(), 3, model_->body_inertia + 3 * body);
  }
  void copy(const std::vector<double>& list, std::size_t k, mjtNum* to) const {
    std::copy_n(batch_.of(list, k), batch_.freedoms, to);
  }

  const Batch& batch_;
  std::vector<double> numbers_;
  std::unique_ptr<mjModel, Delete> model_;
  std::unique_ptr<mjData, Delete> data_;
};

}  // namespace

std::vector<Way> mujoco_ways(const std::string& path, const Chain& chain, Quantity quantity, const Batch& batch) {
  const auto mujoco = std::make_shared<Mujoco>(path, chain, batch);
  const auto way = [&](const char* competitor, const char* functions, auto kernel) {
    return Way{competitor,
               mj_versionString(),
               "double",
               functions,
               [mujoco, kernel](std::size_t first, std::size_t last) {
                 for (std::size_t k = first; k < last; ++k) (mujoco.get()->*kernel)(k);
               },
               [mujoco, quantity] { return mujoco->result(quantity); }};
  };
  switch (quantity) {
    case Quantity::inverse_dynamics:
      return {way("MuJoCo", "mj_kinematics, mj_comPos, mj_comVel, mj_rne", &Mujoco::inverse_dynamics),
              way("MuJoCo whole", "mj_inverse", &Mujoco::whole_inverse)};
    case Quantity::mass_matrix:
      return {way("MuJoCo", "mj_kinematics, mj_comPos, mj_crb", &Mujoco::mass_matrix)};
    case Quantity::forward_dynamics:
      return {way("MuJoCo", "mj_kinematics, mj_comPos, mj_crb, mj_factorM, mj_comVel, mj_rne, mj_solveM",
                  &Mujoco::forward_dynamics),
              way("MuJoCo whole", "mj_forward", &Mujoco::whole_forward)};
  }
  return {};
}

}  // namespace kernels
