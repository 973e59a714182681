// SPDX-License-Identifier: GPL-3.0-or-later
// Snippets of the manual that use generated headers and the runtime, in what they take for granted: snippets.mjs puts the n-th
// block of C++ of a page where a line "// snippet: PAGE n" stands.
#include <cstdio>
#include <iostream>
#include <type_traits>
#include <vector>

#include <Eigen/Sparse>

#include "generated/andrews_squeezer.hpp"
#include "generated/billiard.hpp"
#include "generated/double_pendulum.hpp"
#include "generated/rolling_hoop.hpp"
#include "generated/vibration_absorber.hpp"
#include "torsor/runtime/batch/batch.hpp"
#include "torsor/runtime/batch/motion_ensemble.hpp"
#include "torsor/runtime/batch/packed_motion_ensemble.hpp"
#include "torsor/runtime/batch/packed_taylor.hpp"
#include "torsor/runtime/constraints/consistent_state.hpp"
#include "torsor/runtime/contacts/integrate_contacts.hpp"
#include "torsor/runtime/contacts/mechanism_with_contacts.hpp"
#include "torsor/runtime/integration/events.hpp"
#include "torsor/runtime/integration/dormand_prince_54.hpp"
#include "torsor/runtime/integration/runge_kutta_4.hpp"
#include "torsor/runtime/integration/taylor.hpp"
#include "torsor/runtime/mechanism.hpp"
#include "torsor/runtime/numerics/operational_inertia.hpp"
#include "torsor/runtime/small_motions/equilibrium_stability.hpp"
#include "torsor/runtime/small_motions/forced_response.hpp"
#include "torsor/runtime/small_motions/fourier_series.hpp"
#include "torsor/runtime/small_motions/linear_response.hpp"
#include "torsor/runtime/small_motions/modes.hpp"
#include "torsor/runtime/small_motions/steady_states.hpp"
#ifdef TORSOR_WITH_MPI
#include "examples/grains/piles.hpp"
#include "torsor/runtime/mpi/ensemble_mpi.hpp"
#endif

using namespace torsor::runtime;

// snippet: docs/batches.md 1

namespace many_states {
arm7::Mechanism<double>::State state_of(std::size_t i);
void run() {
  // snippet: docs/batches.md 2
  Arms::Arrays<49> masses(states.size());
  // snippet: docs/batches.md 3
}
}  // namespace many_states

namespace ensembles {
using Arm = arm7::Mechanism<double>;
void run(const std::vector<double>& times) {
  // snippet: docs/batches.md 4
}
void steps_together(const std::vector<double>& times) {
  const auto members = [](std::uint64_t) { return Member<Arm>(); };
  // snippet: docs/batches.md 5
}
void lanes(const std::vector<double>& times) {
  const auto members = [](std::uint64_t) { return Member<double_pendulum::Mechanism<double>>(); };
  // snippet: docs/batches.md 6
}
}  // namespace ensembles

#ifdef TORSOR_WITH_MPI
void processes() {
  // snippet: docs/batches.md 7
}
#endif

namespace consistent_starts {
using Mechanism = andrews_squeezer::Mechanism<double>;
void run(const Mechanism::Precomputed& precomputed, StateVector<Mechanism>& y) {
  // snippet: docs/constraints.md 1
}
}  // namespace consistent_starts

void move_with_contacts() {
  // snippet: docs/contacts.md 2
}

namespace ball_with_events {
using State = std::array<double, 2>;
void run(State& y) {
  const auto ball = [](double, const State& at, State& rate) {
    rate = {at[1], -9.81};
    return torsor::Status::ok;
  };
  // snippet: docs/events.md 1
}
}  // namespace ball_with_events

namespace methods {
using namespace double_pendulum;
void run() {
  // snippet: docs/integrators.md 1
}
}  // namespace methods

namespace sparse_rows {
using Mechanism = rolling_hoop::Mechanism<double>;
void run(const Mechanism::Precomputed& precomputed, const Mechanism::State& state) {
  // snippet: docs/kernels.md 2
}
}  // namespace sparse_rows

namespace tasks {
struct Arm {  // no committed header has this kernel
  struct State {};
  struct OperationalInertia {
    std::array<double, 36> hand_inverse_inertia;
  };
  static torsor::Status operational_inertia(const State&, const State&, OperationalInertia&);
};
double run(const Arm::State& precomputed, const Arm::State& state, double acceleration_x) {
  Arm::OperationalInertia result;
  double force_x = 0;
  // snippet: docs/kernels.md 1
  return force_x;
}
}  // namespace tasks

namespace descriptions {
void run() {
  // snippet: docs/languages.md 1
}
}  // namespace descriptions

namespace controller {
using Crane = arm7::Mechanism<double>;  // has inputs and no constraints, as the crane
int run() {
  // snippet: README.md 2
  return 0;
}
}  // namespace controller

namespace small_motions {
using Absorber = vibration_absorber::Mechanism<double>;
void rests(const Absorber::Precomputed& precomputed) {
  // snippet: docs/small_motions.md 1
}
void harmonic(const LinearSystem& system, const Eigen::VectorXd& force, double omega) {
  // snippet: docs/small_motions.md 2
}
void periodic(const LinearSystem& system, double omega) {
  const auto force_at = [](double t) { return Eigen::VectorXd::Constant(2, t); };
  // snippet: docs/small_motions.md 3
}
void from_a_start(const LinearSystem& system, const Eigen::VectorXd& x0, const Eigen::VectorXd& v0, const Eigen::VectorXd& weight,
                  const Eigen::VectorXd& force, double omega) {
  // snippet: docs/small_motions.md 4
}
}  // namespace small_motions
