// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "torsor/runtime/abi.h"
#include "torsor/runtime/abi/operands.hpp"
#include "torsor/runtime/abi/tiles.hpp"
#include "torsor/runtime/batch/parallel.hpp"
#include "torsor/runtime/batch/simd.hpp"

namespace torsor::runtime::abi {

/// Which states a block of a call holds: `count` from `first` on, and the last of them again in lanes that are left.
struct StatesOfBlock {
  std::size_t first, count;
};

/// Reads columns of `rows` numbers into packs, a state in each lane.
template <std::size_t rows, std::size_t lanes>
void read_any_columns(const torsor_view& from, StatesOfBlock states, double* to) noexcept {
  const char* const first =
      static_cast<const char*>(from.data) + static_cast<std::ptrdiff_t>(states.first) * from.state;
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    const char* const column = first + static_cast<std::ptrdiff_t>(std::min(lane, states.count - 1)) * from.state;
    for (std::size_t k = 0; k < rows; ++k) {
      std::memcpy(to + k * lanes + lane, column + static_cast<std::ptrdiff_t>(k) * from.row, sizeof(double));
    }
  }
}

/// The same, through registers where that is possible. Absent: zeros. `all`: states of the whole call.
template <std::size_t rows, std::size_t lanes>
void read_columns(const torsor_view& from, StatesOfBlock states, [[maybe_unused]] std::size_t all,
                  double* to) noexcept {
  if (from.data == nullptr) {
    std::fill_n(to, rows * lanes, 0.0);
    return;
  }
  const char* const first =
      static_cast<const char*>(from.data) + static_cast<std::ptrdiff_t>(states.first) * from.state;
  if (from.state == sizeof(double) && states.count == lanes) {  // packs already
    for (std::size_t k = 0; k < rows; ++k) {
      std::memcpy(to + k * lanes, first + static_cast<std::ptrdiff_t>(k) * from.row, lanes * sizeof(double));
    }
    return;
  }
  if constexpr (lanes > 1 && Tile<lanes>::in_registers) {
    if (from.row == sizeof(double) && states.count == lanes) {
      // Behind a column are those of later states, each a number at least, as long as there are enough of them.
      const bool beyond =
          from.state >= static_cast<std::ptrdiff_t>(rows * sizeof(double)) && states.first + 2 * lanes <= all;
      return columns_to_packs<rows, lanes>(first, from.state, beyond, to);
    }
  }
  read_any_columns<rows, lanes>(from, states, to);
}

struct MatrixShape {
  std::size_t rows, columns;
};

/// Writes a matrix of each of some states from packs that hold it column by column, the first in the first lane.
template <std::size_t lanes>
void write_matrices(const double* from, MatrixShape shape, StatesOfBlock states, const torsor_view& to) noexcept {
  const auto [rows, columns] = shape;
  char* const data = static_cast<char*>(to.data) + static_cast<std::ptrdiff_t>(states.first) * to.state;
  for (std::size_t lane = 0; lane < states.count; ++lane) {
    char* const matrix = data + static_cast<std::ptrdiff_t>(lane) * to.state;
    for (std::size_t j = 0; j < columns; ++j) {
      for (std::size_t i = 0; i < rows; ++i) {
        std::memcpy(matrix + static_cast<std::ptrdiff_t>(i) * to.row + static_cast<std::ptrdiff_t>(j) * to.column,
                    from + (j * rows + i) * lanes + lane, sizeof(double));
      }
    }
  }
}

