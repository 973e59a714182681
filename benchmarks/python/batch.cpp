// SPDX-License-Identifier: GPL-3.0-or-later
// The batch of C++ beside Python's call, in one process: batch.py compiles it with the flags of the library.
#include <cstddef>

#include "panda.hpp"
#include "torsor/runtime/batch/batch.hpp"

namespace {
using Arms = torsor::runtime::BatchOf<panda::Mechanism, double>;
struct Problem {
  Arms arms;
  Arms::States states;
  Arms::Accelerations accelerations;
  Arms::Multipliers multipliers;
  Arms::Forces forces;
  explicit Problem(std::size_t n) : states(n), accelerations(n), multipliers(n), forces(n) {}
};
}  // namespace

extern "C" {
void* make_problem(std::size_t n, const double* q, const double* v, const double* a) {
  auto* const problem = new Problem(n);
  for (std::size_t i = 0; i < n; ++i) {
    Arms::Single::State state{};
    Arms::Single::Accelerations accelerations{};
    for (std::size_t k = 0; k < 7; ++k) {
      state.q[static_cast<int>(k)] = q[7 * i + k];
      state.v[static_cast<int>(k)] = v[7 * i + k];
      accelerations[static_cast<int>(k)] = a[7 * i + k];
    }
    problem->states.set(i, state);
    problem->accelerations.set(i, accelerations);
  }
  return problem;
}

void evaluate_problem(void* made) {
  auto& p = *static_cast<Problem*>(made);
  p.arms.inverse_dynamics(p.states, p.accelerations, p.multipliers, p.forces);
}

void read_problem(const void* made, double* forces) {
  const auto& p = *static_cast<const Problem*>(made);
  for (std::size_t i = 0; i < p.forces.size(); ++i) {
    for (std::size_t k = 0; k < 7; ++k) forces[7 * i + k] = p.forces.entry(i, k);
  }
}
}
