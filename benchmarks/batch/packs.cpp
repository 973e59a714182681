// SPDX-License-Identifier: GPL-3.0-or-later
// Compiled for this processor, once for each kind of registers by each compiler. The build defines MODEL_HEADER and
// MODEL_OPTIONS, and of each PACKED_WAYS, the function, PACKED_REGISTERS, its name for people, and PACKED_BYTES, how many
// a pack has. The namespaces are renamed for each, so that no linker takes one's functions for another's.
#include <algorithm>
#include <array>
#include <memory>
#include <stdexcept>
#include <string>

#define torsor PACKED_NAMESPACE
#define panda PACKED_MECHANISM
#include MODEL_HEADER
#include "torsor/runtime/batch/batch.hpp"

#include "benchmarks/kernels/batch.hpp"
#include "benchmarks/kernels/way.hpp"

namespace {

using kernels::Batch;
using kernels::Quantity;
using kernels::Way;

template <class Number>
constexpr int pack_lanes = PACKED_BYTES / static_cast<int>(sizeof(Number));

/// The states of a batch and the results of kernels, in packs.
template <class Number>
struct Packs {
  using Arms = torsor::runtime::BatchOf<panda::Mechanism, Number, pack_lanes<Number>>;
  using M = typename Arms::Packed;
  static constexpr int n = M::coordinate_count;
  static constexpr std::size_t lanes = pack_lanes<Number>;

  explicit Packs(const Batch& batch)
      : states(batch.states),
        accelerations(batch.states),
        inputs(batch.states),
        forces(batch.states),
        results(batch.states),
        masses(batch.states) {
    for (std::size_t k = 0; k < batch.states; ++k) {
      typename Arms::Single::State state{};
      typename Arms::Single::Accelerations a{};
      typename Arms::Single::Inputs u{};
      for (int i = 0; i < n; ++i) {
        const auto place = static_cast<std::size_t>(i);
        state.q[i] = static_cast<Number>(batch.of(batch.q, k)[place]);
        state.v[i] = static_cast<Number>(batch.of(batch.v, k)[place]);
        a[i] = static_cast<Number>(batch.of(batch.a, k)[place]);
        u[i] = static_cast<Number>(batch.of(batch.tau, k)[place]);
      }
      states.set(k, state);
      accelerations.set(k, a);
      inputs.set(k, u);
    }
  }

  // Functions of their own, as for the single kernels.
  [[gnu::noinline]] void inverse_dynamics(std::size_t b) {
    M::inverse_dynamics(arms.packed(), states.block(b), accelerations.block(b), {}, forces.block(b));
  }
  [[gnu::noinline]] void mass_matrix(std::size_t b) { M::mass_matrix(arms.packed(), states.block(b), masses.block(b)); }
  [[gnu::noinline]] void forward_dynamics(std::size_t b) {
    typename M::Multipliers none;
    if (M::forward_dynamics(arms.packed(), states.block(b), inputs.block(b), results.block(b), none) !=
        torsor::Status::ok)
      ++failures;
  }

  std::vector<double> result(Quantity quantity) const {
    switch (quantity) {
      case Quantity::inverse_dynamics:
        return last_of(forces);
      case Quantity::mass_matrix:
        return last_of(masses);
      case Quantity::forward_dynamics:
        break;
    }
    if (failures > 0) throw std::runtime_error("forward dynamics found a singular mass matrix");
    return last_of(results);
  }
  template <class Results>
  std::vector<double> last_of(const Results& all) const {
    std::vector<double> numbers;
    for (std::size_t k = 0; k < Results::entries(); ++k) numbers.push_back(static_cast<double>(all.entry(last, k)));
    return numbers;
  }

  Arms arms;
  typename Arms::States states;
  typename Arms::Accelerations accelerations;
  typename Arms::Inputs inputs;
  typename Arms::Forces forces;
  typename Arms::Accelerations results;
  typename Arms::template Arrays<n * n> masses;
  std::size_t last = 0, failures = 0;
};

template <class Number>
Way way(Quantity quantity, const Batch& batch, const char* scalar) {
  const auto all = std::make_shared<Packs<Number>>(batch);
  const auto loop = [all](auto kernel) {
    // Whole packs, those of the first and the last state included
    return [all, kernel](std::size_t first, std::size_t end) {
      for (std::size_t b = first / all->lanes; b * all->lanes < end; ++b) (all.get()->*kernel)(b);
      all->last = end - 1;
    };
  };
  Way result{"torsor, packs of " + std::to_string(pack_lanes<Number>) + " (" PACKED_REGISTERS ")",
             MODEL_OPTIONS,
             scalar,
             kernels::name_of(quantity),
             {},
             [all, quantity] { return all->result(quantity); }};
  if (quantity == Quantity::inverse_dynamics) result.run = loop(&Packs<Number>::inverse_dynamics);
  if (quantity == Quantity::mass_matrix) result.run = loop(&Packs<Number>::mass_matrix);
  if (quantity == Quantity::forward_dynamics) result.run = loop(&Packs<Number>::forward_dynamics);
  return result;
}

}  // namespace

std::vector<Way> PACKED_WAYS(Quantity quantity, const Batch& batch) {
  return {way<double>(quantity, batch, "double"), way<float>(quantity, batch, "float")};
}
