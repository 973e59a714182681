// SPDX-License-Identifier: GPL-3.0-or-later
// Compiled with HEADER, MECHANISM and REAL for any processor: prints, of every kernel at some states, 64 bits (FNV-1a)
// of all its results. What is not a number has many bit patterns and counts as one.
#include <array>
#include <cstdint>
#include <tuple>
#include <type_traits>

#include HEADER

#if defined(BARE)
extern "C" void say(const char* text);
#else
#include <cstdio>
static void say(const char* text) { std::fputs(text, stdout); }
#endif

namespace {

using Real = REAL;
using M = MECHANISM::Mechanism<Real>;
using Bits = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;

struct Hash {
  std::uint64_t value = 0xcbf29ce484222325ULL;

  void add(std::uint64_t bits) {
    for (int byte = 0; byte < 8; ++byte) value = (value ^ ((bits >> (8 * byte)) & 255U)) * 0x100000001b3ULL;
  }
  template <class T>
  void add_numbers(const T& numbers) {
    if constexpr (!std::is_empty_v<T>) {
      static_assert(sizeof(T) % sizeof(Real) == 0, "results hold nothing but numbers");
      Real all[sizeof(T) / sizeof(Real)];
      __builtin_memcpy(all, &numbers, sizeof(T));
      for (const Real& each : all) {
        Bits bits;
        __builtin_memcpy(&bits, &each, sizeof(Bits));
        add(each == each ? bits : 0x7fffffffU);
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

/// What kernels read.
struct Given {
  M::State state = M::initial_state();
  M::Accelerations accelerations{};
  M::Multipliers multipliers{};
  M::Inputs inputs{};
  M::Precomputed precomputed = M::precompute(M::default_parameters());
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
  void add(Hash&) const {}
};
template <class T>
struct Held<T&> {
  const Given& given;
  T value{};
  T& get() { return value; }
  void add(Hash& hash) const { hash.add_numbers(value); }
};
template <>
struct Held<int> {
  const Given& given;
  int get() const { return order; }
  void add(Hash&) const {}
};
template <class T>
struct Held<T*> {
  const Given& given;
  std::array<T, order + 1> value{};
  T* get() { return value.data(); }
  void add(Hash& hash) const { hash.add_numbers(value); }
};

struct Evaluation {
  const Given& given;
  int number;

  template <class Code, class... Arguments>
  void operator()(const torsor::KernelDescription& kernel,
                  Code (*function)(const M::Precomputed&, const M::State&, Arguments...)) const {
    std::tuple<Held<Arguments>...> held{Held<Arguments>{given}...};
    std::apply(
        [&](auto&... each) {
          Hash hash;
          if constexpr (std::is_void_v<Code>) {
            function(given.precomputed, given.state, each.get()...);
          } else {
            hash.add(static_cast<std::uint64_t>(function(given.precomputed, given.state, each.get()...)));
          }
          (each.add(hash), ...);
          hash.print(kernel.name, number);
        },
        held);
  }
};

/// In (-1, 1), with 20 bits.
struct Random {
  std::uint32_t state = 1;
  Real next() {
    state = state * 1664525U + 1013904223U;
    return static_cast<Real>(static_cast<std::int32_t>(state >> 11) - (1 << 20)) * static_cast<Real>(0x1p-20f);
  }
};

}  // namespace

int main() {
  Random random;
  // Near the initial state, then with angles beyond those that the short reduction takes, in float and in double.
  const Real spreads[] = {static_cast<Real>(0.5f), 2, 3000, static_cast<Real>(0x1p40f)};
  int number = 0;
  for (const Real spread : spreads) {
    Given given;
    given.state.time += random.next();
    for (int i = 0; i < M::coordinate_count; ++i) given.state.q[i] += spread * random.next();
    for (int i = 0; i < M::velocity_count; ++i) given.state.v[i] += random.next();
    for (int i = 0; i < M::velocity_count; ++i) given.accelerations[i] = random.next();
    for (int i = 0; i < M::multiplier_count; ++i) given.multipliers[i] = random.next();
    for (int i = 0; i < M::input_count; ++i) given.inputs[i] = random.next();
    M::for_each_kernel(Evaluation{given, number});
    ++number;
  }
  return 0;
}
