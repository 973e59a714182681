// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Every kernel of one generated header behind C functions, so that one program (states.cpp) can be linked with the
// kernels of any header at any level of optimisation. Include after the header; needs nothing else.
#include <array>
#include <tuple>
#include <type_traits>

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

template <class M>
using quaternions = decltype(M::quaternions[0]);
template <class Result>
using jacobian = decltype(Result::gamma, Result::jacobian);
template <class Result>
using columns = decltype(Result::columns);

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
  for (int i = 0; i < count; ++i) to[i] = in[i];
  return in + count;
}

/// What kernels read.
template <class M>
struct Given {
  typename M::State state{};
  typename M::Accelerations accelerations{};
  typename M::Multipliers multipliers{};
  typename M::Inputs inputs{};
  typename M::Precomputed precomputed{};

  explicit Given(const double* in) noexcept {
    auto parameters = M::default_parameters();
    state.time = *in++;
    in = read(in, M::coordinate_count, state.q);
    in = read(in, M::velocity_count, state.v);
    in = read(in, M::velocity_count, accelerations);
    in = read(in, M::multiplier_count, multipliers);
    in = read(in, M::input_count, inputs);
    read(in, M::parameter_count, parameters);
    precomputed = M::precompute(parameters);
  }
  operator const typename M::Accelerations&() const noexcept { return accelerations; }
  operator const typename M::Multipliers&() const noexcept { return multipliers; }
  operator const typename M::Inputs&() const noexcept { return inputs; }
};

constexpr int order = 8;  // of Taylor coefficients

/// An argument behind the state: it is given, or it holds a result, which it adds.
template <class M, class Argument>
struct Held;
template <class M, class T>
struct Held<M, const T&> {
  explicit Held(const Given<M>& given) noexcept : value(given) {}
  const T& get() noexcept { return value; }
  void add(Results&, const char*, int) noexcept {}
  static constexpr bool is_result = false;
  const T& value;
};
template <class M, class T>
struct Held<M, T&> {
  explicit Held(const Given<M>&) noexcept {}
  T& get() noexcept { return value; }
  void add(Results& results, const char* name, int code) noexcept {
    if constexpr (!std::is_empty<T>::value) results.add(name, code, value);
    // Once more by themselves, for the condition of the matrix that is solved with.
    if constexpr (Has<T, jacobian>::value) {
      results.add("constraint_jacobian", code, value.jacobian);
      if constexpr (Has<T, columns>::value) results.add("constraint_columns", code, value.columns);
    }
  }
  static constexpr bool is_result = true;
  T value{};
};
template <class M>
struct Held<M, int> {
  explicit Held(const Given<M>&) noexcept {}
  int get() noexcept { return order; }
  void add(Results&, const char*, int) noexcept {}
  static constexpr bool is_result = false;
};
template <class M, class T>
struct Held<M, T*> {
  explicit Held(const Given<M>&) noexcept {}
  T* get() noexcept { return value.data(); }
  void add(Results& results, const char* name, int code) noexcept {
    value[0] = {};  // the state again
    results.add(name, code, value);
  }
  static constexpr bool is_result = true;
  std::array<T, order + 1> value{};
};

/// Evaluates every kernel that it is shown. Its first result has the kernel's name, another one its own.
template <class M>
struct Evaluation {
  const Given<M>& given;
  Results& results;

  template <class Code, class... Arguments>
  void operator()(const torsor::KernelDescription& kernel,
                  Code (*function)(const typename M::Precomputed&, const typename M::State&, Arguments...)) noexcept {
    std::tuple<Held<M, Arguments>...> held{Held<M, Arguments>(given)...};
    std::apply(
        [&](auto&... each) {
          int code = -1;
          if constexpr (std::is_void<Code>::value) {
            function(given.precomputed, given.state, each.get()...);
          } else {
            code = static_cast<int>(function(given.precomputed, given.state, each.get()...));
          }
          const char* name = kernel.name;
          const char* last = kernel.result_count > 0 ? kernel.results[0].result : "";
          int next = 0;
          const auto add = [&](auto& one) {
            one.add(results, name, code);
            if (!one.is_result) return;
            while (next < kernel.result_count && same(kernel.results[next].result, last)) ++next;
            if (next < kernel.result_count) name = last = kernel.results[next].result;
          };
          (add(each), ...);
        },
        held);
  }

 private:
  static bool same(const char* a, const char* b) noexcept {
    for (; *a != 0 && *a == *b; ++a, ++b) {
    }
    return *a == *b;
  }
};

template <class M>
void evaluate(const double* in, Results& results) {
  const Given<M> given(in);
  M::for_each_kernel(Evaluation<M>{given, results});
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
  for (int i = 0; i < M::parameter_count; ++i) *in++ = parameters[i];
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
