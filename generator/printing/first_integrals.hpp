// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/dynamics/equations/equations.hpp"
#include "torsor/generator/printing/inline_view.hpp"
#include "torsor/generator/printing/page.hpp"
#include "torsor/generator/printing/stretches.hpp"

namespace torsor::printing {

/// Painlevé's equation, the first integrals that were found and, where T2 − T0 − U is not conserved, which of its
/// conditions fails; for each coordinate without a momentum integral, what stands against it. The squares of `stretches`
/// stay whole in the energy.
void write_first_integrals(const Equations& equations, const InlineLimits& limits, Page& page,
                           const std::vector<Stretch>& stretches = {});

}  // namespace torsor::printing
