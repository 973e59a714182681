// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/import/urdf_collisions.hpp"

namespace torsor {

/// Contacts of links with each other, from their <collision> elements. `contacts` names pairs A:B. Each sphere of
/// the one meets each sphere of the other. A side with a face behind it, B+z, is the plane of that face of its only box
/// or cylinder, without edges: spheres, boxes (their corners) and cylinders (their rims) of the other meet it. The
/// contact <A>_<B> has numbers behind it where a link has several elements: that of A's, then that of B's. Throws
/// UsageError for what is no such pair, FileError for a form that cannot be read.
void add_contacts(const UrdfContactScene& around, const Surfaces& contacts);

}  // namespace torsor
