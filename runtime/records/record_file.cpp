// SPDX-License-Identifier: MIT
#include "torsor/runtime/records/record_file.hpp"

#include <array>
#include <bit>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <string>

#if __has_include(<sys/file.h>)
#include <sys/file.h>
#endif

#include "torsor/runtime/records/digest.hpp"

namespace torsor::runtime {

namespace {

using Head = std::array<std::uint64_t, 7>;
constexpr std::uint64_t version_and_order = (std::uint64_t{1} << 32) | 0x01020304U;

Head words_of(const RecordHead& head) {
  Head words{};
  constexpr char name[17] = "torsor ensemble\n";
  std::memcpy(words.data(), name, 16);
  words[2] = version_and_order;
  words[3] = head.question;
  words[4] = head.count;
  words[5] = head.numbers;
  words[6] = Digest{}.add(words[2]).add(words[3]).add(words[4]).add(words[5]).value();
  return words;
}

std::uint64_t checksum(std::uint64_t index, std::span<const std::uint64_t> numbers) {
  Digest digest;
  digest.add(index);
  for (const std::uint64_t number : numbers) digest.add(number);
  return digest.value();
}

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& why) {
  throw FileError("'" + path.string() + "' " + why);
}

/// A pipe or a device holds no records to go on from, and opening a pipe waits for whoever is at its other end.
void refuse_pipes(const std::filesystem::path& path) {
  std::error_code ignored;
  const std::filesystem::file_status status = std::filesystem::status(path, ignored);
  if (std::filesystem::exists(status) && !is_regular_file(status) && !is_directory(status))
    refuse(path, "is no regular file, so that it holds no records to go on from; choose a file on a disk");
}

/// What is in the file of a whole head; false when it ends before. `expected`, where there is one, must begin like it.
bool read_head(const std::filesystem::path& path, std::istream& stream, const Head* expected, RecordHead& head) {
  Head words{};
  stream.read(reinterpret_cast<char*>(words.data()), sizeof words);
  const auto read = static_cast<std::size_t>(stream.gcount());
  if (read < sizeof words) {
    const Head any = words_of({});
    // Up to the name, every file of records begins alike.
    const Head& like = expected != nullptr ? *expected : any;
    if (std::memcmp(words.data(), like.data(), expected != nullptr ? read : std::min<std::size_t>(read, 16)) == 0)
      return false;
    refuse(path, "is no file of records; choose another name");
  }
  if (std::memcmp(words.data(), words_of({}).data(), 16) != 0)
    refuse(path, "is no file of records; choose another name");
  if (words[2] != version_and_order)
    refuse(path, "was written by another version, or on a machine with another order of bytes");
  head = {words[3], words[4], words[5]};
  if (words != words_of(head)) refuse(path, "has a damaged head; remove it and begin again");
  return true;
}

/// Whether the next record is whole and the one of this index; its numbers are then those of the buffer from 1 on.
bool read_record(std::istream& stream, std::uint64_t index, std::vector<std::uint64_t>& buffer) {
  const auto bytes = static_cast<std::streamsize>(buffer.size() * sizeof(std::uint64_t));
  stream.read(reinterpret_cast<char*>(buffer.data()), bytes);
  return stream.gcount() == bytes && buffer.front() == index &&
         buffer.back() == checksum(index, std::span(buffer).subspan(1, buffer.size() - 2));
}

std::string in_words(const RecordHead& head) {
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(head.question));
  return std::to_string(head.count) + " records of " + std::to_string(head.numbers) + " numbers, question " + digits;
}

}  // namespace

RecordFile::RecordFile(const std::filesystem::path& path, const RecordHead& head)
    : path_(path), head_(head), buffer_(head.numbers + 2) {
  const Head words = words_of(head_);
  open_alone();
  std::uint64_t good = 0;
  {
    std::ifstream stream = open_file(path_);
    RecordHead found;
    if (read_head(path_, stream, &words, found)) {
      if (found != head_) {
        refuse(path_, "holds the results of another question (" + in_words(found) + ", not " + in_words(head_) +
                          "): the mechanism, its members, the times or the method are not those it was begun with; "
                          "choose another file, or remove this one");
      }
      while (written_ < head_.count && read_record(stream, written_, buffer_)) ++written_;
      good = sizeof words + written_ * buffer_.size() * sizeof(std::uint64_t);
    }
  }
  std::error_code error;
  std::filesystem::resize_file(path_, good, error);
  if (error) detail::fail_to_write(path_, error.value());
  if (good == 0) write(words);
  flush();
}

RecordFile::~RecordFile() = default;

/// For appending, and before a byte is read: what another process has in hand may grow until it is locked.
void RecordFile::open_alone() {
  refuse_pipes(path_);
  errno = 0;
  file_.reset(std::fopen(path_.string().c_str(), "ab"));
  if (!file_) detail::fail_to_write(path_, errno);
#if __has_include(<sys/file.h>)
  if (::flock(::fileno(file_.get()), LOCK_EX | LOCK_NB) != 0)
    refuse(path_, "is being written by another process; wait for it, or choose another file");
#endif
}

void RecordFile::write(std::span<const std::uint64_t> words) {
  errno = 0;
  if (std::fwrite(words.data(), sizeof(std::uint64_t), words.size(), file_.get()) != words.size())
    detail::fail_to_write(path_, errno != 0 ? errno : EIO);
}

void RecordFile::append(std::span<const double> record) {
  if (record.size() != head_.numbers || complete())
    throw std::logic_error("RecordFile::append: a record too many, or of a wrong size");
  buffer_.front() = written_;
  for (std::size_t i = 0; i < record.size(); ++i) buffer_[i + 1] = std::bit_cast<std::uint64_t>(record[i]);
  buffer_.back() = checksum(written_, std::span(buffer_).subspan(1, record.size()));
  write(buffer_);
  ++written_;
}

void RecordFile::flush() {
  errno = 0;
  if (std::fflush(file_.get()) != 0) detail::fail_to_write(path_, errno != 0 ? errno : EIO);
}

Records read_records(const std::filesystem::path& path) {
  refuse_pipes(path);
  std::ifstream stream = open_file(path);
  Records records;
  if (!read_head(path, stream, nullptr, records.head)) return records;
  // A head may promise more than there is, or than memory holds: no record that is longer than the file is whole.
  if (records.head.numbers > std::filesystem::file_size(path) / sizeof(std::uint64_t)) return records;
  std::vector<std::uint64_t> buffer(records.head.numbers + 2);
  for (std::uint64_t i = 0; i < records.head.count && read_record(stream, i, buffer); ++i) {
    for (std::size_t k = 1; k + 1 < buffer.size(); ++k) records.values.push_back(std::bit_cast<double>(buffer[k]));
  }
  return records;
}

}  // namespace torsor::runtime
