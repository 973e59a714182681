// SPDX-License-Identifier: GPL-3.0-or-later
#define BUILD_NAMESPACE native_build
#include "benchmarks/sincos/measured.cpp"