/// The same for a shape that is known when this is compiled: through registers where matrices have no gaps.
template <std::size_t lanes, std::size_t rows, std::size_t columns>
void write_matrices_of(const double* from, StatesOfBlock states, const torsor_view& to) noexcept {
  if constexpr (lanes > 1 && Tile<lanes>::in_registers) {
    constexpr auto number = static_cast<std::ptrdiff_t>(sizeof(double));
    constexpr std::size_t numbers = rows * columns;
    if (states.count == lanes) {
      char* const data = static_cast<char*>(to.data) + static_cast<std::ptrdiff_t>(states.first) * to.state;
      if (to.state == number && numbers > 1) {  // packs already
        for (std::size_t k = 0; k < numbers; ++k) {
          std::memcpy(
              data + static_cast<std::ptrdiff_t>(k % rows) * to.row + static_cast<std::ptrdiff_t>(k / rows) * to.column,
              from + k * lanes, lanes * sizeof(double));
        }
        return;
      }
      if ((rows == 1 || to.row == number) &&
          (columns == 1 || to.column == static_cast<std::ptrdiff_t>(rows) * number)) {
        return packs_to_states<numbers, lanes>(
            from, [](std::size_t k) { return k; }, data, to.state);
      }
      if (to.column == number && to.row == static_cast<std::ptrdiff_t>(columns) * number) {
        return packs_to_states<numbers, lanes>(
            from, [](std::size_t k) { return k % columns * rows + k / columns; }, data, to.state);
      }
    }
  }
  write_matrices<lanes>(from, {rows, columns}, states, to);
}

/// Asks for the columns of a later block, so that they are there when it is read: what a kernel needs all at once
/// before it can begin would be waited for. Inlined: g++ drops calls of functions that only fetch.
template <std::size_t rows, std::size_t lanes>
TORSOR_SIMD_INLINED void fetch_columns(const torsor_view& from, std::size_t first, std::size_t states) noexcept {
#if defined(__GNUC__)
  constexpr std::ptrdiff_t line = 64, size = rows * sizeof(double);
  if (from.data == nullptr || from.row != sizeof(double) || from.state == 0 || first + lanes > states) return;
  const char* column = static_cast<const char*>(from.data) + static_cast<std::ptrdiff_t>(first) * from.state;
  if (from.state == size) {
    for (std::ptrdiff_t at = 0; at < static_cast<std::ptrdiff_t>(lanes) * size; at += line)
      __builtin_prefetch(column + at);
    return;
  }
  for (std::size_t lane = 0; lane < lanes; ++lane, column += from.state) {
    for (std::ptrdiff_t at = 0; at < size; at += line) __builtin_prefetch(column + at);
  }
#endif
}

/// Adds the numbers of each lane: the sum is finite only where all of them are.
template <class Scalar>
void add_numbers(const Scalar* numbers, std::size_t count, Scalar& sum) noexcept {
  for (std::size_t k = 0; k < count; ++k) sum = sum + numbers[k];
}

/// Whether all numbers of a lane are finite: x - x is 0, or not a number.
template <std::size_t lanes>
void find_not_finite(const double* numbers, std::size_t count, std::array<bool, lanes>& finite) noexcept {
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const double number = numbers[k * lanes + lane];
      finite[lane] = finite[lane] && number - number == 0.0;
    }
  }
}

/// Writes a result of packs.
using ResultWriter = void (*)(const double* from, StatesOfBlock states, const torsor_view& to) noexcept;

/// What the description says of a kernel, for its calls.
struct KernelShape {
  bool reads_accelerations = false, reads_multipliers = false, reads_inputs = false;
  const torsor_abi_result* results = nullptr;
  const ResultWriter* writers = nullptr;  ///< of packs, one for each result; null: its shape depends on the order
  std::size_t result_count = 0;
};

/// A kernel with its parameters.
template <class M>
struct KernelOfParameters {
  const AnyKernel<M>& kernel;
  const KernelShape& shape;
  const typename M::Precomputed& precomputed;
};

/// A kernel over a pack, or over numbers, at some states of a call.
template <class M, std::size_t lanes>
class BlockCall {
  static_assert(sizeof(ScalarOf<M>) == lanes * sizeof(double), "a pack is its numbers and nothing else");

 public:
  BlockCall(const KernelOfParameters<M>& of, const torsor_call& call, std::byte* results) noexcept
      : kernel_(of.kernel), shape_(of.shape), precomputed_(of.precomputed), call_(call), results_(results) {
    operands_.order = call.order;
  }

