// SPDX-License-Identifier: MIT
#pragma once

#include "torsor/runtime/equations_of_motion.hpp"
#ifdef TORSOR_ABI_WITH_CONSTRAINTS
#include "torsor/runtime/mechanism.hpp"
#endif

namespace torsor::runtime::abi {

/// The motion of `equations_of_motion`: held on its constraints where there are some. Whoever compiles a mechanism with
/// multipliers defines TORSOR_ABI_WITH_CONSTRAINTS.
#ifdef TORSOR_ABI_WITH_CONSTRAINTS
template <HasForwardDynamics M, class InputLaw>
using MotionOfLibrary = MotionOf<M, InputLaw>;
#else
template <HasForwardDynamics M, class InputLaw>
requires(M::multiplier_count == 0) using MotionOfLibrary = EquationsOfMotion<M, InputLaw>;
#endif

}  // namespace torsor::runtime::abi
