// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/base/zip_archive.hpp"

#include <array>
#include <cstdint>
#include <limits>
#include <string_view>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"

namespace torsor {
namespace {

/// The checksum of the format: CRC-32, polynomial 0xEDB88320 reflected.
std::uint32_t checksum(std::string_view bytes) {
  static const std::array<std::uint32_t, 256> table = [] {
    std::array<std::uint32_t, 256> all{};
    for (std::uint32_t i = 0; i < 256; ++i) {
      std::uint32_t value = i;
      for (int bit = 0; bit < 8; ++bit) value = (value >> 1) ^ ((value & 1U) != 0 ? 0xEDB88320U : 0U);
      all[i] = value;
    }
    return all;
  }();
  std::uint32_t sum = 0xFFFFFFFFU;
  for (const char byte : bytes) sum = (sum >> 8) ^ table[(sum ^ static_cast<unsigned char>(byte)) & 0xFFU];
  return sum ^ 0xFFFFFFFFU;
}

void put(std::string& to, std::uint64_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) to += static_cast<char>((value >> (8 * i)) & 0xFFU);
}

/// What both headers of a file have in common: from the version that is needed to the length of the name.
std::string common_fields(const ArchivedFile& file) {
  std::string text;
  put(text, 10, 2);      // version 1.0
  put(text, 0x0800, 2);  // names in UTF-8
  put(text, 0, 2);       // stored
  put(text, 0, 2);       // midnight
  put(text, 0x21, 2);    // of 1980-01-01
  put(text, checksum(file.bytes), 4);
  put(text, file.bytes.size(), 4);
  put(text, file.bytes.size(), 4);
  put(text, file.path.size(), 2);
  return text;
}

}  // namespace

std::string zip_archive(const std::vector<ArchivedFile>& files) {
  std::string archive, directory;
  for (const ArchivedFile& file : files) {
    const std::size_t place = archive.size();
    if (place + file.bytes.size() > std::numeric_limits<std::uint32_t>::max()) {
      throw FileError(fmt::format("the archive with '{}' is larger than 4 GiB", file.path));
    }
    const std::string fields = common_fields(file);
    put(archive, 0x04034B50, 4);
    archive += fields;
    put(archive, 0, 2);
    archive += file.path + file.bytes;
    put(directory, 0x02014B50, 4);
    put(directory, 0x0314, 2);  // made on Unix
    directory += fields;
    put(directory, 0, 2);
    put(directory, 0, 2);
    put(directory, 0, 2);
    put(directory, 0, 2);
    put(directory, 0100644U << 16U, 4);
    put(directory, place, 4);
    directory += file.path;
  }
  const std::size_t place = archive.size();
  archive += directory;
  put(archive, 0x06054B50, 4);
  put(archive, 0, 4);
  put(archive, files.size(), 2);
  put(archive, files.size(), 2);
  put(archive, directory.size(), 4);
  put(archive, place, 4);
  put(archive, 0, 2);
  return archive;
}

}  // namespace torsor
