// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Every kernel of one generated header behind C functions, so that one program (states.cpp) can be linked with the
// kernels of any header at any level of optimisation. Include after the header; needs nothing else.

namespace kernels_by_number {

// What a pattern of calls is well-formed for.
template <class M, template <class> class Call, class = void>
struct Has {
  static constexpr bool value = false;
};
template <class...>
using Void = void;
template <class M, template <class> class Call>
struct Has<M, Call, Void<Call<M>>> {
  static constexpr bool value = true;
};

template <class T>
T& any() noexcept;

#define TORSOR_KERNEL(name, ...) \
  template <class M>             \
  using name = decltype(M::name(any<const typename M::Precomputed>(), any<const typename M::State>(), __VA_ARGS__))
TORSOR_KERNEL(kinematics, any<typename M::Kinematics>());
TORSOR_KERNEL(bias, any<typename M::GeneralizedForces>());
TORSOR_KERNEL(energy, any<const typename M::Inputs>(), any<typename M::Energy>());
TORSOR_KERNEL(first_integrals, any<typename M::FirstIntegrals>());
TORSOR_KERNEL(constraints, any<typename M::Constraints>());
TORSOR_KERNEL(inverse_dynamics, any<const typename M::Accelerations>(), any<const typename M::Multipliers>(),
              any<typename M::GeneralizedForces>());
TORSOR_KERNEL(reactions, any<const typename M::Accelerations>(), any<const typename M::Multipliers>(),
              any<const typename M::Inputs>(), any<typename M::Reactions>());
TORSOR_KERNEL(linearisation, any<const typename M::Accelerations>(), any<const typename M::Multipliers>(),
              any<const typename M::Inputs>(), any<typename M::Linearisation>());
TORSOR_KERNEL(inverse_dynamics_derivatives, any<const typename M::Accelerations>(), any<const typename M::Multipliers>(),
              any<typename M::InverseDynamicsDerivatives>());
TORSOR_KERNEL(forward_dynamics_derivatives, any<const typename M::Inputs>(),
              any<typename M::ForwardDynamicsDerivatives>());
TORSOR_KERNEL(sparse_constraint_jacobian, any<typename M::SparseConstraintJacobian>());
TORSOR_KERNEL(residual, any<const typename M::Accelerations>(), any<const typename M::Multipliers>(),
              any<const typename M::Inputs>(), any<std::array<double, M::velocity_count + M::multiplier_count>>());
TORSOR_KERNEL(residual_jacobian, any<const typename M::Accelerations>(), any<const typename M::Multipliers>(),
              any<const typename M::Inputs>(), any<typename M::ResidualJacobian>());
TORSOR_KERNEL(inverse_dynamics_second_derivatives, any<const typename M::Accelerations>(),
              any<const typename M::Multipliers>(), any<typename M::InverseDynamicsSecondDerivatives>());
TORSOR_KERNEL(forward_dynamics_second_derivatives, any<const typename M::Inputs>(),
              any<typename M::ForwardDynamicsSecondDerivatives>());
TORSOR_KERNEL(inverse_dynamics_sensitivities, any<const typename M::Accelerations>(),
              any<const typename M::Multipliers>(), any<typename M::InverseDynamicsSensitivities>());
TORSOR_KERNEL(forward_dynamics_sensitivities, any<const typename M::Inputs>(),
              any<typename M::ForwardDynamicsSensitivities>());
TORSOR_KERNEL(regressor, any<const typename M::Accelerations>(), any<typename M::Regressor>());
TORSOR_KERNEL(mass_matrix, any<std::array<double, M::velocity_count * M::velocity_count>>());
TORSOR_KERNEL(coordinate_rates, any<std::array<double, M::coordinate_count>>());
TORSOR_KERNEL(jets, any<const typename M::Inputs>(), 1,
              static_cast<std::array<double, M::coordinate_count + M::velocity_count>*>(nullptr));
#undef TORSOR_KERNEL
template <class M>
using quaternions = decltype(M::quaternions[0]);
template <class M>
using columns = decltype(any<typename M::Constraints>().columns);

/// Results one after the other in a buffer, or their number alone where there is none.
struct Results {
  double* out;  // may be null
  int* status;  // of each kernel, -1 for one that has none; may be null
  const char** names;
  int* ends;  // of each kernel in the buffer
  int kernels = 0, count = 0;

