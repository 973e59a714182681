// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <stdexcept>

#include <kdl/config.h>
#include <kdl/chain.hpp>
#include <kdl/chaindynparam.hpp>
#include <kdl/chainfdsolver_recursive_newton_euler.hpp>
#include <kdl/chainidsolver_recursive_newton_euler.hpp>

#include "benchmarks/kernels/peers.hpp"

namespace kernels {
namespace {

/// As KDL's reader of URDF files makes it: joints with their axes in the parent's, inertias in the link's.
KDL::Chain made(const Chain& chain) {
  KDL::Chain result;
  for (const Joint& joint : chain.joints) {
    const auto& r = joint.rotation;
    const auto& i = joint.inertia;
    const KDL::Frame frame(KDL::Rotation(r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8]),
                           KDL::Vector(joint.origin[0], joint.origin[1], joint.origin[2]));
    KDL::Vector axis = KDL::Vector::Zero();
    axis(joint.axis) = 1;
    const KDL::RigidBodyInertia inertia(joint.mass,
                                        KDL::Vector(joint.mass_centre[0], joint.mass_centre[1], joint.mass_centre[2]),
                                        KDL::RotationalInertia(i[0], i[3], i[5], i[1], i[2], i[4]));
    result.addSegment(KDL::Segment(KDL::Joint(frame.p, frame.M * axis, KDL::Joint::RotAxis), frame, inertia));
  }
  return result;
}

class Kdl {
 public:
  Kdl(const Chain& chain, const Batch& batch) : chain_(made(chain)), gravity_(vector(chain.gravity)) {
    const auto fill = [&](std::vector<KDL::JntArray>& arrays, const std::vector<double>& list) {
      for (std::size_t k = 0; k < batch.states; ++k) {
        KDL::JntArray array(static_cast<unsigned int>(batch.freedoms));
        for (std::size_t i = 0; i < batch.freedoms; ++i) array(static_cast<unsigned int>(i)) = batch.of(list, k)[i];
        arrays.push_back(array);
      }
    };
    fill(q_, batch.q);
    fill(v_, batch.v);
    fill(a_, batch.a);
    fill(tau_, batch.tau);
  }

  void inverse_dynamics(std::size_t k) { check(inverse_.CartToJnt(q_[k], v_[k], a_[k], no_forces_, numbers_)); }
  void mass_matrix(std::size_t k) { check(parameters_.JntToMass(q_[k], mass_)); }
  void forward_dynamics(std::size_t k) { check(forward_.CartToJnt(q_[k], v_[k], tau_[k], no_forces_, numbers_)); }

  std::vector<double> result(Quantity quantity) const {
    if (failed_) throw std::runtime_error("a solver of KDL failed");
    const double* first = quantity == Quantity::mass_matrix ? mass_.data.data() : numbers_.data.data();
    const auto size = quantity == Quantity::mass_matrix ? mass_.data.size() : numbers_.data.size();
    return {first, first + size};
  }

 private:
  static KDL::Vector vector(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }
  void check(int status) { failed_ = failed_ || status < 0; }

  KDL::Chain chain_;
  KDL::Vector gravity_;
  unsigned int n_ = chain_.getNrOfJoints();
  std::vector<KDL::JntArray> q_, v_, a_, tau_;
  KDL::Wrenches no_forces_ = KDL::Wrenches(n_, KDL::Wrench::Zero());
  KDL::ChainIdSolver_RNE inverse_{chain_, gravity_};
  KDL::ChainDynParam parameters_{chain_, gravity_};
  KDL::ChainFdSolver_RNE forward_{chain_, gravity_};
  KDL::JntArray numbers_{n_};
  KDL::JntSpaceInertiaMatrix mass_{static_cast<int>(n_)};
  bool failed_ = false;
};

}  // namespace

Way kdl_way(const Chain& chain, Quantity quantity, const Batch& batch) {
  const auto kdl = std::make_shared<Kdl>(chain, batch);
  const auto loop = [kdl](auto kernel) {
    return [kdl, kernel](std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k) (kdl.get()->*kernel)(k);
    };
  };
  Way way{"KDL", KDL_VERSION_STRING, "double", "", {}, [kdl, quantity] { return kdl->result(quantity); }};
  switch (quantity) {
    case Quantity::inverse_dynamics:
      way.functions = "ChainIdSolver_RNE::CartToJnt";
      way.run = loop(&Kdl::inverse_dynamics);
      break;
    case Quantity::mass_matrix:
      way.functions = "ChainDynParam::JntToMass";
      way.run = loop(&Kdl::mass_matrix);
      break;
    case Quantity::forward_dynamics:
      way.functions = "ChainFdSolver_RNE::CartToJnt";
      way.run = loop(&Kdl::forward_dynamics);
      break;
  }
  return way;
}

}  // namespace kernels
