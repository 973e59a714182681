// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/dynamics/equations/equations.hpp"
#include "torsor/generator/printing/inline_view.hpp"
#include "torsor/generator/printing/page.hpp"

namespace torsor::printing {

/// Contacts that open and close: gaps, velocities and generalised forces of each, then the laws of Signorini and Coulomb
/// with their regimes, the jumps that percussions make, and Carnot's loss (Pommier, §6.2.3 and §7.6). Nothing where the
/// scene has none.
void write_contacts(const Equations& equations, const InlineLimits& limits, Page& page);

}  // namespace torsor::printing
