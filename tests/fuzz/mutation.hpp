// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace torsor::fuzzing {

/// The input of this number: one of the corpus, damaged in one to eight places. It depends on its arguments alone, so
/// that an input is found again by its number.
std::string damaged(const std::vector<std::string>& corpus, std::uint64_t seed, std::uint64_t number);

}  // namespace torsor::fuzzing
