// SPDX-License-Identifier: GPL-3.0-or-later
// The files that the runtime reads: records, references.
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <unistd.h>

#include "torsor/runtime/records/csv.hpp"
#include "torsor/runtime/records/digest.hpp"
#include "torsor/runtime/records/record_file.hpp"
#include "torsor/runtime/records/reference.hpp"
#include "tests/fuzz/target.hpp"

namespace torsor::fuzzing {
namespace {

/// A file of this process that holds the input.
std::filesystem::path file_of(std::string_view input) {
  static const std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("torsor_fuzz_" + std::to_string(::getpid()));
  std::ofstream(path, std::ios::binary | std::ios::trunc).write(input.data(), static_cast<std::streamsize>(input.size()));
  return path;
}

struct Removed {
  std::filesystem::path path;
  ~Removed() {
    std::error_code ignored;
    std::filesystem::remove(path, ignored);
  }
};

/// With the checksum that belongs to the head, so that counts of any size are met.
std::string with_checksum(std::string_view input) {
  std::string text(input);
  std::array<std::uint64_t, 7> head{};
  if (text.size() < sizeof head) return text;
  std::memcpy(head.data(), text.data(), sizeof head);
  head[6] = runtime::Digest{}.add(head[2]).add(head[3]).add(head[4]).add(head[5]).value();
  std::memcpy(text.data(), head.data(), sizeof head);
  return text;
}

}  // namespace

void read_record_file(std::string_view input) {
  // The question that the files of the corpus answer.
  constexpr runtime::RecordHead head{123, 7, 3};
  const Removed file{file_of(input.size() % 2 == 0 ? with_checksum(input) : std::string(input))};
  try {
    const std::uint64_t found = runtime::read_records(file.path).size();
    runtime::RecordFile again(file.path, head);
    if (again.written() != found) throw std::logic_error("a file of records is read otherwise than it is gone on with");
    while (!again.complete()) again.append(std::vector<double>(3, static_cast<double>(again.written())));
    again.flush();
    if (!runtime::read_records(file.path).complete()) throw std::logic_error("records that were written are not read");
  } catch (const runtime::FileError& refusal) {
    if (*refusal.what() == '\0') throw std::logic_error("an error says nothing");
  }
}

void read_reference_file(std::string_view input) {
  const Removed file{file_of(input)};
  try {
    const auto reference = runtime::read_reference<double>(file.path);
    for (std::size_t i = 0; i < reference.rows(); ++i) {
      const bool later = i == 0 || reference.times[i] > reference.times[i - 1];
      if (!later || !std::isfinite(reference.times[i])) throw std::logic_error("times of a reference do not increase");
      for (std::size_t k = 0; k < reference.names.size(); ++k) {
        if (!std::isfinite(reference.value(i, k))) throw std::logic_error("a reference holds what is no number");
      }
    }
  } catch (const runtime::FileError& refusal) {
    if (*refusal.what() == '\0') throw std::logic_error("an error says nothing");
  }
}

void read_table_head(std::string_view input) {
  const Removed file{file_of(input)};
  try {
    static_cast<void>(runtime::read_header(file.path));
  } catch (const runtime::FileError& refusal) {
    if (*refusal.what() == '\0') throw std::logic_error("an error says nothing");
  }
}

}  // namespace torsor::fuzzing