  /// Reads, evaluates and says which lanes have numbers that are not finite among their arguments. A kernel without a
  /// status of its own gets that of its results.
  int operator()(StatesOfBlock states, std::array<bool, lanes>& finite) noexcept {
    finite.fill(true);
    const Scalar sum = each_argument([&](const torsor_view& from, auto& to) { return read(from, to, states); });
    if (!(sum - sum >= Scalar(0.0))) {  // some number is not finite, or the sum alone
      each_argument([&](const torsor_view&, auto& to) {
        using Structure = std::remove_reference_t<decltype(to)>;
        find_not_finite<lanes>(reinterpret_cast<const double*>(&to), scalars_in<Structure, Scalar>, finite);
        return Scalar(0.0);
      });
    }
    const int status = kernel_.call(kernel_.function, precomputed_, operands_, results_);
    return status == torsor_state_ok && !results_are_finite() ? torsor_state_not_finite : status;
  }

  /// Of these states, the first in the first lane.
  void write(StatesOfBlock states) const noexcept {
    const double* from = reinterpret_cast<const double*>(results_);
    for (std::size_t r = 0; r < shape_.result_count; ++r) {
      const torsor_abi_result& result = shape_.results[r];
      const auto rows = static_cast<std::size_t>(result.rows);
      const auto columns = static_cast<std::size_t>(result.columns == 0 ? call_.order + 1 : result.columns);
      if (rows > 0 && call_.results[r].data != nullptr) {
        if (lanes > 1 && shape_.writers[r] != nullptr) {
          shape_.writers[r](from, states, call_.results[r]);
        } else {
          write_matrices<lanes>(from, {rows, columns}, states, call_.results[r]);
        }
      }
      from += rows * columns * lanes;
    }
  }

 private:
  using Scalar = ScalarOf<M>;

  [[nodiscard]] bool results_are_finite() const noexcept {
    const auto orders = static_cast<std::size_t>(kernel_.scalars_of_orders > 0 ? call_.order + 1 : 0);
    const std::size_t count = kernel_.scalars + orders * kernel_.scalars_of_orders;
    Scalar sum(0.0);
    add_numbers(reinterpret_cast<const Scalar*>(results_), count, sum);
    if (sum - sum >= Scalar(0.0)) return true;
    std::array<bool, lanes> finite;  // or the sum alone has overflowed
    finite.fill(true);
    find_not_finite<lanes>(reinterpret_cast<const double*>(results_), count * lanes, finite);
    return std::all_of(finite.begin(), finite.end(), [](bool each) { return each; });
  }

  /// Of what `work` gives for each argument that the kernel reads, the sum.
  template <class Work>
  Scalar each_argument(const Work& work) noexcept {
    const Scalar state =
        work(call_.time, operands_.state.time) + work(call_.q, operands_.state.q) + work(call_.v, operands_.state.v);
    Scalar others(0.0);
    if (shape_.reads_accelerations) others = work(call_.accelerations, operands_.accelerations);
    if (shape_.reads_multipliers) others = others + work(call_.multipliers, operands_.multipliers);
    if (shape_.reads_inputs) others = others + work(call_.inputs, operands_.inputs);
    return state + others;
  }

  template <class Structure>
  Scalar read(const torsor_view& from, Structure& to, StatesOfBlock states) noexcept {
    Scalar sum(0.0);
    constexpr std::size_t rows = scalars_in<Structure, Scalar>;
    if constexpr (rows > 0) {
      read_columns<rows, lanes>(from, states, call_.states, reinterpret_cast<double*>(&to));
      if constexpr (lanes > 1) fetch_columns<rows, lanes>(from, states.first + 2 * lanes, call_.states);
      add_numbers(reinterpret_cast<const Scalar*>(&to), rows, sum);
    }
    return sum;
  }

  const AnyKernel<M>& kernel_;
  const KernelShape& shape_;
  const typename M::Precomputed& precomputed_;
  const torsor_call& call_;
  std::byte* results_;
  Operands<M> operands_;
};

/// A kernel of a mechanism, over numbers and over packs.
template <class Single, class Packed>
class KernelCall {
  static constexpr std::size_t lanes = sizeof(ScalarOf<Packed>) / sizeof(double);

 public:
  AnyKernel<Single> single{};
  AnyKernel<Packed> packed{};
  KernelShape shape{};

