// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <mpi.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <string>

namespace torsor::mpi_test {

inline int rank() {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  return rank;
}
inline int processes() {
  int size = 0;
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  return size;
}

inline std::string contents(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

/// A folder that all processes know, empty at first.
class SharedFolder {
 public:
  SharedFolder() {
    auto name = static_cast<std::uint64_t>(std::random_device{}());
    MPI_Bcast(&name, 1, MPI_UINT64_T, 0, MPI_COMM_WORLD);
    path = std::filesystem::temp_directory_path() / ("torsor mpi test " + std::to_string(name));
    if (rank() == 0) std::filesystem::create_directories(path);
  }
  ~SharedFolder() {
    MPI_Barrier(MPI_COMM_WORLD);
    std::error_code ignored;
    if (rank() == 0) std::filesystem::remove_all(path, ignored);
  }
  SharedFolder(const SharedFolder&) = delete;
  SharedFolder& operator=(const SharedFolder&) = delete;

  std::filesystem::path path;
};

}  // namespace torsor::mpi_test
