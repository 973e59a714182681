// SPDX-License-Identifier: MIT
#pragma once
#include <mpi.h>

#include <cstdint>
#include <filesystem>
#include <stdexcept>

#include "torsor/runtime/batch/ensemble.hpp"

namespace torsor::runtime {

/// As `run_ensemble`, on the processes of a communicator, each with `options.threads` threads: the first one writes the
/// file and hands out `at_once` members at a time (0: four for each thread), the others compute; a single process does
/// both. The file has the same bytes as that of one process, and either can go on with the other's.
///
/// All processes call it with the same question, between MPI_Init and MPI_Finalize; MPI is called on this thread only,
/// so that MPI_THREAD_FUNNELED is enough. `options.progress` is called in the first process. Every process gets the
/// same result. What one of them throws is thrown in all: in the others, and what came from elsewhere, as EnsembleError
/// with the same text. An EnsembleError also tells that the processes were given different questions.
EnsembleProgress run_ensemble_over_mpi(MPI_Comm communicator, const std::filesystem::path& file, const RecordHead& head,
                                       const EnsembleMember& member, const EnsembleOptions& options = {},
                                       std::uint64_t at_once = 0);

/// An ensemble failed in another process; the text is that of its error.
class EnsembleError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace torsor::runtime
