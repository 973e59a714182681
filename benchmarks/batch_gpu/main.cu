// SPDX-License-Identifier: GPL-3.0-or-later
// batch_gpu: nanoseconds for one state of a seven-joint arm on a graphics processor, a state for each thread, in double
// and in float. States and results lie there as structures of arrays: neighbouring threads read neighbouring numbers.
// Every 97th result is held against the processor in double: statuses must be the same, results finite and within the
// bound. Ends with 1 where they are not, with 77 when there is no graphics processor.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

#define TORSOR_DEVICE __host__ __device__
#include "generated/arm7.hpp"
#include "torsor/generator/verification/worst.hpp"

namespace {

constexpr int state_count = 1 << 20, turns = 101, threads = 128;

void require(cudaError_t error, const char* what) {
  if (error == cudaSuccess) return;
  std::fprintf(stderr, "batch_gpu: cannot %s: %s\n", what, cudaGetErrorString(error));
  std::exit(1);
}

/// The i-th of structures of `Number` whose entries lie `state_count` numbers apart.
template <class Structure, class Number, class Scalar>
__host__ __device__ Structure load_as(const Scalar* rows, int i) {
  constexpr int entries = sizeof(Structure) / sizeof(Number);
  Number values[entries];
  for (int k = 0; k < entries; ++k) values[k] = Number(rows[k * state_count + i]);
  Structure structure;
  memcpy(&structure, values, sizeof structure);
  return structure;
}
template <class Structure, class Scalar>
__host__ __device__ Structure load(const Scalar* rows, int i) {
  return load_as<Structure, Scalar>(rows, i);
}
template <class Structure, class Scalar>
__host__ __device__ void store(const Structure& structure, Scalar* rows, int i) {
  constexpr int entries = sizeof(Structure) / sizeof(Scalar);
  Scalar values[entries];
  memcpy(values, &structure, sizeof structure);
  for (int k = 0; k < entries; ++k) rows[k * state_count + i] = values[k];
}

using Exact = arm7::Mechanism<double>;
constexpr int joints = Exact::velocity_count;

/// How far results are off, and the size that this is relative to.
struct Error {
  double difference = 0, size = 0;
};

struct ForwardDynamics {
  static constexpr const char* name = "forward_dynamics";
  template <class Scalar>
  __host__ __device__ static bool evaluate(const Scalar* states, const Scalar* inputs, Scalar* results, int i) {
    using M = arm7::Mechanism<Scalar>;
    typename M::Accelerations a;
    typename M::Multipliers none;
    const auto status = M::forward_dynamics(M::precompute(M::default_parameters()),
                                            load<typename M::State>(states, i), load<typename M::Inputs>(inputs, i), a,
                                            none);
    store(a, results, i);
    return status == torsor::Status::ok;
  }
  /// What the accelerations miss M a + h = u by, relative to its terms: what solving backward stably leaves whatever
  /// the condition of M.
  template <class Scalar>
  static Error error(const Scalar* states, const Scalar* inputs, const Scalar* results, int i) {
    const auto p = Exact::precompute(Exact::default_parameters());
    const auto state = load_as<Exact::State, double>(states, i);
    const auto u = load_as<Exact::Inputs, double>(inputs, i);
    const auto a = load_as<Exact::Accelerations, double>(results, i);
    Exact::GeneralizedForces h, needed, of_one[joints];
    Exact::bias(p, state, h);
    Exact::inverse_dynamics(p, state, a, {}, needed);
    for (int k = 0; k < joints; ++k) {
      Exact::Accelerations one{};
      one[k] = a[k];
      Exact::inverse_dynamics(p, state, one, {}, of_one[k]);
    }
    double worst = 0, greatest = 0;
    for (int j = 0; j < joints; ++j) {
      double size = std::abs(h[j]) + std::abs(u[j]);
      for (int k = 0; k < joints; ++k) size += std::abs(of_one[k][j] - h[j]);
      const double missed = std::abs(needed[j] - u[j]);
      if (torsor::is_worse(missed, worst)) worst = missed;
      greatest = std::max(greatest, size);
    }
    return {worst / greatest, 1.0};
  }
};
struct Bias {
  static constexpr const char* name = "bias";
  template <class Scalar>
  __host__ __device__ static bool evaluate(const Scalar* states, const Scalar*, Scalar* results, int i) {
    using M = arm7::Mechanism<Scalar>;
    typename M::GeneralizedForces forces;
    M::bias(M::precompute(M::default_parameters()), load<typename M::State>(states, i), forces);
    store(forces, results, i);
    return true;
  }
  template <class Scalar>
  static Error error(const Scalar* states, const Scalar*, const Scalar* results, int i) {
    Exact::GeneralizedForces exact;
    Exact::bias(Exact::precompute(Exact::default_parameters()), load_as<Exact::State, double>(states, i), exact);
    const auto found = load_as<Exact::GeneralizedForces, double>(results, i);
    Error error;
    for (int j = 0; j < joints; ++j) {
      const double difference = std::abs(found[j] - exact[j]);
      if (torsor::is_worse(difference, error.difference)) error.difference = difference;
      error.size = std::max(error.size, std::abs(exact[j]));
    }
    return error;
  }
};

template <class Kernel, class Scalar>
__global__ void every_state(const Scalar* states, const Scalar* inputs, Scalar* results, Scalar* regular) {
  const int i = static_cast<int>(blockIdx.x * blockDim.x + threadIdx.x);
  if (i < state_count) regular[i] = Scalar(Kernel::evaluate(states, inputs, results, i) ? 1 : 0);
}

/// Numbers there, a copy of those here.
template <class Scalar>
class OnDevice {
 public:
  explicit OnDevice(const std::vector<Scalar>& values) : bytes_(values.size() * sizeof(Scalar)) {
    require(cudaMalloc(&data_, bytes_), "get memory");
    require(cudaMemcpy(data_, values.data(), bytes_, cudaMemcpyHostToDevice), "copy the states");
  }
  ~OnDevice() { cudaFree(data_); }
  OnDevice(const OnDevice&) = delete;
  OnDevice& operator=(const OnDevice&) = delete;
  Scalar* data() const { return data_; }
  void read(std::vector<Scalar>& values) const {
    require(cudaMemcpy(values.data(), data_, bytes_, cudaMemcpyDeviceToHost), "copy the results");
  }

