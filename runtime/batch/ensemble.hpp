// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <span>

#include "torsor/runtime/records/record_file.hpp"

namespace torsor::runtime {

/// How far an ensemble is.
struct EnsembleProgress {
  std::uint64_t done = 0;  ///< members whose records are in the file, in order
  std::uint64_t total = 0;
  std::uint64_t found = 0;  ///< of those, how many were there from an earlier run
};

struct EnsembleOptions {
  unsigned threads = 1;  ///< 0: as many as the processor runs at once; the file does not depend on it
  /// Called on the caller's thread, at the start and whenever records were written; false ends the run, which may be
  /// resumed.
  std::function<bool(const EnsembleProgress&)> progress{};
};

/// Writes the record of one member. Called on several threads at once, for different members; the same index must give
/// the same record whenever it is called. What it throws ends the run and reaches the caller.
using EnsembleMember = std::function<void(std::uint64_t index, std::span<double> record)>;

/// Members that are computed together, as a SIMD register's lanes are: `compute` writes the records of members first to
/// first + count - 1, one behind the other. Groups begin at multiples of `together`; the last may be smaller. One that
/// is in the file in part is computed anew, so what a member's record depends on in its group stays the same. If a
/// record depends on `together` (by what is fused, or by its neighbours) it must be part of the head's question: else a
/// file may be continued with groups of another size.
struct EnsembleGroups {
  std::uint64_t together = 1;  ///< 1 or more
  std::function<void(std::uint64_t first, std::uint64_t count, std::span<double> records)> compute;
};

/// Computes the records of members 0, ..., head.count - 1 that a file does not hold yet and appends each as soon as
/// those before it are there. Interrupt it at any time, by whatever means, and call it again: the file ends up the same
/// byte by byte, whatever the number of threads. Throws FileError, see RecordFile, and what the members throw.
EnsembleProgress run_ensemble(const std::filesystem::path& file, const RecordHead& head, const EnsembleMember& member,
                              const EnsembleOptions& options = {});
/// As above; as many groups are under way at once as there are threads. Throws std::invalid_argument where
/// `groups.together` is 0, before the file is touched.
EnsembleProgress run_ensemble(const std::filesystem::path& file, const RecordHead& head, const EnsembleGroups& groups,
                              const EnsembleOptions& options = {});

/// A progress callback that keeps one line up to date, "340 of 1000 members, 34 %", and goes on.
[[nodiscard]] std::function<bool(const EnsembleProgress&)> progress_line(std::ostream& stream);

}  // namespace torsor::runtime
