// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/cli/commands.hpp"
#include "generator/emission/header.hpp"

namespace torsor {

GeneratedHeader generate_header(const Scene& scene, const std::vector<std::string>& names,
                                const ModelOptions& options) {
  const Equations equations(scene, options);
  GeneratedHeader header;
  std::vector<Kernel> kernels;
  for (const std::string& name : names) {
    kernels.push_back(make_kernel(name, equations));
    if (!kernels.back().skipped.empty()) header.absent.emplace_back(name, kernels.back().skipped);
  }
  header.text = emit_header(equations, kernels, {options});
  return header;
}

}  // namespace torsor
