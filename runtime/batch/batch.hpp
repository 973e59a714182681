// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <initializer_list>
#include <span>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "torsor/runtime/batch/parallel.hpp"
#include "torsor/runtime/batch/simd.hpp"
#include "torsor/runtime/mechanism.hpp"
#include "torsor/runtime/status.hpp"

namespace torsor::runtime {

/// One structure of a generated mechanism (State, Inputs, Accelerations, ...) for many states. They are stored block by
/// block: a block is that structure over a pack, hence the same entry of `lanes` consecutive states side by side, and
/// its entries follow each other. So a kernel reads a block as it is, from one stretch of memory.
/// `Single` and `Packed` are the structure over Number and over Simd<Number, lanes>: both hold scalars and nothing
/// else.
template <class Single, class Packed, class Number, int lane_count>
class Batch {
  static_assert(std::is_trivially_copyable_v<Single> && std::is_standard_layout_v<Single>);
  static constexpr std::size_t entry_count = std::is_empty_v<Single> ? 0 : sizeof(Single) / sizeof(Number);
  static constexpr std::size_t lanes = lane_count;
  static_assert(entry_count == 0 || (sizeof(Single) == entry_count * sizeof(Number) &&
                                     sizeof(Packed) == entry_count * sizeof(Simd<Number, lane_count>)),
                "a structure of scalars only");

 public:
  using Value = Single;
  using Block = Packed;

  /// All of them `value`.
  explicit Batch(std::size_t size, const Single& value = Single{}) : size_(size), blocks_((size + lanes - 1) / lanes) {
    for (std::size_t i = 0; i < blocks_.size() * lanes; ++i) put(i, value);
  }

  [[nodiscard]] std::size_t size() const noexcept { return size_; }
  [[nodiscard]] static constexpr std::size_t entries() noexcept { return entry_count; }

  [[nodiscard]] Single operator[](std::size_t i) const noexcept {
    Single value{};
    for (std::size_t k = 0; k < entry_count; ++k) {
      const Number number = entry(i, k);
      std::memcpy(reinterpret_cast<char*>(&value) + k * sizeof(Number), &number, sizeof(Number));
    }
    return value;
  }
  void set(std::size_t i, const Single& value) noexcept {
    put(i, value);
    // Lanes beyond the last state repeat it: what is computed there is thrown away, but must not cost more.
    if (i + 1 == size_) {
      for (std::size_t lane = size_; lane < blocks_.size() * lanes; ++lane) put(lane, value);
    }
  }

  /// The k-th scalar of the structure, in the order in which the header declares them.
  [[nodiscard]] Number entry(std::size_t i, std::size_t k) const noexcept {
    Number number;
    std::memcpy(&number, address(i, k), sizeof(Number));
    return number;
  }
  void set_entry(std::size_t i, std::size_t k, Number number) noexcept {
    std::memcpy(const_cast<char*>(address(i, k)), &number, sizeof(Number));
  }

  /// The block of a value in all lanes.
  [[nodiscard]] static Packed repeated(const Single& value) noexcept {
    Packed block{};
    for (std::size_t k = 0; k < entry_count; ++k) {
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        std::memcpy(reinterpret_cast<char*>(&block) + (k * lanes + lane) * sizeof(Number),
                    reinterpret_cast<const char*>(&value) + k * sizeof(Number), sizeof(Number));
      }
    }
    return block;
  }
  /// State i becomes what its lane of such a block is.
  void set_from(std::size_t i, const Packed& block) noexcept {
    for (std::size_t k = 0; k < entry_count; ++k) {
      std::memcpy(const_cast<char*>(address(i, k)),
                  reinterpret_cast<const char*>(&block) + (k * lanes + i % lanes) * sizeof(Number), sizeof(Number));
    }
  }

  [[nodiscard]] std::size_t block_count() const noexcept { return blocks_.size(); }
  [[nodiscard]] Packed& block(std::size_t b) noexcept { return blocks_[b]; }
  [[nodiscard]] const Packed& block(std::size_t b) const noexcept { return blocks_[b]; }

