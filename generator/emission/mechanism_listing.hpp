// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/emission/kernel.hpp"
#include "generator/emission/provenance.hpp"
#include "generator/listing/lowering.hpp"

namespace torsor {

/// A kernel and how it is computed.
struct KernelListing {
  Kernel kernel;
  Listing listing;
};

/// A member of Precomputed.
struct PrecomputedMember {
  std::string name;
  std::string meaning;
};

/// All functions of one mechanism, as every language writes them.
struct MechanismListing {
  const Equations* equations = nullptr;
  ModelOptions options;
  Layout layout;
  Schedule schedule;
  std::vector<Structure> common;           ///< structures that every mechanism has
  std::vector<Structure> own;              ///< those that its kernels bring along
  std::vector<PrecomputedMember> members;  ///< of Precomputed, behind the parameters
  Listing default_parameters, precompute, initial_state;
  std::vector<KernelListing> kernels;  ///< those that are not skipped
  std::vector<Kernel> asked;           ///< all that were asked for

  const Structure* structure(const std::string& name) const;  ///< null: there is none
};

/// Lowers all functions. Throws Error when a kernel reads a symbol that it is not given, and SceneError where the
/// initial state depends on more than parameters, or two members of a structure would have one name.
MechanismListing lower_mechanism(const Equations& equations, const std::vector<Kernel>& kernels,
                                 const ModelOptions& options);

/// What the head comment tells, with the operations of each kernel's text.
Provenance provenance_of(const MechanismListing& mechanism, const std::vector<OperationCount>& of_kernels,
                         const std::string& language = {}, const std::string& extension = "hpp");

}  // namespace torsor
