// SPDX-License-Identifier: GPL-3.0-or-later
// The build writes models.inc: MEASURED(name) for each generated header.
#include "benchmarks/kernels/measured.hpp"

#define MEASURED(model) kernels::Measured measured_##model();
namespace generic_build {
#include "models.inc"
}
namespace native_build {
#include "models.inc"
}
#undef MEASURED

namespace kernels {

std::vector<Measured> generated_headers(bool native) {
  std::vector<Measured> headers;
#define MEASURED(model) \
  headers.push_back(native ? native_build::measured_##model() : generic_build::measured_##model());
#include "models.inc"
#undef MEASURED
  return headers;
}

}  // namespace kernels
