// SPDX-License-Identifier: GPL-3.0-or-later
// The build writes models.inc: MEASURED(build, name) for each generated header.
#include "benchmarks/kernels/measured.hpp"

#define MEASURED(build, model)          \
  namespace build {                     \
  kernels::Measured measured_##model(); \
  }
#include "models.inc"
#undef MEASURED

namespace kernels {

std::vector<Measured> generated_headers() {
  std::vector<Measured> headers;
#define MEASURED(build, model) headers.push_back(build::measured_##model());
#include "models.inc"
#undef MEASURED
  return headers;
}

}  // namespace kernels
