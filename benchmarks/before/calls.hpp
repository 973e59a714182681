// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

constexpr int sample_count = 64, kernel_count = 5;

struct Kernels {
  const char* name;
  void (*call)(int sample);
};

extern const Kernels kernels_before[kernel_count], kernels_now[kernel_count];
extern const int joints_before, joints_now;
/// Takes q, v and a of each joint in turn, sample after sample.
void prepare_before(const double* numbers);
void prepare_now(const double* numbers);
