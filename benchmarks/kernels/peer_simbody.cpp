// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include <SimTKsimbody.h>

#include "benchmarks/kernels/peers.hpp"

namespace kernels {
namespace {

std::string version() {
  int major = 0, minor = 0, build = 0;
  SimTK_version_SimTKcommon(&major, &minor, &build);
  return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(build);
}

SimTK::Vec3 vec3(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

/// A pin turns about the third axis of its frames: this brings the joint's axis there.
SimTK::Rotation to_axis(int axis) {
  using SimTK::Mat33;
  if (axis == 0) return SimTK::Rotation(Mat33(0, 0, 1, 1, 0, 0, 0, 1, 0), true);
  if (axis == 1) return SimTK::Rotation(Mat33(0, 1, 0, 0, 0, 1, 1, 0, 0), true);
  return {};
}

class Simbody {
 public:
  Simbody(const Chain& chain, const Batch& batch) : batch_(batch), n_(static_cast<int>(batch.freedoms)) {
    SimTK::MobilizedBody parent = matter_.Ground();
    for (const Joint& joint : chain.joints) {
      const auto& r = joint.rotation;
      const auto& i = joint.inertia;
      const SimTK::Rotation turn(SimTK::Mat33(r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8]), true);
      const SimTK::Rotation axis = to_axis(joint.axis);
      const SimTK::Inertia central(i[0], i[3], i[5], i[1], i[2], i[4]);
      const SimTK::Vec3 centre = vec3(joint.mass_centre);
      const SimTK::MassProperties mass(joint.mass, centre, central.shiftFromMassCenter(centre, joint.mass));
      parent = SimTK::MobilizedBody::Pin(parent, SimTK::Transform(turn * axis, vec3(joint.origin)),
                                         SimTK::Body::Rigid(mass), SimTK::Transform(axis));
    }
    gravity_ = SimTK::Force::Gravity(forces_, matter_, vec3(chain.gravity));
    state_ = system_.realizeTopology();
    system_.realizeModel(state_);
    given_.resize(n_);
    numbers_.resize(n_);
  }

  void inverse_dynamics(std::size_t k) {
    move_to(k);
    copy(batch_.a, k, given_);
    matter_.calcResidualForceIgnoringConstraints(state_, none_, gravity_.getBodyForces(state_), given_, numbers_);
  }
  void mass_matrix(std::size_t k) {
    copy(batch_.q, k, state_.updQ());
    system_.realize(state_, SimTK::Stage::Position);
    matter_.calcM(state_, mass_);
  }
  void forward_dynamics(std::size_t k) {
    move_to(k);
    system_.realize(state_, SimTK::Stage::Dynamics);
    copy(batch_.tau, k, given_);
    matter_.calcAccelerationIgnoringConstraints(state_, given_, gravity_.getBodyForces(state_), numbers_, spatial_);
  }

  std::vector<double> result(Quantity quantity) const {
    std::vector<double> numbers;
    for (int i = 0; i < n_; ++i) {
      if (quantity != Quantity::mass_matrix) numbers.push_back(numbers_[i]);
      for (int j = 0; j < n_ && quantity == Quantity::mass_matrix; ++j) numbers.push_back(mass_(j, i));
    }
    return numbers;
  }

 private:
  void copy(const std::vector<double>& list, std::size_t k, SimTK::Vector& to) const {
    const double* from = batch_.of(list, k);
    for (int i = 0; i < n_; ++i) to[i] = from[i];
  }
  void move_to(std::size_t k) {
    copy(batch_.q, k, state_.updQ());
    copy(batch_.v, k, state_.updU());
    system_.realize(state_, SimTK::Stage::Velocity);
  }

  const Batch& batch_;
  int n_;
  SimTK::MultibodySystem system_;
  SimTK::SimbodyMatterSubsystem matter_{system_};
  SimTK::GeneralForceSubsystem forces_{system_};
  SimTK::Force::Gravity gravity_;
  SimTK::State state_;
  SimTK::Vector none_, given_, numbers_;
  SimTK::Matrix mass_;
  SimTK::Vector_<SimTK::SpatialVec> spatial_;
};

}  // namespace

Way simbody_way(const Chain& chain, Quantity quantity, const Batch& batch) {
  const auto simbody = std::make_shared<Simbody>(chain, batch);
  const auto loop = [simbody](auto kernel) {
    return [simbody, kernel](std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k) (simbody.get()->*kernel)(k);
    };
  };
  Way way{"Simbody", version(), "double", "", {}, [simbody, quantity] { return simbody->result(quantity); }};
  switch (quantity) {
    case Quantity::inverse_dynamics:
      way.functions = "realize(Velocity), Gravity::getBodyForces, calcResidualForceIgnoringConstraints";
      way.run = loop(&Simbody::inverse_dynamics);
      break;
    case Quantity::mass_matrix:
      way.functions = "realize(Position), calcM";
      way.run = loop(&Simbody::mass_matrix);
      break;
    case Quantity::forward_dynamics:
      way.functions = "realize(Dynamics), Gravity::getBodyForces, calcAccelerationIgnoringConstraints";
      way.run = loop(&Simbody::forward_dynamics);
      break;
  }
  return way;
}

}  // namespace kernels
