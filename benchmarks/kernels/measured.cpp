// SPDX-License-Identifier: GPL-3.0-or-later
// One generated header as a controller would compile it: for any processor, for this one, and by another compiler, in a
// namespace each, so that none takes another's functions. The build defines MODEL, the header's namespace, MODEL_NAME,
// MODEL_WITHOUT, MODEL_HEADER, MODEL_BUILD and MODEL_OPTIONS.
#include "benchmarks/kernels/measured.hpp"

#include <array>
#include <cmath>
#include <memory>
#include <stdexcept>

namespace MODEL_BUILD {
#include MODEL_HEADER
}

namespace MODEL_BUILD {
namespace {

using kernels::Batch;
using kernels::Quantity;
using kernels::Way;

/// The states of a batch and the results of kernels, in the header's own structures.
template <class Scalar>
struct Kernels {
  using M = MODEL::Mechanism<Scalar>;
  static constexpr int n = M::coordinate_count;

  explicit Kernels(const Batch& batch)
      : states(batch.states),
        accelerations(batch.states),
        inputs(batch.states),
        forces(batch.states),
        results(batch.states),
        masses(batch.states) {
    for (std::size_t k = 0; k < batch.states; ++k) {
      for (int i = 0; i < n; ++i) {
        const auto place = static_cast<std::size_t>(i);
        states[k].q[i] = static_cast<Scalar>(batch.of(batch.q, k)[place]);
        states[k].v[i] = static_cast<Scalar>(batch.of(batch.v, k)[place]);
        accelerations[k][i] = static_cast<Scalar>(batch.of(batch.a, k)[place]);
        inputs[k][i] = static_cast<Scalar>(batch.of(batch.tau, k)[place]);
      }
    }
  }

  // Functions of their own, as in a program that calls a kernel from one place: nothing is shared between two states.
  [[gnu::noinline]] void inverse_dynamics(std::size_t k) {
    M::inverse_dynamics(precomputed, states[k], accelerations[k], {}, forces[k]);
  }
  [[gnu::noinline]] void mass_matrix(std::size_t k) { M::mass_matrix(precomputed, states[k], masses[k]); }
  [[gnu::noinline]] void forward_dynamics(std::size_t k) {
    typename M::Multipliers none;
    if (M::forward_dynamics(precomputed, states[k], inputs[k], results[k], none) != torsor::Status::ok) ++failures;
  }

  std::vector<double> result(Quantity quantity) const {
    std::vector<double> numbers;
    switch (quantity) {
      case Quantity::inverse_dynamics:
        for (int i = 0; i < n; ++i) numbers.push_back(static_cast<double>(forces[last][i]));
        break;
      case Quantity::mass_matrix:
        for (const Scalar entry : masses[last]) numbers.push_back(static_cast<double>(entry));
        break;
      case Quantity::forward_dynamics:
        if (failures > 0) throw std::runtime_error("forward dynamics found a singular mass matrix");
        for (int i = 0; i < n; ++i) numbers.push_back(static_cast<double>(results[last][i]));
        break;
    }
    return numbers;
  }

  typename M::Precomputed precomputed = M::precompute(M::default_parameters());
  std::vector<typename M::State> states;
  std::vector<typename M::Accelerations> accelerations;
  std::vector<typename M::Inputs> inputs;
  std::vector<typename M::GeneralizedForces> forces;
  std::vector<typename M::Accelerations> results;
  std::vector<std::array<Scalar, n * n>> masses;
  std::size_t last = 0, failures = 0;
};

template <class Scalar>
Way way(Quantity quantity, const Batch& batch, const char* scalar) {
  const auto all = std::make_shared<Kernels<Scalar>>(batch);
  // A loop for each kernel: what is timed holds no choice between them.
  const auto loop = [all](auto kernel) {
    return [all, kernel](std::size_t first, std::size_t end) {
      for (std::size_t k = first; k < end; ++k) (all.get()->*kernel)(k);
      all->last = end - 1;
    };
  };
  Way result{"torsor",     MODEL_OPTIONS,
             scalar,       kernels::name_of(quantity),
             {},           [all, quantity] { return all->result(quantity); },
             MODEL_WITHOUT};
  if (quantity == Quantity::inverse_dynamics) result.run = loop(&Kernels<Scalar>::inverse_dynamics);
  if (quantity == Quantity::mass_matrix) result.run = loop(&Kernels<Scalar>::mass_matrix);
  if (quantity == Quantity::forward_dynamics) result.run = loop(&Kernels<Scalar>::forward_dynamics);
  return result;
}

std::vector<Way> ways(Quantity quantity, const Batch& batch) {
  std::vector<Way> ways = {way<double>(quantity, batch, "double")};
  if (std::string(MODEL_WITHOUT).empty()) ways.push_back(way<float>(quantity, batch, "float"));
  return ways;
}

}  // namespace

#define JOINED(left, right) JOINED_AS_WRITTEN(left, right)
#define JOINED_AS_WRITTEN(left, right) left##right

kernels::Measured JOINED(measured_, MODEL)() { return {MODEL_NAME, MODEL_WITHOUT, MODEL_HEADER, ways}; }

}  // namespace MODEL_BUILD
