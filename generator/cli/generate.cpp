// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/cli/commands.hpp"
#include "generator/emission/header.hpp"

namespace torsor {

std::string generate_header(const Scene& scene, const std::vector<std::string>& names, const ModelOptions& options) {
  const Equations equations(scene, options);
  std::vector<Kernel> kernels;
  for (const std::string& name : names) kernels.push_back(make_kernel(name, equations));
  return emit_header(equations, kernels, {options});
}

}  // namespace torsor
