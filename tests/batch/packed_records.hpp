// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "torsor/runtime/batch/packed_motion_ensemble.hpp"

namespace torsor::packed_records {

using namespace torsor::runtime;

inline const std::vector<double> times = {0.1, 0.25, 1.0};

template <class Ensemble>
std::vector<double> records_of(const Ensemble& ensemble, const RecordHead& head) {
  std::vector<double> records(head.count * head.numbers);
  const EnsembleGroups groups = ensemble.groups();
  for (std::uint64_t first = 0; first < head.count; first += groups.together) {
    const std::uint64_t count = std::min(groups.together, head.count - first);
    groups.compute(first, count, std::span(records).subspan(first * head.numbers, count * head.numbers));
  }
  return records;
}

/// How many of the members' records differ in a bit from those of members alone.
template <template <class> class Mechanism, class Members, class Method>
int different(std::uint64_t count, Members members, const Method& method, std::vector<double>* found = nullptr) {
  using M = Mechanism<double>;
  const auto packed = packed_motion_ensemble<Mechanism, double>({.count = count, .times = times}, members, method);
  const auto alone = motion_ensemble<M>({.count = count, .times = times}, members, method);
  const RecordHead head = alone.head();
  EXPECT_EQ(packed.head().count, head.count);
  EXPECT_EQ(packed.head().numbers, head.numbers);
  EXPECT_NE(packed.head().question, head.question);
  const std::vector<double> records = records_of(packed, head);
  int differing = 0;
  for (std::uint64_t i = 0; i < count; ++i) {
    std::vector<double> expected(head.numbers);
    alone(i, expected);
    differing += std::memcmp(expected.data(), &records[i * head.numbers], head.numbers * sizeof(double)) != 0;
  }
  if (found != nullptr) *found = records;
  return differing;
}

}  // namespace torsor::packed_records
