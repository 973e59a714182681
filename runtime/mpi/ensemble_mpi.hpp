// SPDX-License-Identifier: MIT
#pragma once
#include <mpi.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <stdexcept>

#include "torsor/runtime/batch/ensemble.hpp"

namespace torsor::runtime {

/// Which processes compute an ensemble, and how.
struct MpiEnsembleOptions {
  MPI_Comm communicator = MPI_COMM_WORLD;
  unsigned threads = 1;                                     ///< of each process, as in EnsembleOptions
  std::uint64_t at_once = 0;                                ///< members handed out at a time; 0: four for each thread
  std::function<bool(const EnsembleProgress&)> progress{};  ///< as in EnsembleOptions, in the first process
};

/// As `run_ensemble`, on the processes of a communicator: the first one writes the file and hands out members, the
/// others compute; a single process does both. The file has the same bytes as that of one process, and either can go on
/// with the other's.
///
/// All processes call it with the same question, between MPI_Init and MPI_Finalize; MPI is called on this thread only,
/// so that MPI_THREAD_FUNNELED is enough. Every process gets the same result. What one of them throws is thrown in all:
/// in the others, and what came from elsewhere, as EnsembleError with the same text. An EnsembleError also tells that the
/// processes were given different questions.
EnsembleProgress run_ensemble_over_mpi(const std::filesystem::path& file, const RecordHead& head,
                                       const EnsembleMember& member, const MpiEnsembleOptions& options = {});

/// An ensemble failed in another process; the text is that of its error.
class EnsembleError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace torsor::runtime