 private:
  [[nodiscard]] const char* address(std::size_t i, std::size_t k) const noexcept {
    return reinterpret_cast<const char*>(&blocks_[i / lanes]) + (k * lanes + i % lanes) * sizeof(Number);
  }
  void put(std::size_t i, const Single& value) noexcept {
    for (std::size_t k = 0; k < entry_count; ++k) {
      Number number;
      std::memcpy(&number, reinterpret_cast<const char*>(&value) + k * sizeof(Number), sizeof(Number));
      set_entry(i, k, number);
    }
  }

  std::size_t size_;
  std::vector<Packed> blocks_;
};

struct BatchOptions {
  unsigned threads = 1;              ///< 0: as many as the processor runs at once; results do not depend on it
  std::span<Evaluation> statuses{};  ///< if not empty, one for each state: what the kernel says of it
};

/// How many states a kernel failed for, and the worst of what it said.
struct BatchReport {
  std::size_t failed = 0;
  Evaluation worst = Evaluation::ok;
  [[nodiscard]] explicit operator bool() const noexcept { return failed == 0; }
};

/// The kernels of a generated mechanism for many states at once: `BatchOf<arm7::Mechanism, double> arm;`.
/// Every block of `lanes` states takes the same path through the same instructions, the last and incomplete one too, so
/// that a state's results depend neither on its place, nor on its neighbours, nor on the number of threads.
template <template <class> class Mechanism, class Number, int lanes = native_lanes<Number>>
class BatchOf {
 public:
  using Single = Mechanism<Number>;
  using Packed = Mechanism<Simd<Number, lanes>>;
  template <class Value, class Block>
  using Of = Batch<Value, Block, Number, lanes>;
  using States = Of<typename Single::State, typename Packed::State>;
  using Inputs = Of<typename Single::Inputs, typename Packed::Inputs>;
  using Accelerations = Of<typename Single::Accelerations, typename Packed::Accelerations>;
  using Multipliers = Of<typename Single::Multipliers, typename Packed::Multipliers>;
  using Forces = Of<typename Single::GeneralizedForces, typename Packed::GeneralizedForces>;
  using Parameters = Of<typename Single::Parameters, typename Packed::Parameters>;
  template <std::size_t count>
  using Arrays = Of<std::array<Number, count>, std::array<Simd<Number, lanes>, count>>;

  explicit BatchOf(const typename Single::Parameters& parameters = Single::default_parameters())
      : single_(Single::precompute(parameters)), packed_(Packed::precompute(broadcast(parameters))) {}

  /// Calls `kernel(std::type_identity<M>{}, precomputed, values...)` for every block of the batches, with M = Packed.
  /// The kernel returns nothing, or a status. Where the status of a block is not 0, the kernel is called once more
  /// for each state of the block, with that state in all lanes. Its status and its results are then those of that
  /// state. So neither depends on the neighbours, and a kernel may return before it has written everything. It must
  /// not read its own results: they are not the same at the second call. A state that fails keeps the results that
  /// its call has left.
  /// Throws std::invalid_argument when the batches, or the statuses, are not of one size.
  template <class Kernel, class... Batches>
  BatchReport for_each(const Kernel& kernel, const BatchOptions& options, Batches&... batches) const {
    require_one_size(options, {batches.size()...});
    const std::size_t blocks = std::get<0>(std::tie(batches...)).block_count();
    const unsigned parts = thread_count(options.threads);
    std::vector<BatchReport> reports(parts);
    in_parts(blocks, parts, [&](std::size_t part, std::size_t first, std::size_t end) {
      BatchReport report;
      for (std::size_t b = first; b < end; ++b) evaluate(kernel, options, b, report, batches...);
      reports[part] = report;
    });
    BatchReport total;
    for (const BatchReport& report : reports) {
      total.failed += report.failed;
      total.worst = std::max(total.worst, report.worst);
    }
    return total;
  }

  /// M a + h = E u + Aᵀλ, solved for a and λ.
  BatchReport forward_dynamics(const States& states, const Inputs& inputs, Accelerations& a, Multipliers& lambda,
                               const BatchOptions& options = {}) const {
    const auto kernel = []<class M>(std::type_identity<M>, const typename M::Precomputed& precomputed,
                                    const typename M::State& state, const typename M::Inputs& u,
                                    typename M::Accelerations& acceleration, typename M::Multipliers& multipliers) {
      return M::forward_dynamics(precomputed, state, u, acceleration, multipliers);
    };
    return for_each(kernel, options, states, inputs, a, lambda);
  }

