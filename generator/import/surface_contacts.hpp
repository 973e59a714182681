// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "torsor/generator/import/identifiers.hpp"
#include "torsor/generator/import/surfaces.hpp"
#include "torsor/generator/mechanics/scene.hpp"

namespace torsor {

/// Contacts of one law between solids that a file states, each centred at a frame's origin with its axis along z.
class SurfaceContacts {
 public:
  /// The law's coefficients are the run-time parameters <word>_friction and <word>_restitution.
  SurfaceContacts(Scene& scene, FileIdentifiers& identifiers, const std::string& word, const Surfaces& surfaces);

  /// A frame at a place of another.
  FrameHandle at(const std::string& name, const FrameReference& parent, const Placement& placement) const;

  void touch(const std::string& name, const ContactShape& shape, const ContactShape& other) const;
  /// With both rims, <name>_top and <name>_base.
  void cylinder_on_plane(const std::string& name, const FrameHandle& centre, const form::Cylinder& cylinder,
                         const FrameReference& plane) const;
  /// With the balls at both ends, <name>_top and <name>_base; `length` is that between their centres.
  void capsule_on_plane(const std::string& name, const FrameHandle& centre, const form::Cylinder& capsule,
                        const FrameReference& plane) const;

 private:
  Scene& scene_;
  FileIdentifiers& identifiers_;
  SurfaceLaw law_;
};

}  // namespace torsor
