// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "torsor/generator/verification/reference.hpp"

namespace torsor {

/// 64 bits (FNV-1a) of everything that a reference depends on: the definitions of the Lagrange derivation, parameters, initial
/// state, times, digits, and how it is integrated. Another question has other bits but for one in 2^64; the same
/// question the same on every machine.
std::uint64_t reference_digest(const Scene& scene, const ReferenceOptions& options);

/// The reference, kept in <folder>/<scene>-<digest>.csv, which is made where it is absent: a reference is not
/// integrated twice. A kept file ends with a digest of its own text: one that was cut or changed is integrated again.
/// Throws FileError where the folder cannot be written.
ReferenceResult integrate_cached_reference(const Scene& scene, const ReferenceOptions& options, const std::string& folder);

}  // namespace torsor