  template <class T>
  void add(const char* name, int code, const T& value) {
    static_assert(sizeof(T) % sizeof(double) == 0, "results hold nothing but numbers");
    const double* from = reinterpret_cast<const double*>(&value);
    for (unsigned i = 0; i < sizeof(T) / sizeof(double); ++i) {
      if (out != nullptr) out[count] = from[i];
      ++count;
    }
    if (status != nullptr) status[kernels] = code;
    if (names != nullptr) names[kernels] = name;
    if (ends != nullptr) ends[kernels] = count;
    ++kernels;
  }
};

template <class Vector>
const double* read(const double* in, int count, Vector& to) {
  if constexpr (sizeof(Vector) >= sizeof(double)) {
    for (int i = 0; i < count; ++i) to[i] = in[i];
  }
  return in + count;
}

template <class M>
constexpr int multipliers() {
  return M::multiplier_count;
}

template <class M>
void evaluate(const double* in, Results& results) {
  typename M::State s{};
  typename M::Accelerations a{};
  typename M::Multipliers lambda{};
  typename M::Inputs u{};
  auto parameters = M::default_parameters();
  s.time = *in++;
  in = read(in, M::coordinate_count, s.q);
  in = read(in, M::velocity_count, s.v);
  in = read(in, M::velocity_count, a);
  in = read(in, M::multiplier_count, lambda);
  in = read(in, M::input_count, u);
  if constexpr (M::parameter_count > 0) read(in, M::parameter_count, parameters);
  const auto p = M::precompute(parameters);

  if constexpr (Has<M, kinematics>::value) {
    typename M::Kinematics result{};
    M::kinematics(p, s, result);
    results.add("kinematics", -1, result);
  }
  if constexpr (Has<M, coordinate_rates>::value) {
    std::array<double, M::coordinate_count> rates{};
    M::coordinate_rates(p, s, rates);
    results.add("coordinate_rates", -1, rates);
  }
  if constexpr (Has<M, mass_matrix>::value) {
    std::array<double, M::velocity_count * M::velocity_count> mass{};
    M::mass_matrix(p, s, mass);
    results.add("mass_matrix", -1, mass);
  }
  typename M::GeneralizedForces forces{};
  if constexpr (Has<M, bias>::value) {
    M::bias(p, s, forces);
    results.add("bias", -1, forces);
  }
  if constexpr (Has<M, inverse_dynamics>::value) {
    M::inverse_dynamics(p, s, a, lambda, forces);
    results.add("inverse_dynamics", -1, forces);
  }
  if constexpr (Has<M, energy>::value) {
    typename M::Energy result{};
    M::energy(p, s, u, result);
    results.add("energy", -1, result);
  }
  if constexpr (Has<M, first_integrals>::value) {
    typename M::FirstIntegrals result{};
    M::first_integrals(p, s, result);
    results.add("first_integrals", -1, result);
  }
  if constexpr (Has<M, constraints>::value) {
    typename M::Constraints result{};
    M::constraints(p, s, result);
    results.add("constraints", -1, result);
    // Once more by themselves, for the condition of the matrix that is solved with.
    results.add("constraint_jacobian", -1, result.jacobian);
    if constexpr (Has<M, columns>::value) results.add("constraint_columns", -1, result.columns);
  }
  if constexpr (Has<M, reactions>::value) {
    typename M::Reactions result{};
    M::reactions(p, s, a, lambda, u, result);
    results.add("reactions", -1, result);
  }
  if constexpr (Has<M, regressor>::value) {
    typename M::Regressor result{};
    M::regressor(p, s, a, result);
    results.add("regressor", -1, result);
  }
  if constexpr (Has<M, inverse_dynamics_derivatives>::value) {
    typename M::InverseDynamicsDerivatives result{};
    M::inverse_dynamics_derivatives(p, s, a, lambda, result);
    results.add("inverse_dynamics_derivatives", -1, result);
  }
  if constexpr (Has<M, sparse_constraint_jacobian>::value) {
    typename M::SparseConstraintJacobian result{};
    M::sparse_constraint_jacobian(p, s, result);
    results.add("sparse_constraint_jacobian", -1, result);
  }
  if constexpr (Has<M, residual>::value) {
    std::array<double, M::velocity_count + M::multiplier_count> result{};
    M::residual(p, s, a, lambda, u, result);
    results.add("residual", -1, result);
  }
  if constexpr (Has<M, residual_jacobian>::value) {
    typename M::ResidualJacobian result{};
    M::residual_jacobian(p, s, a, lambda, u, result);
    results.add("residual_jacobian", -1, result);
  }
  if constexpr (Has<M, inverse_dynamics_second_derivatives>::value) {
    typename M::InverseDynamicsSecondDerivatives result{};
    M::inverse_dynamics_second_derivatives(p, s, a, lambda, result);
    results.add("inverse_dynamics_second_derivatives", -1, result);
  }
  if constexpr (Has<M, inverse_dynamics_sensitivities>::value) {
    typename M::InverseDynamicsSensitivities result{};
    M::inverse_dynamics_sensitivities(p, s, a, lambda, result);
    results.add("inverse_dynamics_sensitivities", -1, result);
  }
  typename M::Accelerations found{};
  typename M::Multipliers reaction{};
  const int status = static_cast<int>(M::forward_dynamics(p, s, u, found, reaction));
  results.add("forward_dynamics", status, found);
  if constexpr (M::multiplier_count > 0) results.add("multipliers", status, reaction);
  if constexpr (Has<M, linearisation>::value) {
    typename M::Linearisation result{};
    const auto code = M::linearisation(p, s, a, lambda, u, result);
    results.add("linearisation", static_cast<int>(code), result);
  }
  if constexpr (Has<M, forward_dynamics_derivatives>::value) {
    typename M::ForwardDynamicsDerivatives result{};
    const auto code = M::forward_dynamics_derivatives(p, s, u, result);
    results.add("forward_dynamics_derivatives", static_cast<int>(code), result);
  }
  if constexpr (Has<M, forward_dynamics_second_derivatives>::value) {
    typename M::ForwardDynamicsSecondDerivatives result{};
    const auto code = M::forward_dynamics_second_derivatives(p, s, u, result);
    results.add("forward_dynamics_second_derivatives", static_cast<int>(code), result);
  }
  if constexpr (Has<M, forward_dynamics_sensitivities>::value) {
    typename M::ForwardDynamicsSensitivities result{};
    const auto code = M::forward_dynamics_sensitivities(p, s, u, result);
    results.add("forward_dynamics_sensitivities", static_cast<int>(code), result);
  }
  if constexpr (Has<M, jets>::value) {
    constexpr int order = 8;
    std::array<std::array<double, M::coordinate_count + M::velocity_count>, order + 1> result{};
    const auto code = M::jets(p, s, u, order, result.data());
    result[0] = {};  // the state again
    results.add("jets", static_cast<int>(code), result);
  }
}

/// Initial state and default parameters, nothing else.
template <class M>
void start(double* in) {
  const auto s = M::initial_state();
  *in++ = s.time;
  for (int i = 0; i < M::coordinate_count; ++i) *in++ = s.q[i];
  for (int i = 0; i < M::velocity_count; ++i) *in++ = s.v[i];
  for (int i = 0; i < M::velocity_count + M::multiplier_count + M::input_count; ++i) *in++ = 0.0;
  const auto parameters = M::default_parameters();
  (void)parameters;
  if constexpr (M::parameter_count > 0) {
    for (int i = 0; i < M::parameter_count; ++i) *in++ = parameters[i];
  }
}

/// Sizes of the parts of the input: coordinates, velocities, accelerations, multipliers, inputs, parameters.
template <class M>
int size_of_part(int part) {
  constexpr int sizes[] = {M::coordinate_count, M::velocity_count, M::velocity_count,
                           M::multiplier_count, M::input_count,    M::parameter_count};
  return sizes[part];
}

/// Where the quaternion of this number begins; -1 beyond the last.
template <class M>
int quaternion(int number) {
  (void)number;
  if constexpr (Has<M, quaternions>::value) {
    if (number < M::quaternion_count) return M::quaternions[number];
  }
  return -1;
}

}  // namespace kernels_by_number

#define TORSOR_KERNELS_BY_NUMBER(M)                                                                             \
  extern "C" {                                                                                                  \
  void torsor_evaluate(const double* in, double* out, int* status, const char** names, int* ends, int* kernels) { \
    kernels_by_number::Results results{out, status, names, ends};                                               \
    kernels_by_number::evaluate<M>(in, results);                                                                \
    *kernels = results.kernels;                                                                                 \
  }                                                                                                             \
  void torsor_start(double* in) { kernels_by_number::start<M>(in); }                                            \
  int torsor_size_of_part(int part) { return kernels_by_number::size_of_part<M>(part); }                        \
  int torsor_quaternion(int number) { return kernels_by_number::quaternion<M>(number); }                        \
  }
