// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "torsor/generator/mechanics/scene.hpp"
#include "torsor/generator/printing/print_equations.hpp"

namespace torsor {

/// The statics of a scene as a person reads it, parameters as symbols: −(U + T0) and the equations of equilibrium; with
/// a state `about` ("theta", "pi/2") what is left of them there, Lejeune-Dirichlet's criterion with the second
/// derivatives of −(U + T0), and Hurwitz's conditions of the linearised equations; verdicts with the scene's values
/// where every parameter has one. Where a criterion says nothing, "cannot conclude" and why. Equilibria are not sought:
/// the runtime does that (find_equilibria). Throws UsageError for a state that cannot be read.
///
/// `set` gives parameters other values in all of it ("omega", "0"). Throws UsageError where it names no parameter.
std::string statics_text(const Scene& scene, const std::vector<std::pair<std::string, std::string>>& about,
                         const std::vector<std::pair<std::string, std::string>>& set = {}, const PageStyle& style = {});

}  // namespace torsor
