// SPDX-License-Identifier: MIT
// A seven-joint arm on a Cortex-M4F, in float: the interrupt of each millisecond computes the torques that make it
// follow a motion (computed torque), and the main program moves a simulated arm by them. No allocation, no C library
// but frexpf.
#include <atomic>

#include "examples/cortex_m/board.hpp"
#include "generated/arm7.hpp"

namespace {

using Arm = arm7::Mechanism<float>;
constexpr int n = Arm::velocity_count;
constexpr float period = 0.001f;  // s

const Arm::Precomputed precomputed = Arm::precompute(Arm::default_parameters());
Arm::State state;
Arm::Inputs torques;
std::atomic<bool> has_torques{false};  // until the arm has moved by them

struct Motion {
  float place, velocity, acceleration;
};
/// Of each joint: rad, rad/s, rad/s^2. All begin at rest.
Motion wanted(int joint, float time) noexcept {
  const float amplitude = 0.3f, rate = 2.0f + 0.3f * static_cast<float>(joint);
  float sine, cosine;
  torsor::scalar_traits<float>::sincos(rate * time, sine, cosine);
  return {amplitude * (1.0f - cosine), amplitude * rate * sine, amplitude * rate * rate * cosine};
}

/// a = a_d + K_v (v_d - v) + K_p (q_d - q), torques = M a + h: errors then follow e'' + K_v e' + K_p e = 0.
void control() noexcept {
  constexpr float stiffness = 400.0f, damping = 40.0f;  // s^-2, s^-1
  Arm::Accelerations a;
  for (int joint = 0; joint < n; ++joint) {
    const Motion motion = wanted(joint, state.time);
    a[joint] = motion.acceleration + damping * (motion.velocity - state.v[joint]) +
               stiffness * (motion.place - state.q[joint]);
  }
  Arm::GeneralizedForces forces;
  Arm::inverse_dynamics(precomputed, state, a, forces);
  for (int joint = 0; joint < n; ++joint) torques[joint] = forces[joint];
}

/// The arm itself, by Heun's method; false where the kernel found no accelerations.
bool move() noexcept {
  Arm::Accelerations a, later;
  if (Arm::forward_dynamics(precomputed, state, torques, a) != torsor::Status::ok) return false;
  Arm::State next = state;
  next.time += period;
  for (int joint = 0; joint < n; ++joint) {
    next.q[joint] += period * (state.v[joint] + 0.5f * period * a[joint]);
    next.v[joint] += period * a[joint];
  }
  if (Arm::forward_dynamics(precomputed, next, torques, later) != torsor::Status::ok) return false;
  for (int joint = 0; joint < n; ++joint) next.v[joint] += 0.5f * period * (later[joint] - a[joint]);
  state = next;
  return true;
}

}  // namespace

extern "C" void tick() {
  if (has_torques.load(std::memory_order_acquire)) return;
  control();
  has_torques.store(true, std::memory_order_release);
}

int main() {
  state = Arm::initial_state();
  for (int joint = 0; joint < n; ++joint) state.q[joint] = wanted(joint, 0.0f).place + 0.05f, state.v[joint] = 0.0f;
  Clock::start(25000, true);  // a millisecond of MPS2's 25 MHz

  float error = 0.0f;
  for (int step = 0; step <= 2000; ++step) {
    while (!has_torques.load(std::memory_order_acquire)) {
    }
    error = 0.0f;
    for (int joint = 0; joint < n; ++joint) {
      const float e = state.q[joint] - wanted(joint, state.time).place;
      if (!(e <= error)) error = e;
      if (!(-e <= error)) error = -e;
    }
    if (step % 500 == 0) {
      say("t = ");
      say_number(state.time, 1);
      say(" s, largest error ");
      say_number(error, 6);
      say(" rad\n");
    }
    if (!move()) return 1;
    has_torques.store(false, std::memory_order_release);
  }
  return error < 0.001f ? 0 : 1;
}