  /// torsor_evaluate: one state by numbers, more by packs.
  std::int64_t operator()(const typename Single::Precomputed& numbers, const typename Packed::Precomputed& packs,
                          torsor_call& call) const {
    call.worst = torsor_state_ok;
    const bool missing = call.q.data == nullptr || call.v.data == nullptr ||
                         (shape.reads_accelerations && call.accelerations.data == nullptr) || call.results == nullptr;
    if (missing) return torsor_call_without_argument;
    if (single.scalars_of_orders > 0 && (call.order < 1 || call.order > static_cast<int>(jet_order_max))) {
      return torsor_call_bad_order;
    }
    if (call.states == 0) return 0;
    if (call.states == 1) return one(numbers, call);
    return many(packs, call);
  }

 private:
  template <class M>
  static std::size_t bytes(const AnyKernel<M>& kernel, const torsor_call& call) noexcept {
    const auto orders = static_cast<std::size_t>(kernel.scalars_of_orders > 0 ? call.order + 1 : 0);
    return std::max<std::size_t>(1, (kernel.scalars + orders * kernel.scalars_of_orders) * sizeof(ScalarOf<M>));
  }

  static void say(torsor_call& call, std::int64_t& failed, std::size_t state, int status) noexcept {
    if (call.statuses != nullptr) call.statuses[state] = status;
    call.worst = std::max(call.worst, status);
    failed += status == torsor_state_ok ? 0 : 1;
  }

  std::int64_t one(const typename Single::Precomputed& precomputed, torsor_call& call) const {
    Scratch scratch;
    std::byte* const results = scratch.of(bytes(single, call));
    if (results == nullptr) return torsor_call_without_memory;
    BlockCall<Single, 1> block({single, shape, precomputed}, call, results);
    std::array<bool, 1> finite;
    const int status = block({0, 1}, finite);
    block.write({0, 1});
    std::int64_t failed = 0;
    say(call, failed, 0, finite[0] ? status : torsor_state_argument_not_finite);
    return failed;
  }

  std::int64_t many(const typename Packed::Precomputed& precomputed, torsor_call& call) const {
    struct Part {
      std::int64_t failed = 0;
      std::int32_t worst = torsor_state_ok;
    };
    const std::size_t blocks = (call.states + lanes - 1) / lanes;
    const unsigned parts = std::min<unsigned>(thread_count(call.threads), max_parts);
    std::array<Part, max_parts> reports{};
    in_parts(blocks, parts, [&](std::size_t part, std::size_t first, std::size_t end) {
      torsor_call own = call;
      reports[part] = {blocks_of(precomputed, own, first, end), own.worst};
    });
    std::int64_t failed = 0;
    for (const Part& report : reports) {
      if (report.failed < 0) return report.failed;
      failed += report.failed;
      call.worst = std::max(call.worst, report.worst);
    }
    return failed;
  }

  std::int64_t blocks_of(const typename Packed::Precomputed& precomputed, torsor_call& call, std::size_t first_block,
                         std::size_t end_block) const {
    Scratch scratch;
    std::byte* const results = scratch.of(bytes(packed, call));
    if (results == nullptr) return torsor_call_without_memory;
    BlockCall<Packed, lanes> block({packed, shape, precomputed}, call, results);
    std::int64_t failed = 0;
    for (std::size_t b = first_block; b < end_block; ++b) {
      const std::size_t first = b * lanes, count = std::min(lanes, call.states - first);
      std::array<bool, lanes> finite;
      const int status = block({first, count}, finite);
      const bool all_finite = std::all_of(finite.begin(), finite.end(), [](bool each) { return each; });
      if (status == 0 && all_finite) {
        block.write({first, count});
        if (call.statuses != nullptr) std::fill_n(call.statuses + first, count, std::int32_t{torsor_state_ok});
        continue;
      }
      // Each state alone, in all lanes: then what is said is its own.
      for (std::size_t i = first; i < first + count; ++i) {
        std::array<bool, lanes> alone;
        const int own = block({i, 1}, alone);
        block.write({i, 1});
        say(call, failed, i, alone[0] ? own : torsor_state_argument_not_finite);
      }
    }
    return failed;
  }

  static constexpr unsigned max_parts = 256;
};

}  // namespace torsor::runtime::abi
