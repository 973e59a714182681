// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/kernels/kernel_robotics.hpp"

#include "torsor/generator/dynamics/forces/gravity_forces.hpp"
#include "torsor/generator/dynamics/recursions/centroidal_momentum.hpp"
#include "torsor/generator/kernels/kernel_parts.hpp"

namespace torsor {

Kernel make_gravity(const Equations& equations) {
  Kernel kernel;
  kernel.documentation =
      "Generalised forces of gravity g(q), as the bias has them: what motors must supply at rest where nothing else\n"
      "acts, the gradient of the potential energy of weight.";
  kernel.results = {{"GeneralizedForces", "forces"}};
  assign_vector(kernel, {"forces"}, gravity_forces(equations.model().without_lines()), unknowns(equations));
  return kernel;
}

std::string no_gravity(const Equations& equations) {
  return equations.model().upward_gravity().is_zero() ? "the scene has no gravity" : "";
}

Kernel make_centroidal_momentum(const Equations& equations) {
  const CentroidalMomentum found = centroidal_momentum(equations.model());
  const std::size_t n = unknowns(equations);
  Kernel kernel;
  kernel.documentation =
      "Centre of mass C of the bodies that move, their momentum about it and the centroidal momentum matrix, in "
      "ground\n"
      "axes: (linear, angular) = A v + b, b of what laws of time drive.";
  kernel.structures = {
      {"CentroidalMomentum",
       "Momentum of all bodies that move about their centre of mass C, in ground axes.",
       {vector_member("center", 3, {"C", "m"}),
        vector_member("linear", 3, {"momentum", "kg m/s"}),
        vector_member("angular", 3, {"angular momentum about C", "kg m^2/s"}),
        matrix_member("matrix", 6, n, "A, stored column by column; rows 0 to 2 linear, 3 to 5 angular")}}};
  kernel.results = {{"CentroidalMomentum", "result"}};
  for (int i = 0; i < 3; ++i) {
    const auto row = static_cast<std::size_t>(i);
    kernel.assignments.push_back({{"result", "center", row}, found.center[i]});
    kernel.assignments.push_back({{"result", "linear", row}, found.momentum.resultant[i]});
    kernel.assignments.push_back({{"result", "angular", row}, found.momentum.moment[i]});
    for (std::size_t j = 0; j < n; ++j) {
      kernel.assignments.push_back({{"result", "matrix", 6 * j + row}, found.columns[j].resultant[i]});
      kernel.assignments.push_back({{"result", "matrix", 6 * j + 3 + row}, found.columns[j].moment[i]});
    }
  }
  return kernel;
}

std::string no_moving_mass(const Equations& equations) {
  return moves_mass(equations.model()) ? "" : "no body that moves has a mass";
}

}  // namespace torsor
