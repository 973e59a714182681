// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "torsor/generator/emission/mechanism_listing.hpp"
#include "torsor/generator/kernels/kernel_outputs.hpp"
#include "torsor/generator/mechanics/size_bounds.hpp"

namespace torsor {

enum class FmiVersion { two, three };

/// A mechanism as a functional mock-up unit: its kernels, and what it gives beside its motion.
struct FmiUnit {
  FmiVersion version = FmiVersion::two;
  OutputNames outputs;
  MechanismListing mechanism;
  std::vector<SizeBound> sizes{};  ///< those that run-time parameters bear on: the unit refuses what they cannot be

  const Scene& scene() const { return mechanism.scene(); }
  const std::string& name() const { return scene().name(); }
  /// Then the contact layer moves it, and contacts share in multipliers.
  bool has_contacts() const { return !scene().content().contacts.empty(); }
  std::size_t place_count() const { return 3 * outputs.points.size() + 12 * outputs.frames.size(); }
};

/// Derives what the unit is made of. Throws SceneError for a name that is none, where the mechanism has no forward
/// dynamics, and for reactions where contacts share in them.
FmiUnit lower_unit(const Scene& scene, FmiVersion version, const OutputNames& outputs = {},
                   const ModelOptions& options = {});

}  // namespace torsor
