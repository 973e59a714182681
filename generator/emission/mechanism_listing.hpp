// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "torsor/generator/emission/provenance.hpp"
#include "torsor/generator/kernels/kernel.hpp"
#include "torsor/generator/listing/lowering.hpp"
#include "torsor/generator/listing/precomputation.hpp"

namespace torsor {

/// A kernel and how it is computed.
struct KernelListing {
  KernelSignature kernel;
  Listing listing;
  std::optional<int> before;  ///< operations before any were saved; none of recurrences, which have nothing to compare
};

/// A kernel by itself.
struct LoweredKernel {
  Listing listing;
  Listing once;  ///< what it reads from Precomputed, by its places there
};
LoweredKernel lower_kernel(Program& program, const Kernel& kernel, const Layout& layout);

/// What functions of the mechanism may be given.
Layout layout_of(const Equations& equations, const std::vector<SymbolPointer>& parameters);

/// All functions of one mechanism, as every language writes them.
struct MechanismListing {
  std::unique_ptr<const Equations> equations;  ///< nothing of them is derived
  ModelOptions options;
  Layout layout;
  std::vector<Structure> common;           ///< structures that every mechanism has
  std::vector<Structure> own;              ///< those that its kernels bring along
  std::vector<PrecomputedMember> members;  ///< of Precomputed, behind the parameters
  Listing default_parameters, precompute, initial_state;
  std::vector<KernelListing> kernels;  ///< those that are not absent
  std::vector<AskedKernel> asked;      ///< all that were asked for

  const Scene& scene() const { return equations->scene(); }
  const Structure* structure(const std::string& name) const;  ///< null: there is none
};

/// A kernel that has no name in kernel.hpp.
struct FurtherKernel {
  std::string name;
  std::function<Kernel(const Equations&)> make;
};

/// Derives and lowers the kernels of these names, each as if it were the only one: a function is the same whichever
/// others there are. The scene is lowered to a model once. Further kernels come last. Throws UsageError naming an unknown
/// kernel, Error when a kernel reads a symbol that it is not given, and SceneError where the initial state depends on more
/// than parameters, or two members of a structure would have one name.
MechanismListing lower_mechanism(const Scene& scene, const std::vector<std::string>& kernels,
                                 const ModelOptions& options = {}, const std::vector<FurtherKernel>& further = {});

/// What the head comment tells, with the operations of each kernel's text.
Provenance provenance_of(const MechanismListing& mechanism, const std::string& language = {},
                         const std::string& extension = "hpp");

}  // namespace torsor
