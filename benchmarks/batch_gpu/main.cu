// SPDX-License-Identifier: GPL-3.0-or-later
// batch_gpu: nanoseconds for one state of a seven-joint arm on a graphics processor, a state for each thread, in double
// and in float. States and results lie there as structures of arrays: neighbouring threads read neighbouring numbers.
// The results are compared with those of the processor. Ends with 77 when there is no graphics processor.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>
#include <vector>

#define TORSOR_DEVICE __host__ __device__
#include "generated/arm7.hpp"

namespace {

constexpr int state_count = 1 << 20, turns = 101, threads = 128;

void require(cudaError_t error, const char* what) {
  if (error == cudaSuccess) return;
  std::fprintf(stderr, "batch_gpu: cannot %s: %s\n", what, cudaGetErrorString(error));
  std::exit(1);
}

/// The i-th of structures whose entries lie `state_count` numbers apart.
template <class Structure, class Scalar>
__host__ __device__ Structure load(const Scalar* rows, int i) {
  constexpr int entries = sizeof(Structure) / sizeof(Scalar);
  Scalar values[entries];
  for (int k = 0; k < entries; ++k) values[k] = rows[k * state_count + i];
  Structure structure;
  memcpy(&structure, values, sizeof structure);
  return structure;
}
template <class Structure, class Scalar>
__host__ __device__ void store(const Structure& structure, Scalar* rows, int i) {
  constexpr int entries = sizeof(Structure) / sizeof(Scalar);
  Scalar values[entries];
  memcpy(values, &structure, sizeof structure);
  for (int k = 0; k < entries; ++k) rows[k * state_count + i] = values[k];
}

struct ForwardDynamics {
  static constexpr const char* name = "forward_dynamics";
  template <class Scalar>
  __host__ __device__ static void evaluate(const Scalar* states, const Scalar* inputs, Scalar* results, int i) {
    using M = arm7::Mechanism<Scalar>;
    typename M::Accelerations a;
    typename M::Multipliers none;
    const auto status = M::forward_dynamics(M::precompute(M::default_parameters()),
                                            load<typename M::State>(states, i), load<typename M::Inputs>(inputs, i), a,
                                            none);
    store(a, results, i);
    // A state that failed is seen in its results.
    if (status != torsor::Status::ok) results[i] = Scalar(INFINITY);
  }
};
struct Bias {
  static constexpr const char* name = "bias";
  template <class Scalar>
  __host__ __device__ static void evaluate(const Scalar* states, const Scalar*, Scalar* results, int i) {
    using M = arm7::Mechanism<Scalar>;
    typename M::GeneralizedForces forces;
    M::bias(M::precompute(M::default_parameters()), load<typename M::State>(states, i), forces);
    store(forces, results, i);
  }
};

template <class Kernel, class Scalar>
__global__ void every_state(const Scalar* states, const Scalar* inputs, Scalar* results) {
  const int i = static_cast<int>(blockIdx.x * blockDim.x + threadIdx.x);
  if (i < state_count) Kernel::evaluate(states, inputs, results, i);
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

template <class Kernel, class Scalar>
void measure(const char* scalar) {
  using M = arm7::Mechanism<Scalar>;
  std::mt19937_64 random(1);
  std::uniform_real_distribution<Scalar> angle(Scalar(-3.2), Scalar(3.2)), rate(Scalar(-2), Scalar(2));
  std::vector<Scalar> states, inputs(std::size_t{M::input_count} * state_count),
      results(std::size_t{M::velocity_count} * state_count), here(results);
  states.resize(state_count);  // times, all 0
  for (int i = 0; i < M::coordinate_count * state_count; ++i) states.push_back(angle(random));
  for (int i = 0; i < M::velocity_count * state_count; ++i) states.push_back(rate(random));
  for (Scalar& input : inputs) input = rate(random);

  const OnDevice<Scalar> device_states(states), device_inputs(inputs), device_results(results);
  cudaEvent_t begin, end;
  require(cudaEventCreate(&begin), "make a clock");
  require(cudaEventCreate(&end), "make a clock");
  std::vector<float> milliseconds(turns);
  for (float& each : milliseconds) {
    require(cudaEventRecord(begin), "read the clock");
    every_state<Kernel, Scalar><<<(state_count + threads - 1) / threads, threads>>>(
        device_states.data(), device_inputs.data(), device_results.data());
    require(cudaGetLastError(), "start the kernel");
    require(cudaEventRecord(end), "read the clock");
    require(cudaEventSynchronize(end), "run the kernel");
    require(cudaEventElapsedTime(&each, begin, end), "read the clock");
  }
  device_results.read(results);
  double worst = 0, greatest = 0;
  for (int i = 0; i < state_count; i += 97) {
    Kernel::evaluate(states.data(), inputs.data(), here.data(), i);
    for (int k = 0; k < M::velocity_count; ++k) {
      const std::size_t at = static_cast<std::size_t>(k) * state_count + static_cast<std::size_t>(i);
      worst = std::max(worst, std::abs(double(results[at]) - double(here[at])));
      greatest = std::max(greatest, std::abs(double(here[at])));
    }
  }
  std::sort(milliseconds.begin(), milliseconds.end());
  std::printf("%-18s%-8s%9.3f   %.0e\n", Kernel::name, scalar, milliseconds[turns / 2] * 1e6 / state_count,
              worst / greatest);
  cudaEventDestroy(begin);
  cudaEventDestroy(end);
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
  measure<ForwardDynamics, double>("double");
  measure<ForwardDynamics, float>("float");
  measure<Bias, double>("double");
  measure<Bias, float>("float");
  return 0;
}
