// SPDX-License-Identifier: GPL-3.0-or-later
// Compiled with HEADER, MECHANISM and REAL for any processor: prints, of every kernel at some states, 64 bits (FNV-1a)
// of all its results. What is not a number has many bit patterns and counts as one. With LANES, a power of two up to 4, the
// states go through packs of so many.
#include <array>
#include <cstdint>
#include <tuple>
#include <type_traits>

#include HEADER

#if defined(LANES)
#include "torsor/runtime/batch/simd.hpp"
#else
#define LANES 1
#endif

#if defined(BARE)
extern "C" void say(const char* text);
#else
#include <cstdio>
static void say(const char* text) { std::fputs(text, stdout); }
#endif

namespace {

using Real = REAL;
constexpr int lanes = LANES, states = 4;
static_assert(states % lanes == 0);
#if LANES > 1
using Scalar = torsor::runtime::Simd<Real, lanes>;
#else
using Scalar = Real;
#endif
using M = MECHANISM::Mechanism<Scalar>;
using Bits = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;

struct Hash {
  std::uint64_t value = 0xcbf29ce484222325ULL;

  void add(std::uint64_t bits) {
    for (int byte = 0; byte < 8; ++byte) value = (value ^ ((bits >> (8 * byte)) & 255U)) * 0x100000001b3ULL;
  }
  template <class T>
  void add_numbers(const T& numbers, int lane) {
    if constexpr (!std::is_empty_v<T>) {
      static_assert(sizeof(T) % sizeof(Scalar) == 0, "results hold nothing but numbers");
      Real all[sizeof(T) / sizeof(Real)];
      __builtin_memcpy(all, &numbers, sizeof(T));
      for (unsigned k = static_cast<unsigned>(lane); k < sizeof(T) / sizeof(Real); k += lanes) {
        Bits bits;
        __builtin_memcpy(&bits, &all[k], sizeof(Bits));
        add(all[k] == all[k] ? bits : 0x7fffffffU);
      }
    }
  }
  void print(const char* name, int state) const {
    char text[24] = {' ', static_cast<char>('0' + state), ' '};
    for (int digit = 0; digit < 16; ++digit) text[3 + digit] = "0123456789abcdef"[(value >> (60 - 4 * digit)) & 15U];
    text[19] = '\n';
    say(name);
    say(text);
  }
};

constexpr int order = 4;  // of Taylor coefficients

/// In (-1, 1), with 20 bits.
struct Random {
  std::uint32_t state = 1;
  Real next() {
    state = state * 1664525U + 1013904223U;
    return static_cast<Real>(static_cast<std::int32_t>(state >> 11) - (1 << 20)) * static_cast<Real>(0x1p-20f);
  }
};

/// What is added to the initial state, and what else is given.
struct Drawn {
  Real time{};
  std::array<Real, M::coordinate_count + 1> q{};  // no array of no numbers
  std::array<Real, M::velocity_count + 1> v{}, accelerations{};
  std::array<Real, M::multiplier_count + 1> multipliers{};
  std::array<Real, M::input_count + 1> inputs{};

  void draw(Random& random, Real spread) {
    const auto fill = [&](Real factor, int count, Real* numbers) {
      for (int i = 0; i < count; ++i) numbers[i] = factor * random.next();
    };
    time = random.next();
    fill(spread, M::coordinate_count, q.data());
    fill(1, M::velocity_count, v.data());
    fill(1, M::velocity_count, accelerations.data());
    fill(1, M::multiplier_count, multipliers.data());
    fill(1, M::input_count, inputs.data());
  }
};

using Chosen = std::array<const Drawn*, lanes>;

/// What kernels read, a state in each lane.
struct Given {
  M::State state = M::initial_state();
  M::Accelerations accelerations{};
  M::Multipliers multipliers{};
  M::Inputs inputs{};
  M::Precomputed precomputed = M::precompute(M::default_parameters());

