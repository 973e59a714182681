// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ctime>

namespace work_precision {

/// Seconds the processor has worked for this thread: what other programs take of it does not count.
inline double processor_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace work_precision
