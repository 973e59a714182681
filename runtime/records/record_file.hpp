// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include "torsor/runtime/records/file.hpp"

namespace torsor::runtime {

/// What a file of records answers: which question, how many records make it whole, and how many numbers each has.
struct RecordHead {
  std::uint64_t question = 0;  ///< a digest of everything that the records depend on
  std::uint64_t count = 0;
  std::uint64_t numbers = 0;

  friend bool operator==(const RecordHead&, const RecordHead&) = default;
};

/// A file of records, 0, 1, 2, ... in this order, that survives interruption at any byte: the head (56 bytes: a text
/// that names the format, its version, the order of bytes, the three numbers of RecordHead, a checksum), then for each
/// record its index, its numbers in double, and a checksum of both. What follows the last good record is dropped when
/// the file is opened again, so that the file of a resumed run ends up the same byte by byte.
class RecordFile {
 public:
  /// Creates the file, or opens it behind its last good record. Throws FileError when it cannot be read or written,
  /// holds something else, answers another question, or is being written by another process.
  RecordFile(const std::filesystem::path& path, const RecordHead& head);
  ~RecordFile();
  RecordFile(const RecordFile&) = delete;
  RecordFile& operator=(const RecordFile&) = delete;

  [[nodiscard]] std::uint64_t written() const noexcept { return written_; }
  [[nodiscard]] bool complete() const noexcept { return written_ == head_.count; }

  /// The next record. Throws FileError when the disk is full.
  void append(std::span<const double> record);
  /// Hands what was appended to the system: the end of this process can no longer lose it.
  void flush();

 private:
  void open_alone();
  void write(std::span<const std::uint64_t> words);

  struct Close {
    void operator()(std::FILE* file) const noexcept { std::fclose(file); }
  };
  std::filesystem::path path_;
  RecordHead head_;
  std::uint64_t written_ = 0;
  std::vector<std::uint64_t> buffer_;
  std::unique_ptr<std::FILE, Close> file_;
};

/// The good records of a file, one after the other.
struct Records {
  RecordHead head;
  std::vector<double> values;

  [[nodiscard]] std::uint64_t size() const noexcept { return head.numbers == 0 ? 0 : values.size() / head.numbers; }
  [[nodiscard]] bool complete() const noexcept { return size() == head.count; }
  [[nodiscard]] std::span<const double> operator[](std::size_t i) const noexcept {
    return std::span(values).subspan(i * head.numbers, head.numbers);
  }
};

/// Reads a file of records, whole or not. Throws FileError when it is none.
[[nodiscard]] Records read_records(const std::filesystem::path& path);

}  // namespace torsor::runtime
