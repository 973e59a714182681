// SPDX-License-Identifier: GPL-3.0-or-later
// Compiled for this processor, as ensemble.cpp is. The build defines MODEL_HEADER.
#include "benchmarks/batch/threads.hpp"

#include <chrono>
#include <set>
#include <stdexcept>
#include <thread>

#include MODEL_HEADER
#include "benchmarks/kernels/batch.hpp"
#include "torsor/runtime/batch/batch.hpp"

namespace {

/// All states' forward dynamics.
template <class Number>
class LargeBatch {
 public:
  using Arms = torsor::runtime::BatchOf<panda::Mechanism, Number>;
  using Single = typename Arms::Single;

  explicit LargeBatch(const kernels::Batch& batch)
      : states_(batch.states), inputs_(batch.states), accelerations_(batch.states), multipliers_(batch.states) {
    for (std::size_t k = 0; k < batch.states; ++k) {
      typename Single::State state{};
      typename Single::Inputs inputs{};
      for (int i = 0; i < Single::coordinate_count; ++i) {
        const auto place = static_cast<std::size_t>(i);
        state.q[i] = static_cast<Number>(batch.of(batch.q, k)[place]);
        state.v[i] = static_cast<Number>(batch.of(batch.v, k)[place]);
        inputs[i] = static_cast<Number>(batch.of(batch.tau, k)[place]);
      }
      states_.set(k, state);
      inputs_.set(k, inputs);
    }
  }

  void run(unsigned threads) {
    if (!arms_.forward_dynamics(states_, inputs_, accelerations_, multipliers_, {.threads = threads}))
      throw std::runtime_error("threads: forward dynamics found a singular mass matrix");
  }
  std::vector<Number> results() const {
    std::vector<Number> numbers;
    for (std::size_t i = 0; i < accelerations_.size(); ++i) {
      for (std::size_t k = 0; k < accelerations_.entries(); ++k) numbers.push_back(accelerations_.entry(i, k));
    }
    return numbers;
  }

 private:
  Arms arms_;
  typename Arms::States states_;
  typename Arms::Inputs inputs_;
  typename Arms::Accelerations accelerations_;
  typename Arms::Multipliers multipliers_;
};

template <class Number>
void measure(const kernels::Batch& batch, int turns, const char* scalar, std::vector<ThreadTimes>& all) {
  const std::set<unsigned> counts{1, 2, torsor::runtime::thread_count(0)};
  LargeBatch<Number> large(batch);
  large.run(1);
  const std::vector<Number> expected = large.results();
  for (const unsigned threads : counts) {
    large.run(threads);
    if (large.results() != expected)
      throw std::runtime_error("threads: results on " + std::to_string(threads) + " threads are not those on one");
  }
  std::vector<std::vector<double>> nanoseconds(counts.size()), ratios(counts.size());
  for (int turn = 0; turn < turns; ++turn) {
    std::size_t i = 0;
    for (const unsigned threads : counts) {
      using Clock = std::chrono::steady_clock;
      const auto start = Clock::now();
      large.run(threads);
      const std::chrono::duration<double, std::nano> taken = Clock::now() - start;
      nanoseconds[i].push_back(taken.count() / static_cast<double>(batch.states));
      ratios[i].push_back(nanoseconds[i].back() / nanoseconds[0].back());
      ++i;
    }
  }
  std::size_t i = 0;
  for (const unsigned threads : counts) {
    all.push_back({threads,
                   scalar,
                   torsor::runtime::native_lanes<Number>,
                   {kernels::spread_of(nanoseconds[i]), kernels::spread_of(ratios[i])}});
    ++i;
  }
}

}  // namespace

std::vector<ThreadTimes> thread_times(std::size_t states, int turns) {
  const kernels::Batch batch = kernels::random_batch(panda::Mechanism<double>::coordinate_count, states);
  std::vector<ThreadTimes> all;
  measure<double>(batch, turns, "double", all);
  measure<float>(batch, turns, "float", all);
  return all;
}