  /// M a + h - Aᵀλ. The kernel has no status: a state has failed where one of its forces is not a finite number.
  BatchReport inverse_dynamics(const States& states, const Accelerations& a, const Multipliers& lambda, Forces& forces,
                               const BatchOptions& options = {}) const {
    const auto kernel = []<class M>(std::type_identity<M>, const typename M::Precomputed& precomputed,
                                    const typename M::State& state, const typename M::Accelerations& acceleration,
                                    const typename M::Multipliers& multipliers, typename M::GeneralizedForces& result) {
      M::inverse_dynamics(precomputed, state, acceleration, multipliers, result);
      // 0 x is 0 for every finite x and not a number for any other.
      ScalarOf<M> zero(Number(0));
      for (int i = 0; i < M::velocity_count; ++i) zero = zero + ScalarOf<M>(Number(0)) * result[i];
      return zero <= ScalarOf<M>(Number(0)) ? Evaluation::ok : Evaluation::not_finite;
    };
    return for_each(kernel, options, states, a, lambda, forces);
  }

  [[nodiscard]] const typename Single::Precomputed& single() const noexcept { return single_; }
  [[nodiscard]] const typename Packed::Precomputed& packed() const noexcept { return packed_; }

 private:
  static typename Packed::Parameters broadcast(const typename Single::Parameters& parameters) {
    return Parameters::repeated(parameters);
  }

  static void require_one_size(const BatchOptions& options, std::initializer_list<std::size_t> sizes) {
    const std::size_t size = *sizes.begin();
    for (const std::size_t other : sizes) {
      if (other != size) {
        throw std::invalid_argument("BatchOf: one batch holds " + std::to_string(size) + " states and another " +
                                    std::to_string(other) + "; give them one size");
      }
    }
    if (!options.statuses.empty() && options.statuses.size() != size) {
      throw std::invalid_argument("BatchOf: there are " + std::to_string(options.statuses.size()) + " statuses for " +
                                  std::to_string(size) + " states; give one for each, or none");
    }
  }

  template <class Kernel, class... Batches>
  void evaluate(const Kernel& kernel, const BatchOptions& options, std::size_t b, BatchReport& report,
                Batches&... batches) const {
    using Outcome = decltype(kernel(std::type_identity<Packed>{}, packed_, batches.block(b)...));
    if constexpr (std::is_void_v<Outcome>) {
      kernel(std::type_identity<Packed>{}, packed_, batches.block(b)...);
      settle(options, b, size_of(batches...));
    } else if (to_evaluation(kernel(std::type_identity<Packed>{}, packed_, batches.block(b)...)) == Evaluation::ok) {
      settle(options, b, size_of(batches...));
    } else {
      ask_each(kernel, options, b, report, batches...);
    }
  }

  template <class First, class... Others>
  static std::size_t size_of(const First& first, const Others&...) noexcept {
    return first.size();
  }

  static void settle(const BatchOptions& options, std::size_t b, std::size_t size) noexcept {
    if (options.statuses.empty()) return;
    for (std::size_t i = b * lanes; i < std::min(size, (b + 1) * lanes); ++i) options.statuses[i] = Evaluation::ok;
  }

  template <class Kernel, class... Batches>
  void ask_each(const Kernel& kernel, const BatchOptions& options, std::size_t b, BatchReport& report,
                Batches&... batches) const {
    const std::size_t end = std::min(size_of(batches...), (b + 1) * lanes);
    for (std::size_t i = b * lanes; i < end; ++i) {
      std::tuple blocks{Batches::repeated(batches[i])...};
      const Evaluation evaluation = std::apply(
          [&](auto&... block) {
            const Evaluation said = to_evaluation(kernel(std::type_identity<Packed>{}, packed_, block...));
            (keep(batches, i, block), ...);
            return said;
          },
          blocks);
      if (!options.statuses.empty()) options.statuses[i] = evaluation;
      if (evaluation == Evaluation::ok) continue;
      ++report.failed;
      report.worst = std::max(report.worst, evaluation);
    }
  }

  template <class Values>
  static void keep(Values& values, std::size_t i, const typename std::remove_const_t<Values>::Block& block) noexcept {
    if constexpr (!std::is_const_v<Values>) values.set_from(i, block);
  }

  typename Single::Precomputed single_;
  typename Packed::Precomputed packed_;
};

}  // namespace torsor::runtime
