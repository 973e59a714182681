// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

/// One kernel in one scalar: for numbers, or for packs of so many lanes.
struct Way {
  const char* kernel;
  const char* scalar;  ///< "double" or "float"
  int lanes;           ///< 1: the single kernel
  /// Evaluates all states of a table once.
  void (*run)();
};

constexpr int table_size = 1024;  ///< states, a multiple of the lanes of every pack

/// The greatest difference between what packs and single kernels gave in the last runs, relative to the greatest
/// result.
double worst_difference(const char* kernel, const char* scalar);

/// Ways compiled for this processor, of each kernel and scalar the single one first.
std::span<const Way> ways();