  explicit Given(const Chosen& chosen) {
    const auto packed = [&](const auto& number) {
      Real numbers[lanes];
      for (int lane = 0; lane < lanes; ++lane) numbers[lane] = number(*chosen[static_cast<unsigned>(lane)]);
      Scalar all{};
      static_assert(sizeof(all) == sizeof(numbers), "a pack is its numbers and nothing else");
      __builtin_memcpy(static_cast<void*>(&all), numbers, sizeof(all));
      return all;
    };
    const auto fill = [&](int count, const auto& member, auto& to) {
      for (int i = 0; i < count; ++i) {
        to[i] = to[i] + packed([&](const Drawn& of) { return (of.*member)[static_cast<unsigned>(i)]; });
      }
    };
    state.time = state.time + packed([](const Drawn& of) { return of.time; });
    fill(M::coordinate_count, &Drawn::q, state.q);
    fill(M::velocity_count, &Drawn::v, state.v);
    fill(M::velocity_count, &Drawn::accelerations, accelerations);
    fill(M::multiplier_count, &Drawn::multipliers, multipliers);
    fill(M::input_count, &Drawn::inputs, inputs);
  }
};

/// An argument behind the state: it is given, or it holds a result.
template <class Argument>
struct Held;
template <class T>
struct Held<const T&> {
  const Given& given;
  const T& get() const {
    if constexpr (std::is_same_v<T, M::Accelerations>)
      return given.accelerations;
    else if constexpr (std::is_same_v<T, M::Multipliers>)
      return given.multipliers;
    else
      return given.inputs;
  }
  void add(Hash&, int) const {}
};
template <class T>
struct Held<T&> {
  const Given& given;
  T value{};
  T& get() { return value; }
  void add(Hash& hash, int lane) const { hash.add_numbers(value, lane); }
};
template <>
struct Held<int> {
  const Given& given;
  int get() const { return order; }
  void add(Hash&, int) const {}
};
template <class T>
struct Held<T*> {
  const Given& given;
  std::array<T, order + 1> value{};
  T* get() { return value.data(); }
  void add(Hash& hash, int lane) const { hash.add_numbers(value, lane); }
};

struct Evaluation {
  const Given& given;
  const Drawn* drawn;  ///< of the first lane
  int number;          ///< its state's

  template <class Code, class... Arguments>
  void operator()(const torsor::KernelDescription& kernel,
                  Code (*function)(const M::Precomputed&, const M::State&, Arguments...)) const {
    std::array<Hash, lanes> hashes;
    [[maybe_unused]] const int code = evaluate(function, given, hashes);
    if constexpr (lanes > 1) {
      // What is said of a pack is the worst of its states: each alone, in all lanes.
      for (unsigned lane = 0; code != 0 && lane < lanes; ++lane) {
        std::array<Hash, lanes> own;
        Chosen chosen;
        chosen.fill(drawn + lane);
        const Given alone(chosen);
        evaluate(function, alone, own);
        hashes[lane] = own[0];
      }
    }
    for (int lane = 0; lane < lanes; ++lane) hashes[static_cast<unsigned>(lane)].print(kernel.name, number + lane);
  }

 private:
  template <class Code, class... Arguments>
  static int evaluate(Code (*function)(const M::Precomputed&, const M::State&, Arguments...), const Given& given,
                      std::array<Hash, lanes>& hashes) {
    std::tuple<Held<Arguments>...> held{Held<Arguments>{given}...};
    return std::apply(
        [&](auto&... each) {
          int code = 0;
          if constexpr (std::is_void_v<Code>) {
            function(given.precomputed, given.state, each.get()...);
          } else {
            code = static_cast<int>(function(given.precomputed, given.state, each.get()...));
          }
          for (int lane = 0; lane < lanes; ++lane) {
            Hash& hash = hashes[static_cast<unsigned>(lane)];
            if (!std::is_void_v<Code>) hash.add(static_cast<std::uint64_t>(code));
            (each.add(hash, lane), ...);
          }
          return code;
        },
        held);
  }
};

}  // namespace

int main() {
  Random random;
  // Near the initial state, then with angles beyond those that the short reduction takes, in float and in double.
  const Real spreads[states] = {static_cast<Real>(0.5f), 2, 3000, static_cast<Real>(0x1p40f)};
  static Drawn drawn[states];
  for (int i = 0; i < states; ++i) drawn[i].draw(random, spreads[i]);
  for (int i = 0; i < states; i += lanes) {
    Chosen chosen;
    for (int lane = 0; lane < lanes; ++lane) chosen[static_cast<unsigned>(lane)] = drawn + i + lane;
    const Given given(chosen);
    M::for_each_kernel(Evaluation{given, drawn + i, i});
  }
  return 0;
}