 private:
  Scalar* data_ = nullptr;
  std::size_t bytes_;
};

/// Whether the results kept to the bound.
template <class Kernel, class Scalar>
bool measure(const char* scalar) {
  using M = arm7::Mechanism<Scalar>;
  std::mt19937_64 random(1);
  std::uniform_real_distribution<Scalar> angle(Scalar(-3.2), Scalar(3.2)), rate(Scalar(-2), Scalar(2));
  std::vector<Scalar> states, inputs(std::size_t{M::input_count} * state_count),
      results(std::size_t{M::velocity_count} * state_count), here(results), regular(state_count);
  states.resize(state_count);  // times, all 0
  for (int i = 0; i < M::coordinate_count * state_count; ++i) states.push_back(angle(random));
  for (int i = 0; i < M::velocity_count * state_count; ++i) states.push_back(rate(random));
  for (Scalar& input : inputs) input = rate(random);

  const OnDevice<Scalar> device_states(states), device_inputs(inputs), device_results(results),
      device_regular(regular);
  cudaEvent_t begin, end;
  require(cudaEventCreate(&begin), "make a clock");
  require(cudaEventCreate(&end), "make a clock");
  std::vector<float> milliseconds(turns);
  for (float& each : milliseconds) {
    require(cudaEventRecord(begin), "read the clock");
    every_state<Kernel, Scalar><<<(state_count + threads - 1) / threads, threads>>>(
        device_states.data(), device_inputs.data(), device_results.data(), device_regular.data());
    require(cudaGetLastError(), "start the kernel");
    require(cudaEventRecord(end), "read the clock");
    require(cudaEventSynchronize(end), "run the kernel");
    require(cudaEventElapsedTime(&each, begin, end), "read the clock");
  }
  device_results.read(results);
  device_regular.read(regular);
  double worst = 0, greatest = 0;
  int other_statuses = 0;
  for (int i = 0; i < state_count; i += 97) {
    const bool ok = Kernel::evaluate(states.data(), inputs.data(), here.data(), i);
    if (ok != (regular[static_cast<std::size_t>(i)] == Scalar(1))) ++other_statuses;
    if (!ok) continue;
    const Error error = Kernel::error(states.data(), inputs.data(), results.data(), i);
    if (torsor::is_worse(error.difference, worst)) worst = error.difference;
    greatest = std::max(greatest, error.size);
  }
  // 24 roundings for each joint, as tests/headers/worst_states.sh allows fused multiplications.
  const double difference = worst / greatest, bound = 24.0 * joints * std::numeric_limits<Scalar>::epsilon();
  const bool kept = difference <= bound && other_statuses == 0;  // false for what is no number
  std::sort(milliseconds.begin(), milliseconds.end());
  std::printf("%-18s%-8s%9.3f   %.0e\n", Kernel::name, scalar, milliseconds[turns / 2] * 1e6 / state_count, difference);
  if (!kept) {
    std::printf("batch_gpu: %s in %s: %.1e is above %.1e, or the status is another one (%d times)\n", Kernel::name, scalar,
                difference, bound, other_statuses);
  }
  cudaEventDestroy(begin);
  cudaEventDestroy(end);
  return kept;
}

}  // namespace

int main() {
  int devices = 0;
  if (cudaGetDeviceCount(&devices) != cudaSuccess || devices == 0) {
    std::puts("batch_gpu: there is no graphics processor that CUDA can use");
    return 77;
  }
  cudaDeviceProp properties{};
  require(cudaGetDeviceProperties(&properties, 0), "ask for the processor's name");
  std::printf("%s, %d states\n%-18s%-8s%9s   %s\n", properties.name, state_count, "kernel", "scalar", "ns", "difference");
  bool kept = measure<ForwardDynamics, double>("double");
  kept = measure<ForwardDynamics, float>("float") && kept;
  kept = measure<Bias, double>("double") && kept;
  kept = measure<Bias, float>("float") && kept;
  return kept ? 0 : 1;
}
