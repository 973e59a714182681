// SPDX-License-Identifier: GPL-3.0-or-later
// Compiled for this processor: see CMakeLists.txt one folder up.
#include "benchmarks/batch/measured.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <vector>

#include "generated/arm7.hpp"
#include "runtime/batch.hpp"

namespace {

using torsor::runtime::BatchOf;
using torsor::runtime::native_lanes;

struct ForwardDynamics {
  static constexpr const char* name = "forward_dynamics";
  template <class M>
  using Result = typename M::Accelerations;
  template <class M>
  static int evaluate(const typename M::Precomputed& precomputed, const typename M::State& state,
                      const typename M::Inputs& inputs, Result<M>& result) {
    typename M::Multipliers none;
    return static_cast<int>(M::forward_dynamics(precomputed, state, inputs, result, none));
  }
};
struct Bias {
  static constexpr const char* name = "bias";
  template <class M>
  using Result = typename M::GeneralizedForces;
  template <class M>
  static int evaluate(const typename M::Precomputed& precomputed, const typename M::State& state,
                      const typename M::Inputs&, Result<M>& result) {
    M::bias(precomputed, state, result);
    return 0;
  }
};
struct MassMatrix {
  static constexpr const char* name = "mass_matrix";
  template <class M>
  using Result = std::array<torsor::runtime::ScalarOf<M>, 49>;
  template <class M>
  static int evaluate(const typename M::Precomputed& precomputed, const typename M::State& state,
                      const typename M::Inputs&, Result<M>& result) {
    M::mass_matrix(precomputed, state, result);
    return 0;
  }
};

/// The same states for single kernels, one structure after the other, and for packs.
template <class Kernel, class Number>
struct Table {
  using Arms = BatchOf<arm7::Mechanism, Number>;
  using Single = typename Arms::Single;
  using Packed = typename Arms::Packed;
  using Results =
      typename Arms::template Of<typename Kernel::template Result<Single>, typename Kernel::template Result<Packed>>;

  Arms arms;
  std::vector<typename Single::State> states;
  std::vector<typename Single::Inputs> inputs;
  std::vector<typename Kernel::template Result<Single>> results{table_size};
  typename Arms::States packed_states{table_size};
  typename Arms::Inputs packed_inputs{table_size};
  Results packed_results{table_size};

  Table() {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<Number> angle(Number(-3.2), Number(3.2)), rate(Number(-2), Number(2));
    for (int i = 0; i < table_size; ++i) {
      typename Single::State state{};
      typename Single::Inputs u{};
      for (int k = 0; k < Single::coordinate_count; ++k) state.q[k] = angle(random);
      for (int k = 0; k < Single::velocity_count; ++k) state.v[k] = rate(random);
      for (int k = 0; k < Single::input_count; ++k) u[k] = rate(random);
      states.push_back(state);
      inputs.push_back(u);
      packed_states.set(static_cast<std::size_t>(i), state);
      packed_inputs.set(static_cast<std::size_t>(i), u);
    }
  }
  static Table& only() {
    static Table table;
    return table;
  }

  static void one_by_one() {
    Table& t = only();
    for (std::size_t i = 0; i < table_size; ++i)
      Kernel::template evaluate<Single>(t.arms.single(), t.states[i], t.inputs[i], t.results[i]);
  }
  static void in_packs() {
    Table& t = only();
    const auto kernel = []<class M>(std::type_identity<M>, const typename M::Precomputed& precomputed,
                                    const typename M::State& state, const typename M::Inputs& u,
                                    typename Kernel::template Result<M>& result) {
      return static_cast<torsor::Status>(Kernel::template evaluate<M>(precomputed, state, u, result));
    };
    t.arms.for_each(kernel, {}, t.packed_states, t.packed_inputs, t.packed_results);
  }
  static double difference() {
    Table& t = only();
    double worst = 0, greatest = 0;
    constexpr std::size_t count = Results::entries();
    for (std::size_t i = 0; i < table_size; ++i) {
      Number row[count];
      std::memcpy(row, &t.results[i], sizeof row);
      for (std::size_t k = 0; k < count; ++k) {
        worst = std::max(worst, std::abs(double(row[k]) - double(t.packed_results.entry(i, k))));
        greatest = std::max(greatest, std::abs(double(row[k])));
      }
    }
    return worst / greatest;
  }
};

template <class Number>
constexpr const char* name_of = sizeof(Number) == sizeof(float) ? "float" : "double";

template <class Kernel, class Number>
constexpr Way single{Kernel::name, name_of<Number>, 1, Table<Kernel, Number>::one_by_one};
template <class Kernel, class Number>
constexpr Way packs{Kernel::name, name_of<Number>, native_lanes<Number>, Table<Kernel, Number>::in_packs};

template <class Kernel>
double difference(const char* scalar) {
  return std::strcmp(scalar, "float") == 0 ? Table<Kernel, float>::difference() : Table<Kernel, double>::difference();
}

}  // namespace

double worst_difference(const char* kernel, const char* scalar) {
  if (std::strcmp(kernel, Bias::name) == 0) return difference<Bias>(scalar);
  if (std::strcmp(kernel, MassMatrix::name) == 0) return difference<MassMatrix>(scalar);
  return difference<ForwardDynamics>(scalar);
}

std::span<const Way> ways() {
  static constexpr Way all[] = {single<ForwardDynamics, double>,
                                packs<ForwardDynamics, double>,
                                single<ForwardDynamics, float>,
                                packs<ForwardDynamics, float>,
                                single<Bias, double>,
                                packs<Bias, double>,
                                single<Bias, float>,
                                packs<Bias, float>,
                                single<MassMatrix, double>,
                                packs<MassMatrix, double>,
                                single<MassMatrix, float>,
                                packs<MassMatrix, float>};
  return all;
}
