// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "torsor/generator/verification/kernel_accuracy.hpp"

namespace torsor {

/// A group of results that is allowed more than the bar, and why.
struct AccuracyException {
  std::string scene, kernel, group, scalar;  ///< "*" stands for any
  double limit = 0;                          ///< of the scaled error [ulp]
  std::string reason;
};

/// Reads `scene | kernel | group | scalar | limit | reason`, one a line; empty lines and lines that start with # are
/// skipped. Throws UsageError quoting a line that it cannot read.
std::vector<AccuracyException> parse_accuracy_exceptions(const std::string& text);

struct VerifyOptions {
  ModelOptions model{};
  std::vector<std::string> kernels{};  ///< empty: all
  std::vector<Precision> precisions{Precision::in_double, Precision::in_float};
  int digits = 50;
  int states = 64;
  int climbs = 2;  ///< searches for a worse state, for each group
  std::uint64_t seed = 1;
  int range = double_states.large;  ///< sizes go up to 2^±range, in float no further than it can
  std::vector<AccuracyException> exceptions{};
};

/// What is asked of every group of results: scaled error in ulp.
inline constexpr double accuracy_bar = 8;

/// One group of results in one format, at the worst state that was found.
struct VerifyRow {
  std::string kernel, group, scalar;
  Accuracy worst;            ///< certified with CLN
  std::uint64_t seed = 0;    ///< of the state that it is, or that the search started from
  bool searched = false;
  std::string state;         ///< NAME=VALUE of what the group depends on
  std::map<std::string, double> numbers{};  ///< the same
  std::string remark{};      ///< why digits are lost there, where that is known
  double potential = 0;      ///< the largest bound of the scaled error at any state looked at [ulp]
  int states = 0;            ///< looked at, without those that the kernel reports itself
  int undefined = 0;         ///< further states where there is no result, and no status that says so: 0/0, NaN
  double limit = accuracy_bar;
  std::string reason;        ///< of the exception that applies, if any

  /// The bound is one: no error may exceed it.
  bool bounded() const { return worst.error <= worst.bound; }
  /// A group that could be measured at no state has shown nothing.
  bool passed() const {
    return worst.counted ? worst.scaled <= limit && bounded() : worst.identically_zero;  // false for NaN
  }
};

/// Looks for the worst error of every kernel, in each format: at `states` states of seeds `seed`, `seed` + 1, …, then
/// from the worst of these uphill, coordinate by coordinate, once after the bound and once after the error itself, and
/// so on `climbs` times. The worst found is measured with CLN. The same result for the same options, everywhere.
std::vector<VerifyRow> verify_scene(const Scene& scene, const VerifyOptions& options);

/// The exceptions for a scene that no row needs: what they name stays within the bar, or is not among the rows. A
/// longer search, or other kernels, may need others: rows are those of the search that the exceptions were written for.
std::vector<AccuracyException> needless_exceptions(const std::string& scene, const std::vector<VerifyRow>& rows,
                                                   const std::vector<AccuracyException>& exceptions);

}  // namespace torsor
