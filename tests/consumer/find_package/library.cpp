// SPDX-License-Identifier: GPL-3.0-or-later
// The program of someone who links to the shared library of a mechanism: the mass matrix at the start, by its table alone.
#include <torsor/runtime/abi.h>

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <vector>

int main() {
  const torsor_abi* arm = torsor_mechanism();
  if (arm->version != TORSOR_ABI_VERSION || arm->size != sizeof(torsor_abi)) return 1;
  const auto n = static_cast<std::size_t>(arm->coordinate_count), m = static_cast<std::size_t>(arm->velocity_count);
  torsor_model* model = arm->create(nullptr);
  std::vector<double> q(n), v(m), mass(m * m, NAN);
  double time = NAN;
  arm->initial_state(model, &time, q.data(), v.data());
  int failed = 2;
  for (const torsor_abi_kernel* kernel = arm->kernels; kernel != arm->kernels + arm->kernel_count; ++kernel) {
    if (std::strcmp(kernel->name, "mass_matrix") != 0) continue;
    torsor_view results{};
    results.data = mass.data();
    results.row = sizeof(double);
    results.column = static_cast<std::ptrdiff_t>(m * sizeof(double));
    torsor_call call{};
    call.model = model;
    call.states = 1;
    call.q.data = q.data();
    call.q.row = sizeof(double);
    call.v.data = v.data();
    call.v.row = sizeof(double);
    call.results = &results;
    failed = kernel->evaluate(&call) == 0 && mass[0] == 3 ? 0 : 3;  // carriage and rod
  }
  arm->destroy(model);
  std::printf("%s has %zu coordinates; along the first it moves %g kg\n", arm->name, n, mass[0]);
  return failed;
}
