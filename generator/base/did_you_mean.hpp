// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace torsor {

/// The least number of letters inserted, left out, replaced, or exchanged with their neighbour, that makes one word of
/// the other; no letter is touched twice. Small and capital letters count as the same. Bytes are compared.
/// Source: the optimal string alignment distance; Damerau, A technique for computer detection and correction of spelling
/// errors, Communications of the ACM 7 (1964).
std::size_t edit_distance(std::string_view a, std::string_view b);

/// Whether `word` looks like a misspelling of `known`: at most one edit for every three letters of the longer one, three
/// at most, so that words of one or two letters differ in capitals only. Words of more than 100 bytes are like no other.
bool looks_like(std::string_view word, std::string_view known);

/// Those of the known words that `word` looks like at the least distance, in their order, each once.
std::vector<std::string> nearest_words(std::string_view word, const std::vector<std::string>& known);

/// "did you mean 'elbow'? ", with the nearest words, three at most. Where none is near, words of five letters and more may
/// be one edit further away; where none is there either, those that begin with `word` (three letters or more) are named,
/// if they are three at most. Empty otherwise. To stand before the list of the known:
/// `fmt::format("unknown frame '{}': {}the scene has {}", name, did_you_mean(name, known), fmt::join(known, ", "))`.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& known);

}  // namespace torsor
