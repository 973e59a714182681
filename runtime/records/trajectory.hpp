// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>

#include "torsor/runtime/records/csv.hpp"
#include "torsor/runtime/records/file.hpp"

namespace torsor::runtime {

/// One row of a trajectory.
template <std::floating_point Scalar, std::size_t columns>
struct Sample {
  Scalar time;
  std::array<Scalar, columns> values;
};

/// Records samples into storage of the caller, whose size is the capacity; recording allocates nothing and may be used
/// as an observer. Samples beyond the capacity are counted as lost, and writing then fails rather than hide it.
/// `names` are those of the values, in the units of the mechanism; the time comes before them.
template <std::floating_point Scalar, std::size_t columns>
class Trajectory {
 public:
  Trajectory(std::span<Sample<Scalar, columns>> storage, std::array<std::string, columns> names)
      : storage_(storage), names_(std::move(names)) {}

  void operator()(const Scalar& time, const std::array<Scalar, columns>& values) noexcept {
    if (size_ == storage_.size()) {
      ++lost_;
      return;
    }
    storage_[size_++] = {time, values};
  }

  [[nodiscard]] std::span<const Sample<Scalar, columns>> samples() const noexcept { return storage_.first(size_); }
  [[nodiscard]] std::int64_t lost() const noexcept { return lost_; }

  void clear() noexcept {
    size_ = 0;
    lost_ = 0;
  }

  /// Header `time,names...`, then one row a sample, each number the shortest decimal that reads back the same. Written
  /// whole or not at all. Throws FileError: file not writable, bad column name, samples lost.
  void write_csv(const std::filesystem::path& path) const {
    if (lost_ > 0) {
      throw FileError("cannot write '" + path.string() + "': " + std::to_string(lost_) +
                      " samples did not fit the capacity of " + std::to_string(storage_.size()) +
                      "; give the trajectory more storage or record fewer states");
    }
    std::string text = "time";
    for (const std::string& name : names_) {
      text += ',';
      append_name(text, name, path);
    }
    text += '\n';
    for (const auto& sample : samples()) {
      append_number(text, sample.time);
      for (const Scalar& value : sample.values) {
        text += ',';
        append_number(text, value);
      }
      text += '\n';
    }
    write_file(path, text);
  }

 private:
  std::span<Sample<Scalar, columns>> storage_;
  std::array<std::string, columns> names_;
  std::size_t size_ = 0;
  std::int64_t lost_ = 0;
};

}  // namespace torsor::runtime
